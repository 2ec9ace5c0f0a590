/* A model as it is drawn, kept in a file: patches, and their surfels as they are, compressed, or
 * both.
 *
 * The file is one block: a head, then patches, levels, surfels, frames, the table of radii, words,
 * colours, each begun at a multiple of 64 bytes and as it is in memory, little-endian. It is read
 * at once and used where it lies; nothing is done for a point but hash its bytes. The head says
 * which version wrote it, of what it was made (a key), how much there is of everything, and the
 * hash of all.
 *
 * source ours; XXH3 for the hashes
 */
#ifndef APPS_POINTS_CACHE_H
#define APPS_POINTS_CACHE_H

#include "apps/points/compress.h"
#include "pipeline/io/file.h"

/* A model to draw. */
typedef struct PackedModel {
    Patches patches;       /* surfels: NULL where only the compressed ones are wanted */
    Compressed compressed; /* words: NULL where they are not */
    GpFile file;           /* what a model from a cache lies in; else empty */
} PackedModel;

/* Frees all, wherever it lies, and zeroes; a zeroed one is fine. */
void packed_model_free(PackedModel *model);

/* Of what a model is made: the input's content and the settings that lead from it to surfels and
 * patches.
 * in     input: as content_hash (apps/base/content.h) has it; settings: any text that tells them
 *        apart */
uint64_t cache_key(uint64_t input, const char *settings);

/* Reads a model that was written for the same key.
 * out    model: with what was written; free with packed_model_free; untouched on failure
 * errors GP_ERROR_IO (no such file), GP_ERROR_MEMORY, GP_ERROR_FORMAT: it is to be built anew, and
 *        the message says why: "FILE: not a cache of points", "... of another version", "... of
 *        another model or other settings", "... truncated ...", "... damaged ..." */
GpResult cache_read(const char *path, uint64_t key, PackedModel *model, GpError *error);

/* Writes a model, beside its place and renamed.
 * errors GP_ERROR_IO, GP_ERROR_MEMORY; the old file stays then */
GpResult cache_write(const char *path, uint64_t key, const PackedModel *model, GpError *error);

#endif
