/* A batch of triangles: set up side by side, filled one by one, in their order. */
#include "pipeline/fast/lanes/raster/fill_triangles.h"

#include "pipeline/fast/lanes/raster/fill.h"
#include "pipeline/fast/lanes/raster/hierarchical_depth.h"
#include "pipeline/fast/lanes/raster/sorted_triangles.h"

#include "pipeline/units/input_assembly.h"

/* A vertex of the draw, for the units that take one triangle at a time. */
static void load_corner(const FastDraw *d, uint32_t number, GpScreenVertex *corner)
{
    uint32_t at = number - d->first_vertex;
    const FastPosition *p = &d->positions[at];
    corner->x = p->x;
    corner->y = p->y;
    corner->z = p->z;
    corner->rw = p->rw;
    corner->varying = d->varyings + (size_t)at * d->stride;
    const float *distance = corner->varying + d->modes.components;
    for (int i = 0; i < GP_MAX_CLIP_PLANES; i++)
        if (d->needs.clip_planes >> i & 1)
            corner->clip_distance[i] = *distance++;
}

void fast_fill_corners(Tile *tile, const GpScreenVertex corner[3])
{
    GpTriangle triangle;
    const GpRect rect = fast_tile_rect(tile, tile->draw);
    if (gp_setup_triangle(corner, &tile->draw->draw->state.raster, &rect, &triangle) ==
        GP_SETUP_DRAWN)
        fast_fill_triangle(tile, &triangle);
}

/* The long way, for triangles that are too large for lanes. */
static void fill_alone(Tile *tile, uint32_t primitive)
{
    const FastDraw *d = tile->draw;
    uint32_t number[3];
    GpScreenVertex corner[3];
    gp_assemble(&d->draw->geometry, primitive - d->first_primitive, number);
    for (int k = 0; k < 3; k++)
        load_corner(d, number[k], &corner[k]);
    fast_fill_corners(tile, corner);
}

/* Lanes of `kind` that come before any other of those that are left. */
static unsigned run_of(unsigned kind, unsigned left)
{
    unsigned others = left & ~kind;
    return left & ~others & (others - 1);
}

static void fill_batch(const Filler *filler, const BatchCorners *corners)
{
    Tile *tile = filler->tile;
    TriangleBatch batch;
    fast_set_up_batch(filler, corners, &batch);
    unsigned left = batch.tiny | batch.small | batch.alone;
    if (!left)
        return;
    while (left) {
        unsigned tiny = run_of(batch.tiny, left), small = run_of(batch.small, left);
        if (tiny | small) {
            fast_fill_sorted(tile);
            fast_reserve_records(tile, GP_LANES);
        }
        if (tiny && tile->draw->path == FAST_ORDERED)
            fast_fill_compacted(filler, &batch, tiny);
        else if (tiny)
            fast_fill_tiny(filler, &batch, tiny);
        else if (small && tile->draw->one_color)
            fast_fill_one_color(filler, &batch, small);
        else if (small)
            fast_fill_small(filler, &batch, small);
        else
            fill_alone(tile, batch.primitives[__builtin_ctz(left)]);
        left &= ~(tiny | small ? tiny | small : left & -left);
    }
}

void fast_fill_triangles(Tile *tile, const uint32_t *primitives, uint32_t count)
{
    const Filler filler = fast_filler(tile);
    if (is_usual(filler.early))
        renew_hierarchical_depth(tile, count);
    if (covers_hide(&filler)) {
        const uint32_t hidden = fast_hidden_by_cover(tile, primitives, count);
        primitives += hidden;
        count -= hidden;
    }
    BatchCorners corners[2]; /* those of the next batch are found while this one is filled */
    fast_find_corners(tile->draw, primitives, count, &corners[0]);
    for (uint32_t batch = 0; count; batch++) {
        const BatchCorners *present = &corners[batch & 1];
        primitives += present->count;
        count -= present->count;
        if (count)
            fast_find_corners(tile->draw, primitives, count, &corners[~batch & 1]);
        fill_batch(&filler, present);
    }
}
