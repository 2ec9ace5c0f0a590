/* Benchmark cases of voxelization: meshes in memory to volumes in memory, and two volumes combined.
 * All are 256 voxels a side. */
#include "apps/bench/cases.h"
#include "apps/techniques/voxel/volume/combine.h"
#include "apps/techniques/voxel/inputs/scene.h"

#include <string.h>

enum { SIZE = 256, SLAB = 32 };

/* --- meshes ----------------------------------------------------------------------------------- */

/* Triangles in their box, in the frame's memory. */
static GpResult read_model(const char *name, Frame *frame, VoxelModel *model, GpError *error)
{
    VoxelScene scene;
    GpResult result = voxel_scene_open(name, &scene, error);
    if (result)
        return result;
    const VoxelBox box = voxel_scene_box(&scene, SIZE);
    *model = voxel_scene_model(&scene, &box);
    const size_t floats = 3 * (size_t)model->vertex_count,
                 corners = 3 * (size_t)model->triangle_count;
    model->positions = frame_copy(frame, model->positions, floats * sizeof *model->positions);
    model->indices = frame_copy(frame, model->indices, corners * sizeof *model->indices);
    model->normals = model->colors = NULL;
    voxel_scene_close(&scene);
    return GP_OK;
}

GpResult bench_build_voxelize(const BenchCase *bench, Frame *frame, GpError *error)
{
    static const struct {
        const char *mesh;
        VoxelKind kind;
        VoxelMethod method;
        float twist; /* radians a voxel, by a motion that may change from frame to frame */
    } volumes[] = {
        [VOXELIZE_CONSERVATIVE] = { "meshes/bunny.ply", VOXEL_SURFACE, VOXEL_CONSERVATIVE, 0 },
        [VOXELIZE_THIN] = { "meshes/bunny.ply", VOXEL_SURFACE, VOXEL_THIN, 0 },
        [VOXELIZE_SOLID] = { "meshes/horse.ply", VOXEL_SOLID, VOXEL_XOR, 0 },
        [VOXELIZE_TWISTED] = { "meshes/bunny.ply", VOXEL_SURFACE, VOXEL_CONSERVATIVE, 0.01f },
        [VOXELIZE_MILLION] = { "meshes/happy_buddha.ply", VOXEL_SURFACE, VOXEL_CONSERVATIVE, 0 },
    };
    const VoxelSetting setting = { .kind = volumes[bench->variant].kind,
                                   .method = volumes[bench->variant].method,
                                   .size = SIZE,
                                   .bits = 1 };
    VoxelModel model;
    FlatTexture flat;
    GpResult result = read_model(volumes[bench->variant].mesh, frame, &model, error);
    if (result)
        return result;
    if (volumes[bench->variant].twist > 0) {
        model.motion.twist = model.most_twist = volumes[bench->variant].twist;
        model.motions = frame_alloc(frame, 1, sizeof *model.motions);
    }
    result = voxel_build(&model, &setting, frame, &flat, error);
    frame->color = flat.texels;
    return result;
}

/* --- two volumes ------------------------------------------------------------------------------ */

/* The bits of a column's slab that are in a ball. */
static uint32_t bits_of_ball(const double centre[3], double radius, uint32_t x, uint32_t y,
                             uint32_t slab)
{
    uint32_t bits = 0;
    for (uint32_t k = 0; k < SLAB; k++) {
        double dx = x + 0.5 - centre[0], dy = y + 0.5 - centre[1];
        double dz = slab * SLAB + k + 0.5 - centre[2];
        bits |= (uint32_t)(dx * dx + dy * dy + dz * dz < radius * radius) << k;
    }
    return bits;
}

static FlatTexture make_ball(Frame *frame, const double centre[3], double radius)
{
    FlatTexture ball = flat_texture_make(frame, SIZE, 1);
    for (uint32_t slab = 0; slab < ball.slabs; slab++)
        for (uint32_t y = 0; y < SIZE; y++)
            for (uint32_t x = 0; ball.texels->level[0].texels && x < SIZE; x++) {
                uint32_t bits = bits_of_ball(centre, radius, x, y, slab);
                memcpy(flat_texture_texel(&ball, slab, x, y), &bits, sizeof bits);
            }
    return ball;
}

/* In place: later frames find what the first one left, and do the same work on it. */
GpResult bench_build_combine(const BenchCase *bench, Frame *frame, GpError *error)
{
    const FlatTexture a = make_ball(frame, (const double[3]){ 96, 128, 128 }, 80);
    const FlatTexture b = make_ball(frame, (const double[3]){ 160, 128, 128 }, 80);
    if (bench->variant == COMBINE_COLLISION) {
        const VoxelRange whole = voxel_range_whole(SIZE);
        voxel_collide(frame, &a, &b, &whole, &a);
    } else {
        voxel_combine(frame, &a, &b, VOXEL_UNION, &a);
    }
    frame->color = a.texels;
    return frame_result(frame, error);
}
