#include "tests/support/voxel_case.h"

#include "pipeline/io/file.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

#include <math.h>
#include <stdio.h>

/* --- models ----------------------------------------------------------------------------------- */

/* A rotation about (1, 2, 3), after Rodrigues; without a library's sine, for the same bits
 * anywhere. */
static void rotation(double turn, double m[3][3])
{
    const double cosine = (1 - turn * turn) / (1 + turn * turn),
                 sine = 2 * turn / (1 + turn * turn);
    const double axis[3] = { 1 / sqrt(14), 2 / sqrt(14), 3 / sqrt(14) };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[i][j] = (i == j ? cosine : 0) + (1 - cosine) * axis[i] * axis[j];
    for (int k = 0; k < 3; k++) {
        m[(k + 1) % 3][(k + 2) % 3] -= sine * axis[k];
        m[(k + 2) % 3][(k + 1) % 3] += sine * axis[k];
    }
}

/* The motion of a model that fills its volume once it is turned. */
static VoxelMotion turned_motion(const GpMesh *mesh, double turn, uint32_t size)
{
    double m[3][3];
    float *turned = gp_alloc(mesh->vertex_count, 3 * sizeof *turned);
    assert_non_null(turned);
    rotation(turn, m);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const float *p = mesh->positions + 3 * i;
        for (int k = 0; k < 3; k++)
            turned[3 * i + (size_t)k] =
                (float)(m[k][0] * (double)p[0] + m[k][1] * (double)p[1] + m[k][2] * (double)p[2]);
    }
    const VoxelBox box = voxel_box(turned, mesh->indices, 3 * mesh->triangle_count, size);
    VoxelMotion motion = voxel_still(&box);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            motion.to_voxels[i][j] = (float)(m[i][j] * box.scale);
    gp_free(turned);
    return motion;
}

static void place_vertex(const VoxelModel *model, uint32_t vertex, double place[3])
{
    const float *p = model->positions + 3 * (size_t)vertex;
    for (int k = 0; k < 3; k++) {
        const float *row = model->motion.to_voxels[k];
        place[k] = (double)row[0] * (double)p[0] + (double)row[1] * (double)p[1] +
                   (double)row[2] * (double)p[2] + (double)row[3];
    }
}

/* Of a scene, which it takes over. */
static VoxelCase make_case(const VoxelScene *scene, const VoxelMotion *motion, uint32_t size)
{
    const VoxelBox same = { .size = size, .scale = 1 };
    VoxelCase c = { .scene = *scene, .size = size };
    GpMesh *mesh = &c.scene.mesh;
    if (!mesh->colors)
        mesh->colors = gp_alloc(mesh->vertex_count, 4 * sizeof *mesh->colors);
    c.triangles = gp_alloc(mesh->triangle_count, sizeof *c.triangles);
    assert_true(mesh->colors && c.triangles);
    c.model = voxel_scene_model(&c.scene, &same);
    c.model.motion = *motion;
    for (uint32_t i = 0; i < 3 * mesh->triangle_count; i++)
        place_vertex(&c.model, mesh->indices[i], c.triangles[i / 3].corner[i % 3]);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        double place[3];
        place_vertex(&c.model, i, place);
        for (size_t k = 0; k < 3; k++)
            mesh->colors[4 * (size_t)i + k] = (float)(place[k] / size);
        mesh->colors[4 * (size_t)i + 3] = 1;
    }
    return c;
}

VoxelCase voxel_case_open(const char *name, double turn, uint32_t size)
{
    char path[400];
    GpError error = { "" };
    VoxelScene scene;
    if (!strchr(name, '.'))
        snprintf(path, sizeof path, "builtin:%s", name);
    else if (gp_data_find(name, path, sizeof path, &error))
        skip();
    if (voxel_scene_open(path, &scene, &error))
        fail_msg("%s", error.text);
    const VoxelMotion motion = turned_motion(&scene.mesh, turn, size);
    return make_case(&scene, &motion, size);
}

VoxelCase voxel_case_of(const float *corners, uint32_t triangle_count, uint32_t size)
{
    const VoxelBox same = { .size = size, .scale = 1 };
    const VoxelMotion motion = voxel_still(&same);
    const size_t bytes = 9 * (size_t)triangle_count * sizeof *corners;
    VoxelScene scene = { .mesh = { .positions = gp_alloc(bytes, 1),
                                   .indices = gp_alloc(triangle_count, 3 * sizeof(uint32_t)),
                                   .vertex_count = 3 * triangle_count,
                                   .triangle_count = triangle_count } };
    assert_true(scene.mesh.positions && scene.mesh.indices);
    memcpy(scene.mesh.positions, corners, bytes);
    for (uint32_t i = 0; i < 3 * triangle_count; i++)
        scene.mesh.indices[i] = i;
    return make_case(&scene, &motion, size);
}

void voxel_case_free(VoxelCase *c)
{
    voxel_scene_close(&c->scene);
    gp_free(c->triangles);
    *c = (VoxelCase){ .size = 0 };
}

/* --- volumes ---------------------------------------------------------------------------------- */

static uint64_t count_voxels(const uint8_t *voxels, uint32_t size, uint32_t bits)
{
    uint64_t count = 0;
    if (bits == 1)
        return voxel_count(voxels, size);
    for (size_t i = 0; i < (size_t)size * size * size; i++)
        count += bits == 8 ? voxels[i] != 0 : (voxels[2 * i] | voxels[2 * i + 1]) != 0;
    return count;
}

static void draw_volume(VoxelDraw *draw, const void *context, uint32_t size, uint32_t bits,
                        bool everywhere, uint8_t *voxels)
{
    Frame frame = { .color = NULL };
    const FlatTexture flat = flat_texture_make(&frame, size, bits);
    draw(context, &frame, &flat);
    if (everywhere)
        run_everywhere(&frame);
    else
        run_list(&frame.list);
    flat_texture_read(&flat, voxels);
    /* none beyond its end */
    assert_int_equal(flat_texture_count(&flat), count_voxels(voxels, size, bits));
    frame_free(&frame);
}

void voxel_run(VoxelDraw *draw, const void *context, uint32_t size, bool everywhere, uint8_t *bits)
{
    draw_volume(draw, context, size, 1, everywhere, bits);
}

typedef struct Build {
    const VoxelModel *model;
    const VoxelSetting *setting;
} Build;

static void build(const void *context, Frame *frame, const FlatTexture *flat)
{
    const Build *b = context;
    GpError error = { "" };
    if (voxel_draw(b->model, b->setting, frame, flat, &error))
        fail_msg("%s", error.text);
}

void voxel_case_draw(const VoxelCase *c, const VoxelSetting *setting, bool everywhere,
                     uint8_t *voxels)
{
    const Build both = { &c->model, setting };
    assert_int_equal(setting->size, c->size);
    draw_volume(build, &both, c->size, setting->bits, everywhere, voxels);
}

uint8_t *voxel_case_volume(const VoxelCase *c, const VoxelSetting *setting)
{
    uint8_t *voxels = gp_alloc(voxel_bytes(c->size), setting->bits);
    assert_non_null(voxels);
    voxel_case_draw(c, setting, false, voxels);
    return voxels;
}

uint8_t *voxel_read(const FlatTexture *flat)
{
    uint8_t *voxels = gp_alloc(flat_texture_bytes(flat), 1);
    assert_non_null(voxels);
    flat_texture_read(flat, voxels);
    return voxels;
}

/* --- voxels ----------------------------------------------------------------------------------- */

bool voxel_at(const uint8_t *bits, uint32_t size, uint32_t x, uint32_t y, uint32_t z)
{
    const size_t i = x + size * (y + size * (size_t)z);
    return bits[i / 8] >> i % 8 & 1;
}

uint64_t voxel_count_range(const FlatTexture *flat, const VoxelRange *range)
{
    uint8_t *bits = voxel_read(flat);
    uint64_t count = 0;
    for (uint32_t z = range->low[2]; z < range->end[2]; z++)
        for (uint32_t y = range->low[1]; y < range->end[1]; y++)
            for (uint32_t x = range->low[0]; x < range->end[0]; x++)
                count += voxel_at(bits, flat->size, x, y, z);
    gp_free(bits);
    return count;
}

uint64_t voxel_count_without(const uint8_t *a, const uint8_t *b, uint32_t size)
{
    uint64_t count = 0;
    for (size_t i = 0; i < voxel_bytes(size); i++)
        count += (uint64_t)__builtin_popcount(a[i] & ~b[i] & 0xff);
    return count;
}
