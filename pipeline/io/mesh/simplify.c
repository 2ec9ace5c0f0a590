/* OpenMesh stands in a library of its own, simplify_openmesh.cpp, in ../lib beside the program, and is
 * loaded when a mesh is simplified; a build without it (make WITH_OPENMESH=) says so here. */
#include "pipeline/io/mesh/simplify.h"

#include <dlfcn.h>
#include <pthread.h>

static GpSimplifyFn *simplify;
static GpError reason;

static void load(void)
{
    void *handle = dlopen("libglasspipe_openmesh.so", RTLD_LAZY | RTLD_LOCAL);
    if (handle)
        *(void **)&simplify = dlsym(handle, "gp_mesh_openmesh");
    if (!simplify)
        gp_fail(&reason, GP_ERROR_UNSUPPORTED, "%s", dlerror());
}

GpResult gp_mesh_simplify(const GpSimplifyInput *input, GpSimplified *simplified, GpError *error)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, load);
    if (!simplify)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "simplifying a mesh needs OpenMesh, which is not there: %s", reason.text);
    GpSimplified made = { .vertices = NULL };
    const GpResult result = simplify(input, &made);
    if (result) {
        gp_simplified_free(&made);
        return gp_fail(error, result, "out of memory");
    }
    *simplified = made;
    return GP_OK;
}

void gp_simplified_free(GpSimplified *simplified)
{
    gp_free(simplified->vertices);
    gp_free(simplified->indices);
    *simplified = (GpSimplified){ .vertices = NULL };
}
