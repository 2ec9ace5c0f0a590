/* Set-up and rasterizer: fill rule, exactness, points. */
#include "pipeline/units/raster.h"
#include "pipeline/units/setup.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { GRID = 32 };

typedef struct Point {
    int32_t x, y;
} Point;

/* How often each pixel of a small window was covered. */
typedef struct Coverage {
    uint8_t count[GRID][GRID];
} Coverage;

static const GpRect window = { 0, 0, GRID, GRID };

static GpSetupResult fill_culled(Coverage *coverage, Point a, Point b, Point c, GpCull cull)
{
    GpScreenVertex corner[3] = { { .x = a.x, .y = a.y, .rw = 1 },
                                 { .x = b.x, .y = b.y, .rw = 1 },
                                 { .x = c.x, .y = c.y, .rw = 1 } };
    GpTriangle triangle;
    GpSetupResult result =
        gp_setup_triangle(corner, &(GpRasterState){ .cull = cull }, &window, &triangle);
    if (result != GP_SETUP_DRAWN)
        return result;
    GpRasterWalk walk = gp_raster_triangle(&triangle);
    GpQuad quad;
    while (gp_raster_next(&walk, &quad))
        for (int i = 0; i < 4; i++)
            if (quad.mask >> i & 1)
                coverage->count[quad.y + i / 2][quad.x + i % 2]++;
    return result;
}

static void fill(Coverage *coverage, Point a, Point b, Point c)
{
    fill_culled(coverage, a, b, c, GP_CULL_NONE);
}

static int covered_once(const Coverage *coverage)
{
    int pixels = 0;
    for (int y = 0; y < GRID; y++)
        for (int x = 0; x < GRID; x++) {
            assert_true(coverage->count[y][x] <= 1);
            pixels += coverage->count[y][x];
        }
    return pixels;
}

/* A point in pixels, in Direct3D 9's coordinates: the centre of pixel (i, j) is (i, j). */
static Point d3d9(double x, double y)
{
    return (Point){ (int32_t)((x + 0.5) * GP_SUBPIXELS), (int32_t)((y + 0.5) * GP_SUBPIXELS) };
}

static void r06_rectangle_and_its_halves_fill_25_15_10(void **state)
{
    (void)state;
    Coverage upper = { 0 }, lower = { 0 }, both = { 0 };
    fill(&upper, d3d9(0, 0), d3d9(5, 0), d3d9(5, 5));
    assert_int_equal(covered_once(&upper), 15);
    fill(&lower, d3d9(0, 5), d3d9(0, 0), d3d9(5, 5));
    assert_int_equal(covered_once(&lower), 10);
    fill(&both, d3d9(0, 0), d3d9(5, 0), d3d9(5, 5));
    fill(&both, d3d9(0, 5), d3d9(0, 0), d3d9(5, 5));
    assert_int_equal(covered_once(&both), 25);
    for (int y = 0; y < 5; y++)
        for (int x = 0; x < 5; x++)
            assert_int_equal(both.count[y][x], 1);
}

static void fill_around_centre(Coverage *coverage, double x0, double y0, double x1, double y1)
{
    Point corner[4] = { d3d9(x0, y0), d3d9(x1, y0), d3d9(x1, y1), d3d9(x0, y1) };
    Point centre = d3d9((x0 + x1) / 2, (y0 + y1) / 2);
    for (int i = 0; i < 4; i++)
        fill(coverage, corner[i], corner[(i + 1) % 4], centre);
}

static void r07_shifted_rectangles_cover_the_same_eight_pixels(void **state)
{
    (void)state;
    Coverage half = { 0 }, whole = { 0 };
    fill_around_centre(&half, 0.5, 0.5, 2.5, 4.5);
    fill_around_centre(&whole, 1, 1, 3, 5);
    assert_int_equal(covered_once(&half), 8);
    assert_int_equal(covered_once(&whole), 8);
    assert_memory_equal(&half, &whole, sizeof half);
}

/* --- random fans and meshes --------------------------------------------------------------------
 */

static int64_t cross(Point o, Point a, Point b)
{
    return (int64_t)(a.x - o.x) * (b.y - o.y) - (int64_t)(a.y - o.y) * (b.x - o.x);
}

static int by_position(const void *a, const void *b)
{
    const Point *p = a, *q = b;
    return p->x != q->x ? (p->x > q->x) - (p->x < q->x) : (p->y > q->y) - (p->y < q->y);
}

/* Convex hull, clockwise with y down; Andrew's monotone chain. */
static int convex_hull(Point *points, int count, Point *hull)
{
    qsort(points, (size_t)count, sizeof *points, by_position);
    int size = 0;
    for (int pass = 0; pass < 2; pass++) {
        int floor = size;
        for (int k = 0; k < count; k++) {
            Point p = points[pass ? count - 1 - k : k];
            while (size >= floor + 2 && cross(hull[size - 2], hull[size - 1], p) <= 0)
                size--;
            hull[size++] = p;
        }
        size--;
    }
    return size;
}

/* The fill rule stated once more, on a whole convex polygon, without triangles. */
static bool polygon_covers(const Point *hull, int size, int px, int py)
{
    Point centre = { px * GP_SUBPIXELS + GP_SUBPIXELS / 2, py * GP_SUBPIXELS + GP_SUBPIXELS / 2 };
    for (int i = 0; i < size; i++) {
        Point a = hull[i], b = hull[(i + 1) % size];
        int64_t side = cross(a, b, centre);
        bool top_or_left = (a.y == b.y && b.x > a.x) || b.y < a.y;
        if (side < 0 || (side == 0 && !top_or_left))
            return false;
    }
    return size >= 3;
}

static void check_fan(Random *random, int32_t reach, int snap)
{
    Point points[9], hull[20], apex;
    int count = random_int(random, 3, 9);
    for (int i = 0; i < count; i++) {
        points[i].x = random_int(random, -reach, GRID * GP_SUBPIXELS + reach) & -snap;
        points[i].y = random_int(random, -reach, GRID * GP_SUBPIXELS + reach) & -snap;
    }
    int size = convex_hull(points, count, hull);
    if (size < 3)
        return;
    /* an apex inside: a mean of the hull's corners, or one of them */
    int64_t x = 0, y = 0;
    for (int i = 0; i < size; i++) {
        x += hull[i].x;
        y += hull[i].y;
    }
    apex = (Point){ (int32_t)(x / size), (int32_t)(y / size) };
    for (int i = 0; i < size; i++)
        if (cross(hull[i], hull[(i + 1) % size], apex) < 0)
            apex = hull[0];

    Coverage coverage = { 0 };
    for (int i = 0; i < size; i++) {
        Point a = hull[i], b = hull[(i + 1) % size];
        bool flip = random_bits(random) & 1; /* any winding */
        switch (random_int(random, 0, 2)) {  /* any first corner */
        case 0:
            fill(&coverage, flip ? b : a, flip ? a : b, apex);
            break;
        case 1:
            fill(&coverage, apex, flip ? b : a, flip ? a : b);
            break;
        default:
            fill(&coverage, flip ? b : a, apex, flip ? a : b);
        }
    }
    for (int py = 0; py < GRID; py++)
        for (int px = 0; px < GRID; px++)
            assert_int_equal(coverage.count[py][px], polygon_covers(hull, size, px, py));
}

static int fans_wanted(void)
{
    const char *text = getenv("GP_TEST_FANS"); /* `make check` asks for 1,000,000 */
    return text ? atoi(text) : 20000;
}

static void r05_shared_edge_covered_once(void **state)
{
    (void)state;
    Random random = { 5 };
    for (int i = 0; i < fans_wanted(); i++)
        check_fan(&random, i % 3 ? 0 : 8 * GP_SUBPIXELS, i % 2 ? 1 : GP_SUBPIXELS / 2);
}

static void r09_union_of_fan_is_hull_far_outside_the_window(void **state)
{
    (void)state;
    Random random = { 9 };
    for (int i = 0; i < fans_wanted() / 10; i++)
        check_fan(&random, 8300000 - GRID * GP_SUBPIXELS, 1); /* nearly the guard band */
}

static void r09_jittered_mesh_covers_its_rectangle_once(void **state)
{
    (void)state;
    enum { CELLS = 8, CELL = GRID * GP_SUBPIXELS / CELLS };
    Random random = { 90 };
    for (int round = 0; round < fans_wanted() / 100; round++) {
        Point at[CELLS + 1][CELLS + 1];
        for (int y = 0; y <= CELLS; y++)
            for (int x = 0; x <= CELLS; x++) {
                bool border = x == 0 || y == 0 || x == CELLS || y == CELLS;
                int32_t reach = border ? 0 : CELL / 4;
                at[y][x] = (Point){ x * CELL + random_int(&random, -reach, reach),
                                    y * CELL + random_int(&random, -reach, reach) };
            }
        Coverage coverage = { 0 };
        for (int y = 0; y < CELLS; y++)
            for (int x = 0; x < CELLS; x++) {
                Point a = at[y][x], b = at[y][x + 1], c = at[y + 1][x + 1], d = at[y + 1][x];
                bool other = random_bits(&random) & 1;
                fill(&coverage, a, b, other ? d : c);
                fill(&coverage, other ? b : a, c, d);
            }
        assert_int_equal(covered_once(&coverage), GRID * GRID);
    }
}

/* --- facing and degenerate triangles -----------------------------------------------------------
 */

static void r08_zero_area_draws_nothing(void **state)
{
    (void)state;
    Coverage coverage = { 0 };
    Point a = { 0, 0 }, b = { 2560, 2560 }, c = { 5120, 5120 };
    assert_int_equal(fill_culled(&coverage, a, b, c, GP_CULL_NONE), GP_SETUP_ZERO_AREA);
    assert_int_equal(fill_culled(&coverage, a, a, a, GP_CULL_NONE), GP_SETUP_ZERO_AREA);
    assert_int_equal(covered_once(&coverage), 0);
}

static void cull_takes_the_facing_it_names(void **state)
{
    (void)state;
    Point a = { 0, 0 }, b = { 2560, 0 }, c = { 0, 2560 }; /* clockwise with y down */
    Coverage coverage = { 0 };
    assert_int_equal(fill_culled(&coverage, a, b, c, GP_CULL_CW), GP_SETUP_CULLED);
    assert_int_equal(fill_culled(&coverage, a, c, b, GP_CULL_CCW), GP_SETUP_CULLED);
    assert_int_equal(covered_once(&coverage), 0);
    assert_int_equal(fill_culled(&coverage, a, b, c, GP_CULL_CCW), GP_SETUP_DRAWN);
    Coverage other = { 0 };
    assert_int_equal(fill_culled(&other, a, c, b, GP_CULL_CW), GP_SETUP_DRAWN);
    assert_memory_equal(&coverage, &other, sizeof coverage);
}

static void edge_functions_sum_to_the_area_everywhere(void **state)
{
    (void)state;
    Random random = { 77 };
    for (int i = 0; i < 2000; i++) {
        GpScreenVertex corner[3] = { { .rw = 1 }, { .rw = 1 }, { .rw = 1 } };
        for (int k = 0; k < 3; k++) {
            corner[k].x = random_int(&random, -8300000, 8300000);
            corner[k].y = random_int(&random, -8300000, 8300000);
        }
        GpTriangle t;
        if (gp_setup_triangle(corner, &(GpRasterState){ 0 }, &window, &t) != GP_SETUP_DRAWN)
            continue;
        int64_t sum_a = t.a[0] + t.a[1] + t.a[2], sum_b = t.b[0] + t.b[1] + t.b[2];
        assert_true(sum_a == 0 && sum_b == 0);
        assert_true(t.c[0] + t.c[1] + t.c[2] == t.area2);
        for (int k = 0; k < 3; k++) /* edge k vanishes at its own two corners, is the area at k */
            for (int v = 0; v < 3; v++) {
                int64_t e = t.a[k] * t.corner[v].x + t.b[k] * t.corner[v].y + t.c[k];
                assert_true(e == (k == v ? t.area2 : 0));
            }
    }
}

/* --- points -------------------------------------------------------------------------------------
 */

static int fill_point(Coverage *coverage, int32_t x, int32_t y, float size)
{
    GpPointSprite sprite;
    GpScreenVertex center = { .x = x, .y = y, .rw = 1 };
    if (gp_setup_point(&center, size, &window, &sprite) != GP_SETUP_DRAWN)
        return 0;
    GpRasterWalk walk = gp_raster_sprite(&sprite);
    GpQuad quad;
    while (gp_raster_next(&walk, &quad))
        for (int i = 0; i < 4; i++)
            if (quad.mask >> i & 1)
                coverage->count[quad.y + i / 2][quad.x + i % 2]++;
    return covered_once(coverage);
}

static void r12_point_covers_what_its_two_triangles_would(void **state)
{
    (void)state;
    Random random = { 12 };
    for (int i = 0; i < 3000; i++) {
        int32_t x = random_int(&random, -1000, GRID * GP_SUBPIXELS + 1000);
        int32_t y = random_int(&random, -1000, GRID * GP_SUBPIXELS + 1000);
        int32_t whole = random_int(&random, 0, 10 * GP_SUBPIXELS);
        Coverage point = { 0 }, triangles = { 0 };
        fill_point(&point, x, y, (float)whole / GP_SUBPIXELS);
        Point a = { x - whole / 2, y - whole / 2 };
        Point b = { a.x + whole, a.y }, c = { a.x + whole, a.y + whole }, d = { a.x, a.y + whole };
        fill(&triangles, a, b, c);
        fill(&triangles, a, c, d);
        assert_memory_equal(&point, &triangles, sizeof point);
    }
}

static void r12_point_of_size_one_covers_one_pixel_anywhere(void **state)
{
    (void)state;
    for (int32_t y = 4 * GP_SUBPIXELS; y < 6 * GP_SUBPIXELS; y += 7)
        for (int32_t x = 4 * GP_SUBPIXELS; x < 6 * GP_SUBPIXELS; x += 5) {
            Coverage coverage = { 0 };
            assert_int_equal(fill_point(&coverage, x, y, 1), 1);
        }
}

static void r12_point_sizes_without_meaning_draw_nothing(void **state)
{
    (void)state;
    Coverage coverage = { 0 };
    assert_int_equal(fill_point(&coverage, 2000, 2000, 0), 0);
    assert_int_equal(fill_point(&coverage, 2000, 2000, -3), 0);
    assert_int_equal(fill_point(&coverage, 2000, 2000, 0.0f / 0.0f), 0);
    assert_int_equal(fill_point(&coverage, 2000, 2000, 1e30f), GRID * GRID);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r06_rectangle_and_its_halves_fill_25_15_10),
        cmocka_unit_test(r07_shifted_rectangles_cover_the_same_eight_pixels),
        cmocka_unit_test(r05_shared_edge_covered_once),
        cmocka_unit_test(r09_union_of_fan_is_hull_far_outside_the_window),
        cmocka_unit_test(r09_jittered_mesh_covers_its_rectangle_once),
        cmocka_unit_test(r08_zero_area_draws_nothing),
        cmocka_unit_test(cull_takes_the_facing_it_names),
        cmocka_unit_test(edge_functions_sum_to_the_area_everywhere),
        cmocka_unit_test(r12_point_covers_what_its_two_triangles_would),
        cmocka_unit_test(r12_point_of_size_one_covers_one_pixel_anywhere),
        cmocka_unit_test(r12_point_sizes_without_meaning_draw_nothing),
    };
    return cmocka_run_group_tests_name("raster", tests, NULL, NULL);
}
