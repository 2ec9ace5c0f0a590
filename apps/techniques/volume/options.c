#include "apps/techniques/volume/options.h"

#include <math.h>

const VolumeOptions volume_option_defaults = {
    .splats = VOLUME_SPLAT_DEFAULTS,
    .orbit = { .azimuth = 30, .elevation = 20, .zoom = 1 },
};

static const char *const methods[] = { [VOLUME_RAYCAST] = "raycast",
                                       [VOLUME_SLICES] = "slices",
                                       [VOLUME_SPLAT] = "splat",
                                       [VOLUME_METHODS] = NULL };
static const char *const modes[] = { [VOXELS_VB] = "vb", [VOXELS_VT] = "vt", [VOXELS_PT] = "pt",
                                     [VOXELS_IM] = "im", [VOXELS_QD] = "qd", NULL };
static const char *const filters[] = {
    [VOXEL_EWA] = "ewa",          [VOXEL_RECONSTRUCTION] = "reconstruction",
    [VOXEL_LOW_PASS] = "lowpass", [VOXEL_ADAPTIVE] = "adaptive",
    [VOXEL_BOUNDED] = "bounded",  [VOXEL_FILTERS] = NULL
};
static const char *const sheets[] = { [SHEETS_AXIS] = "axis", [SHEETS_IMAGE] = "image", NULL };
static const char *const sums[] = { [VOXEL_HALVES] = "16f",
                                    [VOXEL_FLOATS] = "32f",
                                    [VOXEL_BYTES] = "8",
                                    [VOXEL_BYTES_NEAR] = "adaptive",
                                    NULL };
static const char *const ups[] = { "y", "z", "x", "-y", "-z", NULL };

#define OF(member) offsetof(VolumeOptions, member)

const SettingField volume_settings[] = {
    { "method", NULL,
      "raycast: a ray for each pixel, values interpolated and then classified (default); slices: "
      "the same in planes between slices, with 2D textures; splat: each sample a spot, added up in "
      "sheets. An option of one method alone means that method",
      SETTING_NAME, OF(method), .names = methods },

    { "step", "L", "Length of a ray's steps, in samples (default: 1)", SETTING_NUMBER,
      OF(rays.step), .low = 0.05, .high = 16 },
    { "spacing", "L", "Of slices: distance of planes, in samples (default: 1)", SETTING_NUMBER,
      OF(slices.spacing), .low = 0.05, .high = 16 },
    { "mode", NULL,
      "Where splats are kept: vb, all in vertex buffers (default); vt, pt: values in a texture "
      "that the vertex or the pixel shader reads; im: a draw for each; qd: four vertices each",
      SETTING_NAME, OF(splats.mode), .names = modes },
    { "filter", NULL,
      "What a splat is as wide as: ewa, its kernel and the pixel's filter (default); "
      "reconstruction, lowpass: one of them; adaptive: by distances, as printed; bounded: the "
      "cheapest within the tolerance",
      SETTING_NAME, OF(splats.filter), .names = filters },
    { "sheets", NULL,
      "What splats are added up in: axis, slices of the volume (default); image: slabs of equal "
      "depth",
      SETTING_NAME, OF(splats.sheets), .names = sheets },
    { "accumulate", NULL,
      "What sheets are added up in: 16f (default) or 32f, floats; 8 bits; adaptive: 8 bits where "
      "the volume is near",
      SETTING_NAME, OF(splats.sums), .names = sums },
    { "after", NULL, "Classify what splats add up to, not samples before they are splatted",
      SETTING_FLAG, OF(splats.after), .low = 0 },
    { "alphas", NULL, "Add up opacities, as printed, not extinctions", SETTING_FLAG,
      OF(splats.alphas), .low = 0 },
    { "flat", NULL, "Flatten the kernels of opaque samples into their surface", SETTING_FLAG,
      OF(splats.flat), .low = 0 },
    { "deviation", "S", "Standard deviation of a splat's kernel, in samples (default: 0.5)",
      SETTING_NUMBER, OF(splats.deviation), .low = 0.2, .high = 4 },
    { "cut", "C", "Splats end at so many standard deviations (default: 2)", SETTING_NUMBER,
      OF(splats.cut), .low = 0.5, .high = 6 },
    { "lowpass", "S", "Standard deviation of the pixel's filter, in pixels (default: 0.4)",
      SETTING_NUMBER, OF(splats.low_pass), .low = 0.05, .high = 4 },
    { "tolerance", "T",
      "Of the filter bounded: the share of what splats add that may lie elsewhere (default: 0.05)",
      SETTING_NUMBER, OF(splats.tolerance), .low = 0, .high = 1 },
    { "thickness", "L",
      "Of sheets: so many slices or samples (default: 2 slices, 1 sample; as printed: 1)",
      SETTING_NUMBER, OF(splats.thickness), .low = 0.25, .high = 64 },

    { "cull", "N", "Mark opaque pixels every N sheets (default: 0, never)", SETTING_INTEGER,
      OF(splats.cull), .low = 0, .high = 64 },

    { "transfer", "FILE",
      "What values look like: lines of value, red, green, blue, opacity; or bonsai, engine, "
      "marschner-lobb, checkerboard or fog (default: chosen from the histogram)",
      SETTING_TEXT, OF(transfer), .aside = true },
    { "lit", NULL, "Light surfaces in the volume from beside the eye", SETTING_FLAG, OF(lit),
      .aside = true },
    { "camera", "FILE", "A camera, as scenes have it: eye, at, up, fovy, near, far", SETTING_TEXT,
      OF(camera), .aside = true },
    { "from", "AZIMUTH ELEVATION",
      "Where the volume is seen from, in degrees (default: 30 20; 0 0 is in front)", SETTING_VECTOR,
      OF(orbit.azimuth), .low = -360, .high = 360, .count = 2, .aside = true },
    { "up", NULL, "Which axis points up: y (default), z, x, -y or -z", SETTING_NAME, OF(orbit.up),
      .names = ups, .aside = true },
    { "zoom", "F", "Larger by so much than what fills the picture", SETTING_NUMBER, OF(orbit.zoom),
      .low = 0.1, .high = 1000, .aside = true },
    { "measure", NULL, "Hold the picture against the truths, and say how far off it is",
      SETTING_FLAG, OF(measures), .aside = true },
    { .name = NULL },
};

_Static_assert(OF(orbit.elevation) == OF(orbit.azimuth) + sizeof(double), "two angles");

/* --- what goes together ----------------------------------------------------------------------- */

/* Options of one method, which mean it where none is named, and are refused beside another. */
static const struct {
    const char *option;
    VolumeMethod method;
} belongs[] = {
    { "step", VOLUME_RAYCAST },    { "spacing", VOLUME_SLICES },  { "mode", VOLUME_SPLAT },
    { "filter", VOLUME_SPLAT },    { "sheets", VOLUME_SPLAT },    { "accumulate", VOLUME_SPLAT },
    { "after", VOLUME_SPLAT },     { "alphas", VOLUME_SPLAT },    { "flat", VOLUME_SPLAT },
    { "deviation", VOLUME_SPLAT }, { "cut", VOLUME_SPLAT },       { "lowpass", VOLUME_SPLAT },
    { "tolerance", VOLUME_SPLAT }, { "thickness", VOLUME_SPLAT }, { "cull", VOLUME_SPLAT },
};

void volume_options_imply(void *setting, uint32_t given)
{
    VolumeOptions *options = setting;
    if (setting_is_given(volume_settings, given, "method"))
        return;
    for (size_t i = 0; i < GP_COUNT(belongs); i++)
        if (setting_is_given(volume_settings, given, belongs[i].option))
            options->method = belongs[i].method;
}

GpResult volume_options_check(const void *setting, uint32_t given, const char *extension,
                              GpError *error)
{
    const VolumeOptions *options = setting;
    (void)extension;
    for (size_t i = 0; i < GP_COUNT(belongs); i++)
        if (options->method != belongs[i].method &&
            setting_is_given(volume_settings, given, belongs[i].option))
            return gp_fail(error, GP_ERROR_INVALID, "--%s: expected --method %s with it",
                           belongs[i].option, methods[belongs[i].method]);
    if (options->camera && setting_is_given(volume_settings, given, "from"))
        return gp_fail(error, GP_ERROR_INVALID,
                       "--camera and --from: a camera is described by the one or the other");
    if (fabs(options->orbit.elevation) > 89)
        return gp_fail(error, GP_ERROR_INVALID, "--from: expected -89 to 89 degrees of elevation");
    return GP_OK;
}
