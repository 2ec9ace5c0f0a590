/* The order of cells that needs no depth test: of two places on a ray from the eye the nearer comes
 * later, for images and eyes of both kinds, wherever the eye is. */
#include "apps/depth_images/drawing/order.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { W = 23, H = 17, CELLS = (W - 1) * (H - 1) };

static const DepthPlane planes[2] = {
    { .right = { 1, 0, 0 },
      .up = { 0, 1, 0 },
      .forward = { 0, 0, 1 },
      .left = -0.5,
      .bottom = -0.3,
      .width = 1,
      .height = 0.6 },
    { .is_parallel = true,
      .right = { 1, 0, 0 },
      .up = { 0, 1, 0 },
      .forward = { 0, 0, 1 },
      .left = -1,
      .bottom = -0.5,
      .width = 2,
      .height = 1 },
};

static const double all[2] = { 0, 1e9 };

/* All pixels show something. */
static DepthLattice lattice_of(const DepthPlane *plane, DepthPixels *pixels)
{
    DepthLattice lattice;
    assert_int_equal(depth_pixels_make(W, H, false, pixels), GP_OK);
    for (uint32_t i = 0; i < W * H; i++)
        pixels->depth[i] = 2;
    assert_int_equal(
        depth_lattice_make(plane, pixels, &(EdgeSetting){ .rule = EDGES_NONE }, &lattice), GP_OK);
    return lattice;
}

/* When a cell's two triangles come. */
static void find_ranks(const WarpOrder *order, const DepthLattice *lattice, uint32_t rank[CELLS])
{
    static uint32_t indices[6 * W * H];
    uint8_t seen[CELLS] = { 0 };
    assert_int_equal(warp_order_cells(order, lattice, all, indices), 6 * CELLS);
    for (uint32_t i = 0; i < CELLS; i++) {
        uint32_t least = UINT32_MAX;
        for (int k = 0; k < 6; k++)
            least = indices[6 * i + (uint32_t)k] < least ? indices[6 * i + (uint32_t)k] : least;
        const uint32_t cell = least / W * (W - 1) + least % W;
        assert_true(least % W < W - 1 && seen[cell]++ == 0);
        rank[cell] = i;
    }
}

static int64_t cell_of(const DepthPlane *plane, const DepthPixels *pixels, const double point[3])
{
    double place[2], depth;
    if (!depth_plane_place(plane, pixels, point, place, &depth))
        return -1;
    const double x = floor(place[0] - 0.5), y = floor(place[1] - 0.5);
    return x >= 0 && y >= 0 && x < W - 1 && y < H - 1 ? (int64_t)(y * (W - 1) + x) : -1;
}

/* Pairs of places on rays from an eye. returns how many of them were in two cells of the picture */
static uint32_t check_eye(const DepthPlane *plane, const double eye[4], Random *random)
{
    static uint32_t rank[CELLS];
    DepthPixels pixels;
    uint32_t pairs = 0;
    DepthLattice lattice = lattice_of(plane, &pixels);
    const WarpOrder order = warp_order(plane, &pixels, eye);
    find_ranks(&order, &lattice, rank);
    for (int i = 0; i < 400; i++) {
        double near[3], far[3];
        depth_plane_point(plane, &pixels, (double)random_float(random, 0.5f, W - 0.5f),
                          (double)random_float(random, 0.5f, H - 0.5f),
                          (double)random_float(random, 1, 4), near);
        const double share = (double)random_float(random, 0.01f, 1);
        for (int k = 0; k < 3; k++)
            far[k] = near[k] + share * (eye[3] > 0 ? near[k] - eye[k] : -eye[k]);
        const int64_t first = cell_of(plane, &pixels, far), second = cell_of(plane, &pixels, near);
        if (first < 0 || second < 0 || first == second)
            continue;
        pairs++;
        assert_true(rank[first] < rank[second]);
    }
    depth_lattice_free(&lattice);
    depth_pixels_free(&pixels);
    return pairs;
}

static void the_nearer_comes_later(void **state)
{
    (void)state;
    Random random = { 5 };
    uint32_t pairs = 0;
    for (int i = 0; i < 300; i++) {
        double eye[4] = { [3] = i % 3 == 0 ? 0 : 1 };
        for (int k = 0; k < 3; k++)
            eye[k] = (double)random_float(&random, -2, 2) * (i % 5 == 0 ? 5 : 1);
        if (i % 7 == 0)
            eye[2] = 0; /* its epipole is without end */
        if (i % 11 == 0)
            eye[1] = 0;
        pairs += check_eye(&planes[i & 1], eye, &random);
    }
    print_message("# %u pairs\n", pairs);
    assert_true(pairs > 20000);
}

/* And the other way round it would not. */
static void the_sign_of_the_epipole_turns_the_order(void **state)
{
    (void)state;
    DepthPixels pixels;
    DepthLattice lattice = lattice_of(&planes[0], &pixels);
    const double before[4] = { 0.1, 0.05, -1, 1 }, beyond[4] = { 0.1, 0.05, 1, 1 };
    assert_true(warp_order(&planes[0], &pixels, before).away);
    assert_false(warp_order(&planes[0], &pixels, beyond).away);
    assert_false(warp_order(&planes[1], &pixels, before).away);
    assert_false(warp_order(&planes[1], &pixels, beyond).away);
    depth_lattice_free(&lattice);
    depth_pixels_free(&pixels);
}

/* Only cells of which all depths are asked for. */
static void cells_beyond_the_range_are_left_out(void **state)
{
    (void)state;
    static uint32_t indices[6 * W * H];
    DepthPixels pixels;
    DepthLattice lattice = lattice_of(&planes[1], &pixels);
    const WarpOrder order = { .epipole = { 3, 4 } };
    lattice.flat[5 * W + 6] = 9;
    assert_int_equal(warp_order_cells(&order, &lattice, (double[2]){ 1, 3 }, indices),
                     6 * (CELLS - 4));
    lattice.neighbour[9 * W + 2] = 0;
    assert_int_equal(warp_order_cells(&order, &lattice, (double[2]){ 1, 3 }, indices),
                     6 * (CELLS - 4 - 3));
    depth_lattice_free(&lattice);
    depth_pixels_free(&pixels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_nearer_comes_later),
        cmocka_unit_test(the_sign_of_the_epipole_turns_the_order),
        cmocka_unit_test(cells_beyond_the_range_are_left_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
