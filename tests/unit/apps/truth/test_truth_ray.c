/* The truth's rays: the tree finds what a list finds, nothing slips through or shades itself. */
#include "apps/truth/ray_scene.h"
#include "tests/support/ball.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

static double random_in(Random *random, double low, double high)
{
    return low + (high - low) * ((double)(random_bits(random) >> 11) * 0x1p-53);
}

static void random_point(Random *random, double low, double high, double point[3])
{
    for (int i = 0; i < 3; i++)
        point[i] = random_in(random, low, high);
}

static TruthScene *create(const TruthTriangle *triangles, uint32_t count)
{
    TruthScene *scene;
    assert_int_equal(truth_scene_create(triangles, count, &scene), GP_OK);
    return scene;
}

/* --- the tree against a list ------------------------------------------------------------------ */

enum { SOUP = 1500, RAYS = 1500 };

typedef enum SoupKind {
    SCATTERED, /* small, anywhere */
    MIXED,     /* of all sizes */
    FLAT,      /* in the plane y = 0, on a coarse grid: many ties */
    COPIES,    /* few different ones, many times */
    SOUP_KINDS
} SoupKind;

static void fill_soup(Random *random, SoupKind kind, TruthTriangle soup[SOUP])
{
    for (int i = 0; i < SOUP; i++) {
        double centre[3], size = kind == MIXED ? pow(10, random_in(random, -4, 0.3)) : 0.05;
        random_point(random, -1, 1, centre);
        for (int corner = 0; corner < 3; corner++) {
            double *p = soup[i].corner[corner];
            random_point(random, -size, size, p);
            vector_add_scaled(p, 1, centre, p);
            for (int k = 0; k < 3 && kind == FLAT; k++)
                p[k] = k == 1 ? 0 : round(p[k] * 8) / 8;
        }
        if (kind == COPIES && i >= 20)
            soup[i] = soup[i % 20];
    }
}

/* A quarter of the rays are along an axis, a quarter aim at a corner. */
static void random_ray(Random *random, const TruthTriangle soup[SOUP], double origin[3],
                       double direction[3])
{
    random_point(random, -1.5, 1.5, origin);
    random_point(random, -1, 1, direction);
    switch (random_int(random, 0, 3)) {
    case 0: {
        int axis = random_int(random, 0, 2);
        for (int i = 0; i < 3; i++) {
            direction[i] = i == axis ? (direction[i] < 0 ? -2 : 2) : 0;
            origin[i] = round(origin[i] * 8) / 8;
        }
        break;
    }
    case 1:
        vector_subtract(soup[random_int(random, 0, SOUP - 1)].corner[0], origin, direction);
        break;
    default:
        break;
    }
}

static bool first_in_list(const TruthTriangle soup[SOUP], const double origin[3],
                          const double direction[3], TruthHit *hit)
{
    TruthRay ray = truth_ray(origin, direction);
    *hit = (TruthHit){ .t = HUGE_VAL, .triangle = TRUTH_NO_TRIANGLE };
    for (uint32_t i = 0; i < SOUP; i++) {
        TruthHit here = { .triangle = i };
        if (truth_ray_triangle(&ray, &soup[i], &here.t, here.share) && here.t > 0 &&
            here.t < hit->t)
            *hit = here;
    }
    return hit->triangle != TRUTH_NO_TRIANGLE;
}

static void the_tree_finds_what_a_list_finds(void **state)
{
    (void)state;
    static TruthTriangle soup[SOUP];
    Random random = { 1 };
    for (SoupKind kind = 0; kind < SOUP_KINDS; kind++) {
        fill_soup(&random, kind, soup);
        TruthScene *scene = create(soup, SOUP);
        int met = 0;
        for (int i = 0; i < RAYS; i++) {
            double origin[3], direction[3];
            TruthHit expected, hit = { 0 };
            random_ray(&random, soup, origin, direction);
            bool meets = first_in_list(soup, origin, direction, &expected);
            assert_int_equal(truth_first_hit(scene, origin, direction, &hit), meets);
            if (meets && (hit.t != expected.t || hit.triangle != expected.triangle ||
                          memcmp(hit.share, expected.share, sizeof hit.share) != 0))
                fail_msg("kind %d ray %d: triangle %u at %.17g, not %u at %.17g", kind, i,
                         hit.triangle, hit.t, expected.triangle, expected.t);
            met += meets;
        }
        assert_in_range(met, RAYS / 10, RAYS);
        truth_scene_destroy(&scene);
    }
}

static void what_blocks_is_what_a_list_has_in_between(void **state)
{
    (void)state;
    static TruthTriangle soup[SOUP];
    Random random = { 2 };
    fill_soup(&random, SCATTERED, soup);
    TruthScene *scene = create(soup, SOUP);
    int blocked = 0;
    for (int i = 0; i < RAYS; i++) {
        double from[3], to[3], direction[3];
        uint32_t skip = (uint32_t)random_int(&random, 0, SOUP - 1);
        bool between = false, beyond = false;
        random_point(&random, -1, 1, from);
        random_point(&random, -1, 1, to);
        vector_subtract(to, from, direction);
        TruthRay ray = truth_ray(from, direction);
        for (uint32_t k = 0; k < SOUP; k++) {
            double t, share[3];
            if (k != skip && truth_ray_triangle(&ray, &soup[k], &t, share)) {
                between = between || (t > 0 && t < 1);
                beyond = beyond || t > 0;
            }
        }
        assert_int_equal(truth_blocked(scene, from, to, skip), between);
        assert_int_equal(truth_blocked_along(scene, from, direction, skip), beyond);
        blocked += between;
    }
    assert_in_range(blocked, RAYS / 10, RAYS * 9 / 10);
    truth_scene_destroy(&scene);
}

/* Cramer's rule in long double: another way to the same point. */
static bool meet_by_cramer(const TruthTriangle *triangle, const double origin[3],
                           const double direction[3], double *t)
{
    long double m[3][3], rhs[3];
    for (int i = 0; i < 3; i++) {
        long double first = (long double)triangle->corner[0][i];
        m[i][0] = (long double)triangle->corner[1][i] - first;
        m[i][1] = (long double)triangle->corner[2][i] - first;
        m[i][2] = -(long double)direction[i];
        rhs[i] = (long double)origin[i] - first;
    }
    long double solution[3], determinant = 0;
    for (int column = -1; column < 3; column++) {
        long double a[3][3];
        for (int i = 0; i < 9; i++)
            a[i / 3][i % 3] = i % 3 == column ? rhs[i / 3] : m[i / 3][i % 3];
        long double value = a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
                            a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
                            a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
        if (column < 0)
            determinant = value;
        else
            solution[column] = value / determinant;
    }
    *t = (double)solution[2];
    return solution[0] >= 0 && solution[1] >= 0 && solution[0] + solution[1] <= 1;
}

static void a_meeting_is_where_cramers_rule_puts_it(void **state)
{
    (void)state;
    Random random = { 3 };
    int met = 0;
    for (int i = 0; i < 20000; i++) {
        TruthTriangle triangle;
        double origin[3], direction[3], t = 0, expected, share[3] = { 0 };
        for (int corner = 0; corner < 3; corner++)
            random_point(&random, -1, 1, triangle.corner[corner]);
        random_point(&random, -1, 1, origin);
        random_point(&random, -1, 1, direction);
        TruthRay ray = truth_ray(origin, direction);
        bool meets = meet_by_cramer(&triangle, origin, direction, &expected);
        assert_int_equal(truth_ray_triangle(&ray, &triangle, &t, share), meets);
        if (!meets)
            continue;
        met++;
        double point[3] = { 0 };
        for (int corner = 0; corner < 3; corner++)
            vector_add_scaled(point, share[corner], triangle.corner[corner], point);
        vector_add_scaled(point, -t, direction, point);
        vector_subtract(point, origin, point);
        assert_true(vector_extent(point) < 1e-10);
        assert_true(fabs(t - expected) < 1e-10 * (1 + fabs(expected)));
    }
    assert_in_range(met, 1000, 10000);
}

/* --- cracks and edges ------------------------------------------------------------------------- */

static const double origin_of_space[3] = { 0, 0, 0 };

/* A point of a triangle: a corner, on an edge, or inside, as near as rounding puts it. */
static void pick_point(Random *random, const TruthTriangle *triangle, double point[3])
{
    double share[3] = { random_in(random, 0, 1), random_in(random, 0, 1), random_in(random, 0, 1) };
    int kind = random_int(random, 0, 2);
    for (int i = 0; i < kind; i++)
        share[i] = 0;
    double sum = share[0] + share[1] + share[2];
    for (int i = 0; i < 3; i++)
        point[i] = 0;
    for (int i = 0; i < 3; i++)
        vector_add_scaled(point, kind == 2 ? share[i] > 0 : share[i] / sum, triangle->corner[i],
                          point);
}

static void no_ray_leaves_a_closed_mesh(void **state)
{
    (void)state;
    static TruthTriangle ball[BALL];
    make_ball(origin_of_space, 1, ball);
    TruthScene *scene = create(ball, BALL);
    Random random = { 4 };
    for (int i = 0; i < 100000; i++) {
        double origin[3], aim[3], direction[3];
        TruthHit hit;
        random_point(&random, -0.3, 0.3, origin);
        pick_point(&random, &ball[random_int(&random, 0, BALL - 1)], aim);
        vector_subtract(aim, origin, direction);
        assert_true(truth_first_hit(scene, origin, direction, &hit));
        assert_true(fabs(hit.t - 1) < 1e-12);
    }
    truth_scene_destroy(&scene);
}

/* Points on corners and edges too, where neighbours are met at t = 0. */
static void a_convex_mesh_never_shades_its_lit_side(void **state)
{
    (void)state;
    static TruthTriangle ball[BALL];
    make_ball(origin_of_space, 1, ball);
    TruthScene *scene = create(ball, BALL);
    Random random = { 5 };
    int lit = 0, dark = 0;
    for (int i = 0; i < 100000; i++) {
        uint32_t number = (uint32_t)random_int(&random, 0, BALL - 1);
        double point[3], light[3], edge[2][3], normal[3], way[3];
        pick_point(&random, &ball[number], point);
        random_point(&random, -8, 8, light);
        vector_subtract(ball[number].corner[1], ball[number].corner[0], edge[0]);
        vector_subtract(ball[number].corner[2], ball[number].corner[0], edge[1]);
        vector_cross(edge[0], edge[1], normal);
        vector_subtract(light, point, way);
        double facing = vector_dot(normal, way);
        if (sqrt(vector_dot(light, light)) < 1.1 || fabs(facing) < 1e-6)
            continue;
        if (vector_dot(normal, point) < 0)
            facing = -facing;
        if (facing > 0) {
            assert_false(truth_blocked(scene, point, light, number));
            assert_false(truth_blocked_along(scene, point, way, number));
            lit++;
        } else
            dark++;
    }
    assert_in_range(lit, 20000, 80000);
    assert_in_range(dark, 20000, 80000);
    truth_scene_destroy(&scene);
}

static void ends_do_not_block(void **state)
{
    (void)state;
    const TruthTriangle walls[2] = { { { { -1, -1, 0 }, { 3, -1, 0 }, { -1, 3, 0 } } },
                                     { { { -1, -1, 1 }, { 3, -1, 1 }, { -1, 3, 1 } } } };
    TruthScene *scene = create(walls, 2);
    const double below[3] = { 0, 0, -1 }, low[3] = { 0, 0, 0 }, high[3] = { 0, 0, 1 },
                 above[3] = { 0, 0, 2 }, up[3] = { 0, 0, 1 };
    assert_false(truth_blocked(scene, low, high, TRUTH_NO_TRIANGLE));
    assert_true(truth_blocked(scene, low, above, 0));
    assert_false(truth_blocked(scene, low, above, 1)); /* the one it is on does not block either */
    assert_true(truth_blocked(scene, below, high, TRUTH_NO_TRIANGLE));
    assert_false(truth_blocked(scene, below, low, TRUTH_NO_TRIANGLE));
    assert_false(truth_blocked(scene, low, low, TRUTH_NO_TRIANGLE));
    assert_true(truth_blocked_along(scene, low, up, 0));
    assert_false(truth_blocked_along(scene, high, up, 1));
    truth_scene_destroy(&scene);
}

static void scenes_may_be_empty_but_not_infinite(void **state)
{
    (void)state;
    TruthScene *scene = create(NULL, 0), *none = NULL;
    const double origin[3] = { 0 }, direction[3] = { 0, 0, 1 };
    TruthHit hit;
    assert_false(truth_first_hit(scene, origin, direction, &hit));
    assert_false(truth_blocked(scene, origin, direction, TRUTH_NO_TRIANGLE));
    truth_scene_destroy(&scene);
    assert_null(scene);
    truth_scene_destroy(&scene);
    TruthTriangle bad = { { { 0, 0, 0 }, { 1, 0, HUGE_VAL }, { 0, 1, 0 } } };
    assert_int_equal(truth_scene_create(&bad, 1, &none), GP_ERROR_INVALID);
    assert_null(none);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_tree_finds_what_a_list_finds),
        cmocka_unit_test(what_blocks_is_what_a_list_has_in_between),
        cmocka_unit_test(a_meeting_is_where_cramers_rule_puts_it),
        cmocka_unit_test(no_ray_leaves_a_closed_mesh),
        cmocka_unit_test(a_convex_mesh_never_shades_its_lit_side),
        cmocka_unit_test(ends_do_not_block),
        cmocka_unit_test(scenes_may_be_empty_but_not_infinite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
