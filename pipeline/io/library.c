#include "pipeline/io/library.h"

#include <dlfcn.h>
#include <string.h>

/* C++ comes first, by itself: of the libraries that need it, even static objects may find no
 * memory (gp_call_without_memory). */
static void set_new_handler(void)
{
    GpEndFn (*set)(GpEndFn end);
    const GpEndFn end = gp_called_without_memory();
    void *runtime = end ? dlopen("libstdc++.so.6", RTLD_LAZY | RTLD_LOCAL) : NULL;
    void *found = runtime ? dlsym(runtime, "_ZSt15set_new_handlerPFvvE") : NULL;
    if (!found)
        return;
    memcpy(&set, &found, sizeof set);
    set(end);
}

GpResult gp_library_find(const char *file, const char *name, void **found, GpError *error)
{
    set_new_handler();
    void *handle = dlopen(file, RTLD_LAZY | RTLD_LOCAL);
    void *symbol = handle ? dlsym(handle, name) : NULL;
    if (symbol) {
        *found = symbol;
        return GP_OK;
    }
    /* The loader has words for each thing that it had no memory for; these are for other
     * failures. */
    const char *why = dlerror();
    why = why ? why : name;
    if (strstr(why, "cannot open shared object file"))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "which is not there: %s", why);
    if (strstr(why, "undefined symbol"))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "which is of another version: %s", why);
    return gp_fail(error, GP_ERROR_MEMORY, "which cannot be loaded, for want of memory: %s", why);
}
