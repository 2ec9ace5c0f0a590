/* Interpolation: barycentrics, depth, clip distances and varyings at the centres of a quad.
 * in: the set-up triangle or sprite and the quad's edge values; out: depth, varyings, and the mask
 * where user planes cut. Rules R11, R12, R16, R18; nothing is stepped from pixel to pixel. */
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

/* Screen-linear share of a corner: an exact integer over an exact integer, with one rounding
 * for each and one for the product, however thin the triangle is. */
static float screen_share(const GpTriangle *t, const GpQuad *quad, int corner, int pixel)
{
    return (float)quad->edge[corner][pixel] * t->inverse_area;
}

/* A corner's share is E_i rw_i over the sum of all three: terms of one sign, of which none is a
 * difference, so that each share keeps its digits however far the corners are apart. */
void gp_interpolate_barycentrics(const GpTriangle *t, GpQuad *quad)
{
    const int first = t->nearest, second = (first + 1) % 3, third = (first + 2) % 3;
    const float ratio1 = t->rw_ratio[0], ratio2 = t->rw_ratio[1];
    const bool even = ratio1 == 1.0f && ratio2 == 1.0f;
    for (int pixel = 0; pixel < 4; pixel++) {
        const float part0 = (float)quad->edge[first][pixel];
        const float part1 = (float)quad->edge[second][pixel] * ratio1;
        const float part2 = (float)quad->edge[third][pixel] * ratio2;
        const float w = 1.0f / (part0 + (part1 + part2)); /* the only reciprocal of the pixel */
        quad->barycentric[first][pixel] = even ? screen_share(t, quad, first, pixel) : part0 * w;
        quad->barycentric[second][pixel] = even ? screen_share(t, quad, second, pixel) : part1 * w;
        quad->barycentric[third][pixel] = even ? screen_share(t, quad, third, pixel) : part2 * w;
    }
}

/* v0 + (s1 (v1 - v0) + s2 (v2 - v0)), from the nearest corner on: equal corner values come out
 * unchanged, bit for bit. */
static float blend_corners(const GpTriangle *t, const float v[3], const float share[3])
{
    const int first = t->nearest, second = (first + 1) % 3, third = (first + 2) % 3;
    return v[first] +
           (share[second] * (v[second] - v[first]) + share[third] * (v[third] - v[first]));
}

void gp_interpolate_clip(const GpTriangle *t, unsigned planes, GpQuad *quad)
{
    for (int i = 0; i < GP_MAX_CLIP_PLANES; i++) {
        if (!(planes >> i & 1))
            continue;
        for (int pixel = 0; pixel < 4; pixel++) {
            float distance[3], share[3];
            for (int k = 0; k < 3; k++) {
                distance[k] = t->corner[k].clip_distance[i];
                share[k] = quad->barycentric[k][pixel];
            }
            if (!(blend_corners(t, distance, share) >= 0))
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
        const float v[3] = { t->corner[0].varying[c], t->corner[1].varying[c],
                             t->corner[2].varying[c] };
        const bool on_screen = modes->mode[c] == GP_LINEAR_SCREEN;
        for (int pixel = 0; pixel < 4; pixel++) {
            float share[3];
            for (int k = 0; k < 3; k++)
                share[k] =
                    on_screen ? screen_share(t, quad, k, pixel) : quad->barycentric[k][pixel];
            quad->varying[c][pixel] = modes->mode[c] == GP_FLAT ? v[0] : blend_corners(t, v, share);
        }
    }
}

void gp_interpolate_on_screen(const GpTriangle *t, const GpVaryingModes *modes, GpQuad *quad)
{
    GpVaryingModes linear = *modes;
    for (int c = 0; c < modes->components; c++)
        linear.mode[c] = modes->mode[c] == GP_FLAT ? GP_FLAT : GP_LINEAR_SCREEN;
    for (int k = 0; k < 3; k++)
        for (int pixel = 0; pixel < 4; pixel++)
            quad->barycentric[k][pixel] = screen_share(t, quad, k, pixel);
    gp_interpolate_varyings(t, &linear, ~(uint64_t)0, quad);
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
