/* OpenMesh stands in a library of its own, simplify_openmesh.cpp, in ../lib beside the program, and
 * is loaded when a mesh is simplified; a build without it (make WITH_OPENMESH=) says so here. */
#include "pipeline/io/library.h"
#include "pipeline/io/mesh/simplify.h"

#include <pthread.h>

static GpSimplifyFn *simplify;
static GpResult loaded;
static GpError reason;

static void load(void)
{
    loaded = gp_library_find("libglasspipe_openmesh.so", "gp_mesh_openmesh", (void **)&simplify,
                             &reason);
}

GpResult gp_mesh_simplify(const GpSimplifyInput *input, GpSimplified *simplified, GpError *error)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, load);
    if (!simplify)
        return gp_fail(error, loaded, "simplifying a mesh needs OpenMesh, %s", reason.text);
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
