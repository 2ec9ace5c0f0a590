#include "apps/techniques/warp/options.h"

#include "apps/base/model_color.h"

#include <math.h>

#define DEFAULT_TURN 12

const WarpOptions warp_option_defaults = {
    .source_size = { 512, 512 },
    .turn = DEFAULT_TURN,
    .orbit = { .azimuth = (double)NAN, .elevation = (double)NAN, .zoom = 1 },
};

/* clang-format off */
static const char *const methods[] = {
    [WARP_AUTO] = "auto",
    [WARP_LAYERS] = "layers",
    [WARP_DIRECT] = "direct",
    [WARP_SURFACE] = "surface",
    [WARP_PLANAR_PRINTED] = "planar",
    [WARP_CYLINDER_PRINTED] = "cylinder",
    [WARP_RELIEF] = "relief",
    [WARP_DMESH] = "dmesh",
    [WARP_SIMPLIFIED] = "simplified",
    [WARP_DISPLACEMENT] = "displacement",
    [WARP_RELIEF_TEXTURE] = "relief-texture",
    [WARP_PARALLAX] = "parallax",
    [WARP_BUMP] = "bump",
    [WARP_POLYGONS] = "polygons",
    [WARP_METHODS] = NULL
};
/* clang-format on */
static const char *const cuts[] = { [WARP_CUT_AUTO] = "auto",
                                    [WARP_CUT_SLOPES] = "slopes",
                                    [WARP_CUT_RELATIVE] = "relative",
                                    [WARP_CUT_NONE] = "none",
                                    NULL };
static const char *const kinds[] = {
    [WARP_PLANAR] = "planar", [WARP_CYLINDER] = "cylinder", [WARP_BOX] = "box", NULL
};
const char *const warp_ups[] = { "y", "z", "x", "-y", "-z", NULL };

#define OF(member) offsetof(WarpOptions, member)

const SettingField warp_settings[] = {
    { "method", NULL,
      "auto: by what the image is (default); layers: merged grids of what is in front and of what "
      "lies behind it; direct: the front alone; surface: the same of cylinders too; planar, "
      "cylinder: as printed, within a plane; relief: a search along the ray of each pixel; dmesh, "
      "simplified: a mesh of all pixels, or of a part of its triangles; displacement: rays through "
      "a field of distances; relief-texture: a picture on a rectangle, warped by the processor; "
      "parallax, bump: one whose places are shifted, or not; polygons: the mesh itself. An option "
      "of one method alone means that method",
      SETTING_NAME, OF(method), .names = methods },
    { "kind", NULL,
      "What is captured of a mesh: planar, a picture (default); cylinder, one that is looked "
      "through from all sides; box, six pictures around it",
      SETTING_NAME, OF(kind), .names = kinds },
    { "step", "N",
      "Pixels of the image from vertex to vertex (default: by how small they are in the picture)",
      SETTING_INTEGER, OF(step), .low = 1, .high = 128 },
    { "cut", NULL,
      "Of layers, direct and planar, where surfaces end: auto, by slopes, or as printed (default); "
      "slopes, at steps steeper than both sides of them; relative, at steps of 2 % of the depth; "
      "none: rubber sheets hang between near and far",
      SETTING_NAME, OF(cut), .names = cuts },
    { "tolerance", "T",
      "Of layers and direct: pixels of the image by which merged triangles may be off (default: "
      "1); -1: none are merged",
      SETTING_NUMBER, OF(tolerance), .low = -1, .high = 16 },
    { "entries", "N", "Of planar: entries of the table by which cells move (default: 4096)",
      SETTING_INTEGER, OF(entries), .low = 2, .high = 8192 },
    { "search", "N", "Of relief and displacement: steps along a ray (default: 64)", SETTING_INTEGER,
      OF(search), .low = 1, .high = 255 },
    { "halvings", "N",
      "Of relief: how often the step is halved that meets the surface (default: 8)",
      SETTING_INTEGER, OF(halvings), .low = 1, .high = 255 },
    { "unlimited", NULL,
      "Of parallax: places move as far as the view's slope has it, also where it is flat",
      SETTING_FLAG, OF(unlimited), .low = 0 },
    { "share", "S", "Of simplified: part of the triangles that is left, at least (default: 0.1)",
      SETTING_NUMBER, OF(share), .low = 0.001, .high = 1 },
    { "field", "N",
      "Of displacement: samples of the field of distances along its longest side (default: 128)",
      SETTING_INTEGER, OF(field), .low = 8, .high = 512 },
    { "source-size", "WxH", "Size of the image that is captured (default: 512x512)", SETTING_SIZE,
      OF(source_size), .low = 1, .high = 4096 },
    { "turn", "DEGREES",
      "How far the view is turned to the right of the source, about the middle of the model "
      "(default: 12)",
      SETTING_NUMBER, OF(turn), .low = -180, .high = 180 },

    { "source", "CAMERA.json",
      "The camera by which a mesh is captured, as scenes have it: eye, at, up, fovy, near, far "
      "(default: one that sees all of it, from 30 degrees to the right and 20 above)",
      SETTING_TEXT, OF(source), .aside = true },
    { "color", "NAME",
      "Of a mesh: file, its own colours (default where there are any); " MODEL_COLOR_HELP,
      SETTING_TEXT, OF(color), .aside = true },
    { "unlit", NULL, "Show colours as they are, without light", SETTING_FLAG, OF(unlit),
      .aside = true },
    { "detail", "FILE",
      "Of layers, direct, planar and cylinder: a small relief all over, whose heights are the "
      "brightness of a picture, or its fourth channel",
      SETTING_TEXT, OF(detail), .aside = true },
    { "detail-depth", "D",
      "By how much white stands out of black, in the model's unit; below 0: is carved in (default: "
      "a 50th of its longest side)",
      SETTING_NUMBER, OF(detail_depth), .low = -1e9, .high = 1e9, .aside = true },
    { "detail-repeat", "N", "So many copies of the relief across the image (default: 4)",
      SETTING_INTEGER, OF(detail_repeat), .low = 1, .high = 1024, .aside = true },
    { "camera", "FILE", "The view: a camera, as scenes have it", SETTING_TEXT, OF(camera),
      .aside = true },
    { "from", "AZIMUTH ELEVATION",
      "Where the model is seen from, in degrees (0 0 is in front; default: beside the source)",
      SETTING_VECTOR, OF(orbit.azimuth), .low = -360, .high = 360, .count = 2, .aside = true },
    { "up", NULL, "Which axis points up, and cylinders stand along: y (default), z, x, -y or -z",
      SETTING_NAME, OF(orbit.up), .names = warp_ups, .aside = true },
    { "zoom", "F", "Larger by so much than what fills the picture, with --from", SETTING_NUMBER,
      OF(orbit.zoom), .low = 0.1, .high = 1000, .aside = true },
    { "truth", "FILE",
      "What the picture is held against: a mesh, or a depth image from the eye of the view, such "
      "as a photograph (default: the mesh that was captured)",
      SETTING_TEXT, OF(truth), .aside = true },
    { "measure", NULL, "Hold the picture against the truth, and say how far off it is",
      SETTING_FLAG, OF(measures), .aside = true },
    { .name = NULL },
};

_Static_assert(OF(orbit.elevation) == OF(orbit.azimuth) + sizeof(double), "two angles");

#define BIT(number) (1u << (number))

const char *warp_method_name(WarpMethod method)
{
    return methods[method];
}

bool warp_method_draws(WarpMethod method, WarpKind kind)
{
    static const uint32_t draws[WARP_METHODS] = {
        [WARP_AUTO] = BIT(WARP_PLANAR) | BIT(WARP_CYLINDER) | BIT(WARP_BOX),
        [WARP_LAYERS] = BIT(WARP_PLANAR) | BIT(WARP_BOX),
        [WARP_DIRECT] = BIT(WARP_PLANAR) | BIT(WARP_BOX),
        [WARP_SURFACE] = BIT(WARP_PLANAR) | BIT(WARP_CYLINDER) | BIT(WARP_BOX),
        [WARP_PLANAR_PRINTED] = BIT(WARP_PLANAR) | BIT(WARP_BOX),
        [WARP_CYLINDER_PRINTED] = BIT(WARP_CYLINDER),
        [WARP_RELIEF] = BIT(WARP_PLANAR) | BIT(WARP_BOX),
        [WARP_DMESH] = BIT(WARP_PLANAR) | BIT(WARP_BOX),
        [WARP_SIMPLIFIED] = BIT(WARP_PLANAR) | BIT(WARP_BOX),
        [WARP_DISPLACEMENT] = BIT(WARP_PLANAR) | BIT(WARP_BOX),
        [WARP_RELIEF_TEXTURE] = BIT(WARP_PLANAR) | BIT(WARP_BOX),
        [WARP_PARALLAX] = BIT(WARP_PLANAR) | BIT(WARP_BOX),
        [WARP_BUMP] = BIT(WARP_PLANAR) | BIT(WARP_BOX),
        [WARP_POLYGONS] = BIT(WARP_PLANAR) | BIT(WARP_CYLINDER) | BIT(WARP_BOX),
    };
    return draws[method] >> kind & 1;
}

WarpMethod warp_auto_method(WarpKind kind, bool has_detail)
{
    return kind == WARP_PLANAR     ? WARP_LAYERS
           : !has_detail           ? WARP_SURFACE
           : kind == WARP_CYLINDER ? WARP_CYLINDER_PRINTED
                                   : WARP_LAYERS; /* surfaces are merged before any relief */
}

/* --- what goes together ----------------------------------------------------------------------- */

/* Options of some methods alone. Where no method is named they mean the first of them, unless auto
 * is one; beside others they are refused. */
static const struct {
    const char *option;
    uint32_t methods;
} belongs[] = {
    { "step", BIT(WARP_AUTO) | BIT(WARP_LAYERS) | BIT(WARP_DIRECT) | BIT(WARP_SURFACE) |
                  BIT(WARP_PLANAR_PRINTED) | BIT(WARP_CYLINDER_PRINTED) },
    { "cut", BIT(WARP_AUTO) | BIT(WARP_LAYERS) | BIT(WARP_DIRECT) | BIT(WARP_PLANAR_PRINTED) |
                 BIT(WARP_RELIEF_TEXTURE) },
    { "tolerance", BIT(WARP_AUTO) | BIT(WARP_LAYERS) | BIT(WARP_DIRECT) },
    { "entries", BIT(WARP_PLANAR_PRINTED) },
    { "search", BIT(WARP_RELIEF) | BIT(WARP_DISPLACEMENT) },
    { "halvings", BIT(WARP_RELIEF) },
    { "unlimited", BIT(WARP_PARALLAX) },
    { "share", BIT(WARP_SIMPLIFIED) },
    { "field", BIT(WARP_DISPLACEMENT) },
    { "detail", BIT(WARP_AUTO) | BIT(WARP_LAYERS) | BIT(WARP_DIRECT) | BIT(WARP_PLANAR_PRINTED) |
                    BIT(WARP_CYLINDER_PRINTED) },
};

void warp_options_imply(void *setting, uint32_t given)
{
    WarpOptions *options = setting;
    for (size_t i = 0; i < GP_COUNT(belongs); i++)
        if (!setting_is_given(warp_settings, given, "method") &&
            setting_is_given(warp_settings, given, belongs[i].option) &&
            !(belongs[i].methods >> options->method & 1))
            options->method = (WarpMethod)__builtin_ctz(belongs[i].methods);
    if (!setting_is_given(warp_settings, given, "kind") &&
        !warp_method_draws(options->method, WARP_PLANAR))
        options->kind = WARP_CYLINDER;
}

GpResult warp_options_check(const void *setting, uint32_t given, const char *extension,
                            GpError *error)
{
    const WarpOptions *options = setting;
    const SettingField *fields = warp_settings;
    const bool is_auto = options->method == WARP_AUTO;
    const WarpMethod method =
        is_auto ? warp_auto_method(options->kind, options->detail) : options->method;
    double waves;
    (void)extension;
    const bool is_from = setting_is_given(fields, given, "from"),
               is_turned = setting_is_given(fields, given, "turn");
    const struct {
        bool is_wrong;
        const char *reason;
    } rules[] = {
        { options->camera && is_from,
          "--camera and --from: a camera is described by the one or the other" },
        { is_turned && (is_from || options->camera),
          "--turn is about the source: no --camera and no --from beside it" },
        { is_from && fabs(options->orbit.elevation) > 89,
          "--from: expected -89 to 89 degrees of elevation" },
        { !is_from && setting_is_given(fields, given, "zoom"), "--zoom is for --from" },
        { options->truth && !options->measures, "--truth is for --measure" },
        { !options->detail && (setting_is_given(fields, given, "detail-depth") ||
                               setting_is_given(fields, given, "detail-repeat")),
          "--detail-depth and --detail-repeat are for --detail" },
        { options->detail && setting_is_given(fields, given, "tolerance"),
          "--tolerance does not go with --detail, under which nothing is merged" },
        { options->detail && options->measures && !options->truth,
          "--measure: the mesh lacks what --detail adds to it; --truth names one that has it" },
        { options->method == WARP_PLANAR_PRINTED && options->cut == WARP_CUT_RELATIVE,
          "--cut relative does not go with --method planar" },
        { options->method == WARP_RELIEF_TEXTURE && options->cut == WARP_CUT_SLOPES,
          "--cut slopes does not go with --method relief-texture" },
    };
    for (size_t i = 0; i < GP_COUNT(rules); i++)
        if (rules[i].is_wrong)
            return gp_fail(error, GP_ERROR_INVALID, "%s", rules[i].reason);
    for (size_t i = 0; i < GP_COUNT(belongs); i++)
        if (!(belongs[i].methods >> method & 1) &&
            setting_is_given(fields, given, belongs[i].option))
            return gp_fail(error, GP_ERROR_INVALID, "--%s does not go with --method %s%s%s",
                           belongs[i].option, methods[method],
                           is_auto ? ", which draws images of --kind " : "",
                           is_auto ? kinds[options->kind] : "");
    if (!warp_method_draws(options->method, options->kind))
        return gp_fail(error, GP_ERROR_INVALID, "--method %s does not draw images of --kind %s",
                       methods[options->method], kinds[options->kind]);
    return model_waves(options->color, &waves, error);
}
