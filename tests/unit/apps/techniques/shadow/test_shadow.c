/* How shadow maps fail, and what mends it: each failure of the thesis's chapter 4 as a pair of
 * rows,
 * in pixels of 256 x 256, of which some 42000 show something. Acne is what is dark and should be
 * lit, a leak is what is lit and should be dark. */
#include "apps/techniques/shadow/technique.h"
#include "tests/support/technique/technique_case.h"
#include "tests/support/unit.h"

/* --- scenes ----------------------------------------------------------------------------------- */

#define SIZE  "'size': [256, 256], "
#define VIEW  SIZE "'camera': {'eye': [2.4, 2.6, 3.4], 'at': [0, 0.35, 0], 'fovy': 36}, "
#define FLOOR "{'mesh': 'builtin:plane', 'transform': {'scale': [2, 1, 2]}}"

#define SPOT_OF(range)                                                                             \
    "'lights': [{'position': [-2, 3, 1.5], 'at': [0, 0.3, 0], 'shadow': {'fovy': 60, " range "}}]" \
    ", "
#define SPOT SPOT_OF("'near': 0.5, 'far': 8")
#define CLOSE                                                                                      \
    "'objects': [" FLOOR                                                                           \
    ", {'mesh': 'builtin:torus', 'transform': {'rotate': [1, 0, 0, 90]}, 'fit': [0.6, 0, 0.3, 1]}" \
    ", {'mesh': 'builtin:cube', 'fit': [-0.6, 0, -0.3, 0.7]}]"

/* Closed objects on a floor. */
static const char things[] = "{" VIEW SPOT CLOSE "}";

/* The same; the map's depth begins a thousandth before the light and ends far behind the floor. */
static const char deep[] = "{" VIEW SPOT_OF("'near': 0.001, 'far': 100") CLOSE "}";

/* A sheet that hovers over the floor: its far side is none of the sides that turn away. */
static const char sheet[] =
    "{" VIEW SPOT "'objects': [" FLOOR
    ", {'mesh': 'builtin:plane', 'transform': {'scale': 0.5, 'translate': [0, 0.6, 0]}}]}";

/* A light in the middle that shines to the right, on a cube. */
static const char half[] =
    "{" VIEW "'lights': [{'position': [-0.2, 0.8, 0], 'at': [1.5, 0.6, 0], "
    "            'shadow': {'fovy': 90, 'near': 0.1, 'far': 8}}], "
    "'objects': [" FLOOR ", {'mesh': 'builtin:cube', 'fit': [0.6, 0, 0, 0.9]}]}";

/* A light from above whose map ends in a cylinder. */
static const char edge[] =
    "{" VIEW "'lights': [{'position': [0, 4, 0], 'at': [0, 0, 0], "
    "            'shadow': {'fovy': 24, 'near': 0.5, 'far': 8}}], "
    "'objects': [" FLOOR ", {'mesh': 'builtin:cylinder', 'fit': [0.8, 0, 0, 0.3]}]}";

/* A light in a closed box: everything outside it is dark. */
#define IN_BOX(light)                                                                              \
    "{" VIEW "'lights': [{'position': [0, 1, 0]" light "}], "                                      \
    "'objects': [" FLOOR ", {'mesh': 'builtin:cube', 'fit': [0, 0.8, 0, 0.4]}]}"
static const char box[] =
    IN_BOX(", 'at': [0, 0, 0], 'shadow': {'fovy': 120, 'near': 0.5, 'far': 3}");
static const char box_all_sides[] = IN_BOX("");

/* A light in the middle of two objects, to all sides. */
static const char around[] = "{" VIEW "'lights': [{'position': [0, 1, 0]}], 'objects': [" FLOOR
                             ", {'mesh': 'builtin:cube', 'fit': [-0.9, 0, 0.2, 0.5]}"
                             ", {'mesh': 'builtin:sphere', 'fit': [0.7, 0, 0.5, 0.5]}]}";

/* A long floor, seen from its near end; lit from its far end, or from behind the eye. */
#define ALONG(position, fovy)                                                                      \
    "{" SIZE "'camera': {'eye': [0, 1, 11], 'at': [0, 0.3, 8], 'fovy': 50}, "                      \
    "'lights': [{'position': " position ", 'at': [0, 0, 0], "                                      \
    "            'shadow': {'fovy': " fovy ", 'near': 0.5, 'far': 40}}], "                         \
    "'objects': [{'mesh': 'builtin:plane', 'transform': {'scale': [4, 1, 12]}}"                    \
    ", {'mesh': 'builtin:cube', 'fit': [-0.6, 0, 9.5, 0.4]}"                                       \
    ", {'mesh': 'builtin:cube', 'fit': [0.6, 0, 8.6, 0.4]}"                                        \
    ", {'mesh': 'builtin:cube', 'fit': [0, 0, 6, 0.6]}"                                            \
    ", {'mesh': 'builtin:cube', 'fit': [1.5, 0, 0, 0.9]}"                                          \
    ", {'mesh': 'builtin:cube', 'fit': [-1.5, 0, -6, 0.9]}]}"
static const char duel[] = ALONG("[0.5, 3, -13]", "40");
static const char no_duel[] = ALONG("[6, 20, 14]", "52");

/* Rays straight down, a texel of the map of 64 is 1/16 wide, and a sheet of side 1 whose edges are
 * at x and z = place -+ 0.5. Texel i of Direct3D 9 samples the scene at -2 + i/16 and is read for
 * half a texel to both sides: the shadow is exact where edges lie half way between. */
#define SHEET_AT(place)                                                                            \
    "{" VIEW "'lights': [{'direction': [0, 1, 0], 'at': [0, 0, 0], "                               \
    "         'shadow': {'up': [0, 0, -1], 'height': 4}}], "                                       \
    "'objects': [" FLOOR ", {'mesh': 'builtin:plane', "                                            \
    "            'transform': {'scale': 0.5, 'translate': [" place ", 0.8, " place "]}}]}"
static const char sheet_between_samples[] = SHEET_AT("0.28125");
static const char sheet_on_samples[] = SHEET_AT("0.25");

/* A bare floor in the cone of a light, a point or a square. */
#define IN_CONE(size)                                                                              \
    "{" VIEW "'lights': [{'position': [-1, 3, 1], 'at': [0, 0, 0], 'cone': 15" size "}], "         \
    "'objects': [" FLOOR "]}"
static const char cone[] = IN_CONE("");
static const char cone_with_size[] = IN_CONE(", 'size': 0.6");

/* --- tables ----------------------------------------------------------------------------------- */

static const TechniqueCase biases[] = {
    { "acne, d16", things, "--fit light --map 512 --depth d16 --bias 0 --slope 0", "acne", 12000,
      20000 },
    { "acne, d24", things, "--fit light --map 512 --bias 0 --slope 0", "acne", 12000, 20000 },
    { "acne, d32f", things, "--fit light --map 512 --depth d32f --bias 0 --slope 0", "acne", 12000,
      20000 },
    { "acne, r32f", things, "--fit light --map 512 --method plain --bias 0", "acne", 12000, 20000 },
    { "no acne, d16", things, "--fit light --map 512 --depth d16", "acne", 0, 40 },
    { "no acne, d24", things, "--fit light --map 512", "acne", 0, 40 },
    { "no acne, d32f", things, "--fit light --map 512 --depth d32f", "acne", 0, 40 },
    { "no acne, r32f", things, "--fit light --map 512 --method plain", "acne", 0, 40 },

    { "no peter-panning, d16", things, "--fit light --map 512 --depth d16", "leak", 0, 40 },
    { "no peter-panning, d24", things, "--fit light --map 512", "leak", 0, 40 },
    { "no peter-panning, r32f", things, "--fit light --map 512 --method plain", "leak", 0, 40 },
    { "peter-panning, d16", things, "--fit light --map 512 --depth d16 --bias 0.05", "leak", 2000,
      5000 },
    { "peter-panning, d24", things, "--fit light --map 512 --bias 0.05", "leak", 2000, 5000 },
    { "peter-panning, r32f", things, "--fit light --map 512 --method plain --bias 0.05", "leak",
      2000, 5000 },

    /* 16 bits over too long a range: a step of depth is 0.2 long where things stand. */
    { "a step of d16", deep, "--fit light --depth d16", "leak", 200, 800 },
    { "a step of d24", deep, "--fit light --depth d24", "leak", 0, 30 },
    { "a step of d32f", deep, "--fit light --depth d32f", "leak", 0, 30 },
    { "r32f", deep, "--fit light --method plain", "leak", 0, 30 },
    { "d16 over the casters' range", deep, "--depth d16", "error", 0, 40 },
    /* ... which also hides acne: what has the same code is lit. */
    { "d16's steps hide acne", deep, "--fit light --depth d16 --bias 0 --slope 0", "acne", 0, 200 },
    { "d24 has it", deep, "--fit light --depth d24 --bias 0 --slope 0", "acne", 10000, 20000 },
};

static const TechniqueCase remedies[] = {
    { "far sides need no bias", things, "--fit light --map 512 --casters far --bias 0 --slope 0",
      "error", 0, 80 },
    { "... in the plain method", things,
      "--fit light --map 512 --method plain --casters far --bias 0", "error", 0, 80 },
    { "an offset along normals", things,
      "--fit light --map 512 --normal-offset 1 --bias 0 --slope 0", "error", 0, 100 },
    { "a sheet has no far side", sheet, "--fit light --casters far --bias 0 --slope 0", "leak",
      4000, 7000 },
    { "a sheet with all sides", sheet, "--fit light", "error", 0, 40 },
};

static const TechniqueCase places[] = {
    { "behind the light, printed", half, "--fit light --outside printed", "acne", 4000, 7000 },
    { "... where depth over 1 is not cut", half, "--fit light --outside printed --method plain",
      "acne", 12000, 20000 },
    { "behind the light, lit", half, "--fit light --outside lit", "acne", 0, 20 },
    { "... in the plain method", half, "--fit light --outside lit --method plain", "acne", 0, 20 },

    { "beside the map, printed", edge, "--fit light --outside printed", "acne", 800, 1500 },
    { "beside the map, lit", edge, "--fit light --outside lit", "acne", 0, 20 },
    { "a caster that is cut", edge, "--fit light --outside lit", "leak", 60, 200 },

    { "a cone's edge", cone, "", "error", 0, 4 },
    { "... of a light with a size", cone_with_size, "", "error", 0, 4 },

    { "in a box before the near plane", box, "--fit light", "leak", 38000, 43000 },
    { "in a box behind it", box, "--fit casters", "leak", 0, 3000 },
    { "in a box, to all sides", box_all_sides, "", "error", 0, 0 },
    { "to all sides", around, "--map 512", "error", 0, 40 },
    { "... where an offset is of no use", around, "--map 512 --normal-offset 1", "error", 0, 40 },
};

static const TechniqueCase grids[] = {
    { "duelling frusta", duel, "--fit light --map 512", "error", 300, 900 },
    { "a larger map", duel, "--fit light --map 4096", "error", 0, 150 },
    { "a fitting map", duel, "--fit casters --map 512", "error", 0, 300 },
    { "no duel", no_duel, "--fit light --map 512", "error", 0, 50 },

    { "plain, edges between samples", sheet_between_samples,
      "--method plain --filter nearest --fit light --map 64 --bias 0.001", "error", 0, 0 },
    { "hardware, edges between samples", sheet_between_samples,
      "--filter nearest --fit light --map 64 --bias 0.001", "error", 0, 0 },
    { "plain, edges on samples", sheet_on_samples,
      "--method plain --filter nearest --fit light --map 64 --bias 0.001", "error", 300, 900 },
    { "hardware, edges on samples", sheet_on_samples,
      "--filter nearest --fit light --map 64 --bias 0.001", "error", 300, 900 },
};

static void check(const TechniqueCase *cases, size_t count)
{
    GpError error = { "" };
    if (technique_cases_check(&shadow_technique, cases, count, &error))
        fail_msg("%s", error.text);
}

static void acne_and_peter_panning_end_at_the_chosen_bias(void **state)
{
    (void)state;
    check(biases, GP_COUNT(biases));
}

static void remedies_need_no_bias(void **state)
{
    (void)state;
    check(remedies, GP_COUNT(remedies));
}

static void what_no_map_shows_is_lit(void **state)
{
    (void)state;
    check(places, GP_COUNT(places));
}

static void texels_fit_what_is_seen(void **state)
{
    (void)state;
    check(grids, GP_COUNT(grids));
}

/* --- claims of other forms -------------------------------------------------------------------- */

static TechniqueStage open_stage(const char *scene, uint32_t width, uint32_t height)
{
    TechniqueStage stage;
    GpError error = { "" };
    if (technique_stage_open(&shadow_technique, scene, width, height, &stage, &error))
        fail_msg("%s", error.text);
    return stage;
}

static double measure(const TechniqueStage *stage, const char *options, const char *metric)
{
    TechniqueError measured;
    GpError error = { "" };
    if (technique_stage_measure(stage, options, &measured, &error))
        fail_msg("%s: %s", options, error.text);
    return technique_metric(stage->technique, &measured, metric);
}

/* Steps along an edge are as wide as texels: each doubling of the map halves what is wrong, until
 * pixels are the larger ones. */
static void stair_steps_shrink_with_texels(void **state)
{
    (void)state;
    static const char *const maps[] = { "64", "128", "256", "512" };
    TechniqueStage stage = open_stage(things, 0, 0);
    double before = 0;
    int failed = 0;
    for (size_t i = 0; i < GP_COUNT(maps); i++) {
        char options[64];
        strcpy(options, "--fit light --filter nearest --map ");
        strcat(options, maps[i]);
        double wrong = measure(&stage, options, "error"), ratio = before / wrong;
        before = wrong;
        if (i == 0 || (ratio > 1.3 && ratio < 2.7))
            continue;
        print_error("%s: %g wrong pixels, a ratio of %g\n", options, wrong, ratio);
        failed++;
    }
    assert_int_equal(failed, 0);
    technique_stage_close(&stage);
}

/* 16 points of the light are the truth. */
static void soft_shadows_are_nearer_to_a_light_with_a_size(void **state)
{
    (void)state;
    TechniqueStage stage = open_stage("scenes/shadow_soft.json", 256, 192);
    double hard = measure(&stage, "--method plain --filter bilinear", "rmse");
    double soft = measure(&stage, "--method plain --filter soft", "rmse");
    if (!(soft < 0.6 * hard))
        fail_msg("rmse of visibility: soft %g, bilinear %g", soft, hard);
    technique_stage_close(&stage);
}

/* A row that does not hold is told with its metric. */
static void a_table_can_fail(void **state)
{
    (void)state;
    static const TechniqueCase wrong[] = {
        { "holds", sheet_between_samples, "--filter nearest --fit light --map 64 --bias 0.001",
          "error", 0, 0 },
        { "does not", sheet_between_samples, "--fit light --map 64 --bias 1", "acne", 1, 9 },
    };
    GpError error = { "" };
    assert_int_equal(technique_cases_check(&shadow_technique, wrong, 2, &error), GP_ERROR_INVALID);
    assert_string_equal(error.text,
                        "does not: --fit light --map 64 --bias 1: acne is 0, not in [1, 9]");
    const TechniqueCase unknown = { "no such metric", things, "", "rms", 0, 1e9 };
    assert_int_equal(technique_cases_check(&shadow_technique, &unknown, 1, NULL), GP_ERROR_INVALID);
    const TechniqueCase broken = { "no such option", things, "--maps 3", "error", 0, 1e9 };
    assert_int_equal(technique_cases_check(&shadow_technique, &broken, 1, NULL), GP_ERROR_INVALID);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(acne_and_peter_panning_end_at_the_chosen_bias),
        cmocka_unit_test(remedies_need_no_bias),
        cmocka_unit_test(what_no_map_shows_is_lit),
        cmocka_unit_test(texels_fit_what_is_seen),
        cmocka_unit_test(stair_steps_shrink_with_texels),
        cmocka_unit_test(soft_shadows_are_nearer_to_a_light_with_a_size),
        cmocka_unit_test(a_table_can_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
