/* Files as whole blocks of bytes: read at once, replaced at once, and where the data lies.
 *
 * Readers of formats work on bytes in memory, so that what was checked is what is read; writers
 * make their bytes in memory, so that a full disk never leaves half a file.
 */
#ifndef GP_IO_FILE_H
#define GP_IO_FILE_H

#include "pipeline/base/base.h"

#include <errno.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a call that set errno has come to: GP_ERROR_MEMORY or GP_ERROR_IO. */
static inline GpResult gp_result_of_errno(int problem)
{
    return problem == ENOMEM ? GP_ERROR_MEMORY : GP_ERROR_IO;
}

/* Content of a file. A zero byte follows data[size - 1] and does not count. */
typedef struct GpFile {
    char *data;
    size_t size;
} GpFile;

/* Reads a whole regular file.
 * out    file; free with gp_file_free
 * errors GP_ERROR_IO (missing, a folder, a device, unreadable), GP_ERROR_MEMORY
 * owns   the caller owns file->data */
GpResult gp_file_read(const char *path, GpFile *file, GpError *error);

/* Frees the bytes and empties *file; NULL and empty files are fine. */
void gp_file_free(GpFile *file);

/* Writes a file beside its place, without a name where the system has such files, and renames it,
 * so that path has either its old or its new content and never a part. A symbolic link is followed,
 * also to what is not there yet; a device or a pipe (there is nothing to replace) is written
 * straight.
 * in     data: size bytes, NULL allowed where size is 0
 * errors GP_ERROR_IO (no such folder, not writable, disk full); nothing is left behind */
GpResult gp_file_write(const char *path, const void *data, size_t size, GpError *error);

/* A file that is written piece by piece, as gp_file_write writes one: begun beside its place, and
 * put there when it is whole. */
typedef struct GpFilePieces GpFilePieces;

/* in     path: stays as it is until gp_file_end
 * errors GP_ERROR_IO, GP_ERROR_MEMORY; owns: the caller, until gp_file_end */
GpResult gp_file_begin(const char *path, GpFilePieces **pieces, GpError *error);
GpResult gp_file_add(GpFilePieces *pieces, const void *data, size_t size, GpError *error);

/* Puts it in its place, or removes it where it is not `whole'; sets NULL. NULL is fine.
 * errors GP_ERROR_IO: nothing is left then */
GpResult gp_file_end(GpFilePieces **pieces, bool whole, GpError *error);

/* Removes what gp_file_write has begun, in whatever thread: for what ends the program at any
 * moment, a signal handler among it. */
void gp_file_abandon(void);

/* Finds a data file: the path as given, then in $GLASSPIPE_DATA, then in ../shared/data, then in
 * ../share/glasspipe as seen from the program's folder. An absolute path is only looked for as it
 * is.
 * out    path: the first of these that exists, size bytes with the terminator
 * errors GP_ERROR_IO where there is none or it does not fit; path is untouched then */
GpResult gp_data_find(const char *name, char *path, size_t size, GpError *error);

/* The same for what a file names: beside that file before all others. NULL: there is none. */
GpResult gp_data_find_beside(const char *file, const char *name, char *path, size_t size,
                             GpError *error);

bool gp_path_is_folder(const char *path);

/* The part of a path after its last dot, lower case, at most 7 characters; "" where there is none.
 */
void gp_file_extension(const char *path, char extension[8]);

/* Whether it is this one: lower case, at most 7 characters. */
bool gp_file_has_extension(const char *path, const char *extension);

#ifdef __cplusplus
}
#endif

#endif
