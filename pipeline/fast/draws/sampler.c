#include "pipeline/fast/draws/sampler.h"

#include "pipeline/units/texture.h"
#include "pipeline/units/texture_address.h"

static void prepare_border(const GpTexture *texture, FastSampler *s)
{
    uint8_t texel[16], code[4], stencil;

    gp_texture_border(texture, texel);
    gp_texel_load(s->format, texel, s->border);
    if (s->sampling == FAST_COMPARE) {
        gp_depth_load(s->format, texel, &s->border_code, &stencil);
    } else if (s->sampling == FAST_CODES) {
        gp_texel_codes(s->format, texel, code);
        s->border_code = s->shift == 0 ? code[0]
                                       : (uint32_t)code[3] << 24 | (uint32_t)code[0] << 16 |
                                             (uint32_t)code[1] << 8 | code[2];
    }
}

void fast_prepare_sampler(const GpTexture *texture, FastSampler *sampler)
{
    const GpSampler *from = &texture->sampler;
    const GpSurface *surface = texture->surface;

    *sampler = (FastSampler){ .surface = surface, .sampling = FAST_UNBOUND };
    if (!surface)
        return;
    const GpFormatInfo *info = gp_format_info(surface->format);
    GP_ASSERT(!from->compare || info->is_depth);

    sampler->format = surface->format;
    sampler->sampling = from->compare ? FAST_COMPARE : info->is_unorm8 ? FAST_CODES : FAST_FLOATS;
    sampler->channels = info->is_depth ? 1 : info->channels;
    while (1 << sampler->shift < info->bytes)
        sampler->shift++;
    sampler->min = from->min;
    sampler->mag = from->mag;
    sampler->mip = surface->levels == 1 ? GP_MIP_NONE : from->mip;
    sampler->address_u = from->address_u;
    sampler->address_v = from->address_v;
    sampler->lod_bias = from->lod_bias;
    sampler->min_lod = from->min_lod;
    sampler->max_lod = gp_sampler_max_lod(from);
    /* Without mip levels the level does not depend on the level of detail, so that of 0 will do. */
    if (sampler->mip == GP_MIP_NONE)
        sampler->level =
            surface->levels == 1 ? 0 : gp_level_pair(from, surface->levels, 0.0f).first;
    sampler->one_level = sampler->mip == GP_MIP_NONE && from->min == from->mag;
    for (uint32_t i = 0; i < surface->levels; i++) {
        const GpLevel *level = &surface->level[i];
        sampler->levels[i] = (FastLevel){
            .texels = level->texels,
            .pitch = (int32_t)level->pitch,
            .width = (int32_t)level->width,
            .height = (int32_t)level->height,
            .scale_u = 256.0f * (float)level->width,
            .scale_v = 256.0f * (float)level->height,
        };
    }
    sampler->has_border = from->address_u == GP_BORDER || from->address_v == GP_BORDER;
    if (sampler->has_border)
        prepare_border(texture, sampler);
}
