#include "tests/support/view_case.h"

#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

void view_case_begin(Frame *frame)
{
    *frame = (Frame){ .color = NULL };
}

void view_case_put(const FlatTexture *flat, uint32_t x, uint32_t y, uint32_t z)
{
    uint8_t *texel = flat_texture_texel(flat, z / 32, x, y);
    texel[z % 32 / 8] = (uint8_t)(texel[z % 32 / 8] | 1u << z % 8);
}

bool view_case_get(const FlatTexture *flat, const uint32_t voxel[3])
{
    const uint8_t *texel = flat_texture_texel(flat, voxel[2] / 32, voxel[0], voxel[1]);
    return texel[voxel[2] % 32 / 8] >> voxel[2] % 8 & 1;
}

FlatTexture view_case_random(Frame *frame, uint32_t size, int32_t rarity, uint64_t seed)
{
    const FlatTexture flat = flat_texture_make(frame, size, 1);
    Random random = { seed };
    for (uint32_t i = 0; i < size * size * size; i++)
        if (random_int(&random, 1, rarity) == 1)
            view_case_put(&flat, i % size, i / size % size, i / size / size);
    return flat;
}

Camera view_case_camera(uint32_t size, double x, double y, double z, double distance, double fovy)
{
    Camera camera = { .up = { 0.1, 1, 0.2 },
                      .fovy = fovy,
                      .height = 1.9 * size,
                      .near = 0.01 * size,
                      .far = 8.0 * size };
    const double length = sqrt(x * x + y * y + z * z), way[3] = { x, y, z };
    for (int k = 0; k < 3; k++) {
        camera.at[k] = size / 2.0;
        camera.eye[k] = size / 2.0 + way[k] / length * distance * size;
    }
    return camera;
}

void view_case_draw(Frame *frame, const FlatTexture *flat, const VoxelView *view)
{
    GpError error = { "" };
    if (voxel_view_build(flat, view, VIEW_CASE_SIDE, VIEW_CASE_SIDE, frame, &error))
        fail_msg("%s", error.text);
    run_list(&frame->list);
}

void view_case_pixel(const Frame *frame, const char *pass, int x, int y, float rgba[4])
{
    for (uint32_t i = 0; i < frame->list.pass_count; i++)
        if (!strcmp(frame->list.passes[i].name, pass)) {
            const GpSurface *surface = frame->list.passes[i].color[0].surface;
            gp_texel_load(surface->format,
                          gp_surface_texel(&surface->level[0],
                                           gp_format_info(surface->format)->bytes, (uint32_t)x,
                                           (uint32_t)y),
                          rgba);
            return;
        }
    fail_msg("no pass '%s'", pass);
}
