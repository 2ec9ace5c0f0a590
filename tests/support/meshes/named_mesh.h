/* Meshes by name, as commands take them. */
#ifndef TESTS_NAMED_MESH_H
#define TESTS_NAMED_MESH_H

#include "apps/points/subdivide.h"
#include "apps/scene/model.h"
#include "tests/support/unit.h"

/* Owned by the caller. errors fails the running test where there is none */
static inline GpMesh named_mesh(const char *name)
{
    GpMesh mesh;
    GpError error = { "" };
    if (model_mesh(name, &mesh, &error))
        fail_msg("%s", error.text);
    return mesh;
}

/* The same, of the vertices that triangles use. */
static inline GpMesh referenced_mesh(const char *name)
{
    GpMesh mesh = named_mesh(name);
    assert_int_equal(mesh_keep_referenced(&mesh), GP_OK);
    return mesh;
}

#endif
