#include "tests/support/voxel_picture.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

enum { MORE = 2 }; /* passes and draws beside a picture's own */

void voxel_picture_begin(Work *work)
{
    *work = (Work){ .color = NULL };
    work_reserve(work, VOXEL_VIEW_PASSES + MORE, VOXEL_VIEW_DRAWS + MORE);
}

void voxel_picture_put(const Worksheet *sheet, uint32_t x, uint32_t y, uint32_t z)
{
    const uint32_t slab = z / 32;
    uint8_t *texel =
        gp_surface_texel(&sheet->texels->level[0], 4, slab % sheet->columns * sheet->size + x,
                         slab / sheet->columns * sheet->size + y);
    texel[z % 32 / 8] = (uint8_t)(texel[z % 32 / 8] | 1u << z % 8);
}

bool voxel_picture_get(const Worksheet *sheet, const uint32_t voxel[3])
{
    const uint32_t slab = voxel[2] / 32;
    const uint8_t *texel = gp_surface_texel(&sheet->texels->level[0], 4,
                                            slab % sheet->columns * sheet->size + voxel[0],
                                            slab / sheet->columns * sheet->size + voxel[1]);
    return texel[voxel[2] % 32 / 8] >> voxel[2] % 8 & 1;
}

Worksheet voxel_picture_random(Work *work, uint32_t size, int32_t rarity, uint64_t seed)
{
    const Worksheet sheet = worksheet_make(work, size, 1);
    Random random = { seed };
    for (uint32_t i = 0; i < size * size * size; i++)
        if (random_int(&random, 1, rarity) == 1)
            voxel_picture_put(&sheet, i % size, i / size % size, i / size / size);
    return sheet;
}

Camera voxel_picture_camera(uint32_t size, double x, double y, double z, double distance,
                            double fovy)
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

static void run_list(const GpList *list)
{
    GpDevice *device;
    GpError error = { "" };
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ 0 }, &device, &error), GP_OK);
    if (gp_device_run(device, list, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&device);
}

void voxel_picture_draw(Work *work, const Worksheet *sheet, const VoxelView *view)
{
    GpError error = { "" };
    if (voxel_view_build(sheet, view, VOXEL_PICTURE_SIDE, VOXEL_PICTURE_SIDE, work, &error))
        fail_msg("%s", error.text);
    run_list(&work->list);
}

void voxel_picture_pixel(const Work *work, const char *pass, int x, int y, float rgba[4])
{
    for (uint32_t i = 0; i < work->list.pass_count; i++)
        if (!strcmp(work->list.passes[i].name, pass)) {
            const GpSurface *surface = work->list.passes[i].color[0].surface;
            gp_texel_load(surface->format,
                          gp_surface_texel(&surface->level[0],
                                           gp_format_info(surface->format)->bytes, (uint32_t)x,
                                           (uint32_t)y),
                          rgba);
            return;
        }
    fail_msg("no pass '%s'", pass);
}
