#include "apps/techniques/warp/options.h"

#include "apps/base/model_color.h"

#include <math.h>

#define DEFAULT_TURN 12

const WarpOptions warp_option_defaults = {
    .source_size = { 512, 512 },
    .turn = DEFAULT_TURN,
    .orbit = { .azimuth = (double)NAN, .elevation = (double)NAN, .zoom = 1 },
};

static const char *const methods[] = {
    [WARP_AUTO] = "auto", [WARP_POLYGONS] = "polygons", [WARP_METHODS] = NULL
};
static const char *const kinds[] = { [WARP_PLANAR] = "planar", [WARP_CYLINDER] = "cylinder", NULL };
static const char *const ups[] = { "y", "z", "x", "-y", "-z", NULL };

#define OF(member) offsetof(WarpOptions, member)

const SettingField warp_settings[] = {
    { "method", NULL, "auto: by what the image is (default); polygons: the mesh itself",
      SETTING_NAME, OF(method), .names = methods },
    { "source-size", "WxH", "Size of the image that is captured (default: 512x512)", SETTING_SIZE,
      OF(source_size), .low = 1, .high = 4096 },
    { "turn", "DEGREES",
      "How far the view is turned to the right of the source, about the middle of the model "
      "(default: 12)",
      SETTING_NUMBER, OF(turn), .low = -180, .high = 180 },

    { "kind", NULL,
      "What is captured of a mesh: planar, a picture (default); cylinder, one that is looked "
      "through from all sides",
      SETTING_NAME, OF(kind), .names = kinds, .aside = true },
    { "source", "CAMERA.json",
      "The camera by which a mesh is captured, as scenes have it: eye, at, up, fovy, near, far "
      "(default: one that sees all of it, from 30 degrees to the right and 20 above)",
      SETTING_TEXT, OF(source), .aside = true },
    { "color", "NAME",
      "Of a mesh: file, its own colours (default where there are any); " MODEL_COLOR_HELP,
      SETTING_TEXT, OF(color), .aside = true },
    { "unlit", NULL, "Show colours as they are, without light", SETTING_FLAG, OF(unlit),
      .aside = true },
    { "camera", "FILE", "The view: a camera, as scenes have it", SETTING_TEXT, OF(camera),
      .aside = true },
    { "from", "AZIMUTH ELEVATION",
      "Where the model is seen from, in degrees (0 0 is in front; default: beside the source)",
      SETTING_VECTOR, OF(orbit.azimuth), .low = -360, .high = 360, .count = 2, .aside = true },
    { "up", NULL, "Which axis points up: y (default), z, x, -y or -z", SETTING_NAME, OF(orbit.up),
      .names = ups, .aside = true },
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

const char *warp_method_name(WarpMethod method)
{
    return methods[method];
}

/* --- what goes together ------------------------------------------------------------------------- */

void warp_options_imply(void *setting, uint32_t given)
{
    (void)setting, (void)given;
}

GpResult warp_options_check(const void *setting, uint32_t given, const char *extension,
                            GpError *error)
{
    const WarpOptions *options = setting;
    const SettingField *fields = warp_settings;
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
    };
    for (size_t i = 0; i < GP_COUNT(rules); i++)
        if (rules[i].is_wrong)
            return gp_fail(error, GP_ERROR_INVALID, "%s", rules[i].reason);
    return model_waves(options->color, &waves, error);
}
