/* A batch of triangles: set up side by side, filled one by one, in their order. */
#include "pipeline/fast/lanes/raster/batch.h"

#include "pipeline/units/input_assembly.h"

/* The long way, for triangles that are too large for lanes. */
static void fill_alone(Tile *tile, uint32_t primitive)
{
    const FastDraw *d = tile->draw;
    const GpRect rect = fast_tile_rect(tile, d);
    uint32_t number[3];
    GpScreenVertex corner[3];
    GpTriangle triangle;
    gp_assemble(&d->draw->geometry, primitive - d->first_primitive, number);
    for (int k = 0; k < 3; k++)
        fast_corner_of(d, number[k], &corner[k]);
    if (gp_setup_triangle(corner, &d->draw->state.raster, &rect, &triangle) == GP_SETUP_DRAWN)
        fast_fill_triangle(tile, &triangle);
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
