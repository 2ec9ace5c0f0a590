#include "apps/techniques/shadow/technique.h"

#include "apps/scene/bounds.h"
#include "apps/techniques/shadow/discs.h"
#include "apps/techniques/shadow/light.h"
#include "apps/techniques/shadow/paper_tables.h"
#include "apps/techniques/shadow/shadow.h"
#include "apps/techniques/shadow/words.h"
#include "apps/truth/shadow_error.h"
#include "pipeline/base/pool.h"

#include <math.h>
#include <string.h>

/* --- settings --------------------------------------------------------------------------------- */

static const char *const methods[] = { "plain", "hardware", NULL };
static const char *const filters[] = { "nearest", "bilinear", "soft", NULL };
static const char *const facings[] = { "smooth", "flat", NULL };
static const char *const depths[] = { "auto", "d16", "d24", "d32f", "r32f", NULL };
static const char *const casters[] = { "all", "near", "far", NULL };
static const char *const fits[] = { "light", "casters", "eye", "adaptive", NULL };
static const char *const outsides[] = { "lit", "printed", NULL };

static const SettingField settings[] = {
    { "method", NULL,
      "plain: depths as colours, compared in the shader; hardware: a depth surface "
      "that compares when it is read (default)",
      SETTING_NAME, offsetof(ShadowSetting, method), .names = methods },
    { "filter", NULL,
      "nearest, bilinear (default): the share of 2x2 texels; soft: as wide as the "
      "light makes its penumbra",
      SETTING_NAME, offsetof(ShadowSetting, filter), .names = filters },
    { "map", "N", "Texels a side of the map, 16 to 8192 (default: the light's, else 1024)",
      SETTING_INTEGER, offsetof(ShadowSetting, map), .low = 16, .high = GP_MAX_SIZE },
    { "depth", NULL, "d16, d24 or d32f of the hardware method, r32f of the plain one", SETTING_NAME,
      offsetof(ShadowSetting, depth), .names = depths },
    { "bias", "E", "Taken from a pixel's depth before it is compared, 0 to 1 (default: chosen)",
      SETTING_NUMBER, offsetof(ShadowSetting, bias), .low = 0, .high = 1 },
    { "slope", "S", "Added to the map's depth, times its change over a texel (default: chosen)",
      SETTING_NUMBER, offsetof(ShadowSetting, slope), .low = 0, .high = 64 },
    { "normal-offset", "T", "Look surfaces up T texels above themselves (default: 0)",
      SETTING_NUMBER, offsetof(ShadowSetting, offset), .low = 0, .high = 64 },
    { "casters", NULL, "all (default); near: turned to the light; far: turned away from it",
      SETTING_NAME, offsetof(ShadowSetting, casters), .names = casters },
    { "fit", NULL,
      "What the map covers: light, all that it shines at; casters, the box of what can "
      "cast a shadow (default); eye, the same, finer where the eye is near; adaptive, finer where "
      "shadows end",
      SETTING_NAME, offsetof(ShadowSetting, fit), .names = fits },
    { "facing", NULL,
      "What faces away from the light is dark: smooth, by normals; flat, by "
      "triangles (default)",
      SETTING_NAME, offsetof(ShadowSetting, facing), .names = facings },
    { "outside", NULL,
      "Beside the map and behind the light: lit (default), or printed, as the "
      "thesis's arithmetic has it",
      SETTING_NAME, offsetof(ShadowSetting, outside), .names = outsides },
    { .name = NULL },
};

/* --- sweep ------------------------------------------------------------------------------------ */

#define AS_PRINTED " --fit light --facing smooth --outside printed"

static const TechniqueSweep sweep[] = {
    { "plain, nearest",
      "--method plain --filter nearest --map 512|1024|2048|4096 --bias 0.001|0.004" AS_PRINTED },
    { "plain, four compares",
      "--method plain --filter bilinear --map 512|1024|2048|4096 --bias 0.001|0.004" AS_PRINTED },
    { "hardware, nearest",
      "--filter nearest --map 512|1024|2048|4096 --bias 0.001|0.004 --slope 0" AS_PRINTED },
    { "hardware, 2x2", "--map 512|1024|2048|4096 --bias 0.001|0.004 --slope 0" AS_PRINTED },
    { "slope-scaled bias", "--fit light --facing smooth --map 512|1024|2048|4096" },
    { "dark by triangles", "--fit light --map 512|1024|2048|4096" },
    { "16 bits", "--fit light --depth d16 --map 512|1024|2048|4096" },
    { "far sides", "--fit light --casters far --map 512|1024|2048|4096" },
    { "normal offset", "--fit light --normal-offset 0.5 --map 512|1024|2048|4096" },
    { "fit to casters", "--map 256|512|1024|2048|4096" },
    { "fit, near sides", "--casters near --depth d32f --map 256|512|1024|2048|3072|4096|4608" },
    { "fit to the eye",
      "--fit eye --casters near --depth d32f --map 256|512|1024|2048|3072|3328|4096" },
    { "adaptive", "--fit adaptive --casters near --depth d32f --map 256|512|1024|1536" },
    { "soft", "--method plain --filter soft --map 512|1024|2048" },
    { .method = NULL },
};

static const char *const usual[] = { "fit, near sides", "fit to the eye", "adaptive", NULL };

/* --- truth ------------------------------------------------------------------------------------ */

typedef struct Opened {
    Scene file;
    Scene scene;  /* the same, with discs for its splats */
    Frame memory; /* of what is kept */
    ShadowKept *kept;
    ShadowTruth truth;
    GpPool *pool; /* for errors alone, once their truth is found */
} Opened;

static void close_scene(void *made)
{
    Opened *opened = made;
    gp_pool_destroy(&opened->pool);
    shadow_truth_free(&opened->truth);
    frame_free(&opened->memory);
    scene_free(&opened->file);
    gp_free(opened);
}

static GpResult open_scene(const TechniqueInput *input, void **made, GpError *error)
{
    Opened *opened = gp_alloc(1, sizeof *opened);
    if (!opened)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory");
    const SceneOptions options = { .width = input->width,
                                   .height = input->height,
                                   .shadows = true };
    GpResult result = scene_load(input->path, &options, &opened->file, error);
    if (result) {
        gp_free(opened);
        return result;
    }
    result = shadow_scene_with_discs(&opened->file, &opened->memory, &opened->scene, error);
    if (result) {
        close_scene(opened);
        return result;
    }
    opened->kept = shadow_keep(&opened->scene, &opened->memory);
    if (!opened->kept) {
        close_scene(opened);
        return gp_fail(error, GP_ERROR_MEMORY, "no memory");
    }
    *made = opened;
    return GP_OK;
}

static GpResult build(void *made, const void *setting, GpDevice *device, Frame *frame,
                      GpError *error)
{
    const Opened *opened = made;
    return shadow_build(&opened->scene, opened->kept, setting, device, frame, error);
}

/* What lights agree in; what one light has otherwise than another stays open. */
static void resolve(const void *made, void *object)
{
    const Opened *opened = made;
    const Scene *scene = &opened->scene;
    ShadowSetting *setting = object;
    const ShadowSetting open = *setting;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        ShadowSetting one = open;
        shadow_choose(scene, opened->kept, i, &one);
        const ShadowSetting *first = i == 0 ? &one : setting;
        setting->map = one.map == first->map ? one.map : open.map;
        setting->depth = one.depth == first->depth ? one.depth : open.depth;
        setting->bias = one.bias == first->bias ? one.bias : open.bias;
        setting->slope = one.slope == first->slope ? one.slope : open.slope;
    }
}

/* Lights are added up in the picture, alpha with them. */
static GpResult check_visibility(const void *made, GpError *error)
{
    const uint32_t count = ((const Opened *)made)->scene.light_count;
    return count == 1 ? GP_OK
                      : gp_fail(error, GP_ERROR_INVALID,
                                "--output-visibility is of one light, and the scene has %u", count);
}

/* All triangles of the scene, for rays. errors GP_ERROR_INVALID, GP_ERROR_MEMORY */
static GpResult collect_triangles(const Scene *scene, TruthScene **made)
{
    const GpPass *pass = &scene->list.passes[0];
    uint32_t count = 0, done = 0;
    for (uint32_t i = 0; i < pass->draw_count; i++)
        count += pass->draws[i].geometry.index_count / 3;
    TruthTriangle *triangles = gp_alloc(count, sizeof *triangles);
    if (!triangles)
        return GP_ERROR_MEMORY;
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        const GpGeometry *geometry = &pass->draws[i].geometry;
        for (uint32_t j = 0; j < geometry->index_count; j++)
            draw_position(&pass->draws[i], geometry->indices[j],
                          triangles[done + j / 3].corner[j % 3]);
        done += geometry->index_count / 3;
    }
    GpResult result = truth_scene_create(triangles, count, made);
    gp_free(triangles);
    return result;
}

static void set_square(const SceneLight *light, TruthLight *truth)
{
    double forward[3], right[3], up[3];
    vector_subtract(light->at, light->position, forward);
    vector_cross(forward, light->shadow.up, right);
    vector_cross(right, forward, up);
    vector_normalize(right);
    vector_normalize(up);
    for (int k = 0; k < 3; k++) {
        truth->side[0][k] = light->size * right[k];
        truth->side[1][k] = light->size * up[k];
    }
}

static TruthLight true_light(const SceneLight *light)
{
    TruthLight truth = { .kind = TRUTH_POINT, .half_angle = light->cone };
    if (light->directional)
        truth.kind = TRUTH_DIRECTIONAL;
    else if (light->size > 0)
        truth.kind = TRUTH_AREA;
    else if (light->cone > 0)
        truth.kind = TRUTH_CONE;
    memcpy(truth.position, light->position, sizeof truth.position);
    memcpy(truth.towards, light->position, sizeof truth.towards);
    vector_subtract(light->at, light->position, truth.axis);
    if (light->size > 0)
        set_square(light, &truth);
    return truth;
}

static GpResult cast_truth(void *made, int threads, bool only_lit, GpError *error)
{
    Opened *opened = made;
    const Scene *scene = &opened->scene;
    if (scene->light_count != 1)
        return gp_fail(error, GP_ERROR_INVALID, "the truth is for one light, not %u",
                       scene->light_count);
    if (scene->splats.source_count > 0)
        return gp_fail(error, GP_ERROR_INVALID,
                       "the truth is of triangles, and the scene has splats");
    if (scene->over < scene->list.pass_count)
        return gp_fail(error, GP_ERROR_INVALID,
                       "the truth is of what casts shadows, and the scene has more over it: %s",
                       scene->volume_count > 0 ? "volumes" : "what is blended");
    const ShadowView view = { .camera = scene->camera,
                              .width = scene->picture->width,
                              .height = scene->picture->height,
                              .light = true_light(&scene->lights[0]),
                              .threads = threads,
                              .only_lit = only_lit };
    TruthScene *triangles = NULL;
    shadow_truth_free(&opened->truth); /* of an earlier question */
    GpResult result = collect_triangles(scene, &triangles);
    if (result)
        return truth_scene_fail(error, result);
    result = shadow_truth_cast(triangles, &view, &opened->truth);
    truth_scene_destroy(&triangles);
    return result ? gp_fail(error, result, "no memory for the truth") : GP_OK;
}

static GpResult find_truth(void *made, int threads, GpError *error)
{
    return cast_truth(made, threads, false, error);
}

static GpResult find_truth_error(void *made, int threads, GpError *error)
{
    Opened *opened = made;
    if (!opened->pool && gp_pool_create(threads, &opened->pool, error))
        return GP_ERROR_MEMORY;
    return cast_truth(made, threads, true, error);
}

static const char *const metrics[] = { "acne", "leak", "rmse", "covered", NULL };

/* Alpha is the visibility; where depth stayed clear, nothing was drawn. in: pixels from `first`
 * on */
static void read_visibility(const Frame *frame, size_t first, size_t pixels, float *visibility)
{
    for (size_t i = 0; i < pixels; i++) {
        float depth;
        memcpy(&depth, frame->depth->level[0].texels + (first + i) * sizeof depth, sizeof depth);
        uint8_t alpha = frame->color->level[0].texels[4 * (first + i) + 3];
        visibility[i] = depth < 1 ? (float)alpha / 255 : SHADOW_NOTHING;
    }
}

static GpResult measure(void *made, const Frame *frame, TechniqueError *measured, GpError *error)
{
    const Opened *opened = made;
    const size_t pixels = (size_t)opened->truth.width * opened->truth.height;
    float *visibility = gp_alloc(pixels, sizeof *visibility);
    if (!visibility)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    read_visibility(frame, 0, pixels, visibility);
    const ShadowError shadow = shadow_error(&opened->truth, visibility, NULL);
    gp_free(visibility);
    *measured =
        (TechniqueError){ .error = shadow.acne + shadow.leak,
                          .metrics = { shadow.acne, shadow.leak, shadow.rmse, shadow.covered },
                          .whole = shadow.covered };
    return GP_OK;
}

/* The rows of a picture, each held against the truth by itself. */
typedef struct Rows {
    const ShadowTruth *truth;
    const Frame *frame;
    float *visibility;
    ShadowError *errors; /* [rows] */
} Rows;

static void measure_row(void *context, uint32_t row, int worker)
{
    const Rows *rows = context;
    const uint32_t width = rows->truth->width;
    const size_t first = (size_t)row * width;
    const ShadowTruth truth = { width, 1, rows->truth->visibility + first, NULL };
    (void)worker;
    read_visibility(rows->frame, first, width, rows->visibility + first);
    rows->errors[row] = shadow_error(&truth, rows->visibility + first, NULL);
}

/* Pixels are counted, and so by any thread. */
static GpResult measure_error(void *made, const Frame *frame, TechniqueError *measured,
                              GpError *error)
{
    const Opened *opened = made;
    const uint32_t width = opened->truth.width, height = opened->truth.height;
    const Rows rows = { &opened->truth, frame,
                        gp_alloc_unset((size_t)width * height * sizeof(float)),
                        gp_alloc(height, sizeof(ShadowError)) };
    const bool has_memory = rows.visibility && rows.errors;
    *measured = (TechniqueError){ .error = 0 };
    if (has_memory)
        gp_pool_run(opened->pool, height, measure_row, (void *)&rows);
    for (uint32_t i = 0; i < height && has_memory; i++) {
        measured->error += rows.errors[i].acne + rows.errors[i].leak;
        measured->whole += rows.errors[i].covered;
    }
    gp_free(rows.visibility);
    gp_free(rows.errors);
    return has_memory ? GP_OK : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
}

static GpResult find_difference(void *made, const void *setting, GpDevice *device, Frame *frame,
                                float *off, GpError *error)
{
    const ShadowTruth *truth = &((const Opened *)made)->truth;
    const size_t pixels = (size_t)truth->width * truth->height;
    (void)setting;
    (void)device;
    (void)error;
    read_visibility(frame, 0, pixels, off);
    for (size_t i = 0; i < pixels; i++)
        off[i] = truth->visibility[i] < 0 || off[i] < 0 ? 0 : off[i] - truth->visibility[i];
    return GP_OK;
}

static const Experiment experiments[] = {
    { .name = "shadow",
      .title = "Shadow maps: time against wrong pixels",
      .scene = "scenes/shadow.json",
      .sweep = sweep,
      .usual = usual,
      .error_name = "wrong pixels",
      .part_of = "the covered pixels",
      .metrics = metrics,
      .words = shadow_words,
      .truth = shadow_truth_words,
      .difference = find_difference,
      .over = "more light than in truth, a leak where the pixel counts as wrong",
      .under = "less light, acne where it counts as wrong",
      .find_truth = find_truth,
      .find_truth_error = find_truth_error,
      .measure = measure,
      .measure_error = measure_error },
    { .name = NULL },
};

const Technique shadow_technique = {
    .name = "shadow",
    .arguments = "SCENE.json",
    .input = "a scene file",
    .summary = "a scene under shadow maps",
    .help =
        "Examples:\n"
        "  glasspipe shadow scenes/shadow.json\n"
        "  glasspipe shadow scenes/shadow.json --method plain --filter nearest --bias 0\n"
        "  glasspipe shadow scenes/shadow_soft.json --method plain --filter soft\n"
        "  glasspipe shadow scenes/shadow.json --map 2048 --depth d16 -o shadow.png\n"
        "  glasspipe shadow scenes/shadow.json --error 1%\n"
        "\n"
        "Renders a scene whose lights cast shadows by shadow maps, and prints the picture's hash.\v"
        "With --json the frame is rendered a second time, which is the one that is timed. With one "
        "light, alpha is how much of it a pixel sees: EXR has it, and --output-visibility writes "
        "it alone.",
    .settings = settings,
    .defaults = &shadow_defaults,
    .setting_bytes = sizeof(ShadowSetting),
    .experiments = experiments,
    .tables = shadow_tables,
    .open = open_scene,
    .close = close_scene,
    .build = build,
    .resolve = resolve,
    .alpha = "visibility",
    .quick_truth = true,
    .check_alpha = check_visibility,
};
