#include "apps/techniques/voxel/technique.h"

#include "apps/techniques/voxel/truths.h"

#include <math.h>
#include <stddef.h>

/* --- settings --------------------------------------------------------------------------------- */

static const char *const kinds[] = { "surface", "solid", NULL };
static const char *const methods[] = { "auto",   "conservative", "thin",  "xor", "sheets",
                                       "slices", "ldi",          "faces", NULL };
static const char *const blends[] = { "add", "or", NULL };
static const char *const values[] = { "density", "normal", "color", NULL };

#define NAMED(field) SETTING_NAME, offsetof(VoxelSetting, field), 0, 0

static const SettingField fields[] = {
    { "size", "N", "Voxels a side of the volume, 8 to 1024 (default: 128)", SETTING_INTEGER,
      offsetof(VoxelSetting, size), 8, 1024, NULL },
    { "kind", "KIND", "surface: what triangles touch (default); solid: what they enclose",
      NAMED(kind), kinds },
    { "method", "NAME",
      "conservative: every voxel that is touched (default for surfaces); thin: those met by lines "
      "through middles; xor: each triangle turns over what is below it (default for solids); "
      "sheets: as printed in 2004; slices, ldi, faces: older ones",
      NAMED(method), methods },
    { "bits", "B", "Bits a voxel: 1 (default), 8 or 16; more than one of the method sheets",
      SETTING_INTEGER, offsetof(VoxelSetting, bits), 1, 16, NULL },
    { "blend", "HOW",
      "How the method sheets merges what falls into one voxel: add, as printed (default); or",
      NAMED(blend), blends },
    { "axes", "A", "Axes along which the method sheets looks: 3 (default), or 1: along z",
      SETTING_INTEGER, offsetof(VoxelSetting, axes), 1, 3, NULL },
    { "value", "WHAT", "What voxels of 8 and 16 bits hold: density (default), normal or color",
      NAMED(value), values },
    { .name = NULL },
};

/* --- sweep ------------------------------------------------------------------------------------ */

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
    { "rows of sheets", "--kind solid --method sheets --blend add|or " SIZES },
    { "slices", "--kind solid --method slices " SLOW_SIZES },
    { "layered depths", "--kind solid --method ldi " SLOW_SIZES },
    { "six faces", "--kind solid --method faces " SLOW_SIZES },
    { .method = NULL },
};

/* --- frames ----------------------------------------------------------------------------------- */

typedef struct Study {
    VoxelScene scene; /* first: see study_voxel.h */
    VoxelTruths *truths;
} Study;

static GpResult open_scene(const char *path, uint32_t width, uint32_t height, void **opened,
                           GpError *error)
{
    if (width || height)
        return gp_fail(error, GP_ERROR_INVALID, "a volume has no width and height, but --size N");
    Study *study = gp_alloc(1, sizeof *study);
    VoxelTruths *truths = gp_alloc(1, sizeof *truths);
    GpResult result = study && truths ? voxel_scene_open(path, &study->scene, error)
                                      : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    if (result) {
        gp_free(study);
        gp_free(truths);
        return result;
    }
    study->truths = truths;
    *opened = study;
    return GP_OK;
}

static void close_scene(void *opened)
{
    Study *study = opened;
    voxel_truths_free(study->truths);
    gp_free(study->truths);
    voxel_scene_close(&study->scene);
    gp_free(study);
}

static GpResult build(void *opened, const void *chosen, Frame *frame, GpError *error)
{
    const Study *study = opened;
    const VoxelSetting *setting = chosen;
    GpResult result = flat_texture_check(setting->size, setting->bits, error);
    if (result)
        return result;
    const VoxelMade made = { .setting = *setting,
                             .box = voxel_scene_box(&study->scene, setting->size),
                             .sheet = flat_texture_make(frame, setting->size, setting->bits) };
    frame->made = frame_copy(frame, &made, sizeof made);
    result = voxel_scene_draw(&study->scene, setting, &made.box, frame, &made.sheet, error);
    if (result) {
        frame_free(frame);
        return result;
    }
    frame->color = made.sheet.texels;
    return GP_OK;
}

/* --- truth ------------------------------------------------------------------------------------ */

/* Figures are against the exact voxels of a frame's own size, the error against the model, so that it
 * tells what a finer volume is worth. voxel_truths finds each when a frame is measured. */
static GpResult find_truth(void *opened, int threads, GpError *error)
{
    const Study *study = opened;
    (void)threads;
    if (study->scene.input != VOXEL_MESH)
        return gp_fail(error, GP_ERROR_INVALID, "expected a mesh: there is no other truth");
    return GP_OK;
}

static VoxelTruthKind truth_of(const VoxelSetting *setting)
{
    if (setting->kind == VOXEL_SOLID)
        return VOXEL_TRUTH_INSIDE;
    return setting->method == VOXEL_THIN ? VOXEL_TRUTH_SAMPLED : VOXEL_TRUTH_TOUCHED;
}

/* The voxels of a flat texture that are not 0, as bits. NULL without memory; the caller frees them. */
static uint8_t *bits_of(const FlatTexture *sheet)
{
    const size_t count = (size_t)sheet->size * sheet->size * sheet->size, each = sheet->bits / 8;
    uint8_t *voxels = gp_alloc(flat_texture_bytes(sheet), 1);
    if (voxels)
        flat_texture_read(sheet, voxels);
    if (!voxels || sheet->bits == 1)
        return voxels;
    uint8_t *bits = gp_alloc((count + 7) / 8, 1);
    for (size_t i = 0; bits && i < count; i++)
        if (voxels[i * each] || voxels[i * each + each - 1])
            bits[i / 8] = (uint8_t)(bits[i / 8] | 1u << i % 8);
    gp_free(voxels);
    return bits;
}

static const char *const metrics[] = { "voxels", "missing", "extra", NULL };

static void measure(const void *opened, const Frame *frame, TechniqueError *error)
{
    const Study *study = opened;
    const VoxelMade *made = frame->made;
    const VoxelSetting *setting = &made->setting;
    const VoxelTruth *truth =
        voxel_truths_find(study->truths, &study->scene, truth_of(setting), setting->size);
    uint8_t *bits = truth ? bits_of(&made->sheet) : NULL;
    *error = (TechniqueError){ .error = (double)NAN };
    if (!bits)
        return;
    uint64_t missing, extra;
    voxel_truth_compare(truth, bits, &missing, &extra);
    error->error =
        setting->kind == VOXEL_SOLID
            ? voxel_truths_wrong_volume(study->truths, &study->scene, setting->size, bits)
            : voxel_truths_distance(study->truths, &study->scene, setting->size, bits);
    gp_free(bits);
    error->metrics[0] = (double)flat_texture_count(&made->sheet);
    error->metrics[1] = (double)missing;
    error->metrics[2] = (double)extra;
}

/* --- scaling ----------------------------------------------------------------------------------- */

static double voxels_a_side(const void *opened, const Frame *frame)
{
    (void)opened;
    const VoxelMade *made = frame->made;
    return made->setting.size;
}

static double triangles(const void *opened, const Frame *frame)
{
    (void)frame;
    const Study *study = opened;
    return study->scene.mesh.triangle_count;
}

#define GROWING_SIZES "--size 64|128|256|512"
#define GROWING_MESHES                                                                             \
    "meshes/bunny.ply|meshes/horse.ply|meshes/dragon_100k.ply|meshes/blade_199k.ply|"              \
    "meshes/dragon_res2.ply|meshes/happy_buddha.ply"

static const TechniqueLine with_size[] = {
    { "conservative", "meshes/bunny.ply", "--method conservative " GROWING_SIZES },
    { "thin", "meshes/bunny.ply", "--method thin " GROWING_SIZES },
    { "sheets, add", "meshes/bunny.ply", "--method sheets " GROWING_SIZES },
    { "solid: xor", "meshes/horse.ply", "--kind solid --method xor " GROWING_SIZES },
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
    "one "
    "by one: each is transformed, set up and brought to its tiles, which costs the same however "
    "small it is, so that a smaller volume makes no triangle cheaper that is smaller than a voxel "
    "already. Larger ones cost by the columns of voxels that they cross: as the square of N.",
    "Surfaces, conservative and thin, are mostly triangles: their time rises by no more than the "
    "side. The solid draws up to 128 layers of voxels at once into targets of their own and copies "
    "the whole volume out of them: little at first, towards the cube of N in the end. So does the "
    "printed method, and sooner: it draws three volumes, gathers their slabs, and turns two of "
    "them "
    "by a lookup for every voxel.",
    "With more triangles no line rises as steeply as their number, for the volume's share is the "
    "same for all: least with the printed method, whose volume costs most. Thin surfaces hardly "
    "rise at all: the lists, made once for a model that stands still, leave out triangles so small "
    "that no line through the middles of voxels can meet them; three of four of the largest mesh "
    "here. Meshes of about as many triangles differ all the same: by how large these are, and how "
    "many lie over each other.",
    NULL
};

static const TechniqueScaling scaling = {
    .title = "Voxelization: time against size",
    .text = scaling_text,
    .panels = { { .title = "Larger volumes: bunny; solid: horse",
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

const Technique voxel_technique = {
    .name = "voxelize",
    .title = "Voxelization: time against distance from the model",
    .scene = "meshes/bunny.ply",
    .fields = fields,
    .defaults = &voxel_defaults,
    .setting_bytes = sizeof(VoxelSetting),
    .makes_volumes = true,
    .sweep = sweep,
    .error_name = "RMS distance, thousandths of the model's size",
    .metrics = metrics,
    .scaling = &scaling,
    .open = open_scene,
    .close = close_scene,
    .build = build,
    .find_truth = find_truth,
    .measure = measure,
};

static const VoxelSetting solid_defaults = {
    .kind = VOXEL_SOLID, .size = 128, .bits = 1, .blend = VOXEL_ADD, .axes = 3
};

const Technique solid_technique = {
    .name = "solids",
    .title = "Solid voxels: time against wrong volume",
    .scene = "meshes/horse.ply",
    .fields = fields,
    .defaults = &solid_defaults,
    .setting_bytes = sizeof(VoxelSetting),
    .makes_volumes = true,
    .sweep = solid_sweep,
    .error_name = "wrong volume, thousandths",
    .metrics = metrics,
    .open = open_scene,
    .close = close_scene,
    .build = build,
    .find_truth = find_truth,
    .measure = measure,
};
