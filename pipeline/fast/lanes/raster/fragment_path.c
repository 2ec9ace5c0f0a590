/* Fragment paths: to the visibility buffer, queued for the shader, or only tested. */
#include "pipeline/fast/lanes/raster/fragment_path.h"

static EarlyTest early_test(const Tile *tile, const FastDraw *d)
{
    const GpDepthState *depth = &d->draw->state.depth;
    if (!d->wants_depth)
        return EARLY_NONE;
    if (d->tests_last || d->repeated)
        return EARLY_ANY;
    const bool nearer = depth->test == GP_LESS || depth->test == GP_LESS_EQUAL;
    if (!nearer || !(depth->write || d->path == FAST_ORDERED) || d->needs.stencil ||
        d->needs.shader_depth || (d->needs.ternary && !d->packs_points))
        return EARLY_ANY;
    return tile->depth_format == GP_D32F ? EARLY_NEARER_FLOAT : EARLY_NEARER_UNORM;
}

Filler fast_filler(Tile *tile)
{
    const FastDraw *d = tile->draw;
    return (Filler){ .tile = tile,
                     .d = d,
                     .early = early_test(tile, d),
                     .low = d->viewport.min_depth,
                     .high = d->viewport.max_depth,
                     .scale = tile->depth_format == GP_D16 ? 65535.0 : 16777215.0,
                     .allowance = d->draw->state.depth.test == GP_LESS_EQUAL,
                     .writes = d->draw->state.depth.write && !d->late_depth };
}
