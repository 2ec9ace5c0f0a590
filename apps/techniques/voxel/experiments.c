#include "apps/techniques/voxel/experiments.h"

#include "apps/techniques/voxel/models.h"
#include "apps/techniques/voxel/words.h"

#include <string.h>

/* --- sweeps ----------------------------------------------------------------------------------- */

#define SIZES      "--size 32|64|128|256|512"
#define SLOW_SIZES "--size 32|64|128|256"

static const TechniqueSweep sweep[] = {
    { "conservative", "--method conservative " SIZES },
    { "thin", "--method thin " SIZES },
    { "sheets, add", "--method sheets --bits 1|8|16 " SIZES },
    { "sheets, or", "--method sheets --blend or --bits 1|8|16 " SIZES },
    { "sheets, one axis", "--method sheets --blend or --axes 1 " SIZES },
    { "slices", "--method slices " SLOW_SIZES },
    { "layered depths", "--method ldi " SLOW_SIZES },
    { .method = NULL },
};

static const TechniqueSweep solid_sweep[] = {
    { "xor", "--kind solid --method xor " SIZES },
    { "winding number", "--kind solid --method winding --counters half|byte " SIZES },
    { "rows of sheets", "--kind solid --method sheets --blend add|or " SIZES },
    { "slices", "--kind solid --method slices " SLOW_SIZES },
    { "layered depths", "--kind solid --method ldi " SLOW_SIZES },
    { "six faces", "--kind solid --method faces " SLOW_SIZES },
    { .method = NULL },
};

static const char *const usual[] = { "conservative", "thin", NULL };
static const char *const usual_solid[] = { "xor", NULL };

/* --- truth ------------------------------------------------------------------------------------ */

/* Metrics are against the exact voxels of a frame's own size, the error against the model, so that
 * it tells what a finer volume is worth. voxel_truths finds each when a frame is measured. */
static GpResult find_truth(void *scene, int threads, GpError *error)
{
    VoxelModels *models = scene;
    if (models->scene.input != VOXEL_MESH)
        return gp_fail(error, GP_ERROR_INVALID, "expected a mesh: there is no other truth");
    if (models->pair.scenes[1] || models->scene.twist != 0)
        return gp_fail(error, GP_ERROR_INVALID, "expected one mesh that is not twisted");
    return voxel_truths_prepare(&models->truths, threads, error);
}

static VoxelTruthKind truth_of(const VoxelSetting *setting)
{
    if (setting->kind == VOXEL_SOLID)
        return setting->method == VOXEL_WINDING ? VOXEL_TRUTH_WOUND : VOXEL_TRUTH_INSIDE;
    return setting->method == VOXEL_THIN ? VOXEL_TRUTH_SAMPLED : VOXEL_TRUTH_TOUCHED;
}

/* The voxels of a flat texture that are not 0, as bits. NULL without memory; the caller frees
 * them. */
static uint8_t *bits_of(const FlatTexture *flat)
{
    const size_t count = (size_t)flat->size * flat->size * flat->size, each = flat->bits / 8;
    uint8_t *voxels = gp_alloc(flat_texture_bytes(flat), 1);
    if (voxels)
        flat_texture_read(flat, voxels);
    if (!voxels || flat->bits == 1)
        return voxels;
    uint8_t *bits = gp_alloc((count + 7) / 8, 1);
    for (size_t i = 0; bits && i < count; i++)
        if (voxels[i * each] || voxels[i * each + each - 1])
            bits[i / 8] = (uint8_t)(bits[i / 8] | 1u << i % 8);
    gp_free(voxels);
    return bits;
}

static const char *const metrics[] = { "voxels", "missing", "extra", NULL };

/* Against the model. NaN without memory */
static double wrong_of(VoxelModels *models, const VoxelMade *made, const uint8_t *bits)
{
    const VoxelSetting *setting = &made->setting;
    const VoxelBox *space = &made->pair.boxes[0];
    const VoxelInside inside =
        setting->method == VOXEL_WINDING ? VOXEL_BY_WINDING : VOXEL_BY_PARITY;
    return setting->kind == VOXEL_SOLID
               ? voxel_truths_wrong_volume(&models->truths, &models->scene, inside, space, bits)
               : voxel_truths_distance(&models->truths, &models->scene, space, bits);
}

/* Each voxel has a centre, and a point of the model is as far from the nearest of all at least. */
static void find_least_error(void *scene, const void *setting, TechniqueError *least)
{
    VoxelModels *models = scene;
    const VoxelOptions *options = setting;
    const VoxelBox space = voxel_pair_box(&models->pair, options->voxels.size);
    *least = (TechniqueError){
        .error = voxel_truths_least_distance(&models->truths, &models->scene, &space), .whole = 1000
    };
}

static GpResult measure_error(void *scene, const Frame *frame, TechniqueError *measured,
                              GpError *error)
{
    const VoxelMade *made = frame->made;
    uint8_t *bits = bits_of(&made->pair.result);
    if (!bits)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    *measured = (TechniqueError){ .error = wrong_of(scene, made, bits), .whole = 1000 };
    gp_free(bits);
    return GP_OK;
}

static GpResult measure(void *scene, const Frame *frame, TechniqueError *measured, GpError *error)
{
    VoxelModels *models = scene;
    const VoxelMade *made = frame->made;
    const FlatTexture *texture = &made->pair.result;
    const VoxelTruth *truth = voxel_truths_find(&models->truths, &models->scene,
                                                truth_of(&made->setting), &made->pair.boxes[0]);
    uint8_t *bits = truth ? bits_of(texture) : NULL;
    if (!bits)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    uint64_t missing, extra;
    voxel_truth_compare(truth, bits, &missing, &extra);
    *measured = (TechniqueError){
        .error = wrong_of(models, made, bits),
        .metrics = { (double)flat_texture_count(texture), (double)missing, (double)extra },
        .whole = 1000,
    };
    gp_free(bits);
    return GP_OK;
}

/* Puts the nearest exact volume into a flat texture of one bit a voxel. */
static void make_true(const FlatTexture *flat, const VoxelTruth *truth)
{
    const size_t size = flat->size;
    for (uint32_t slab = 0; slab < flat->slabs; slab++)
        for (size_t y = 0; y < size; y++)
            for (size_t x = 0; x < size; x++) {
                uint8_t *texel = flat_texture_texel(flat, slab, (uint32_t)x, (uint32_t)y);
                uint32_t word, least = 0, most = 0;
                memcpy(&word, texel, sizeof word);
                for (uint32_t k = 0; k < flat->per_texel; k++) {
                    const size_t z = (size_t)slab * flat->per_texel + k;
                    const size_t i = x + size * (y + size * z);
                    if (z >= size)
                        break;
                    least |= (uint32_t)(truth->least[i / 8] >> i % 8 & 1) << k;
                    most |= (uint32_t)(truth->most[i / 8] >> i % 8 & 1) << k;
                }
                word = (word | least) & most;
                memcpy(texel, &word, sizeof word);
            }
}

static float brightness(const GpSurface *picture, size_t pixel)
{
    const uint8_t *texel = picture->level[0].texels + 4 * pixel;
    return (float)(texel[0] + texel[1] + texel[2]) / (3 * 255);
}

/* The picture beside that of the exact voxels, drawn in the same way. */
static GpResult find_difference(void *scene, const void *setting, GpDevice *device, Frame *frame,
                                float *off, GpError *error)
{
    VoxelModels *models = scene;
    const VoxelMade *made = frame->made;
    const VoxelTruth *truth = voxel_truths_find(&models->truths, &models->scene,
                                                truth_of(&made->setting), &made->pair.boxes[0]);
    const GpSurface *drawn = frame->color;
    const uint32_t passes = frame->list.pass_count;
    const size_t pixels = (size_t)drawn->width * drawn->height;
    if (!truth)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    GpResult result = voxel_models_show(scene, setting, frame, error);
    if (result)
        return result;
    make_true(&made->pair.result, truth);
    GpList list = frame->list;
    list.passes += passes;
    list.pass_count -= passes;
    result = gp_device_run(device, &list, error);
    for (size_t i = 0; !result && i < pixels; i++)
        off[i] = brightness(drawn, i) - brightness(frame->color, i);
    frame->color = (GpSurface *)drawn;
    return result;
}

#define BESIDE_EXACT_VOXELS                                                                        \
    .difference = find_difference,                                                                 \
    .over = "brighter than in the picture of the exact voxels of the same size",                   \
    .under = "darker than there"

const Experiment voxel_experiments[] = {
    { .name = "voxelize",
      .title = "Voxelization: time against distance from the model",
      .scene = "builtin:knot",
      .sweep = sweep,
      .usual = usual,
      .error_name = "RMS distance, thousandths of the model's size",
      .part_of = "the model's size",
      .metrics = metrics,
      .words = voxel_surface_words,
      .truth = voxel_surface_truth,
      .find_truth = find_truth,
      .measure = measure,
      .measure_error = measure_error,
      .least_error = find_least_error,
      BESIDE_EXACT_VOXELS },
    { .name = "solids",
      .title = "Solid voxels: time against wrong volume",
      .scene = "builtin:knot",
      .sweep = solid_sweep,
      .usual = usual_solid,
      .error_name = "wrong volume, thousandths",
      .part_of = "the enclosed volume",
      .given = "--kind solid",
      .metrics = metrics,
      .words = voxel_solid_words,
      .truth = voxel_solid_truth,
      .find_truth = find_truth,
      .measure = measure,
      .measure_error = measure_error,
      BESIDE_EXACT_VOXELS },
    { .name = NULL },
};

/* --- scaling ---------------------------------------------------------------------------------- */

static double voxels_a_side(const void *scene, const Frame *frame)
{
    (void)scene;
    const VoxelMade *made = frame->made;
    return made->setting.size;
}

static double triangles(const void *scene, const Frame *frame)
{
    (void)frame;
    const VoxelModels *models = scene;
    return models->scene.mesh.triangle_count;
}

#define GROWING_SIZES "--size 64|128|256|512"
#define GROWING_MESHES                                                                             \
    "builtin:sphere|builtin:knot|meshes/bunny.ply|meshes/horse.ply|meshes/dragon_100k.ply|"        \
    "meshes/blade_199k.ply|meshes/dragon_res2.ply|meshes/happy_buddha.ply"

static const TechniqueLine with_size[] = {
    { "conservative", "builtin:knot", "--method conservative " GROWING_SIZES },
    { "thin", "builtin:knot", "--method thin " GROWING_SIZES },
    { "sheets, add", "builtin:knot", "--method sheets " GROWING_SIZES },
    { "solid: xor", "builtin:knot", "--kind solid --method xor " GROWING_SIZES },
    { .name = NULL },
};

static const TechniqueLine with_triangles[] = {
    { "conservative", GROWING_MESHES, "--method conservative --size 256" },
    { "thin", GROWING_MESHES, "--method thin --size 256" },
    { "sheets, add", GROWING_MESHES, "--method sheets --size 256" },
    { "solid: xor", GROWING_MESHES, "--kind solid --method xor --size 256" },
    { .name = NULL },
};

static const TechniqueSlope size_slopes[] = {
    { 1, "as the side" }, { 2, "as the square" }, { 3, "as the cube" }, { .name = NULL }
};
static const TechniqueSlope triangle_slopes[] = { { 1, "as their number" }, { .name = NULL } };

static const char *const scaling_text[] = {
    "Two costs add up. The volume is cleared and stored, whatever is in it: at one bit a voxel a "
    "volume of N voxels a side is N^3/8 bytes, 32 KB at 64 and 16 MB at 512. The triangles come "
    "one by one: each is transformed, set up and brought to its tiles, which costs the same "
    "however small it is, so that a smaller volume makes no triangle cheaper that is smaller than "
    "a voxel already. Larger ones cost by the columns of voxels that they cross: as the square of "
    "N.",
    "The solid draws up to 128 layers of voxels at once into targets of their own and copies the "
    "whole volume out of them, which is work for every voxel: as the cube of N once it outweighs "
    "the triangles. So is the printed method's, which draws three volumes, gathers their slabs, "
    "and turns two of them by a lookup for every voxel.",
    "With more triangles the volume's share stays the same for all. Thin surfaces need not draw "
    "triangles so small that no line through the centres of voxels can meet them: the lists, made "
    "once for a model that stands still, leave them out. Meshes of about as many triangles differ "
    "all the same: by how large these are, and how many lie over each other.",
    NULL
};

const TechniqueScaling voxel_scaling = {
    .title = "Voxelization: time against size",
    .text = scaling_text,
    .words = voxel_scaling_words,
    .panels = { { .title = "Larger volumes, of the builtin knot",
                  .axis = "voxels a side",
                  .doubles = true,
                  .amount = voxels_a_side,
                  .lines = with_size,
                  .slopes = size_slopes },
                { .title = "Larger meshes, at 256 voxels a side",
                  .axis = "triangles",
                  .amount = triangles,
                  .lines = with_triangles,
                  .slopes = triangle_slopes } },
};
