/* `explain' and `pixel': what a draw needs, and what happened to a pixel. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

static void explain_tells_units_and_limits_of_every_draw(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe explain scene.json"), 0);
    expect_contains(out, "Draw 0");
    expect_matches(out, "\n    depth test            runs     a function is set\n");
    expect_matches(out, "\n    blending              skipped  ");
    expect_matches(out, "\n    depth and stencil     early    ");
    assert_int_equal(shell("glasspipe explain scene.json --json"), 0);
    json_t *object = parse_output();
    json_t *pass = json_array_get(json_object_get(object, "passes"), 0);
    json_t *draw = json_array_get(json_object_get(pass, "draws"), 0);
    size_t i;
    json_t *unit;
    json_array_foreach(json_object_get(draw, "units"), i, unit)
    {
        const char *name = json_string_value(json_object_get(unit, "unit"));
        assert_true(name && !strstr(name, "  "));
        const bool runs = json_is_true(json_object_get(unit, "runs"));
        assert_int_equal(runs, !json_is_false(json_object_get(unit, "runs")));
        assert_non_null(json_string_value(json_object_get(unit, "why")));
        if (strcmp(name, "depth test") == 0 || strcmp(name, "blending") == 0)
            assert_int_equal(runs, name[0] == 'd');
    }
    assert_true(i >= 10);
    assert_string_equal(
        json_string_value(json_object_get(json_object_get(draw, "depth_and_stencil"), "when")),
        "early");
    assert_true(json_is_true(json_object_get(draw, "fits")));
    json_decref(object);
}

static void a_pixel_outside_is_a_usage_error_with_the_valid_range(void **state)
{
    (void)state;
    expect_refused(2, "pixel scene.json 64 0", "X is 0 to 63, Y is 0 to 47");
    expect_refused(2, "pixel scene.json 0 48", "X is 0 to 63, Y is 0 to 47");
    expect_refused(2, "pixel scene.json 100 0 --size 100x10", "X is 0 to 99, Y is 0 to 9");
    expect_refused(2, "pixel scene.json -- -1 0", "X: '-1'");
    expect_refused(2, "pixel scene.json -1 0", "'-1'");
    assert_null(strstr(err, "invalid option"));
    expect_refused(2, "pixel scene.json a 0", "X: 'a'");
    expect_refused(2, "pixel scene.json 0", "expected a scene file, X and Y");
    expect_refused(2, "pixel scene.json 0 0 --pass nothing", "--pass nothing");
}

static void the_history_of_a_covered_pixel_names_every_stage(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe pixel scene.json 32 24"), 0);
    static const char *const stages[] = { "cleared",     "vertex", "clip",  "setup",  "raster",
                                          "interpolate", "shader", "depth", "output", "stored" };
    for (size_t i = 0; i < GP_COUNT(stages); i++)
        expect_contains(out, stages[i]);
    assert_null(strchr(out, '\033')); /* no colour into a file */
    assert_int_equal(shell("glasspipe pixel scene.json 0 0"), 0);
    expect_contains(out, "0 fragments");
}

/* Bytes of the picture against the last value that the history says was stored. */
static void expect_steps(const json_t *event, const json_t *listings)
{
    const json_t *listing =
        json_array_get(listings, (size_t)json_integer_value(json_object_get(event, "listing")));
    size_t i;
    json_int_t values = 0;
    const json_t *step;
    assert_non_null(json_object_get(event, "listing"));
    json_array_foreach(json_object_get(listing, "steps"), i, step) values +=
        json_integer_value(json_object_get(step, "width"));
    assert_true(i > 0);
    assert_int_equal(values, json_array_size(json_object_get(event, "values")));
    assert_true(json_is_true(json_object_get(event, "agrees")));
}

/* Those of the vertex shader are told for each corner, those of the pixel shader once. */
static void steps_of_both_shaders_are_told_where_they_are_asked_for(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe pixel scene.json 32 24 --steps"), 0);
    expect_matches(out, "\n    vertex steps   0 ");
    expect_matches(out, "\n    steps          0 ");
    assert_int_equal(shell("glasspipe pixel scene.json 32 24 --json"), 0);
    assert_null(strstr(out, "listings"));
    assert_int_equal(shell("glasspipe pixel scene.json 32 24 --steps --json"), 0);
    json_t *object = parse_output();
    size_t i, corners = 0, pixels = 0, fragments = 0;
    const json_t *event;
    json_array_foreach(json_object_get(object, "events"), i, event)
    {
        const char *kind = json_string_value(json_object_get(event, "kind"));
        fragments += strcmp(kind, "raster") == 0;
        if (strcmp(kind, "steps") != 0)
            continue;
        expect_steps(event, json_object_get(object, "listings"));
        if (json_object_get(event, "corner"))
            assert_int_equal(json_integer_value(json_object_get(event, "corner")), corners++ % 3);
        else
            pixels++;
    }
    assert_true(fragments > 0);
    assert_int_equal(pixels, fragments);
    assert_int_equal(corners, 3 * fragments);
    json_decref(object);
}

static void expect_history_ends_in_picture(const unsigned char *pixels, int x, int y)
{
    assert_int_equal(shell("glasspipe pixel scene.json %d %d --json", x, y), 0);
    json_t *object = parse_output(), *event, *last = NULL;
    size_t i;
    json_array_foreach(json_object_get(object, "events"), i, event)
    {
        if (strcmp(json_string_value(json_object_get(event, "kind")), "output") == 0)
            last = json_object_get(event, "result");
        else if (strcmp(json_string_value(json_object_get(event, "kind")), "clear") == 0)
            last = json_object_get(json_array_get(json_object_get(event, "targets"), 0), "color");
    }
    assert_non_null(last);
    for (size_t c = 0; c < 3; c++) {
        double value = json_number_value(json_array_get(last, c));
        assert_int_equal(pixels[((size_t)y * 64 + (size_t)x) * 3 + c], (int)(value * 255 + 0.5));
    }
    json_decref(object);
}

static void the_history_of_a_pixel_ends_in_its_value_in_the_picture(void **state)
{
    (void)state;
    static char picture[16384];
    assert_int_equal(shell("glasspipe render scene.json -o a.ppm"), 0);
    size_t length = read_file("a.ppm", picture, sizeof picture), bytes = 64 * 48 * 3;
    assert_true(length > bytes);
    const unsigned char *pixels = (const unsigned char *)picture + length - bytes;
    for (int y = 0; y < 48; y += 12)
        for (int x = 0; x < 64; x += 25)
            expect_history_ends_in_picture(pixels, x, y);
}

/* A picture in a picture: only the second pass has the picture's size. */
static const char two_passes[] =
    "{ \"size\": [64, 48], \"camera\": { \"eye\": [0, 0, 3], \"at\": [0, 0, 0], \"fovy\": 40 },\n"
    "  \"passes\": [\n"
    "    { \"name\": \"small\", \"size\": [16, 12], \"targets\": [ { \"clear\": [1, 0, 0, 1] } ],\n"
    "      \"objects\": [ { \"mesh\": \"builtin:sphere\" } ] },\n"
    "    { \"name\": \"large\", \"objects\": [ { \"mesh\": \"builtin:quad\", \"material\": {\n"
    "      \"program\": \"textured\", \"textures\": [ { \"image\": \"pass:small\" } ] } } ] } ] "
    "}\n";

/* The passes in which something happened to a pixel, as JSON has them: "0 1". */
static void expect_passes(const char *arguments, const char *expected)
{
    char passes[64] = "";
    json_int_t last = -1;
    assert_int_equal(shell("glasspipe pixel two.json --json %s", arguments), 0);
    json_t *object = parse_output(), *event;
    size_t i;
    json_array_foreach(json_object_get(object, "events"), i, event)
    {
        const json_int_t pass = json_integer_value(json_object_get(event, "pass"));
        if (pass != last)
            snprintf(strchr(passes, '\0'), 8, "%s%d", passes[0] ? " " : "", (int)pass);
        last = pass;
    }
    json_decref(object);
    if (strcmp(passes, expected) != 0)
        fail_msg("pixel %s: passes %s instead of %s", arguments, passes, expected);
}

/* Spheres at four distances. */
static void a_ternary_test_tells_replaced_added_and_dropped(void **state)
{
    (void)state;
    static const double places[] = { 0, 0.05, 1, -1 };
    static const char *const verdicts[] = { "replaced", "added", "replaced", "dropped" };
    char text[2000] = "{ \"size\": [16, 16], \"camera\": { \"eye\": [0, 0, 4], \"at\": [0, 0, 0], "
                      "\"near\": 1, \"far\": 10 }, \"objects\": [";
    for (size_t i = 0; i < GP_COUNT(places); i++)
        snprintf(strchr(text, '\0'), 400,
                 "%s{ \"mesh\": \"builtin:sphere\", \"transform\": { \"translate\": [0, 0, %g], "
                 "\"scale\": 0.5 }, \"state\": { \"cull\": \"cw\", \"depth\": { \"ternary\": true, "
                 "\"epsilon\": "
                 "0.03125 } } }",
                 i ? ", " : "", places[i]);
    strcat(text, "] }");
    write_file("ternary.json", text);
    assert_int_equal(shell("glasspipe pixel ternary.json 8 8"), 0);
    const char *at = out;
    for (size_t i = 0; i < GP_COUNT(verdicts); i++) {
        char expected[64];
        snprintf(expected, sizeof expected, "%sed: %s by epsilon 0.03125\n",
                 i == 3 ? "fail" : "pass", verdicts[i]);
        at = strstr(at, expected);
        if (!at)
            fail_msg("no '%s' after the one before it in %s", expected, out);
    }
    assert_int_equal(shell("glasspipe pixel ternary.json 8 8 --json"), 0);
    json_t *object = parse_output(), *event;
    size_t i, met = 0;
    json_array_foreach(json_object_get(object, "events"), i, event)
    {
        const char *verdict = json_string_value(json_object_get(event, "ternary"));
        if (verdict)
            assert_string_equal(verdict, verdicts[met++]);
    }
    assert_int_equal(met, GP_COUNT(verdicts));
    json_decref(object);
    assert_int_equal(shell("glasspipe explain ternary.json"), 0);
    expect_matches(out, "\n    ternary test          runs     an epsilon tells");
}

/* Three spheres, each seen through the others: six fragments, the farthest first. */
static void a_pass_that_sorts_tells_its_fragments_in_their_order(void **state)
{
    (void)state;
    static const double places[] = { 1, -1, 0 };
    char text[2000] =
        "{ \"size\": [16, 16], \"order\": \"depth\", \"camera\": { \"eye\": [0, 0, 4], "
        "\"at\": [0, 0, 0], \"near\": 1, \"far\": 10 }, \"objects\": [";
    for (size_t i = 0; i < GP_COUNT(places); i++)
        snprintf(strchr(text, '\0'), 400,
                 "%s{ \"mesh\": \"builtin:sphere\", \"transform\": { \"translate\": [0, 0, %g], "
                 "\"scale\": 0.4 }, \"state\": { \"depth\": { \"write\": false }, \"blend\": { "
                 "\"op\": \"add\", \"src\": \"one\", \"dst\": \"one\" } } }",
                 i ? ", " : "", places[i]);
    strcat(text, "] }");
    write_file("sorted.json", text);
    assert_int_equal(shell("glasspipe pixel sorted.json 8 8"), 0);
    const char *at = out;
    for (int i = 0; i < 6; i++) {
        static const int draws[] = { 1, 2, 0 };
        char expected[64];
        snprintf(expected, sizeof expected, "Sorted %d of 6, depth: draw %d,", i + 1, draws[i / 2]);
        at = strstr(at, expected);
        if (!at)
            fail_msg("no '%s' after the one before it in %s", expected, out);
    }
    expect_contains(out, "\n6 fragments: 6 stored, 0 rejected.");
    assert_int_equal(shell("glasspipe pixel sorted.json 8 8 --json"), 0);
    json_t *object = parse_output(), *event;
    size_t i, met = 0;
    double before = 1;
    json_array_foreach(json_object_get(object, "events"), i, event)
    {
        if (strcmp(json_string_value(json_object_get(event, "kind")), "sort") != 0)
            continue;
        const double depth = json_number_value(json_object_get(event, "depth"));
        assert_int_equal(json_integer_value(json_object_get(event, "place")), met++);
        assert_true(depth < before);
        before = depth;
    }
    assert_int_equal(met, 6);
    json_decref(object);
    assert_int_equal(shell("glasspipe explain sorted.json"), 0);
    expect_matches(out, "\n    sorting               runs     the pass has an order by depth");
}

static void a_pixel_can_be_followed_through_one_pass(void **state)
{
    (void)state;
    write_file("two.json", two_passes);
    expect_passes("32 24", "1");
    expect_passes("8 6 --pass small", "0");
    expect_passes("8 6 --pass 0", "0");
    expect_passes("8 6 --pass large", "1");
    assert_int_equal(shell("glasspipe pixel two.json 8 6 --pass small"), 0);
    expect_contains(out, "Pixel (8, 6) of 16x12");
    expect_contains(out, "(1, 0, 0, 1)");
    expect_refused(2, "pixel two.json 16 0 --pass small", "X is 0 to 15, Y is 0 to 11");
    expect_refused(2, "pixel two.json 0 0 --pass 2", "--pass 2");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(explain_tells_units_and_limits_of_every_draw),
        PROGRAM_TEST(a_pixel_outside_is_a_usage_error_with_the_valid_range),
        PROGRAM_TEST(the_history_of_a_covered_pixel_names_every_stage),
        PROGRAM_TEST(steps_of_both_shaders_are_told_where_they_are_asked_for),
        PROGRAM_TEST(the_history_of_a_pixel_ends_in_its_value_in_the_picture),
        PROGRAM_TEST(a_ternary_test_tells_replaced_added_and_dropped),
        PROGRAM_TEST(a_pass_that_sorts_tells_its_fragments_in_their_order),
        PROGRAM_TEST(a_pixel_can_be_followed_through_one_pass),
    };
    return cmocka_run_group_tests_name("explain and pixel", tests, find_program, NULL);
}
