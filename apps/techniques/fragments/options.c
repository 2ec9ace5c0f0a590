#include "apps/techniques/fragments/options.h"

#include <math.h>

const FragmentOptions fragment_option_defaults = {
    .kept = 8,
    .alpha = 0.3,
    .orbit = { .azimuth = 30, .elevation = 20, .zoom = 1 },
};

static const char *const methods[] = { [FRAGMENTS_CONVEX] = "convex",
                                       [FRAGMENTS_SORTED] = "sorted",
                                       [FRAGMENTS_DP] = "dp",
                                       [FRAGMENTS_DDP] = "ddp",
                                       [FRAGMENTS_KBUFFER] = "kbuffer",
                                       [FRAGMENTS_STENCIL] = "stencil",
                                       [FRAGMENTS_BUCKET1] = "bucket1",
                                       [FRAGMENTS_BUCKET2] = "bucket2",
                                       [FRAGMENTS_ADAPTIVE] = "adaptive",
                                       [FRAGMENTS_MDT] = "mdt",
                                       [FRAGMENTS_ABUFFER] = "abuffer",
                                       [FRAGMENTS_CPU] = "cpu",
                                       [FRAGMENTS_WEIGHTED] = "weighted",
                                       [FRAGMENT_METHODS] = NULL };
static const char *const pieces[] = { [FRAGMENT_PIECES_BOTH] = "both",
                                      [FRAGMENT_PIECES_OUTWARD] = "outward",
                                      [FRAGMENT_PIECES_MERGED] = "merged",
                                      NULL };
static const char *const orders[] = {
    [CONVEX_ORDER_EXACT] = "exact", [CONVEX_ORDER_GRID] = "grid", NULL
};
static const char *const colors[] = {
    [FRAGMENT_NORMALS] = "normals", [FRAGMENT_MATERIAL] = "material", NULL
};
static const char *const ups[] = { "y", "z", "x", "-y", "-z", NULL };

#define OF(member) offsetof(FragmentOptions, member)

const SettingField fragment_settings[] = {
    { "method", NULL,
      "sorted: the machine sorts the fragments of a pixel (default); convex: convex pieces of the "
      "mesh, put in order as wholes; dp, ddp: the nearest fragments, and the farthest too, peeled "
      "pass by pass; kbuffer: the nearest few of a pixel; stencil: the first few that are drawn; "
      "bucket1, bucket2, adaptive: sorted into buckets by depth, of equal depth in one pass or "
      "two, or where there are fragments; mdt: all of them in 32 bits each; abuffer: all of them; "
      "cpu: the same by the processor; weighted: an average instead of an order",
      SETTING_NAME, OF(method), .names = methods },
    { "kept", "N", "Of kbuffer and stencil: fragments of a pixel that are kept (default: 8)",
      SETTING_INTEGER, OF(kept), .low = 1, .high = 64 },
    { "hazard", "N",
      "Of kbuffer: fragments in flight, which do not see what the others write (default: 0)",
      SETTING_INTEGER, OF(hazard), .low = 0, .high = 65536 },

    { "pieces", NULL,
      "Of convex: both, pieces that are seen from outside or from inside (default); outward, as "
      "the paper has them; merged, joined where they touch",
      SETTING_NAME, OF(pieces), .names = pieces },
    { "tolerance", "T",
      "Of convex: a piece may be concave by so much of the mesh's longest side (default: 0, none "
      "is)",
      SETTING_NUMBER, OF(tolerance), .low = 0, .high = 1 },

    { "order", NULL,
      "Of convex: exact, of all that share a pixel (default); grid, by the cells of a grid and by "
      "planes and slabs between neighbours, as the paper has it, and sometimes wrong",
      SETTING_NAME, OF(order), .names = orders },

    { "alpha", "A", "How much of what is behind it a fragment hides (default: 0.3)", SETTING_NUMBER,
      OF(alpha), .low = 0, .high = 1, .aside = true },
    { "sigma", "S",
      "The mesh is a body that takes light, so much of it in a unit of length (default: 0, it is "
      "none)",
      SETTING_NUMBER, OF(sigma), .low = 0, .high = 1e6, .aside = true },
    { "as-printed", NULL, "Surfaces of the body reflect nothing head on, as the paper prints it",
      SETTING_FLAG, OF(is_as_printed), .aside = true },
    { "color", NULL,
      "Of triangles: normals, their size along the axes (default); material, the file's",
      SETTING_NAME, OF(color), .names = colors, .aside = true },
    { "camera", "FILE", "A camera, as scenes have it: eye, at, up, fovy, near, far", SETTING_TEXT,
      OF(camera), .aside = true },
    { "cache", "FILE",
      "Of convex: keep the pieces in this file, and what parts them, and read them from there",
      SETTING_TEXT, OF(cache), .aside = true },
    { "from", "AZIMUTH ELEVATION",
      "Where the mesh is seen from, in degrees (default: 30 20; 0 0 is in front)", SETTING_VECTOR,
      OF(orbit.azimuth), .low = -360, .high = 360, .count = 2, .aside = true },
    { "up", NULL, "Which axis points up: y (default), z, x, -y or -z", SETTING_NAME, OF(orbit.up),
      .names = ups, .aside = true },
    { "zoom", "F", "Larger by so much than what fills the picture", SETTING_NUMBER, OF(orbit.zoom),
      .low = 0.1, .high = 1000, .aside = true },
    { "measure", NULL, "Hold the picture against the truth, and say how many pixels are wrong",
      SETTING_FLAG, OF(measures), .aside = true },
    { .name = NULL },
};

_Static_assert(OF(orbit.elevation) == OF(orbit.azimuth) + sizeof(double), "two angles");

/* --- what goes together ----------------------------------------------------------------------- */

static bool keeps_some(FragmentMethod method)
{
    return method == FRAGMENTS_KBUFFER || method == FRAGMENTS_STENCIL;
}

static bool asks_for_pieces(uint32_t given)
{
    return setting_is_given(fragment_settings, given, "pieces") ||
           setting_is_given(fragment_settings, given, "tolerance") ||
           setting_is_given(fragment_settings, given, "order") ||
           setting_is_given(fragment_settings, given, "cache");
}

void fragment_options_imply(void *setting, uint32_t given)
{
    FragmentOptions *options = setting;
    if (setting_is_given(fragment_settings, given, "method"))
        return;
    if (setting_is_given(fragment_settings, given, "kept") ||
        setting_is_given(fragment_settings, given, "hazard"))
        options->method = FRAGMENTS_KBUFFER;
    else if (asks_for_pieces(given))
        options->method = FRAGMENTS_CONVEX;
}

GpResult fragment_options_check(const void *setting, uint32_t given, const char *extension,
                                GpError *error)
{
    const FragmentOptions *options = setting;
    (void)extension;
    if (!keeps_some(options->method) && setting_is_given(fragment_settings, given, "kept"))
        return gp_fail(error, GP_ERROR_INVALID,
                       "--kept: expected --method kbuffer or stencil with it");
    if (options->method != FRAGMENTS_KBUFFER &&
        setting_is_given(fragment_settings, given, "hazard"))
        return gp_fail(error, GP_ERROR_INVALID, "--hazard: expected --method kbuffer with it");
    if (options->method != FRAGMENTS_CONVEX && asks_for_pieces(given))
        return gp_fail(
            error, GP_ERROR_INVALID,
            "--pieces, --tolerance, --order, --cache: expected --method convex with them");
    if (options->is_as_printed && !(options->sigma > 0))
        return gp_fail(error, GP_ERROR_INVALID, "--as-printed: expected --sigma with it");
    if (options->camera && setting_is_given(fragment_settings, given, "from"))
        return gp_fail(error, GP_ERROR_INVALID,
                       "--camera and --from: a camera is described by the one or the other");
    if (fabs(options->orbit.elevation) > 89)
        return gp_fail(error, GP_ERROR_INVALID, "--from: expected -89 to 89 degrees of elevation");
    return GP_OK;
}
