/* Convex pieces drawn: held against every fragment by brute force, from any view.
 *
 * $GP_TEST_FRAGMENT_VIEWS asks for so many views of each mesh instead of a few. */
#include "apps/fragments/convex/convex.h"

#include "apps/fragments/drawing/geometry.h"
#include "apps/truth/fragments.h"
#include "tests/support/devices.h"
#include "tests/support/fragments/meshes.h"
#include "tests/support/groups/pool.h"
#include "tests/support/unit.h"

#include <math.h>

enum { SIDE = 64, MOST = 40000 };

/* A mesh with colours, in pieces. */
typedef struct Drawn {
    FragmentCase made;
    FragmentMesh mesh;
    FragmentGeometry geometry;
    ConvexModel model;
} Drawn;

static float colors[MOST][4];

/* Each triangle has a colour of its own, so that an order that is wrong shows. */
static void open_case(Drawn *drawn, FragmentCase made, const PiecesSetting *pieces)
{
    const ConvexSetting setting = { .pieces = *pieces, .has_partings = true };
    GpError fault, error;
    Random random = { 17 };
    drawn->made = made;
    drawn->mesh = fragment_case_mesh(&drawn->made);
    for (uint32_t i = 0; i < made.triangle_count; i++)
        for (int k = 0; k < 4; k++)
            colors[i][k] = k < 3 ? random_float(&random, 0, 1) : random_float(&random, 0.1f, 0.9f);
    drawn->mesh.colors = (const float(*)[4])colors;
    assert_int_equal(fragment_geometry_make(&drawn->mesh, true, &drawn->geometry, NULL), GP_OK);
    drawn->mesh.drawn = &drawn->geometry.drawn;
    assert_int_equal(convex_open(&drawn->mesh, &setting, &drawn->model, &fault, &error), GP_OK);
}

static void close_case(Drawn *drawn)
{
    convex_close(&drawn->model);
    fragment_geometry_free(&drawn->geometry);
    fragment_case_free(&drawn->made);
}

/* A picture that is empty but for its background, and what is drawn over it. */
static ConvexFacts draw_by(const Drawn *drawn, ConvexOrder order, const FragmentView *view,
                           GpSurface *depth, Frame *frame)
{
    ConvexFacts facts;
    frame->color = frame_surface(frame, GP_A32B32G32R32F, view->width, view->height, 1);
    frame_pass(frame, "background", frame->color, NULL, view->background);
    assert_int_equal(
        convex_add(&drawn->model, order, view, frame->color, depth, frame, &facts, NULL), GP_OK);
    return facts;
}

static ConvexFacts draw(const Drawn *drawn, const FragmentView *view, GpSurface *depth,
                        Frame *frame)
{
    return draw_by(drawn, CONVEX_ORDER_EXACT, view, depth, frame);
}

/* Pixels that are off by more than 1/255, and have neither an edge nor a crossing of triangles
 * within snapping of their centre. */
static uint32_t count_wrong(const Drawn *drawn, const FragmentView *view, const GpSurface *picture)
{
    static float rgba[SIDE * SIDE][4];
    const FragmentTruthScene scene = { .positions = drawn->mesh.positions,
                                       .indices = drawn->mesh.indices,
                                       .triangle_count = drawn->mesh.triangle_count,
                                       .colors = drawn->mesh.colors,
                                       .camera = view->camera,
                                       .width = SIDE,
                                       .height = SIDE,
                                       .is_glass = view->glass.is_on,
                                       .sigma = view->glass.sigma,
                                       .reflected =
                                           view->glass.is_as_printed ? 0 : FRAGMENT_REFLECTED,
                                       .begin = view->glass.begin };
    FragmentTruth truth = { .rgba = NULL };
    uint32_t wrong = 0;
    assert_int_equal(fragment_truth_make(&scene, pool, &truth), GP_OK);
    assert_int_equal(gp_surface_read_floats(picture, 0, NULL, &rgba[0][0], NULL), GP_OK);
    for (int i = 0; i < SIDE * SIDE; i++) {
        bool is_off = false;
        for (int c = 0; c < 4; c++)
            is_off |= !(fabs((double)rgba[i][c] - truth.rgba[4 * i + c]) <= 1.0 / 255);
        wrong += is_off && !truth.is_edge[i] && !truth.is_crossing[i];
    }
    fragment_truth_free(&truth);
    return wrong;
}

static uint32_t draw_and_count_by(const Drawn *drawn, ConvexOrder order, const FragmentView *view,
                                  ConvexFacts *facts)
{
    Frame frame = { .color = NULL };
    *facts = draw_by(drawn, order, view, NULL, &frame);
    run_list(&frame.list);
    const uint32_t wrong = count_wrong(drawn, view, frame.color);
    frame_free(&frame);
    return wrong;
}

static uint32_t draw_and_count(const Drawn *drawn, const FragmentView *view, ConvexFacts *facts)
{
    return draw_and_count_by(drawn, CONVEX_ORDER_EXACT, view, facts);
}

static FragmentView view_of(Camera camera)
{
    return (FragmentView){ .camera = camera, .width = SIDE, .height = SIDE };
}

static int views_asked_for(int otherwise)
{
    const char *text = getenv("GP_TEST_FRAGMENT_VIEWS");
    return text ? atoi(text) : otherwise;
}

static void pictures_are_the_truth_from_any_view(void **state)
{
    (void)state;
    static const PiecesSetting settings[] = { { 0 }, { .outward = true }, { .merge = true } };
    Random random = { 23 };
    for (int number = 0; number < FRAGMENT_CASES; number++) {
        Drawn drawn;
        open_case(&drawn, fragment_case(number), &settings[number % 3]);
        for (int i = 0; i < views_asked_for(2); i++) {
            const FragmentView view = view_of(fragment_case_camera(&drawn.made, false, &random));
            ConvexFacts facts;
            const uint32_t wrong = draw_and_count(&drawn, &view, &facts);
            if (wrong > 0)
                fail_msg("%s, view %d: %u pixels are wrong beyond edges; %u faces in knots",
                         drawn.made.name, i, wrong, facts.knot_faces);
        }
        close_case(&drawn);
    }
}

/* As printed: what planes part, what is nested in each other, and two that cut each other in a
 * slab, is right; where circles have to be cut some is wrong, and has the exact order beside it. Of
 * sheets in one plane each is in front, and they are left out. */
static void an_order_by_a_grid_is_right_but_for_circles(void **state)
{
    (void)state;
    Random random = { 29 };
    uint32_t wrong_in_circles = 0;
    for (int number = 0; number < FRAGMENT_CASES - 1; number++) {
        Drawn drawn;
        open_case(&drawn, fragment_case(number), &(PiecesSetting){ 0 });
        for (int i = 0; i < views_asked_for(2); i++) {
            const FragmentView view = view_of(fragment_case_camera(&drawn.made, false, &random));
            ConvexFacts facts;
            const uint32_t wrong = draw_and_count_by(&drawn, CONVEX_ORDER_GRID, &view, &facts);
            if (wrong > (facts.split_sides ? SIDE * SIDE / 4 : 0))
                fail_msg("%s, view %d: %u pixels are wrong; %u circles", drawn.made.name, i, wrong,
                         facts.split_sides);
            wrong_in_circles += wrong;
        }
        close_case(&drawn);
    }
    assert_true(wrong_in_circles > 0);
}

static const Camera from_front = {
    .eye = { 0, 0, 3 }, .up = { 0, 1, 0 }, .fovy = 50, .near = 0.1, .far = 10
};
static const Camera from_aside = {
    .eye = { 1.3, 1.7, 2.3 }, .up = { 0, 1, 0 }, .fovy = 50, .near = 0.1, .far = 10
};

static void glass_is_the_truth_as_printed_and_as_corrected(void **state)
{
    (void)state;
    static const int bodies[] = { 0, 1, 3 }; /* closed, and none in another */
    for (size_t i = 0; i < GP_COUNT(bodies); i++) {
        Drawn drawn;
        open_case(&drawn, fragment_case(bodies[i]), &(PiecesSetting){ 0 });
        for (int printed = 0; printed < 2; printed++) {
            FragmentView view = view_of(from_aside);
            ConvexFacts facts;
            view.glass = (FragmentGlass){
                .is_on = true, .sigma = 1.5, .is_as_printed = printed, .begin = 1
            };
            const uint32_t wrong = draw_and_count(&drawn, &view, &facts);
            if (wrong > 0)
                fail_msg("%s: %u pixels are wrong beyond edges", drawn.made.name, wrong);
        }
        close_case(&drawn);
    }
}

/* A sheet in folds, as high as a twelfth of it. */
static FragmentCase folded_sheet(void)
{
    enum { FOLDS = 16 };
    FragmentCase made = { .name = "folds",
                          .positions = gp_alloc(2 * (FOLDS + 1), 3 * sizeof(float)),
                          .indices = gp_alloc(2 * FOLDS, 3 * sizeof(uint32_t)),
                          .vertex_count = 2 * (FOLDS + 1),
                          .triangle_count = 2 * FOLDS };
    for (uint32_t i = 0; i < made.vertex_count; i++) {
        made.positions[i][0] = (float)(i / 2) * 2 / FOLDS - 1;
        made.positions[i][1] = i % 2 ? 1 : -1;
        made.positions[i][2] = i / 2 % 2 ? 0.16f : 0;
    }
    for (uint32_t i = 0; i < 2 * FOLDS; i++) /* a strip */
        for (uint32_t c = 0; c < 3; c++)
            made.indices[3 * i + c] = i % 2 ? i + 2 - c : i + c;
    return made;
}

/* What a tolerance costs, beside what it is without: layers of a concave piece are lost. */
static void loose_tolerance_loses_fragments(void **state)
{
    (void)state;
    uint32_t wrong[2];
    for (int loose = 0; loose < 2; loose++) {
        Drawn drawn;
        ConvexFacts facts;
        FragmentView view = view_of(from_front);
        vector_set(view.camera.eye, 3, 0.1, 0.4);
        view.camera.up[2] = 1;
        open_case(&drawn, folded_sheet(), &(PiecesSetting){ .tolerance = loose });
        wrong[loose] = draw_and_count(&drawn, &view, &facts);
        assert_int_equal(facts.pieces == 1, loose);
        close_case(&drawn);
    }
    assert_int_equal(wrong[0], 0);
    assert_true(wrong[1] > 100);
}

/* A wall across the middle hides what is behind it, and nothing else. */
static void opaque_depth_hides_fragments(void **state)
{
    (void)state;
    Drawn drawn;
    Frame frame = { .color = NULL }, whole = { .color = NULL };
    FragmentView view = view_of(from_front);
    view.background[2] = view.background[3] = 1;
    open_case(&drawn, fragment_case(0), &(PiecesSetting){ 0 });
    GpSurface *depth = frame_surface(&frame, GP_D32F, SIDE, SIDE, 1);
    const float wall = (float)(10.0 / 9.9 - 10 * 0.1 / 9.9 / 3); /* at the distance 3 */
    frame_pass(&frame, "wall", NULL, depth, NULL)->depth.depth_value = wall;
    draw(&drawn, &view, depth, &frame);
    draw(&drawn, &view, NULL, &whole);
    run_list(&frame.list);
    run_list(&whole.list);
    const float(*cut)[4] = (const float(*)[4])(const void *)frame.color->level[0].texels;
    const float(*all)[4] = (const float(*)[4])(const void *)whole.color->level[0].texels;
    uint32_t fewer = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        assert_float_equal(cut[i][3], 1, 1e-6);
        fewer += fabsf(cut[i][0] - all[i][0]) > 1.0f / 255;
    }
    assert_true(fewer > 100);
    assert_int_equal(gp_float_bits(*(float *)(void *)depth->level[0].texels), gp_float_bits(wall));
    frame_free(&frame);
    frame_free(&whole);
    close_case(&drawn);
}

/* Each face is drawn once, whatever the levels. */
static void the_mesh_is_read_once(void **state)
{
    (void)state;
    Drawn drawn;
    Frame frame = { .color = NULL };
    const FragmentView view = view_of(from_front);
    open_case(&drawn, fragment_case(0), &(PiecesSetting){ 0 });
    draw(&drawn, &view, NULL, &frame);
    uint32_t triangles = 0;
    for (uint32_t p = 0; p < frame.list.pass_count; p++)
        for (uint32_t i = 0; i < frame.list.passes[p].draw_count; i++) {
            const GpGeometry *geometry = &frame.list.passes[p].draws[i].geometry;
            if (geometry->streams[GP_COLOR].data)
                triangles += geometry->index_count / 3;
        }
    assert_in_range(triangles, drawn.mesh.triangle_count / 2, drawn.mesh.triangle_count);
    frame_free(&frame);
    close_case(&drawn);
}

static void bits_are_the_same_on_every_device(void **state)
{
    (void)state;
    for (int number = 0; number < FRAGMENT_CASES; number += 2) {
        Drawn drawn;
        Frame frame = { .color = NULL };
        const FragmentView view = view_of(from_front);
        open_case(&drawn, fragment_case(number), &(PiecesSetting){ 0 });
        draw_by(&drawn, number % 4 ? CONVEX_ORDER_GRID : CONVEX_ORDER_EXACT, &view, NULL, &frame);
        run_everywhere(&frame);
        frame_free(&frame);
        close_case(&drawn);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_the_truth_from_any_view),
        cmocka_unit_test(an_order_by_a_grid_is_right_but_for_circles),
        cmocka_unit_test(glass_is_the_truth_as_printed_and_as_corrected),
        cmocka_unit_test(loose_tolerance_loses_fragments),
        cmocka_unit_test(opaque_depth_hides_fragments),
        cmocka_unit_test(the_mesh_is_read_once),
        cmocka_unit_test(bits_are_the_same_on_every_device),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
