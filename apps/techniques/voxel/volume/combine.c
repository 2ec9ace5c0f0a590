/* Constructive solid geometry by blending, a flat texture over another. */
#include "apps/techniques/voxel/volume/combine.h"

#include "shaders_c/common/texel_copy.h"

#include <string.h>

static void begin_pass(Frame *frame, const char *name, const FlatTexture *flat)
{
    flat_texture_pass(frame, name, flat)->color[0].clear = false;
}

/* Begins the pass that draws the result. Passes without draws come before, to make the operands
 * targets of its neighbours: tiles hold those, and read in place what they hold; all else would be
 * read texel by texel. */
static void begin_result(Frame *frame, const char *name, const FlatTexture *a, const FlatTexture *b,
                         const FlatTexture *result)
{
    begin_pass(frame, "operand", b);
    if (a->texels != result->texels)
        begin_pass(frame, "operand", a);
    begin_pass(frame, name, result);
}

static bool are_alike(const FlatTexture *a, const FlatTexture *b)
{
    return a->size == b->size && a->bits == b->bits && a->texels->width == b->texels->width &&
           a->texels->height == b->texels->height;
}

void voxel_combine(Frame *frame, const FlatTexture *a, const FlatTexture *b, VoxelCombine operation,
                   const FlatTexture *result)
{
    static const struct {
        const GpProgram *program;
        GpBlendOp bits, bytes;
    } ways[] = {
        [VOXEL_UNION] = { &texel_copy_program, GP_BLEND_LOGIC_OR, GP_BLEND_MAX },
        [VOXEL_INTERSECTION] = { &texel_copy_program, GP_BLEND_LOGIC_AND, GP_BLEND_MIN },
        [VOXEL_DIFFERENCE] = { &texel_complement_program, GP_BLEND_LOGIC_AND, GP_BLEND_MIN },
    };
    const bool in_place = a->texels == result->texels;
    if (frame_result(frame, NULL))
        return;
    GP_ASSERT(a->bits != 16 && are_alike(a, b) && are_alike(a, result));
    GP_ASSERT(b->texels != result->texels);
    begin_result(frame, "combine", a, b, result);
    if (!in_place)
        flat_texture_blend(frame, &texel_copy_program, a->texels, GP_BLEND_OFF);
    flat_texture_blend(frame, ways[operation].program, b->texels,
                       a->bits == 1 ? ways[operation].bits : ways[operation].bytes);
}

/* --- collision -------------------------------------------------------------------------------- */

/* The range's rectangle on the patch of a slab. */
static void cut_to_slab(GpRasterState *raster, const FlatTexture *flat, const VoxelRange *range,
                        uint32_t slab)
{
    const GpViewport patch = flat_texture_patch(flat, slab);
    const int32_t left = (int32_t)patch.x, top = (int32_t)patch.y;
    raster->scissor = true;
    raster->scissor_x0 = left + (int32_t)range->low[0];
    raster->scissor_x1 = left + (int32_t)range->end[0];
    raster->scissor_y0 = top + (int32_t)range->low[1];
    raster->scissor_y1 = top + (int32_t)range->end[1];
}

void voxel_collide(Frame *frame, const FlatTexture *a, const FlatTexture *b,
                   const VoxelRange *common, const FlatTexture *result)
{
    if (frame_result(frame, NULL))
        return;
    GP_ASSERT(a->bits == 1 && are_alike(a, b) && are_alike(a, result));
    GP_ASSERT(b->texels != result->texels);
    if (voxel_range_is_empty(common))
        return;
    begin_result(frame, "collide", a, b, result);
    for (uint32_t slab = common->low[2] / 32; slab * 32 < common->end[2]; slab++) {
        GpDraw *draw;
        if (a->texels != result->texels) {
            draw = flat_texture_blend(frame, &texel_copy_program, a->texels, GP_BLEND_OFF);
            cut_to_slab(&draw->state.raster, result, common, slab);
        }
        draw = flat_texture_blend(frame, &texel_copy_program, b->texels, GP_BLEND_LOGIC_AND);
        cut_to_slab(&draw->state.raster, result, common, slab);
    }
}
