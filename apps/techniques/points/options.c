#include "apps/techniques/points/options.h"

#include "apps/base/model_color.h"
#include "apps/points/drawing/choose.h"

#include <math.h>

const PointsOptions points_option_defaults = {
    .splats = SPLAT_DEFAULTS,
    .orbit = { .azimuth = 30, .elevation = 20, .zoom = 1 },
};

/* --- the table -------------------------------------------------------------------------------- */

static const char *const methods[] = { "adaptive", "ewa",      "reconstruction", "lowpass",
                                       "area",     "distance", "ternary",        "perspective",
                                       "quads",    "sprites",  "pixels",         "qsplat",
                                       "spt",      NULL };
static const char *const forms[] = { "none", "ours", "printed", NULL };
static const char *const sums[] = { "half", "float", "byte", NULL };
static const char *const ups[] = { "y", "z", "x", "-y", "-z", NULL };

#define OF(member) offsetof(PointsOptions, member)

const SettingField points_settings[] = {
    { "method", NULL,
      "adaptive: the cheapest filter within a bound of both (default); ewa: both filters, the "
      "surfel's and the pixel's; reconstruction, lowpass: one of them; area, distance: adaptive as "
      "printed; ternary: both in one pass, by a depth test that replaces, adds or drops; "
      "perspective: both, by each pixel's ray against a point's plane; quads: both, four vertices "
      "a point; sprites: discs without filters; pixels: a pixel a point; qsplat, spt: squares of "
      "nodes at most --detail pixels wide (default: 1), found by a walk down the tree, or in a "
      "sequence",
      SETTING_NAME, OF(splats.method), .names = methods },
    { "sums", NULL, "What weights and attributes are added up in: half (default), float or byte",
      SETTING_NAME, OF(splats.sums), .names = sums },
    { "lowpass", "S", "Standard deviation of the pixel's filter, in pixels (default: 0.4)",
      SETTING_NUMBER, OF(splats.low_pass), .low = 0.05, .high = 4 },
    { "spread", "R", "Standard deviation of a point's own Gaussian, in its radii (default: 0.8)",
      SETTING_NUMBER, OF(splats.spread), .low = 0.05, .high = 4 },
    { "cut", "C", "Splats end at so many standard deviations (default: 2)", SETTING_NUMBER,
      OF(splats.cut), .low = 0.5, .high = 6 },
    { "epsilon", "E",
      "How far behind the surface points are hidden, by the footprints of its splats (default: 4)",
      SETTING_NUMBER, OF(splats.epsilon), .low = 0, .high = 1000 },
    { "tolerance", "T",
      "Of the adaptive method: by how much a colour of 0 to 1 may be off where a filter is left "
      "out, or points are merged (default: 0.05)",
      SETTING_NUMBER, OF(splats.tolerance), .low = 0, .high = 1 },
    { "detail", "P",
      "Merge points while that widens splats by at most P pixels, in standard deviations (default: "
      "0, none; of the adaptive method, what its tolerance allows)",
      SETTING_NUMBER, OF(detail), .low = 0, .high = 64 },
    { "budget", "N", "Show at most N splats, merged as far as that takes", SETTING_INTEGER,
      OF(budget), .low = 1, .high = 1 << 30 },
    { "compress", NULL,
      "Keep points in 8 bytes, taken apart as they are drawn: none (default), ours or printed; for "
      "the methods adaptive to distance",
      SETTING_NAME, OF(compress), .names = forms },
    { "two-sided", NULL, "Draw points that face away from the eye too", SETTING_FLAG,
      OF(splats.two_sided), .low = 0 },

    { "subdivide", "K", "Of a mesh: its vertices after K midpoint subdivisions, 0 to 8",
      SETTING_INTEGER, OF(subdivide), .low = 0, .high = 8, .aside = true },
    { "sample", "N", "Of a mesh: N points, spread evenly over its area", SETTING_INTEGER,
      OF(sample), .low = 1, .high = 1 << 27, .aside = true },
    { "sharp", "A",
      "Of a mesh: where its triangles meet at more than A degrees, such as 40, a point for each "
      "side of the crease, at which its splat ends; ewa then stands for adaptive",
      SETTING_NUMBER, OF(sharp), .low = 1, .high = 179, .aside = true },
    { "one-radius", NULL,
      "Of a mesh: give all its vertices one radius, the smallest without holes, instead of each "
      "its own",
      SETTING_FLAG, OF(one_radius), .aside = true },
    { "color", "NAME", "file: the points' own (default where there are any); " MODEL_COLOR_HELP,
      SETTING_TEXT, OF(color), .aside = true },
    { "unlit", NULL, "Show colours as they are, without light", SETTING_FLAG, OF(unlit),
      .aside = true },
    { "camera", "FILE", "A camera, as scenes have it: eye, at, up, fovy, near, far", SETTING_TEXT,
      OF(camera), .aside = true },
    { "from", "AZIMUTH ELEVATION",
      "Where the model is seen from, in degrees (default: 30 20; 0 0 is in front)", SETTING_VECTOR,
      OF(orbit.azimuth), .low = -360, .high = 360, .count = 2, .aside = true },
    { "up", NULL, "Which axis points up: y (default), z, x, -y or -z", SETTING_NAME, OF(orbit.up),
      .names = ups, .aside = true },
    { "zoom", "F", "Larger by so much than what fills the picture", SETTING_NUMBER, OF(orbit.zoom),
      .low = 0.1, .high = 1000, .aside = true },
    { "cache", "FILE",
      "Keep what is built of the points in FILE, and take it from there where it is of the same "
      "points and settings",
      SETTING_TEXT, OF(cache), .aside = true },
    { "measure", NULL, "Hold the picture against the truth, and say how far off it is",
      SETTING_FLAG, OF(measures), .aside = true },
    { "report", NULL, "Print what was read, and what was estimated", SETTING_FLAG, OF(reports),
      .aside = true },
    { .name = NULL },
};

_Static_assert(OF(orbit.elevation) == OF(orbit.azimuth) + sizeof(double), "two angles");

/* --- what is built for them ------------------------------------------------------------------- */

/* Whether surfels are taken from patches, whatever the method. */
static bool is_kept_in_patches(const PointsOptions *options)
{
    return options->detail > 0 || options->budget > 0 || options->cache || options->compress;
}

/* Patches know no clips, but the adaptive method chooses by patches. */
SplatMethod points_method(const PointsOptions *options)
{
    const SplatMethod method = options->splats.method;
    const bool is_clipped = options->sharp > 0 && !is_kept_in_patches(options);
    return method == SPLAT_ADAPTIVE && is_clipped ? SPLAT_EWA : method;
}

bool points_needs_patches(const PointsOptions *options)
{
    const SplatMethod method = points_method(options);
    return splat_needs_patches(method) || method == SPLAT_QSPLAT || method == SPLAT_SEQUENCE ||
           is_kept_in_patches(options);
}

/* --- what goes together ----------------------------------------------------------------------- */

GpResult points_options_check(const void *setting, uint32_t given, const char *extension,
                              GpError *error)
{
    const PointsOptions *options = setting;
    double waves;
    (void)extension;
    const struct {
        bool is_wrong;
        const char *reason;
    } rules[] = {
        { options->sample && setting_is_given(points_settings, given, "subdivide"),
          "--sample and --subdivide: points come from the one or the other" },
        { options->camera && setting_is_given(points_settings, given, "from"),
          "--camera and --from: a camera is described by the one or the other" },
        { options->compress && !splat_takes_compressed(options->splats.method),
          "--compress: expected the method adaptive, ewa, reconstruction, lowpass, area or "
          "distance" },
        { fabs(options->orbit.elevation) > 89, "--from: expected -89 to 89 degrees of elevation" },
    };
    for (size_t i = 0; i < GP_COUNT(rules); i++)
        if (rules[i].is_wrong)
            return gp_fail(error, GP_ERROR_INVALID, "%s", rules[i].reason);
    return model_waves(options->color, &waves, error);
}
