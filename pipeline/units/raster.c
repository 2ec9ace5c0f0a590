/* Rasterizer: walks over the quads of a primitive's box and asks which pixel centres are inside.
 * in: the exact edge functions of set-up; out: quads with their masks and edge values. Rules R5,
 * R9; sprites R12. */
#include "pipeline/units/raster.h"

static GpRasterWalk walk_box(int32_t x0, int32_t y0, int32_t x1, int32_t y1)
{
    return (GpRasterWalk){
        .x0 = x0,
        .y0 = y0,
        .x1 = x1,
        .y1 = y1,
        .x = x0 & ~1,
        .y = y0 & ~1,
    };
}

GpRasterWalk gp_raster_triangle(const GpTriangle *t)
{
    GpRasterWalk walk = walk_box(t->x0, t->y0, t->x1, t->y1);
    walk.triangle = t;
    return walk;
}

GpRasterWalk gp_raster_sprite(const GpPointSprite *s)
{
    GpRasterWalk walk = walk_box(s->x0, s->y0, s->x1, s->y1);
    walk.sprite = s;
    return walk;
}

static bool inside_box(const GpRasterWalk *walk, int32_t x, int32_t y)
{
    return x >= walk->x0 && x <= walk->x1 && y >= walk->y0 && y <= walk->y1;
}

static void cover(const GpRasterWalk *walk, GpQuad *quad)
{
    const GpTriangle *t = walk->triangle;
    quad->mask = 0;
    for (int pixel = 0; pixel < 4; pixel++) {
        int32_t x = quad->x + pixel % 2, y = quad->y + pixel / 2;
        bool inside = inside_box(walk, x, y);
        for (int i = 0; t && i < 3; i++) {
            int64_t center_x = (int64_t)x * GP_SUBPIXELS + GP_SUBPIXELS / 2;
            int64_t center_y = (int64_t)y * GP_SUBPIXELS + GP_SUBPIXELS / 2;
            int64_t edge = t->a[i] * center_x + t->b[i] * center_y + t->c[i];
            quad->edge[i][pixel] = edge;
            inside = inside && (edge > 0 || (edge == 0 && t->accepts_zero[i]));
        }
        quad->mask |= (unsigned)inside << pixel;
    }
}

bool gp_raster_next(GpRasterWalk *walk, GpQuad *quad)
{
    while (walk->y <= walk->y1) {
        quad->x = walk->x;
        quad->y = walk->y;
        walk->x += 2;
        if (walk->x > walk->x1) {
            walk->x = walk->x0 & ~1;
            walk->y += 2;
        }
        cover(walk, quad);
        if (quad->mask) {
            quad->front = walk->sprite || walk->triangle->front;
            return true;
        }
    }
    return false;
}
