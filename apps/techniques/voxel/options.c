#include "apps/techniques/voxel/options.h"

#include <math.h>
#include <string.h>

const VoxelOptions voxel_option_defaults = {
    .voxels = { .size = 128, .bits = 1, .blend = VOXEL_ADD, .axes = 3 },
    .picture = { .width = 512,
                 .height = 512,
                 .orbit = { .azimuth = 30, .elevation = 20, .zoom = 1 } },
};

/* --- the table -------------------------------------------------------------------------------- */

static const char *const kinds[] = { "surface", "solid", NULL };
static const char *const methods[] = { "auto",   "conservative", "thin", "xor",   "winding",
                                       "sheets", "slices",       "ldi",  "faces", NULL };
static const char *const counters[] = { "half", "byte", NULL };
static const char *const blends[] = { "add", "or", NULL };
static const char *const values[] = { "density", "normal", "color", NULL };
static const char *const ways[] = { "union", "intersection", "difference", "collide", NULL };
static const char *const looks[] = { "opaque", "transparent", NULL };
static const char *const shadings[] = { "smooth", "cubes", NULL };
static const char *const ups[] = { "y", "z", "x", "-y", "-z", NULL };

#define OF(member) offsetof(VoxelOptions, member)
#define FARTHEST   1e30 /* so that it is a float too */

const SettingField voxel_settings[] = {
    { "size", "N", "Voxels a side of the volume, 8 to 1024 (default: 128)", SETTING_INTEGER,
      OF(voxels.size), .low = 8, .high = 1024, .letter = 'n' },
    { "kind", NULL, "surface: what triangles touch (default); solid: what they enclose",
      SETTING_NAME, OF(voxels.kind), .names = kinds },
    { "method", NULL,
      "conservative: every voxel that is touched (default for surfaces); thin: those met by lines "
      "through centres; xor: each triangle turns over what is below it (default for solids); "
      "winding: the same with signs, so that parts that overlap or are nested stay full; "
      "sheets: as printed in 2004; slices, ldi, faces: older ones",
      SETTING_NAME, OF(voxels.method), .names = methods },
    { "bits", "B", "Bits a voxel: 1 (default), 8 or 16; more than one of the method sheets",
      SETTING_INTEGER, OF(voxels.bits), .low = 1, .high = 16 },
    { "blend", NULL,
      "How the method sheets merges what falls into one voxel: add, as printed (default); or",
      SETTING_NAME, OF(voxels.blend), .names = blends },
    { "axes", "A", "Axes along which the method sheets looks: 3 (default), or 1: along z",
      SETTING_INTEGER, OF(voxels.axes), .low = 1, .high = 3 },
    { "value", NULL, "What voxels of 8 and 16 bits hold: density (default), normal or color",
      SETTING_NAME, OF(voxels.value), .names = values },
    { "counters", NULL,
      "What the method winding counts in: half, floats of 16 bits (default), right up to 2048 "
      "triangles above a voxel; or byte, up to 127",
      SETTING_NAME, OF(voxels.counters), .names = counters },

    { "xform", "S TX TY TZ",
      "Where the model lies in the volume: voxels = S * position + T (default: its box, in the "
      "centre)",
      SETTING_VECTOR, OF(box), .low = -FARTHEST, .high = FARTHEST, .count = 4, .aside = true },
    { "points", NULL, "Take a mesh's vertices alone, as points", SETTING_FLAG, OF(takes_points),
      .aside = true },
    { "twist", "DEGREES", "Twist the mesh, from its floor to its top by so much", SETTING_NUMBER,
      OF(twist), .low = -VOXEL_MOST_TWIST, .high = VOXEL_MOST_TWIST, .aside = true },
    { "with", "MESH", "A second model, in one volume with the first", SETTING_TEXT, OF(with),
      .aside = true },
    { "combine", NULL,
      "What two models make: union (default), intersection, difference; collide: the voxels that "
      "both have, and where they are",
      SETTING_NAME, OF(combine), .names = ways, .aside = true },
    { "fit", "F",
      "Give the second model F times the first's longest side, and its centre; without a second: "
      "the model in its volume, or scan",
      SETTING_NUMBER, OF(place.fit), .low = 0.001, .high = 1000, .aside = true },
    { "move", "X Y Z", "Then move it, by longest sides of the first", SETTING_VECTOR,
      OF(place.move), .low = -FARTHEST, .high = FARTHEST, .count = 3, .aside = true },
    { "report", NULL,
      "Print what the mesh is: whether it is closed, and what is wrong with it; of solids, where "
      "axes disagree",
      SETTING_FLAG, OF(wants_report), .aside = true },

    { "scan", "FILE",
      "Show the model inside a scanned volume: .nrrd, or .raw, .raw.gz with a .json beside it",
      SETTING_TEXT, OF(scan), .aside = true, .for_pictures = true },
    { "look", NULL, "Of pictures: opaque (default) or transparent", SETTING_NAME, OF(picture.look),
      .names = looks, .aside = true, .for_pictures = true },
    { "shading", NULL, "Of opaque voxels: smooth (default) or cubes", SETTING_NAME,
      OF(picture.shading), .names = shadings, .aside = true, .for_pictures = true },
    { "picture", "WxH", "Size of a picture (default: 512x512)", SETTING_SIZE, OF(picture.width),
      .low = 1, .high = GP_MAX_SIZE, .aside = true, .for_pictures = true },
    { "from", "AZIMUTH ELEVATION",
      "Where a picture is seen from, in degrees (default: 30 20; 0 0 is in front)", SETTING_VECTOR,
      OF(picture.orbit.azimuth), .low = -360, .high = 360, .count = 2, .aside = true,
      .for_pictures = true },
    { "up", NULL, "Which axis points up in a picture: y (default), z, x, -y or -z", SETTING_NAME,
      OF(picture.orbit.up), .names = ups, .aside = true, .for_pictures = true },
    { "zoom", "F", "Larger by so much than what fills a picture", SETTING_NUMBER,
      OF(picture.orbit.zoom), .low = 0.1, .high = 10, .aside = true, .for_pictures = true },
    { .name = NULL },
};

/* Sizes and angles are two members each, one behind the other. */
_Static_assert(OF(picture.height) == OF(picture.width) + sizeof(uint32_t), "a size");
_Static_assert(OF(picture.orbit.elevation) == OF(picture.orbit.azimuth) + sizeof(double),
               "two angles");

/* --- what goes together ----------------------------------------------------------------------- */

/* Options of one method, or of more than one bit, that are given beside another. */
static bool is_given_in_vain(const VoxelOptions *options, uint32_t given, const char **reason)
{
    const VoxelMethod method = options->voxels.method;
    const struct {
        const char *option;
        bool is_used;
        const char *reason;
    } rows[] = {
        { "axes", method == VOXEL_SHEETS, "--axes is for --method sheets" },
        { "blend", method == VOXEL_SHEETS, "--blend is for --method sheets" },
        { "counters", method == VOXEL_WINDING, "--counters is for --method winding" },
        { "value", options->voxels.bits != 1, "--value is for --bits 8 and 16" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        if (!rows[i].is_used && setting_is_given(voxel_settings, given, rows[i].option)) {
            *reason = rows[i].reason;
            return true;
        }
    return false;
}

static bool can_twist(VoxelMethod method)
{
    return method == VOXEL_AUTO || method == VOXEL_CONSERVATIVE || method == VOXEL_THIN ||
           method == VOXEL_XOR || method == VOXEL_WINDING;
}

GpResult voxel_options_check(const void *setting, uint32_t given, const char *extension,
                             GpError *error)
{
    const VoxelOptions *options = setting;
    const bool alone = !options->with, fits = options->place.fit > 0;
    const bool placed = setting_is_given(voxel_settings, given, "xform");
    const bool moves = setting_is_given(voxel_settings, given, "move");
    const VoxelMethod method = options->voxels.method;
    const char *vain = "";
    const bool in_vain = is_given_in_vain(options, given, &vain);
    const struct {
        bool is_wrong;
        const char *reason;
    } rules[] = {
        { options->voxels.bits != 1 && options->voxels.bits != 8 && options->voxels.bits != 16,
          "--bits: expected 1, 8 or 16" },
        { options->voxels.bits != 1 && method != VOXEL_SHEETS,
          "--bits: more than one bit a voxel only --method sheets has" },
        { options->voxels.axes == 2, "--axes: expected 1 or 3, not 2" },
        { setting_is_given(voxel_settings, given, "twist") && !can_twist(method),
          "--twist: expected --method conservative, thin, xor or winding" },
        { in_vain, vain },
        { placed && !(options->box[0] > 0),
          "--xform: expected four numbers, the first above 0: the scale" },
        { alone && setting_is_given(voxel_settings, given, "combine"),
          "--combine needs a second model: --with" },
        { !alone && options->scan, "--scan is around one model, without --with" },
        { alone && placed && (fits || moves),
          "--xform places the model, so that --fit and --move cannot" },
        { alone && moves && !options->scan && !fits,
          "--move moves a second model (--with), or one of another size (--fit)" },
        { strcmp(extension, "bits") == 0 && options->voxels.bits != 1,
          "-o: a file .bits has one bit a voxel, not 8 or 16; expected a name that ends with "
          ".nrrd" },
    };
    const Orbit *orbit = &options->picture.orbit;
    if (fabs(orbit->elevation) > 89)
        return gp_fail(error, GP_ERROR_INVALID,
                       "--from: expected -360 to 360 and -89 to 89 degrees, not %g %g",
                       orbit->azimuth, orbit->elevation);
    for (size_t i = 0; i < GP_COUNT(rules); i++)
        if (rules[i].is_wrong)
            return gp_fail(error, GP_ERROR_INVALID, "%s", rules[i].reason);
    return GP_OK;
}
