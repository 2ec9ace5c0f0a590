#include "apps/volumes/drawing/raycast_volume.h"

#include "shaders_c/volume/raycast.h"

#include <string.h>

_Static_assert((int)VOLUME_BRICK == (int)BRICK_SIDE, "bricks are those of the shader");

/* --- flat textures ---------------------------------------------------------------------------- */

/* Patches of all ways, one way below the other. */
static GpResult make_runs(RaycastVolume *volume, GpError *error)
{
    const uint32_t *count = volume->bricks.count;
    volume->shown = gp_alloc(bricks_total(&volume->bricks) + 1, 1);
    if (!volume->shown)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    if (bricks_total(&volume->bricks) == 0)
        return GP_OK;
    const uint32_t columns = atlas_columns(count[0], count[1] * BRICK_WAYS, count[2]);
    GP_ASSERT(columns > 0);
    volume->columns = columns;
    return gp_surface_create(
        &(GpSurfaceDesc){ .format = GP_R8,
                          .width = columns * count[0],
                          .height = (count[2] + columns - 1) / columns * count[1] * BRICK_WAYS,
                          .name = "bricks" },
        &volume->runs, error);
}

GpResult raycast_find_runs(RaycastVolume *volume, unsigned ways, GpError *error)
{
    const Bricks *bricks = &volume->bricks;
    const uint32_t *count = bricks->count, rows = volume->runs->height / count[1] / BRICK_WAYS;
    uint8_t *runs = gp_alloc(bricks_total(bricks), 1);
    GpResult result = runs ? GP_OK : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (unsigned way = 0; way < BRICK_WAYS && !result; way++) {
        if (volume->known >> way & 1 || !(ways >> way & 1))
            continue;
        result = bricks_runs(bricks, volume->shown, way, runs, error);
        const uint8_t *from = runs;
        const uint32_t first = way * rows * volume->columns;
        for (uint32_t z = 0; z < count[2] && !result; z++)
            for (uint32_t y = 0; y < count[1]; y++, from += count[0])
                memcpy(atlas_texel(volume->runs, volume->columns, count, 0, y, first + z), from,
                       count[0]);
        volume->known |= result ? 0 : 1u << way;
    }
    gp_free(runs);
    return result;
}

GpResult raycast_open(const Field *field, RaycastVolume *volume, GpError *error)
{
    RaycastVolume made = { .field = field };
    GpResult result = volume_atlas_make(field->value, field->size, &made.atlas, error);
    if (!result)
        result = bricks_make(field, &made.bricks, error);
    if (!result)
        result = make_runs(&made, error);
    if (result) {
        raycast_close(&made);
        return result;
    }
    *volume = made;
    return GP_OK;
}

void raycast_close(RaycastVolume *volume)
{
    volume_atlas_free(&volume->atlas);
    gp_surface_destroy(&volume->runs);
    gp_free(volume->shown);
    bricks_free(&volume->bricks);
    *volume = (RaycastVolume){ .field = NULL };
}

void raycast_classify(RaycastVolume *volume, const Transfer *transfer)
{
    volume->transfer = *transfer;
    volume->known = 0;
    bricks_show(&volume->bricks, transfer, volume->shown);
}
