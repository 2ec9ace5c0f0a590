/* Benchmark cases of voxelization: meshes in memory to volumes in memory, and two volumes combined.
 * All are 256 voxels a side. */
#include "apps/bench/cases.h"
#include "apps/techniques/voxel/combine.h"
#include "apps/techniques/voxel/inputs/scene.h"

#include <string.h>

enum { SIZE = 256, SLAB = 32 };

/* --- meshes ----------------------------------------------------------------------------------- */

/* Triangles in their box, in the work's memory. */
static GpResult read_model(const char *name, Work *work, VoxelModel *model, GpError *error)
{
    VoxelScene scene;
    GpResult result = voxel_scene_open(name, &scene, error);
    if (result)
        return result;
    const VoxelBox box = voxel_scene_box(&scene, SIZE);
    *model = voxel_scene_model(&scene, &box);
    const size_t floats = 3 * (size_t)model->vertex_count,
                 corners = 3 * (size_t)model->triangle_count;
    model->positions = work_copy(work, model->positions, floats * sizeof *model->positions);
    model->indices = work_copy(work, model->indices, corners * sizeof *model->indices);
    model->normals = model->colors = NULL;
    voxel_scene_close(&scene);
    return GP_OK;
}

GpResult bench_build_volume(const BenchCase *bench, Work *work, GpError *error)
{
    static const struct {
        const char *mesh;
        int kind, method; /* VoxelKind, VoxelMethod */
        float twist;      /* radians a voxel, by a motion that may change from frame to frame */
    } volumes[] = {
        [VOLUME_CONSERVATIVE] = { "meshes/bunny.ply", VOXEL_SURFACE, VOXEL_CONSERVATIVE, 0 },
        [VOLUME_THIN] = { "meshes/bunny.ply", VOXEL_SURFACE, VOXEL_THIN, 0 },
        [VOLUME_SOLID] = { "meshes/horse.ply", VOXEL_SOLID, VOXEL_XOR, 0 },
        [VOLUME_TWISTED] = { "meshes/bunny.ply", VOXEL_SURFACE, VOXEL_CONSERVATIVE, 0.01f },
        [VOLUME_MILLION] = { "meshes/happy_buddha.ply", VOXEL_SURFACE, VOXEL_CONSERVATIVE, 0 },
    };
    const VoxelSetting setting = { .kind = volumes[bench->variant].kind,
                                   .method = volumes[bench->variant].method,
                                   .size = SIZE,
                                   .bits = 1 };
    VoxelModel model;
    Worksheet sheet;
    uint32_t passes, draws;
    GpResult result = read_model(volumes[bench->variant].mesh, work, &model, error);
    if (result)
        return result;
    if (volumes[bench->variant].twist > 0) {
        model.motion.twist = model.most_twist = volumes[bench->variant].twist;
        model.motions = work_alloc(work, 1, sizeof *model.motions);
    }
    tech_voxel_room(&setting, &passes, &draws);
    work_reserve(work, passes, draws);
    result = tech_voxel_build(&model, &setting, work, &sheet, error);
    work->color = sheet.texels;
    return result;
}

/* --- two volumes ------------------------------------------------------------------------------ */

/* The bits of a column's slab that are in a ball. */
static uint32_t bits_of_ball(const double middle[3], double radius, uint32_t x, uint32_t y,
                             uint32_t slab)
{
    uint32_t bits = 0;
    for (uint32_t k = 0; k < SLAB; k++) {
        double dx = x + 0.5 - middle[0], dy = y + 0.5 - middle[1];
        double dz = slab * SLAB + k + 0.5 - middle[2];
        bits |= (uint32_t)(dx * dx + dy * dy + dz * dz < radius * radius) << k;
    }
    return bits;
}

static Worksheet make_ball(Work *work, const double middle[3], double radius)
{
    Worksheet ball = worksheet_make(work, SIZE, 1);
    for (uint32_t slab = 0; slab < ball.slabs; slab++)
        for (uint32_t y = 0; y < SIZE; y++)
            for (uint32_t x = 0; x < SIZE; x++) {
                uint32_t bits = bits_of_ball(middle, radius, x, y, slab);
                memcpy(worksheet_texel(&ball, slab, x, y), &bits, sizeof bits);
            }
    return ball;
}

/* In place: later frames find what the first one left, and do the same work on it. */
GpResult bench_build_combine(const BenchCase *bench, Work *work, GpError *error)
{
    (void)error;
    const Worksheet a = make_ball(work, (const double[3]){ 96, 128, 128 }, 80);
    const Worksheet b = make_ball(work, (const double[3]){ 160, 128, 128 }, 80);
    work_reserve(work, 2 * VOXEL_COMBINE_PASSES, 2 * voxel_combine_draws(&a));
    if (bench->variant == COMBINE_COLLISION) {
        const VoxelRange whole = voxel_range_whole(SIZE);
        voxel_collide(work, &a, &b, &whole, &a);
    } else {
        voxel_combine(work, &a, &b, VOXEL_UNION, &a);
    }
    work->color = a.texels;
    return GP_OK;
}
