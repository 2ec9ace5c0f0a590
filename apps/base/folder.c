#include "apps/base/folder.h"

#include "pipeline/io/file.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

GpResult folder_make(const char *path, GpError *error)
{
    const int problem = mkdir(path, 0777) == 0 ? 0 : errno;
    if (!problem || gp_path_is_folder(path))
        return GP_OK;
    return gp_fail(error, GP_ERROR_IO, "%.400s: %s", path,
                   strerror(problem == EEXIST ? ENOTDIR : problem));
}
