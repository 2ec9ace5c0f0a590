/* Interpolation: barycentrics, depth, clip distances and varyings at the centres of a quad.
 * in: the set-up triangle or sprite and the quad's edge values; out: depth, varyings, and the mask where
 * user planes cut. Rules R11, R12, R16, R18; nothing is stepped from pixel to pixel. */
#include "pipeline/units/interpolate.h"

GpVaryingModes gp_varying_modes(const GpProgram *program)
{
    GpVaryingModes modes = { .sprite = -1 };
    for (size_t i = 0; i < GP_COUNT(program->varyings) && program->varyings[i].components; i++) {
        const GpVaryingDecl *varying = &program->varyings[i];
        const bool sprite = varying->mode == GP_SPRITE_COORD;
        if (sprite)
            modes.sprite = modes.components;
        for (int c = 0; c < varying->components; c++) {
            const uint64_t bit = (uint64_t)1 << modes.components;
            modes.flat |= varying->mode == GP_FLAT ? bit : 0;
            modes.screen |= varying->mode == GP_LINEAR_SCREEN ? bit : 0;
            modes.mode[modes.components++] = sprite ? GP_PERSPECTIVE : varying->mode;
        }
    }
    return modes;
}

/* Screen-linear share of corner 1 or 2: an exact integer over an exact integer, with one rounding
 * for each and one for the product, however thin the triangle is. */
static float screen_share(const GpTriangle *t, const GpQuad *quad, int corner, int pixel)
{
    return (float)quad->edge[corner][pixel] * t->inverse_area;
}

void gp_interpolate_barycentrics(const GpTriangle *t, GpQuad *quad)
{
    float ratio1 = t->rw_ratio[0], ratio2 = t->rw_ratio[1];
    for (int pixel = 0; pixel < 4; pixel++) {
        float l1 = screen_share(t, quad, 1, pixel), l2 = screen_share(t, quad, 2, pixel);
        /* 1/w over that of corner 0; the only reciprocal of the pixel */
        float rw = 1.0f + (l1 * (ratio1 - 1.0f) + l2 * (ratio2 - 1.0f));
        float w = 1.0f / rw;
        quad->barycentric[1][pixel] = l1 * ratio1 * w;
        quad->barycentric[2][pixel] = l2 * ratio2 * w;
        quad->barycentric[0][pixel] =
            1.0f - (quad->barycentric[1][pixel] + quad->barycentric[2][pixel]);
    }
}

/* v0 + (s1 (v1 - v0) + s2 (v2 - v0)): equal corner values come out unchanged, bit for bit. */
static float blend_corners(float v0, float v1, float v2, float s1, float s2)
{
    return v0 + (s1 * (v1 - v0) + s2 * (v2 - v0));
}

void gp_interpolate_clip(const GpTriangle *t, unsigned planes, GpQuad *quad)
{
    for (int i = 0; i < GP_MAX_CLIP_PLANES; i++) {
        if (!(planes >> i & 1))
            continue;
        for (int pixel = 0; pixel < 4; pixel++) {
            float distance =
                blend_corners(t->corner[0].clip_distance[i], t->corner[1].clip_distance[i],
                              t->corner[2].clip_distance[i], quad->barycentric[1][pixel],
                              quad->barycentric[2][pixel]);
            if (!(distance >= 0))
                quad->mask &= ~(1u << pixel);
        }
    }
}

static float clamp_depth(float depth, float low, float high)
{
    return depth < low ? low : depth > high ? high : depth;
}

void gp_interpolate_depth(const GpTriangle *t, float min_depth, float max_depth, GpQuad *quad)
{
    for (int pixel = 0; pixel < 4; pixel++) {
        double depth = t->z_base + ((double)quad->edge[1][pixel] * t->z_step[0] +
                                    (double)quad->edge[2][pixel] * t->z_step[1]);
        quad->depth[pixel] = clamp_depth((float)depth, min_depth, max_depth);
    }
}

void gp_interpolate_varyings(const GpTriangle *t, const GpVaryingModes *modes, uint64_t wanted,
                             GpQuad *quad)
{
    for (int c = 0; c < modes->components; c++) {
        if (!(wanted >> c & 1))
            continue;
        float v0 = t->corner[0].varying[c];
        float v1 = t->corner[1].varying[c], v2 = t->corner[2].varying[c];
        for (int pixel = 0; pixel < 4; pixel++) {
            float *value = &quad->varying[c][pixel];
            if (modes->mode[c] == GP_FLAT)
                *value = v0;
            else if (modes->mode[c] == GP_LINEAR_SCREEN)
                *value = blend_corners(v0, v1, v2, screen_share(t, quad, 1, pixel),
                                       screen_share(t, quad, 2, pixel));
            else
                *value = blend_corners(v0, v1, v2, quad->barycentric[1][pixel],
                                       quad->barycentric[2][pixel]);
        }
    }
}

void gp_interpolate_sprite(const GpPointSprite *s, const GpVaryingModes *modes, float min_depth,
                           float max_depth, GpQuad *quad)
{
    float per_step = 1.0f / (float)(s->right - s->left);
    for (int pixel = 0; pixel < 4; pixel++) {
        quad->depth[pixel] = clamp_depth(s->center.z, min_depth, max_depth);
        for (int c = 0; c < modes->components; c++)
            quad->varying[c][pixel] = s->center.varying[c];
        if (modes->sprite < 0)
            continue;
        int32_t center_x = (quad->x + pixel % 2) * GP_SUBPIXELS + GP_SUBPIXELS / 2;
        int32_t center_y = (quad->y + pixel / 2) * GP_SUBPIXELS + GP_SUBPIXELS / 2;
        quad->varying[modes->sprite][pixel] = (float)(center_x - s->left) * per_step;
        quad->varying[modes->sprite + 1][pixel] = (float)(center_y - s->top) * per_step;
    }
}
