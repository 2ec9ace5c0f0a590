/* Where two models lie in one volume, and the passes that put their voxels together. */
#include "apps/techniques/voxel/inputs/pair.h"

/* --- places ----------------------------------------------------------------------------------- */

/* A model's space in another's: p' = scale p + offset. */
typedef struct Similarity {
    double scale, offset[3];
} Similarity;

static Similarity place_beside(const VoxelPlace *place, const Bounds *bounds, const Bounds *other)
{
    const double side = bounds_longest(other), own = bounds_longest(bounds);
    Similarity to = { .scale = place->fit > 0 && own > 0 ? place->fit * side / own : 1 };
    for (int k = 0; k < 3; k++) {
        const double centre = (bounds->low[k] + bounds->high[k]) / 2;
        const double others = (other->low[k] + other->high[k]) / 2;
        to.offset[k] = place->move[k] * side;
        to.offset[k] += place->fit > 0 ? others - to.scale * centre : 0;
    }
    return to;
}

/* The box of a model whose space lies so in that of another, which has a box. */
static VoxelBox box_beside(const Similarity *to, const VoxelBox *other)
{
    VoxelBox box = { .size = other->size, .scale = other->scale * to->scale };
    for (int k = 0; k < 3; k++)
        box.offset[k] = other->scale * to->offset[k] + other->offset[k];
    return box;
}

static void place_two(const VoxelPair *pair, const Bounds bounds[2], uint32_t size,
                      VoxelBox boxes[2])
{
    const VoxelScene *first = pair->scenes[0];
    const Similarity to = place_beside(&pair->place, &bounds[1], &bounds[0]);
    Bounds both = bounds[0], moved;
    for (int k = 0; k < 3; k++) {
        moved.low[k] = to.scale * bounds[1].low[k] + to.offset[k];
        moved.high[k] = to.scale * bounds[1].high[k] + to.offset[k];
    }
    bounds_join(&both, &moved);
    boxes[0] = first->is_placed ? voxel_scene_box_around(first, &bounds[0], size)
                                : voxel_box_of(&both, size);
    boxes[1] = box_beside(&to, &boxes[0]);
}

/* In its volume, as beside a cube that fills it. */
static VoxelBox place_one(const VoxelPair *pair, const Bounds *bounds, uint32_t size)
{
    const VoxelScene *scene = pair->scenes[0];
    const double least = VOXEL_BOX_MARGIN, most = size - VOXEL_BOX_MARGIN;
    const Bounds cube = { { least, least, least }, { most, most, most } };
    if (scene->is_placed || !(pair->place.fit > 0))
        return voxel_scene_box_around(scene, bounds, size);
    const Similarity to = place_beside(&pair->place, bounds, &cube);
    return box_beside(&to, &(VoxelBox){ .size = size, .scale = 1 });
}

VoxelBox voxel_pair_box(const VoxelPair *pair, uint32_t size)
{
    const Bounds bounds = voxel_scene_bounds(pair->scenes[0]);
    return place_one(pair, &bounds, size);
}

/* --- passes ----------------------------------------------------------------------------------- */

static GpResult check(const VoxelPair *pair, const VoxelSetting *setting, GpError *error)
{
    if (pair->scenes[1] && pair->combine == VOXEL_TOUCHING && setting->bits != 1)
        return gp_fail(error, GP_ERROR_INVALID, "--combine collide: one bit a voxel, not %u",
                       setting->bits);
    if (pair->scenes[1] && setting->bits == 16)
        return gp_fail(error, GP_ERROR_INVALID, "--with: 1 or 8 bits a voxel, not 16");
    if (pair->scenes[1] && pair->scenes[0]->twist != 0)
        return gp_fail(error, GP_ERROR_INVALID,
                       "--twist turns about the centre of the volume: not --with another model");
    return flat_texture_check(setting->size, setting->bits, error);
}

/* What is too small or too large for its volume, or too far from it, has no matrix. */
static GpResult check_box(const VoxelPair *pair, int which, const Bounds *bounds,
                          const VoxelBox *box, GpError *error)
{
    if (voxel_box_is_usable(box))
        return GP_OK;
    return gp_fail(
        error, GP_ERROR_INVALID,
        "%.100s: %g is no longest side for voxels of %g: a voxel in units of the model, and "
        "the model's place in voxels, have to be 32-bit floats",
        pair->names[which], bounds_longest(bounds), 1 / box->scale);
}

/* Whoever draws the first names it; the second is named here. */
static GpResult draw_model(const VoxelPair *pair, int which, const VoxelSetting *setting,
                           const VoxelBox *box, Frame *frame, VoxelPairMade *made, GpError *error)
{
    GpError reason;
    GpResult result =
        voxel_scene_draw(pair->scenes[which], setting, box, frame, &made->volumes[which], &reason);
    if (!result)
        return GP_OK;
    return which ? gp_fail(error, result, "%.100s: %s", pair->names[which], reason.text)
                 : gp_fail(error, result, "%s", reason.text);
}

static VoxelRange range_around(const VoxelRange *a, const VoxelRange *b)
{
    VoxelRange range;
    for (int k = 0; k < 3; k++) {
        range.low[k] = a->low[k] < b->low[k] ? a->low[k] : b->low[k];
        range.end[k] = a->end[k] > b->end[k] ? a->end[k] : b->end[k];
    }
    return range;
}

static void combine(const VoxelPair *pair, const VoxelRange ranges[2], Frame *frame,
                    VoxelPairMade *made)
{
    const FlatTexture *first = &made->volumes[0], *second = &made->volumes[1];
    const VoxelRange common = voxel_range_common(&ranges[0], &ranges[1]);
    made->around = range_around(&ranges[0], &ranges[1]);
    made->range = pair->combine == VOXEL_UNION        ? made->around
                  : pair->combine == VOXEL_DIFFERENCE ? ranges[0]
                                                      : common;
    made->result = flat_texture_make(frame, first->size, first->bits);
    if (pair->combine == VOXEL_TOUCHING)
        voxel_collide(frame, first, second, &common, &made->result);
    else
        voxel_combine(frame, first, second, pair->combine, &made->result);
}

GpResult voxel_pair_build(const VoxelPair *pair, const VoxelSetting *setting, Frame *frame,
                          VoxelPairMade *made, GpError *error)
{
    GpResult result = check(pair, setting, error);
    if (result)
        return result;
    const bool two = pair->scenes[1] != NULL;
    *made = (VoxelPairMade){ .result = { .size = 0 } };
    VoxelBox *boxes = made->boxes;
    Bounds bounds[2];
    for (int i = 0; i <= two; i++)
        bounds[i] = voxel_scene_bounds(pair->scenes[i]);
    if (two)
        place_two(pair, bounds, setting->size, boxes);
    else
        boxes[0] = place_one(pair, &bounds[0], setting->size);
    for (int i = 0; i <= two && !result; i++)
        result = check_box(pair, i, &bounds[i], &boxes[i], error);
    if (result)
        return result;
    for (int i = 0; i <= two; i++)
        made->volumes[i] = flat_texture_make(frame, setting->size, setting->bits);
    VoxelRange ranges[2];
    for (int i = 0; i <= two && !result; i++) {
        result = draw_model(pair, i, setting, &boxes[i], frame, made, error);
        ranges[i] = voxel_scene_range(&bounds[i], &boxes[i]);
    }
    if (result)
        return result;
    made->result = made->volumes[0];
    made->range = made->around = ranges[0];
    if (two)
        combine(pair, ranges, frame, made);
    return frame_result(frame, error);
}
