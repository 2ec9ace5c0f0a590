/* Texture reads of a packet: a level of detail for each lane from its quad, then a sample; and
 * reads of the pixel's own position. Rule R44. */
#include "pipeline/units/texture_read.h"

/* Difference of one coordinate across the quad that a lane belongs to. */
static float quad_dx(const float *value, int lane)
{
    int left = lane & ~1;
    return value[left + 1] - value[left];
}

static float quad_dy(const float *value, int lane)
{
    int upper = lane & ~2;
    return value[upper + 2] - value[upper];
}

static float lane_lod(const GpTexture *texture, const GpTextureRead *read, int lane)
{
    int lanes = read->lanes;
    const float *u = read->coord, *v = read->coord + lanes, *w = read->coord + 3 * lanes;
    if (read->mode == GP_LOD_EXPLICIT)
        return w[lane];

    float ddx[2], ddy[2];
    if (read->mode == GP_LOD_GRADIENT) {
        ddx[0] = read->gradient[lane];
        ddx[1] = read->gradient[lanes + lane];
        ddy[0] = read->gradient[2 * lanes + lane];
        ddy[1] = read->gradient[3 * lanes + lane];
    } else {
        ddx[0] = quad_dx(u, lane);
        ddx[1] = quad_dx(v, lane);
        ddy[0] = quad_dy(u, lane);
        ddy[1] = quad_dy(v, lane);
    }
    float lod = gp_texture_lod(ddx, ddy, texture->surface->width, texture->surface->height);
    return read->mode == GP_LOD_BIAS ? lod + w[lane] : lod;
}

void gp_texture_read(const GpTexture *texture, const GpTextureRead *read, int distinct,
                     GpSampleReport *reports)
{
    int lanes = read->lanes;
    for (int lane = 0; lane < lanes; lane++) {
        int source = lane % distinct;
        float rgba[4];
        if (lane < distinct) {
            float uvr[3] = { read->coord[lane], read->coord[lanes + lane],
                             read->coord[2 * lanes + lane] };
            float lod = texture->surface ? lane_lod(texture, read, lane) : 0;
            gp_texture_sample(texture, uvr, lod, rgba, reports ? &reports[lane] : NULL);
        }
        for (int c = 0; c < 4; c++)
            read->texel[c * lanes + lane] =
                lane < distinct ? rgba[c] : read->texel[c * lanes + source];
    }
}

void gp_read_texture_plain(const GpShaderCall *call, const GpTextureRead *read)
{
    gp_texture_read(&call->textures[read->slot], read, read->lanes, NULL);
}

void gp_read_local_plain(const GpShaderCall *call, int slot, int packet, int lanes, float *texel)
{
    const GpSurface *surface = call->textures[slot].surface;
    const GpRect *there = &surface->window;
    const float *x = call->pixel + packet * 2 * lanes, *y = x + lanes;
    for (int lane = 0; lane < lanes; lane++) {
        float rgba[4] = { 0, 0, 0, 0 };
        const int32_t column = (int32_t)x[lane], row = (int32_t)y[lane];
        if (column >= there->x0 && column < there->x1 && row >= there->y0 && row < there->y1)
            gp_texel_load(surface->format,
                          gp_surface_texel(&surface->level[0],
                                           gp_format_info(surface->format)->bytes, (uint32_t)column,
                                           (uint32_t)row),
                          rgba);
        for (int c = 0; c < 4; c++)
            texel[c * lanes + lane] = rgba[c];
    }
}
