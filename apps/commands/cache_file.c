#include "apps/commands/cache_file.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

enum { MAGIC = 8 };

/* The first bytes of a cache: apps/points/cache.c, apps/fragments/pieces/pieces_cache.c. */
static const char magics[][MAGIC + 1] = { "gppoints", "gppieces" };

static bool begins_as_cache(const char *path)
{
    char begin[MAGIC];
    FILE *file = fopen(path, "rb");
    const size_t read = file ? fread(begin, 1, MAGIC, file) : 0;
    if (!file)
        return true; /* whoever reads it knows what to say */
    fclose(file);
    for (size_t i = 0; i < GP_COUNT(magics) && read == MAGIC; i++)
        if (memcmp(begin, magics[i], MAGIC) == 0)
            return true;
    return false;
}

GpResult cache_file_check(const SettingField *fields, const void *setting, GpError *error)
{
    const SettingField *field = setting_find(fields, "cache");
    const char *path = NULL;
    struct stat status;
    if (field)
        memcpy(&path, (const char *)setting + field->offset, sizeof path);
    if (!path || stat(path, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size == 0 ||
        begins_as_cache(path))
        return GP_OK;
    return gp_fail(error, GP_ERROR_INVALID,
                   "--cache %.400s: the file is there, and is no cache: expected a name that is "
                   "free, or that of a cache",
                   path);
}
