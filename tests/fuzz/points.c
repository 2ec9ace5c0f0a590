/* Points of every format. */
#include "pipeline/io/points/points.h"
#include "tests/fuzz/targets.h"
#include "tests/support/meshes/mesh_files.h"

static bool read_points(const char *path)
{
    GpPoints points = { .count = 0 };
    GpError error = { "" };
    if (!fuzz_accepted(gp_points_read(path, &points, &error), &error))
        return false;
    for (size_t i = 0; i < 3 * (size_t)points.count; i++)
        fuzz_claim(points.positions[i] * 0 == 0, "positions are finite");
    gp_points_free(&points);
    return true;
}

static bool run_ply(const uint8_t *data, size_t size)
{
    return read_points(fuzz_file(".ply", data, size));
}

static void seeds_ply(const FuzzSeeds *to)
{
    for (int encoding = 0; encoding < 3; encoding++) {
        static const char *const names[] = { "text", "little", "big" };
        MeshBytes bytes = { .size = 0 };
        mesh_write_ply(&bytes, encoding, PLY_VARIANTS - 1);
        to->take(to->user, names[encoding], bytes.data, bytes.size);
    }
    /* every byte a letter: the floats are finite */
    fuzz_seed_text(to, "columns",
                   "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\n"
                   "property float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
                   "property uchar blue\nproperty float radius\nend_header\n"
                   "aaaabbbbccccdefgggghhhhiiiijjjjklmnnnn");
    fuzz_seed_text(
        to, "surfels",
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "property float radius\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nend_header\n0 0 0 0 0 1 0.1 1 2 3\n1 0 0 0 1 0 .2 4 5 6\n");
}

/* The first byte is the format. */
static bool run_text(const uint8_t *data, size_t size)
{
    static const char *const extensions[] = { ".xyz", ".pts", ".xyzn", ".xyzrgb" };
    if (size == 0)
        return false;
    return read_points(fuzz_file(extensions[data[0] % GP_COUNT(extensions)], data + 1, size - 1));
}

static void seeds_text(const FuzzSeeds *to) /* 'd': .xyz */
{
    fuzz_seed_text(to, "xyz", "d0 0 0\n1 2 3\n# no more\n-1e5 .5 1E-3\n");
    fuzz_seed_text(to, "colors", "d0 0 0 255 0 3\n1 2 3 1 2 3\n");
    fuzz_seed_text(to, "pts", "e2\n0 0 0 -5 1 2 3\n1 2 3 9 4 5 6\n");
    fuzz_seed_text(to, "xyzn", "f0 0 0 0 0 1\n1 2 3 0 1 0\n");
    fuzz_seed_text(to, "xyzrgb", "g0 0 0 1 2 3\n");
}

const FuzzTarget fuzz_points_ply = { "points_ply", 2048, run_ply, seeds_ply, NULL };
const FuzzTarget fuzz_points_text = { "points_text", 1024, run_text, seeds_text, NULL };
