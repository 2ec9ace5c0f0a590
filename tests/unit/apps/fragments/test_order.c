/* The order of convex pieces: right at every pixel's centre, from any view. Each face is asked
 * where rays through the centres meet its plane, in double, and times must rise with those
 * distances.
 *
 * $GP_TEST_FRAGMENT_VIEWS asks for so many views of each mesh instead of a few. */
#include "apps/fragments/order/order.h"
#include "apps/fragments/order/relations.h"

#include "tests/support/fragments/meshes.h"
#include "tests/support/unit.h"

#include <math.h>

enum { SIDE = 192, MOST = 4000000 };

/* What a face leaves at a pixel. */
typedef struct Met {
    uint32_t pixel, time; /* level * 2, one more on the far side */
    bool is_in_knot;
    double distance;
    double to_edge; /* in pixels */
} Met;

static Met *met;
static uint32_t met_count;

static int compare_met(const void *a, const void *b)
{
    const Met *p = a, *q = b;
    if (p->pixel != q->pixel)
        return p->pixel < q->pixel ? -1 : 1;
    return (p->distance > q->distance) - (p->distance < q->distance);
}

/* How far inside a triangle a pixel's centre is, in pixels; negative outside. */
static double depth_inside(const ScreenTriangle *t, int32_t x, int32_t y)
{
    double least = 1e9;
    for (int e = 0; e < 3; e++) {
        const int next = (e + 1) % 3;
        const double dx = t->x[next] - t->x[e], dy = t->y[next] - t->y[e];
        const double at = dx * (256 * y + 128 - t->y[e]) - dy * (256 * x + 128 - t->x[e]);
        least = fmin(least, at / sqrt(dx * dx + dy * dy) / 256);
    }
    return least;
}

/* Along the ray through a pixel's centre, in units of the view's direction. */
static double distance_at(const double plane[4], const Camera *camera, int32_t x, int32_t y)
{
    const CameraAxes axes = camera_axes(camera, 1);
    const double right = ((x + 0.5) / SIDE * 2 - 1) * axes.half_width;
    const double up = (1 - (y + 0.5) / SIDE * 2) * axes.half_height;
    double from[3], way[3];
    for (int k = 0; k < 3; k++) {
        const double aside = right * axes.right[k] + up * axes.up[k];
        from[k] = camera->eye[k] + (camera->fovy > 0 ? 0 : aside);
        way[k] = axes.forward[k] + (camera->fovy > 0 ? aside : 0);
    }
    return (plane[3] - vector_dot(plane, from)) / vector_dot(plane, way);
}

static void meet_face(const OrderMesh *mesh, const Camera *camera, const Screen *screen,
                      uint32_t face, uint32_t time, bool is_in_knot)
{
    const ScreenFace *seen = &screen->faces[face];
    for (uint32_t i = seen->first; i < seen->first + seen->count; i++)
        for (int32_t y = seen->box.y0 >> 8; y <= seen->box.y1 >> 8; y++)
            for (int32_t x = seen->box.x0 >> 8; x <= seen->box.x1 >> 8; x++) {
                const double inside = depth_inside(&screen->triangles[i], x, y);
                if (x < 0 || y < 0 || x >= SIDE || y >= SIDE || inside <= 0)
                    continue;
                assert_true(met_count < MOST);
                met[met_count++] = (Met){ (uint32_t)(y * SIDE + x), time, is_in_knot,
                                          distance_at(mesh->planes[face], camera, x, y), inside };
            }
}

static void meet_all(const OrderMesh *mesh, const Camera *camera, const Screen *screen,
                     const Order *order)
{
    met_count = 0;
    for (uint32_t level = 0; level < order->level_count; level++) {
        for (uint32_t i = order->first[level]; i < order->first[level + 1]; i++)
            meet_face(mesh, camera, screen, order->faces[i],
                      2 * level + relations_is_far(mesh->pieces, screen, order->faces[i]), false);
        for (uint32_t i = order->knot_first[level]; i < order->knot_first[level + 1]; i++)
            meet_face(mesh, camera, screen, order->knots[i], 2 * level, true);
    }
    qsort(met, met_count, sizeof *met, compare_met);
}

/* Whether what is met second comes too early, or at the time of what is before it; but where both
 * are within snapping of an edge, or one distance. */
static bool is_wrong(const Met *first, const Met *second, double size)
{
    if (first->pixel != second->pixel ||
        (first->is_in_knot && second->is_in_knot && first->time == second->time))
        return false;
    if (second->time == first->time)
        return true;
    return second->time < first->time && second->distance - first->distance > 1e-9 * size &&
           first->to_edge > 1.0 / 256 && second->to_edge > 1.0 / 256;
}

static uint32_t check_view(const OrderMesh *mesh, const FragmentView *view, Order *order)
{
    Screen screen;
    uint32_t wrong = 0;
    assert_int_equal(screen_make(mesh->mesh, view, &screen, NULL), GP_OK);
    assert_int_equal(order_find(mesh, view, &screen, order, NULL), GP_OK);
    meet_all(mesh, &view->camera, &screen, order);
    assert_true(met_count > 0 || order->level_count == 0);
    for (uint32_t i = 1; i < met_count; i++)
        wrong += is_wrong(&met[i - 1], &met[i], view->camera.far);
    screen_free(&screen);
    return wrong;
}

typedef struct Made {
    FragmentCase mesh_case;
    FragmentMesh mesh;
    Pieces pieces;
    OrderMesh order;
} Made;

static void make(int number, const PiecesSetting *setting, Made *made)
{
    made->mesh_case = fragment_case(number);
    made->mesh = fragment_case_mesh(&made->mesh_case);
    assert_int_equal(pieces_make(made->mesh.positions, made->mesh.vertex_count, made->mesh.indices,
                                 made->mesh.triangle_count, setting, NULL, NULL, &made->pieces,
                                 NULL),
                     GP_OK);
    assert_int_equal(order_mesh_make(&made->mesh, &made->pieces, &made->order, NULL), GP_OK);
}

static void unmake(Made *made)
{
    order_mesh_free(&made->order);
    pieces_free(&made->pieces);
    fragment_case_free(&made->mesh_case);
}

static int views_asked_for(int otherwise)
{
    const char *text = getenv("GP_TEST_FRAGMENT_VIEWS");
    return text ? atoi(text) : otherwise;
}

static void order_is_right_from_any_view(void **state)
{
    (void)state;
    static const PiecesSetting settings[] = { { 0 }, { .outward = true }, { .merge = true } };
    Random random = { 5 };
    for (int number = 0; number < FRAGMENT_CASES; number++) {
        Made made;
        make(number, &settings[number % 3], &made);
        for (int i = 0; i < views_asked_for(4); i++) {
            const FragmentView view = { .camera =
                                            fragment_case_camera(&made.mesh_case, true, &random),
                                        .width = SIDE,
                                        .height = SIDE };
            Order order;
            const uint32_t wrong = check_view(&made.order, &view, &order);
            if (wrong > 0)
                fail_msg("%s, view %d: %u of %u fragments come too early", made.mesh_case.name, i,
                         wrong, met_count);
            /* where sides turn away, steps of the screen make a few */
            const uint32_t knotted = order.knot_first[order.level_count];
            if (made.mesh_case.is_clean && knotted > 16 + made.mesh.triangle_count / 20)
                fail_msg("%s, view %d: %u faces are in knots", made.mesh_case.name, i, knotted);
            order_free(&order);
        }
        unmake(&made);
    }
}

static const FragmentView from_front = {
    .camera = { .eye = { 0, 0, 3 }, .up = { 0, 1, 0 }, .fovy = 50, .near = 0.1, .far = 10 },
    .width = SIDE,
    .height = SIDE,
};

static Order order_of(const Made *made, const FragmentView *view)
{
    Screen screen;
    Order order;
    assert_int_equal(screen_make(&made->mesh, view, &screen, NULL), GP_OK);
    assert_int_equal(order_find(&made->order, view, &screen, &order, NULL), GP_OK);
    screen_free(&screen);
    return order;
}

static int number_of(const char *name)
{
    for (int i = 0; i < FRAGMENT_CASES; i++) {
        FragmentCase made = fragment_case(i);
        const bool found = strcmp(made.name, name) == 0;
        fragment_case_free(&made);
        if (found)
            return i;
    }
    fail_msg("no case %s", name);
    return 0;
}

/* A level for the near side of each, then their far sides; not one for each piece's two sides. */
static void nested_pieces_stand_between_the_sides_of_the_outer_one(void **state)
{
    (void)state;
    Made made;
    make(number_of("nested"), &(PiecesSetting){ 0 }, &made);
    Order order = order_of(&made, &from_front);
    assert_int_equal(made.pieces.count, 4);
    assert_int_equal(order.level_count, 7);
    assert_int_equal(order.split_sides, 0);
    order_free(&order);
    unmake(&made);
}

static void circles_are_taken_apart(void **state)
{
    (void)state;
    Made made;
    make(number_of("beams"), &(PiecesSetting){ 0 }, &made);
    Order order = order_of(&made, &from_front);
    assert_true(order.split_sides > 0);
    assert_int_equal(order.knot_count, 0);
    order_free(&order);
    unmake(&made);
}

static void faces_that_cut_each_other_are_a_knot(void **state)
{
    (void)state;
    Made made;
    make(number_of("crossed"), &(PiecesSetting){ 0 }, &made);
    Order order = order_of(&made, &from_front);
    assert_int_equal(order.knot_count, 1);
    assert_int_equal(order.knot_first[order.level_count], 4);
    order_free(&order);
    unmake(&made);
}

/* Pieces as large as ORDER_LARGE are compared whole. */
static void large_pieces_are_ordered_as_the_small(void **state)
{
    (void)state;
    Made made;
    Random random = { 11 };
    make(number_of("nested"), &(PiecesSetting){ 0 }, &made);
    assert_true(order_is_large(&made.pieces, 0) || order_is_large(&made.pieces, 1));
    for (int i = 0; i < views_asked_for(6); i++) {
        FragmentView view = from_front;
        Order order;
        view.camera = fragment_case_camera(&made.mesh_case, true, &random);
        assert_int_equal(check_view(&made.order, &view, &order), 0);
        order_free(&order);
    }
    unmake(&made);
}

static int set_up(void **state)
{
    (void)state;
    met = gp_alloc(MOST, sizeof *met);
    return met ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    gp_free(met);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(order_is_right_from_any_view),
        cmocka_unit_test(nested_pieces_stand_between_the_sides_of_the_outer_one),
        cmocka_unit_test(circles_are_taken_apart),
        cmocka_unit_test(faces_that_cut_each_other_are_a_knot),
        cmocka_unit_test(large_pieces_are_ordered_as_the_small),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
