/* Meshes of every format. */
#include "pipeline/io/mesh/mesh_file.h"
#include "tests/fuzz/targets.h"
#include "tests/support/meshes/mesh_files.h"

#include <stdio.h>

/* What mesh.h says of every mesh. */
static void check(const GpMesh *mesh)
{
    for (size_t i = 0; i < 3 * (size_t)mesh->vertex_count; i++) {
        fuzz_claim(mesh->positions[i] * 0 == 0, "positions are finite");
        fuzz_claim(mesh->normals != NULL, "there are normals");
    }
    for (size_t i = 0; i < 3 * (size_t)mesh->triangle_count; i++)
        fuzz_claim(mesh->indices[i] < mesh->vertex_count, "indices are in range");
    fuzz_claim(mesh->had_colors == (mesh->colors != NULL), "colours are there as is said");
}

static bool read_mesh(const char *extension, const uint8_t *data, size_t size)
{
    GpMesh mesh = { .vertex_count = 0 };
    GpError error = { "" };
    const GpResult result =
        gp_mesh_read(fuzz_file(extension, data, size), GP_MESH_ALLOW_POINTS, &mesh, &error);
    if (!fuzz_accepted(result, &error))
        return false;
    check(&mesh);
    gp_mesh_free(&mesh);
    return true;
}

/* --- OFF, OBJ --------------------------------------------------------------------------------- */

static bool run_off(const uint8_t *data, size_t size)
{
    return read_mesh(".off", data, size);
}

static void seeds_off(const FuzzSeeds *to)
{
    fuzz_seed_text(to, "plain", "OFF\n5 3 0\n" OFF_VERTICES OFF_FACES);
    fuzz_seed_text(to, "comment", "OFF 3 1 3 # counts\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    fuzz_seed_text(to, "points", "OFF\n2 0 0\n0 0 0\n1e-37 -1E+38 .5\n");
    fuzz_seed_text(to, "colors",
                   "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 1\n3 0 1 2\n");
}

static bool run_obj(const uint8_t *data, size_t size)
{
    return read_mesh(".obj", data, size);
}

static void seeds_obj(const FuzzSeeds *to)
{
    fuzz_seed_text(to, "plain", OBJ_VERTICES "f 4 3 2 1\nf 1 2 5\nf -4 -3 -1\n");
    fuzz_seed_text(to, "all",
                   "mtllib a.mtl\no a\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\n"
                   "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nusemtl m\ns 1\n"
                   "f 1/1/1 2/2/1 3/3/1\nf 1//1 2//1 3//1\nf 1/1 2/2 3/3\n");
}

/* --- PLY, STL, OM ----------------------------------------------------------------------------- */

static bool run_ply(const uint8_t *data, size_t size)
{
    return read_mesh(".ply", data, size);
}

static void seeds_ply(const FuzzSeeds *to)
{
    for (int encoding = 0; encoding < 3; encoding++)
        for (int variant = 0; variant < PLY_VARIANTS; variant++) {
            MeshBytes bytes = { .size = 0 };
            char name[32];
            mesh_write_ply(&bytes, encoding, variant);
            snprintf(name, sizeof name, "%d-%d", encoding, variant);
            to->take(to->user, name, bytes.data, bytes.size);
        }
}

static bool run_stl(const uint8_t *data, size_t size)
{
    return read_mesh(".stl", data, size);
}

static void seeds_stl(const FuzzSeeds *to)
{
    MeshBytes bytes = { .size = 0 };
    mesh_write_stl(&bytes, "solid but binary");
    to->take(to->user, "binary", bytes.data, bytes.size);
    fuzz_seed_text(to, "text", mesh_stl_text);
}

static bool run_om(const uint8_t *data, size_t size)
{
    return read_mesh(".om", data, size);
}

static void seeds_om(const FuzzSeeds *to)
{
    MeshBytes bytes = { .size = 0 };
    mesh_write_om1(&bytes);
    to->take(to->user, "first", bytes.data, bytes.size);
    to->take(to->user, "half-edges", mesh_om_bytes, OM_SIZE);
}

const FuzzTarget fuzz_mesh_off = { "mesh_off", 2048, run_off, seeds_off, NULL };
const FuzzTarget fuzz_mesh_obj = { "mesh_obj", 2048, run_obj, seeds_obj, NULL };
const FuzzTarget fuzz_mesh_ply = { "mesh_ply", 4096, run_ply, seeds_ply, NULL };
const FuzzTarget fuzz_mesh_stl = { "mesh_stl", 2048, run_stl, seeds_stl, NULL };
const FuzzTarget fuzz_mesh_om = { "mesh_om", 2048, run_om, seeds_om, NULL };
