/* Output: reads what render targets hold under a quad, and stores its colours with the write mask.
 * in: a surface, the quad's colours and mask; out: linear floats, or the stored texels. Rules R24,
 * R27, R31, R37. */
#include "pipeline/units/output.h"

static uint8_t *texel_under(const GpSurface *surface, const GpQuad *quad, int pixel)
{
    return gp_surface_texel(&surface->level[0], gp_format_info(surface->format)->bytes,
                            (uint32_t)(quad->x + pixel % 2), (uint32_t)(quad->y + pixel / 2));
}

void gp_output_load(const GpSurface *surface, int target, GpQuad *quad)
{
    for (int pixel = 0; pixel < 4; pixel++) {
        if (!(quad->mask >> pixel & 1))
            continue;
        float rgba[4];
        gp_texel_load(surface->format, texel_under(surface, quad, pixel), rgba);
        for (int c = 0; c < 4; c++)
            quad->destination[target][c][pixel] = rgba[c];
    }
}

void gp_output_clear(GpSurface *surface, unsigned keep, const GpQuad *quad)
{
    static const float nothing[4] = { 0 };
    for (int pixel = 0; pixel < 4; pixel++)
        if (quad->replaced >> pixel & 1)
            gp_texel_store(surface->format, texel_under(surface, quad, pixel), nothing, keep);
}

void gp_output_store(GpSurface *surface, int target, unsigned keep, const GpQuad *quad)
{
    for (int pixel = 0; pixel < 4; pixel++) {
        if (!(quad->mask >> pixel & 1))
            continue;
        float rgba[4];
        for (int c = 0; c < 4; c++)
            rgba[c] = quad->color[target][c][pixel];
        gp_texel_store(surface->format, texel_under(surface, quad, pixel), rgba, keep);
    }
}
