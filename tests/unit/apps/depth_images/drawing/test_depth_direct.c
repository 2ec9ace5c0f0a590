/* Planar depth images drawn straight: themselves from where they were taken, near to the truth from
 * aside, the same bits on every device; and what they fail at, each beside its remedy. */
#include "apps/depth_images/drawing/direct.h"
#include "apps/depth_images/drawing/planar.h"
#include "shaders_c/warp/direct.h"
#include "tests/support/depth/formula.h"

#include <string.h>

static const WarpLight light = { .position = { 0.6, 0.8, 0 },
                                 .directional = true,
                                 .color = { 1, 1, 1 },
                                 .ambient = { .2f, .2f, .2f } };

/* owns: the caller, direct_close */
static Direct open_image(const DepthImage *image)
{
    Direct direct;
    GpError error = { "" };
    if (direct_open(image, &direct, &error))
        fail_msg("%s", error.text);
    return direct;
}

/* A picture of an image as a camera sees it. owns: the caller, frame_free */
static Frame draw(Direct *direct, const DirectSetting *setting, const Camera *camera, bool lit,
                  bool floats)
{
    const WarpView view = { *camera, FORMULA_SIDE, FORMULA_SIDE, lit ? &light : NULL };
    Frame frame = { .color = NULL };
    const WarpTarget target = formula_target(floats, &frame);
    GpError error = { "" };
    if (direct_add(direct, setting, &view, &target, &frame, &error))
        fail_msg("%s", error.text);
    return frame;
}

static FormulaOff off_of(const DepthImage *image, Formula formula, const DirectSetting *setting,
                         const Camera *camera)
{
    Direct direct = open_image(image);
    Frame frame = draw(&direct, setting, camera, false, false);
    run_list(&frame.list);
    const FormulaOff off = formula_compare(formula, camera, &frame);
    frame_free(&frame);
    direct_close(&direct);
    return off;
}

static const DirectSetting usual = { .step = 0 };

/* Texels fall on pixels, and come through them as they are. */
static void an_image_from_its_own_camera_is_itself(void **state)
{
    (void)state;
    static float rgba[FORMULA_IMAGE * FORMULA_IMAGE][4];
    static const float nothing[4] = { 0 };
    for (int way = 0; way < 2; way++) {
        DepthImage image = formula_image(FORMULA_PLANE, way);
        Direct direct = open_image(&image);
        const Camera camera = { .eye = { 0, 0, 5 },
                                .up = { 0, 1, 0 },
                                .fovy = way ? 0 : 40,
                                .height = 3.6,
                                .near = 1,
                                .far = 10 };
        const WarpView view = { camera, FORMULA_IMAGE, FORMULA_IMAGE, NULL };
        Frame frame = { .color = NULL };
        const WarpTarget target = {
            frame_surface(&frame, GP_A32B32G32R32F, FORMULA_IMAGE, FORMULA_IMAGE, 1), NULL
        };
        frame_pass(&frame, "below", target.color, NULL, nothing);
        assert_int_equal(direct_add(&direct, &usual, &view, &target, &frame, NULL), GP_OK);
        run_list(&frame.list);
        assert_int_equal(gp_surface_read_floats(target.color, 0, NULL, &rgba[0][0], NULL), GP_OK);
        for (uint32_t i = 0; i < FORMULA_IMAGE * FORMULA_IMAGE; i++) {
            const uint32_t x = i % FORMULA_IMAGE, y = i / FORMULA_IMAGE;
            const bool at_corner =
                (x == 0 || x == FORMULA_IMAGE - 1) && (y == 0 || y == FORMULA_IMAGE - 1);
            assert_true(rgba[i][3] == 1 || at_corner);
            for (uint32_t k = 0; k < 3 && !at_corner; k++)
                assert_true(fabsf(rgba[i][k] - image.front.color[3 * i + k]) < 1.0f / 255);
        }
        frame_free(&frame);
        direct_close(&direct);
        formula_free(&image);
    }
}

static void planes_are_exact_from_aside(void **state)
{
    (void)state;
    for (int way = 0; way < 4; way++) {
        const Camera camera = formula_camera(2, 1, 3.5, way & 1);
        for (int formula = FORMULA_FLAT; formula <= FORMULA_PLANE; formula++) {
            DepthImage image = formula_image((Formula)formula, way >> 1);
            const FormulaOff off = off_of(&image, (Formula)formula, &usual, &camera);
            print_message("# %u of %u missing, %u too much; colour %.4f, depth %.2g off\n",
                          off.missing, off.covered, off.extra, off.color, off.depth);
            assert_true(off.covered > 500 && off.missing == 0 && off.extra == 0);
            assert_true(off.color < 0.01 && off.depth < 5e-5);
            formula_free(&image);
        }
    }
}

static void rubber_sheets_are_cut(void **state)
{
    (void)state;
    const Camera camera = formula_camera(3, 0, 4, false);
    for (int way = 0; way < 2; way++) {
        DepthImage image = formula_image(FORMULA_STEP, way);
        const FormulaOff sheets =
            off_of(&image, FORMULA_STEP, &(DirectSetting){ .edges.rule = EDGES_NONE }, &camera);
        const FormulaOff cut = off_of(&image, FORMULA_STEP, &usual, &camera);
        print_message("# too much: %u with sheets, %u cut\n", sheets.extra, cut.extra);
        assert_true(sheets.extra > 500 && cut.extra < 10 && cut.missing < 10);
        formula_free(&image);
    }
}

static uint32_t covered_from_aside(const DepthImage *image)
{
    const Camera camera = {
        .eye = { 9, 0, 3 }, .at = { 0, 0, -6 }, .up = { 0, 1, 0 }, .fovy = 40, .near = 1, .far = 60
    };
    Direct direct = open_image(image);
    Frame frame = draw(&direct, &usual, &camera, false, false);
    run_list(&frame.list);
    const uint32_t covered = formula_check_numbers(&frame);
    frame_free(&frame);
    direct_close(&direct);
    return covered;
}

/* A slope in 32 levels, each 11 pixels deep: their steps are no edges, as long as they can be
 * told. */
static void steps_of_few_bits_are_no_edges(void **state)
{
    (void)state;
    DepthImage image = formula_image(FORMULA_FLAT, true);
    uint32_t covered[3];
    for (uint32_t i = 0; i < FORMULA_IMAGE * FORMULA_IMAGE; i++)
        image.front.depth[i] = 1 + (float)(i % FORMULA_IMAGE) * (20.0f / FORMULA_IMAGE);
    covered[0] = covered_from_aside(&image);
    for (uint32_t i = 0; i < FORMULA_IMAGE * FORMULA_IMAGE; i++)
        image.front.depth[i] = floorf(image.front.depth[i] * 1.6f) / 1.6f;
    assert_true(fabs(depth_level(&image.front) - 1 / 1.6) < 1e-5);
    covered[1] = covered_from_aside(&image);
    assert_non_null(
        direct_warning(&image, &(WarpView){ formula_camera(0, 0, 9, false), 8, 8, NULL }));
    image.front.depth[1] += 1e-4f; /* its neighbour is of its level */
    covered[2] = covered_from_aside(&image);
    print_message("# covered: %u, in 32 levels %u, cut at these %u\n", covered[0], covered[1],
                  covered[2]);
    assert_true(covered[1] > covered[0] - covered[0] / 50 && covered[2] < covered[0] * 4 / 5);
    formula_free(&image);
}

/* Micro-structure: heights of a chess board stand out of a plane that faces the eye. */
static void detail_stands_out(void **state)
{
    (void)state;
    static float z[FORMULA_SIDE * FORMULA_SIDE][4];
    static uint8_t texels[4] = { 0, 255, 255, 0 };
    GpSurface *heights;
    const GpSurfaceDesc desc = { .format = GP_R8, .width = 2, .height = 2, .memory = texels };
    assert_int_equal(gp_surface_create(&desc, &heights, NULL), GP_OK);
    for (int way = 0; way < 2; way++) {
        DepthImage image = formula_image(FORMULA_FLAT, way);
        Direct direct = open_image(&image);
        const Camera camera = {
            .eye = { 0, 0, 5 }, .up = { 0, 1, 0 }, .height = 3, .near = 1, .far = 9
        };
        const DirectSetting setting = { .detail = { heights, 0.4, { 8, 8 }, false } };
        Frame frame = draw(&direct, &setting, &camera, false, false);
        uint32_t low = 0, high = 0, covered = 0;
        run_list(&frame.list);
        assert_int_equal(gp_surface_read_floats(frame.depth, 0, NULL, &z[0][0], NULL), GP_OK);
        for (uint32_t i = 0; i < FORMULA_SIDE * FORMULA_SIDE; i++) {
            const double depth = 1 + (double)z[i][0] * 8;
            covered += depth < 8;
            low += fabs(depth - 5) < 1e-3;
            high += fabs(depth - 4.6) < 1e-3;
        }
        print_message("# of %u, %u low, %u high\n", covered, low, high);
        assert_true(low > covered / 5 && high > covered / 5);
        frame_free(&frame);
        direct_close(&direct);
        formula_free(&image);
    }
    gp_surface_destroy(&heights);
}

/* From all sides, on the image's own plane, inside what it shows. */
static void every_eye_gives_numbers(void **state)
{
    (void)state;
    for (int way = 0; way < 4; way++) {
        DepthImage image = formula_image(way & 2 ? FORMULA_BALL : FORMULA_PLANE, way & 1);
        Direct direct = open_image(&image);
        uint32_t covered = 0;
        for (int i = 0; i < 26; i++) {
            static const double away[] = { 3, 1e-3, 5, 300 };
            const double s = away[i % 4];
            const Camera camera =
                formula_camera(s * (i % 3 - 1), s * (i / 3 % 3 - 1), s * (i / 9 - 1) + 1e-4, i & 1);
            Frame frame = draw(&direct, &usual, &camera, true, true);
            run_list(&frame.list);
            covered += formula_check_numbers(&frame);
            frame_free(&frame);
        }
        assert_true(covered > 1000);
        direct_close(&direct);
        formula_free(&image);
    }
}

static void images_of_a_pixel_or_of_nothing_are_drawn(void **state)
{
    (void)state;
    for (uint32_t side = 1; side <= 2; side++)
        for (uint32_t there = 0; there <= side * side; there++) {
            DepthImage image = formula_image(FORMULA_FLAT, true);
            depth_pixels_free(&image.front);
            assert_int_equal(depth_pixels_make(side, side, false, &image.front), GP_OK);
            for (uint32_t i = 0; i < there; i++)
                image.front.depth[i] = 0; /* on the plane that depths are counted from */
            Direct direct = open_image(&image);
            const Camera camera = {
                .eye = { 0, 0, 9 }, .up = { 0, 1, 0 }, .height = 4, .near = 1, .far = 20
            };
            Frame frame = draw(&direct, &usual, &camera, true, true);
            run_list(&frame.list);
            const uint32_t covered = formula_check_numbers(&frame);
            assert_true(there ? covered > 100 : covered == 0);
            frame_free(&frame);
            direct_close(&direct);
            formula_free(&image);
        }
}

static void an_eye_behind_the_image_is_named(void **state)
{
    (void)state;
    DepthImage image = formula_image(FORMULA_BALL, false);
    for (int way = 0; way < 2; way++) {
        const WarpView front = { formula_camera(3, 1, 4, way), 8, 8, NULL },
                       behind = { formula_camera(1, 1, -4, way), 8, 8, NULL };
        assert_null(direct_warning(&image, &front));
        assert_non_null(strstr(direct_warning(&image, &behind), "from behind"));
    }
    formula_free(&image);
}

/* How two pictures differ: on average in 255ths where both cover; and pixels that only one of them
 * covers. */
typedef struct Change {
    double color, cover;
} Change;

static Change change_of(Direct *direct, uint32_t first, uint32_t second, const Camera *camera)
{
    static float rgba[2][FORMULA_SIDE * FORMULA_SIDE][4];
    double color = 0, both = 0, one = 0;
    for (int i = 0; i < 2; i++) {
        const DirectSetting setting = { .step = i ? second : first };
        Frame frame = draw(direct, &setting, camera, false, false);
        run_list(&frame.list);
        assert_int_equal(gp_surface_read_floats(frame.color, 0, NULL, &rgba[i][0][0], NULL), GP_OK);
        frame_free(&frame);
    }
    for (uint32_t i = 0; i < FORMULA_SIDE * FORMULA_SIDE; i++) {
        const bool is_both = rgba[0][i][3] > 0 && rgba[1][i][3] > 0;
        both += is_both;
        one += !is_both && (rgba[0][i][3] > 0 || rgba[1][i][3] > 0);
        for (int k = 0; k < 3 && is_both; k++)
            color += 255 / 3.0 * fabs((double)rgba[0][i][k] - (double)rgba[1][i][k]);
    }
    assert_true(both > 50);
    return (Change){ color / both, one };
}

/* Where the footprint asks for a step, the picture is nearly that of step 1; near by it would not
 * be. */
static void a_change_of_level_is_hardly_seen(void **state)
{
    (void)state;
    static const double aways[] = { 9, 18 };
    DepthImage image = formula_image(FORMULA_BALL, true);
    Direct direct = open_image(&image);
    for (uint32_t i = 0; i < GP_COUNT(aways); i++) {
        const Camera far = formula_camera(0, aways[i] / 3, aways[i], false),
                     near = formula_camera(0, 1, 3, false);
        const Change wanted = change_of(&direct, 1, 2u << i, &far),
                     early = change_of(&direct, 1, 2u << i, &near);
        print_message("# step %u: colours %.2f, cover %.0f; too early %.2f, %.0f\n", 2u << i,
                      wanted.color, wanted.cover, early.color, early.cover);
        assert_true(wanted.color < 2 && wanted.cover < 40 && early.cover > 3 * wanted.cover);
    }
    direct_close(&direct);
    formula_free(&image);
}

/* Two images that go through each other, whichever is drawn first, and by whichever method. */
static void images_meet_in_one_depth_buffer(void **state)
{
    (void)state;
    static float rgba[2][FORMULA_SIDE * FORMULA_SIDE][4];
    const Camera camera = formula_camera(1, 2, 4, false);
    const WarpView view = { camera, FORMULA_SIDE, FORMULA_SIDE, NULL };
    DepthImage images[2] = { formula_image(FORMULA_PLANE, true),
                             formula_image(FORMULA_BALL, false) };
    Direct direct[2] = { open_image(&images[0]), open_image(&images[1]) };
    Planar planar;
    uint32_t first = 0, differ = 0;
    for (uint32_t i = 0; i < FORMULA_IMAGE * FORMULA_IMAGE; i++) /* told apart by blue */
        images[1].front.color[3 * i + 2] = 1;
    assert_int_equal(planar_open(&images[1], &planar, NULL), GP_OK);
    for (int turn = 0; turn < 2; turn++) {
        Frame frame = { .color = NULL };
        const WarpTarget target = formula_target(false, &frame);
        if (turn)
            assert_int_equal(direct_add(&direct[0], &usual, &view, &target, &frame, NULL), GP_OK);
        assert_int_equal(
            planar_add(&planar, &(PlanarSetting){ .is_cut = true }, &view, &target, &frame, NULL),
            GP_OK);
        if (!turn)
            assert_int_equal(direct_add(&direct[0], &usual, &view, &target, &frame, NULL), GP_OK);
        run_list(&frame.list);
        assert_int_equal(gp_surface_read_floats(frame.color, 0, NULL, &rgba[turn][0][0], NULL),
                         GP_OK);
        frame_free(&frame);
    }
    for (uint32_t i = 0; i < FORMULA_SIDE * FORMULA_SIDE; i++) {
        first += rgba[0][i][2] == 1;
        differ += memcmp(rgba[0][i], rgba[1][i], sizeof rgba[0][i]) != 0;
    }
    print_message("# of the ball %u, of both %u differ\n", first, differ);
    assert_true(first > 200 && differ < first / 50);
    planar_close(&planar);
    for (int i = 0; i < 2; i++) {
        direct_close(&direct[i]);
        formula_free(&images[i]);
    }
}

static void images_without_a_second_layer_are_drawn_as_they_are(void **state)
{
    (void)state;
    const Camera camera = formula_camera(2, 1, 4, false);
    DepthImage image = formula_image(FORMULA_BALL, false);
    Direct direct = open_image(&image);
    uint64_t hash[2];
    for (int layers = 0; layers < 2; layers++) {
        Frame frame = draw(&direct, &(DirectSetting){ .layers = layers }, &camera, false, false);
        run_list(&frame.list);
        assert_true(formula_check_numbers(&frame) > 500);
        hash[layers] = gp_surface_hash(frame.color);
        frame_free(&frame);
    }
    assert_true(hash[0] == hash[1]);
    direct_close(&direct);
    formula_free(&image);
}

static void cylinders_are_refused(void **state)
{
    (void)state;
    Direct direct;
    GpError error;
    assert_int_equal(direct_open(&(DepthImage){ .is_cylinder = true }, &direct, &error),
                     GP_ERROR_INVALID);
    assert_string_equal(error.text, "a cylinder is no planar depth image");
}

static void frames_have_the_same_bits_everywhere(void **state)
{
    (void)state;
    static uint8_t texels[4] = { 0, 90, 200, 30 };
    GpSurface *heights;
    const GpSurfaceDesc desc = { .format = GP_R8, .width = 2, .height = 2, .memory = texels };
    assert_int_equal(gp_surface_create(&desc, &heights, NULL), GP_OK);
    const DirectSetting settings[] = {
        usual, { .step = 3 }, { .tolerance = -1 }, { .detail = { heights, 0.1, { 5, 3 }, true } }
    };
    for (int way = 0; way < 2; way++)
        for (size_t i = 0; i < GP_COUNT(settings); i++) {
            DepthImage image = formula_image(i & 1 ? FORMULA_BALL : FORMULA_STEP, way);
            Direct direct = open_image(&image);
            const Camera camera = formula_camera(2, 1, 3, way);
            Frame frame = draw(&direct, &settings[i], &camera, i & 2, false);
            run_everywhere(&frame);
            frame_free(&frame);
            direct_close(&direct);
            formula_free(&image);
        }
    gp_surface_destroy(&heights);
}

static void programs_are_within_their_profiles(void **state)
{
    (void)state;
    static const struct {
        const GpProgram *program;
        GpProfile vertex, pixel;
    } programs[] = { { &direct_program, GP_VS_2_0, GP_PS_2_0 },
                     { &direct_lit_program, GP_VS_2_0, GP_PS_2_0 },
                     { &direct_detail_program, GP_VS_3_0, GP_PS_3_0 },
                     { &direct_detail_lit_program, GP_VS_3_0, GP_PS_3_0 } };
    for (size_t i = 0; i < GP_COUNT(programs); i++) {
        GpError error = { "" };
        if (gp_program_check(programs[i].program, &error))
            fail_msg("%s", error.text);
        assert_int_equal(programs[i].program->vertex_profile, programs[i].vertex);
        assert_int_equal(programs[i].program->pixel_profile, programs[i].pixel);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_image_from_its_own_camera_is_itself),
        cmocka_unit_test(planes_are_exact_from_aside),
        cmocka_unit_test(rubber_sheets_are_cut),
        cmocka_unit_test(steps_of_few_bits_are_no_edges),
        cmocka_unit_test(detail_stands_out),
        cmocka_unit_test(every_eye_gives_numbers),
        cmocka_unit_test(images_of_a_pixel_or_of_nothing_are_drawn),
        cmocka_unit_test(an_eye_behind_the_image_is_named),
        cmocka_unit_test(a_change_of_level_is_hardly_seen),
        cmocka_unit_test(images_meet_in_one_depth_buffer),
        cmocka_unit_test(images_without_a_second_layer_are_drawn_as_they_are),
        cmocka_unit_test(cylinders_are_refused),
        cmocka_unit_test(frames_have_the_same_bits_everywhere),
        cmocka_unit_test(programs_are_within_their_profiles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
