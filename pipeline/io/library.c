#include "pipeline/io/library.h"

#include <dlfcn.h>
#include <string.h>

GpResult gp_library_find(const char *file, const char *name, void **found, GpError *error)
{
    void *handle = dlopen(file, RTLD_LAZY | RTLD_LOCAL);
    void *symbol = handle ? dlsym(handle, name) : NULL;
    if (symbol) {
        *found = symbol;
        return GP_OK;
    }
    /* The loader has words for each thing that it had no memory for; these are for other failures. */
    const char *why = dlerror();
    why = why ? why : name;
    if (strstr(why, "cannot open shared object file"))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "which is not there: %s", why);
    if (strstr(why, "undefined symbol"))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "which is of another version: %s", why);
    return gp_fail(error, GP_ERROR_MEMORY, "which cannot be loaded, for want of memory: %s", why);
}
