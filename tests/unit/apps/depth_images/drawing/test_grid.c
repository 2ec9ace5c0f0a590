/* Grids of planar depth images: as near to every pixel as was asked, without cracks; surfaces that
 * end do so half a cell out, and no triangle hangs between two. */
#include "apps/depth_images/drawing/grid.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { W = 150, H = 67 };

static const DepthPlane planes[2] = {
    { .right = { 1, 0, 0 },
      .up = { 0, 1, 0 },
      .forward = { 0, 0, -1 },
      .left = -0.5,
      .bottom = -0.3,
      .width = 1,
      .height = 0.6 },
    { .is_parallel = true,
      .right = { 1, 0, 0 },
      .up = { 0, 1, 0 },
      .forward = { 0, 0, -1 },
      .left = -1,
      .bottom = -0.5,
      .width = 2,
      .height = 1 },
};

typedef double Shape(double x, double y);

static DepthPixels pixels_of(Shape *shape)
{
    DepthPixels pixels;
    assert_int_equal(depth_pixels_make(W, H, false, &pixels), GP_OK);
    for (uint32_t i = 0; i < W * H; i++)
        pixels.depth[i] = (float)shape(i % W, i / W);
    return pixels;
}

static WarpGrid grid_of(const DepthPlane *plane, const DepthPixels *pixels,
                        const EdgeSetting *edges, const GridSetting *setting)
{
    DepthLattice lattice;
    WarpGrid grid;
    assert_int_equal(depth_lattice_make(plane, pixels, edges, &lattice), GP_OK);
    assert_int_equal(warp_grid_make(&lattice, setting, &grid), GP_OK);
    depth_lattice_free(&lattice);
    return grid;
}

static const GridVertex *corner_of(const WarpGrid *grid, uint32_t index)
{
    return &grid->vertices[grid->indices[index]];
}

/* Twice the area, above 0 of triangles that turn counter-clockwise in a picture whose y goes
 * down. */
static double area_of(const WarpGrid *grid, uint32_t first)
{
    const GridVertex *a = corner_of(grid, first), *b = corner_of(grid, first + 1),
                     *c = corner_of(grid, first + 2);
    return ((double)c->x - (double)a->x) * ((double)b->y - (double)a->y) -
           ((double)b->x - (double)a->x) * ((double)c->y - (double)a->y);
}

static double sum_of_areas(const WarpGrid *grid)
{
    double sum = 0;
    for (uint32_t i = 0; i < grid->index_count; i += 3) {
        assert_true(area_of(grid, i) > 0);
        sum += area_of(grid, i) / 2;
    }
    return sum;
}

/* Flat depth of the triangle's plane at a pixel's middle; false: it is outside. */
static bool plane_at(const WarpGrid *grid, uint32_t first, bool is_parallel, double x, double y,
                     double *flat)
{
    const double area = area_of(grid, first);
    double sum = 0;
    for (uint32_t i = 0; i < 3; i++) {
        const GridVertex *a = corner_of(grid, first + (i + 1) % 3),
                         *b = corner_of(grid, first + (i + 2) % 3);
        const double share =
            ((double)b->x - x) * ((double)a->y - y) - ((double)a->x - x) * ((double)b->y - y);
        if (share / area < -1e-9)
            return false;
        sum += share / area * depth_flat(is_parallel, (double)corner_of(grid, first + i)->depth);
    }
    *flat = sum;
    return true;
}

/* The most that pixels are off triangles over them, in the unit of GridSetting; fails where a pixel
 * has no triangle. */
static double most_off(const WarpGrid *grid, const DepthPlane *plane, const DepthPixels *pixels)
{
    static uint8_t covered[W * H];
    double most = 0, nearest = HUGE_VAL;
    memset(covered, 0, sizeof covered);
    for (uint32_t i = 0; i < W * H; i++)
        nearest = fmin(nearest, (double)pixels->depth[i]);
    const double texel = plane->width / W, unit = plane->is_parallel ? texel : texel / nearest;
    for (uint32_t i = 0; i < grid->index_count; i += 3) {
        double low[2] = { W, H }, high[2] = { 0, 0 };
        for (uint32_t k = 0; k < 3; k++) {
            const GridVertex *v = corner_of(grid, i + k);
            low[0] = fmin(low[0], (double)v->x), low[1] = fmin(low[1], (double)v->y);
            high[0] = fmax(high[0], (double)v->x), high[1] = fmax(high[1], (double)v->y);
        }
        for (double y = floor(low[1]) + 0.5; y <= high[1]; y++)
            for (double x = floor(low[0]) + 0.5; x <= high[0]; x++) {
                const size_t at = (size_t)y * W + (size_t)x;
                double flat;
                if (!plane_at(grid, i, plane->is_parallel, x, y, &flat))
                    continue;
                covered[at] = 1;
                const double own = depth_flat(plane->is_parallel, (double)pixels->depth[at]);
                most = fmax(most, fabs(flat - own) / unit);
            }
    }
    for (uint32_t i = 0; i < W * H; i++)
        assert_true(covered[i]);
    return most;
}

static double leaning(double x, double y)
{
    return 1 / (0.5 + 0.002 * x + 0.003 * y); /* a plane, for an eye */
}

static double bumpy(double x, double y)
{
    return 2 + 0.02 * sin(x * 0.21) * cos(y * 0.17) + 0.001 * x;
}

static void planes_are_few_triangles(void **state)
{
    (void)state;
    DepthPixels pixels = pixels_of(leaning);
    WarpGrid grid = grid_of(&planes[0], &pixels, &(EdgeSetting){ .rule = EDGES_SLOPES },
                            &(GridSetting){ .step = 1 });
    print_message("# %u triangles of %u\n", grid.index_count / 3, 2 * (W - 1) * (H - 1));
    assert_true(grid.index_count / 3 <
                2 * (W - 1) * (H - 1) / 5); /* the picture's sides are fine */
    assert_true(most_off(&grid, &planes[0], &pixels) < 1e-3);
    warp_grid_free(&grid);
    depth_pixels_free(&pixels);
}

static void no_pixel_is_farther_off_than_the_tolerance(void **state)
{
    (void)state;
    static const double tolerances[] = { -1, 0.05, 0.3, 0, 3 };
    for (int way = 0; way < 2; way++) {
        DepthPixels pixels = pixels_of(bumpy);
        uint32_t before = UINT32_MAX;
        for (size_t i = 0; i < GP_COUNT(tolerances); i++) {
            WarpGrid grid = grid_of(&planes[way], &pixels, &(EdgeSetting){ .rule = EDGES_NONE },
                                    &(GridSetting){ .tolerance = tolerances[i] });
            const double off = most_off(&grid, &planes[way], &pixels);
            const double allowed = tolerances[i] != 0 ? fmax(tolerances[i], 0) : GRID_TOLERANCE;
            print_message("# tolerance %g: %.4f off, %u triangles\n", tolerances[i], off,
                          grid.index_count / 3);
            assert_true(off <= allowed + 1e-3);
            assert_true(grid.index_count < before);
            before = grid.index_count;
            warp_grid_free(&grid);
        }
        depth_pixels_free(&pixels);
    }
}

/* An edge from a to b is met by one from b to a, but at the picture's side: then there are no
 * vertices on edges of others, which would open cracks. */
static void neighbours_share_whole_edges(void **state)
{
    (void)state;
    static const uint32_t steps[] = { 1, 2, 3, 16, 200 };
    DepthPixels pixels = pixels_of(bumpy);
    for (size_t s = 0; s < GP_COUNT(steps); s++) {
        WarpGrid grid = grid_of(&planes[0], &pixels, &(EdgeSetting){ .rule = EDGES_NONE },
                                &(GridSetting){ .step = steps[s] });
        assert_true(fabs(sum_of_areas(&grid) - W * H) < 1 * steps[s] * steps[s]); /* its corners */
        uint32_t alone = 0;
        for (uint32_t i = 0; i < grid.index_count; i++) {
            const GridVertex *a = corner_of(&grid, i),
                             *b = corner_of(&grid, i % 3 < 2 ? i + 1 : i - 2);
            bool is_met = false;
            for (uint32_t k = 0; k < grid.index_count && !is_met; k++) {
                const GridVertex *c = corner_of(&grid, k),
                                 *d = corner_of(&grid, k % 3 < 2 ? k + 1 : k - 2);
                is_met = c->x == b->x && c->y == b->y && d->x == a->x && d->y == a->y;
            }
            const bool at_side = (a->x == b->x && (a->x == 0 || a->x == W)) ||
                                 (a->y == b->y && (a->y == 0 || a->y == H));
            alone += !is_met && !at_side && a->x > 0.5f && a->y > 0.5f && a->x < W - 0.5f &&
                     a->y < H - 0.5f;
        }
        assert_int_equal(alone, 0);
        warp_grid_free(&grid);
    }
    depth_pixels_free(&pixels);
}

static double two_steps(double x, double y)
{
    const double square = (x - 60) * (x - 60) + (y - 30) * (y - 30);
    return square < 400 ? 1 + square * 1e-4 : square < 900 ? HUGE_VAL : 2;
}

/* Rubber sheets, and cells that are not cut but left out, beside them. */
static void no_triangle_hangs_between_near_and_far(void **state)
{
    (void)state;
    DepthPixels pixels = pixels_of(two_steps);
    for (uint32_t i = 0; i < W * H; i++) /* no gap between them on the right */
        if (i % W > 60 && pixels.depth[i] == INFINITY)
            pixels.depth[i] = 2;
    uint32_t hanging[3];
    double area[3];
    for (int rule = 0; rule < 3; rule++) {
        WarpGrid grid = grid_of(&planes[0], &pixels, &(EdgeSetting){ .rule = (EdgeRule)rule },
                                &(GridSetting){ .step = 1 });
        hanging[rule] = 0;
        area[rule] = sum_of_areas(&grid);
        for (uint32_t i = 0; i < grid.index_count; i += 3) {
            double low = HUGE_VAL, high = 0;
            for (uint32_t k = 0; k < 3; k++) {
                low = fmin(low, (double)corner_of(&grid, i + k)->depth);
                high = fmax(high, (double)corner_of(&grid, i + k)->depth);
            }
            hanging[rule] += high - low > 0.5;
        }
        warp_grid_free(&grid);
    }
    uint32_t shown = 0;
    for (uint32_t i = 0; i < W * H; i++)
        shown += pixels.depth[i] < DEPTH_NOTHING;
    print_message("# hanging: %u, %u, %u; area %.0f, %.0f, %.0f of %u pixels\n", hanging[0],
                  hanging[1], hanging[2], area[0], area[1], area[2], shown);
    assert_true(hanging[EDGES_SLOPES] == 0 && hanging[EDGES_RELATIVE] == 0);
    assert_true(hanging[EDGES_NONE] > 40);
    for (int rule = 0; rule < 3; rule++) /* as large as what it shows: silhouettes do not shrink */
        assert_true(fabs(area[rule] / shown - 1) < 0.002);
    depth_pixels_free(&pixels);
}

enum { STEEP = 8, LAST = 70 }; /* pixel widths from pixel to pixel, up to a column */

/* A slope that ends, before what is three steps of it deeper, or nothing. */
static DepthPixels slope_before(double behind, bool normals)
{
    DepthPixels pixels;
    const double width = planes[1].width / W;
    assert_int_equal(depth_pixels_make(W, H, normals, &pixels), GP_OK);
    for (uint32_t i = 0; i < W * H; i++) {
        const uint32_t x = i % W, on = x <= LAST ? x : LAST;
        const double across = x <= LAST ? STEEP / sqrt(1 + STEEP * STEEP) : 0;
        pixels.depth[i] = (float)(1 + STEEP * width * on + (x > LAST ? behind * width : 0));
        if (normals) {
            pixels.normal[3 * i] = (float)across;
            pixels.normal[3 * i + 2] = (float)sqrt(1 - across * across);
        }
    }
    return pixels;
}

/* A jump that is no steeper, by the rule, than the slope before it is told by normals. */
static void normals_tell_jumps_from_slopes(void **state)
{
    (void)state;
    DepthPixels pixels = slope_before(2.5 * STEEP, true);
    for (int asks = 0; asks < 2; asks++) {
        DepthLattice lattice;
        const EdgeSetting edges = { .spread = 2.5, .texels = 2, .along = asks ? 0.3 : 0 };
        assert_int_equal(depth_lattice_make(&planes[1], &pixels, &edges, &lattice), GP_OK);
        for (uint32_t x = 0; x + 1 < W; x++)
            assert_int_equal(lattice.neighbour[9 * W + x] & EDGE_RIGHT,
                             asks && x == LAST ? 0 : EDGE_RIGHT);
        depth_lattice_free(&lattice);
    }
    depth_pixels_free(&pixels);
}

/* Beyond its last column a slope goes on for half a step: as it came, twice as steep, or by so much
 * at most. */
static void ends_lean_as_far_as_is_allowed(void **state)
{
    (void)state;
    static const struct {
        GridEnds ends;
        double widths;
    } cases[] = { { { 0, 0 }, STEEP / 2.0 }, { { 2, 0 }, STEEP }, { { 2, 3.5 }, 3.5 } };
    DepthPixels pixels = slope_before(HUGE_VAL, false);
    const double width = planes[1].width / W, last = 1 + STEEP * width * LAST;
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        WarpGrid grid = grid_of(&planes[1], &pixels, &(EdgeSetting){ .texels = 10 },
                                &(GridSetting){ .ends = cases[i].ends });
        double deepest = 0;
        for (uint32_t v = 0; v < grid.vertex_count; v++)
            deepest = fmax(deepest, (double)grid.vertices[v].depth);
        assert_true(fabs((deepest - last) / width - cases[i].widths) < 1e-3);
        warp_grid_free(&grid);
    }
    depth_pixels_free(&pixels);
}

static void a_pixel_alone_is_a_spot_of_its_own_colour(void **state)
{
    (void)state;
    for (int way = 0; way < 2; way++) {
        DepthPixels pixels = pixels_of(two_steps);
        for (uint32_t i = 0; i < W * H; i++)
            pixels.depth[i] = i == 20 * W + 30 ? 0.75f : DEPTH_NOTHING;
        WarpGrid grid = grid_of(&planes[way], &pixels, &(EdgeSetting){ .rule = EDGES_SLOPES },
                                &(GridSetting){ .step = 1 });
        assert_int_equal(grid.index_count, 12);
        assert_true(fabs(sum_of_areas(&grid) - 0.5) < 1e-9);
        for (uint32_t i = 0; i < grid.vertex_count; i++) {
            const GridVertex *v = &grid.vertices[i];
            assert_true(v->u == 30.5f / W && v->v == 20.5f / H && v->depth == 0.75f);
            assert_true(fabsf(v->x - 30.5f) + fabsf(v->y - 20.5f) <= 0.5f);
        }
        warp_grid_free(&grid);
        depth_pixels_free(&pixels);
    }
}

/* Everything that depths may be gives numbers. */
static void depths_at_random_are_numbers(void **state)
{
    (void)state;
    Random random = { 7 };
    for (int round = 0; round < 40; round++) {
        DepthPixels pixels;
        const uint32_t width = (uint32_t)random_int(&random, 1, 6),
                       height = (uint32_t)random_int(&random, 1, 6);
        assert_int_equal(depth_pixels_make(width, height, false, &pixels), GP_OK);
        for (uint32_t i = 0; i < width * height; i++) {
            const float some[] = { DEPTH_NOTHING, 0, 1e-30f, 1, 1.01f, 3e38f };
            pixels.depth[i] = some[random_int(&random, 0, GP_COUNT(some) - 1)];
        }
        WarpGrid grid = grid_of(&planes[round & 1], &pixels,
                                &(EdgeSetting){ .rule = (EdgeRule)random_int(&random, 0, 2) },
                                &(GridSetting){ .step = (uint32_t)random_int(&random, 1, 3) });
        for (uint32_t i = 0; i < grid.vertex_count; i++) {
            const GridVertex *v = &grid.vertices[i];
            assert_true(isfinite(v->x + v->y + v->u + v->v) && isfinite(v->depth));
            assert_true(v->x >= 0 && v->y >= 0 && v->x <= (float)width && v->y <= (float)height);
        }
        warp_grid_free(&grid);
        depth_pixels_free(&pixels);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes_are_few_triangles),
        cmocka_unit_test(no_pixel_is_farther_off_than_the_tolerance),
        cmocka_unit_test(neighbours_share_whole_edges),
        cmocka_unit_test(no_triangle_hangs_between_near_and_far),
        cmocka_unit_test(normals_tell_jumps_from_slopes),
        cmocka_unit_test(ends_lean_as_far_as_is_allowed),
        cmocka_unit_test(a_pixel_alone_is_a_spot_of_its_own_colour),
        cmocka_unit_test(depths_at_random_are_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
