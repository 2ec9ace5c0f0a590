/* Where surfaces of depth images are cut: on slopes, which have no jumps, normals alone decide. */
#include "apps/depth_images/drawing/surface_grid.h"

#include "apps/base/vector.h"
#include "apps/depth_images/drawing/merge.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { SIDE = 12, ROUNDS = 60 };

#define CUT    2.0
#define ACROSS 1.0 /* sides of a pixel */
#define DOWN   1.5

static void random_direction(Random *random, double way[3])
{
    do
        for (int k = 0; k < 3; k++)
            way[k] = random_between(random, -1, 1);
    while (vector_dot(way, way) < 0.1);
    vector_normalize(way);
}

/* Looked at along parallel rays from anywhere. */
static DepthPlane random_plane(Random *random)
{
    DepthPlane plane = { .is_parallel = true,
                         .left = -ACROSS * SIDE / 2,
                         .bottom = -DOWN * SIDE / 2,
                         .width = ACROSS * SIDE,
                         .height = DOWN * SIDE };
    double any[3], back[3];
    random_direction(random, plane.forward);
    do
        random_direction(random, any);
    while (fabs(vector_dot(any, plane.forward)) > 0.9);
    vector_cross(plane.forward, any, plane.right);
    vector_normalize(plane.right);
    vector_set(back, -plane.forward[0], -plane.forward[1], -plane.forward[2]);
    vector_cross(back, plane.right, plane.up);
    for (int k = 0; k < 3; k++)
        plane.eye[k] = random_between(random, -3, 3);
    return plane;
}

/* Depths of a slope: so much deeper a pixel across, and down. Normals: the slope's, or any. */
static DepthImage slope_image(Random *random, const double slope[2], bool has_any)
{
    DepthImage image = { .plane = random_plane(random) };
    assert_int_equal(depth_pixels_make(SIDE, SIDE, true, &image.front), GP_OK);
    double square[3], normal[3];
    for (int k = 0; k < 3; k++) /* down is against up */
        square[k] = slope[0] / ACROSS * image.plane.right[k] - slope[1] / DOWN * image.plane.up[k] -
                    image.plane.forward[k];
    vector_normalize(square);
    for (int i = 0; i < SIDE * SIDE; i++) {
        image.front.depth[i] = (float)(60 + slope[0] * (i % SIDE) + slope[1] * (i / SIDE));
        random_direction(random, normal);
        for (int k = 0; k < 3; k++)
            image.front.normal[3 * i + k] = (float)(has_any ? normal[k] : square[k]);
    }
    return image;
}

static double cosine_at(const DepthImage *image, int pixel, const double way[3])
{
    double normal[3];
    for (int k = 0; k < 3; k++)
        normal[k] = (double)image->front.normal[3 * pixel + k];
    return fabs(vector_dot(normal, way));
}

/* The larger cosine of the angles that the way between two pixels has with the normals at its
 * ends. */
static double cosine_between(const DepthImage *image, int from, int to)
{
    double end[2][3], way[3];
    for (int i = 0; i < 2; i++) {
        const int pixel = i ? to : from;
        depth_plane_point(&image->plane, &image->front, pixel % SIDE + 0.5, pixel / SIDE + 0.5,
                          (double)image->front.depth[pixel], end[i]);
    }
    vector_subtract(end[1], end[0], way);
    vector_normalize(way);
    return fmax(cosine_at(image, from, way), cosine_at(image, to, way));
}

/* returns the cuts that there are */
static int check_cuts(const DepthImage *image, const double slope[2])
{
    SurfaceGrid grid;
    GpError error = { "" };
    int cuts = 0;
    if (surface_grid_open(image, image->front.normal, 1, CUT, &grid, &error))
        fail_msg("%s", error.text);
    assert_int_equal(grid.columns, SIDE);
    assert_int_equal(grid.rows, SIDE);
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int down = 0; down < 2; down++) {
            const int next = i + (down ? SIDE : 1);
            if (down ? i / SIDE == SIDE - 1 : i % SIDE == SIDE - 1)
                continue;
            const double cosine = cosine_between(image, i, next);
            const bool is_cut = grid.cut[i] & (down ? MERGE_CUT_DOWN : MERGE_CUT_RIGHT);
            if (fabs(cosine - 0.5) > 1e-5)
                assert_int_equal(is_cut,
                                 fabs(slope[down]) > CUT * (down ? DOWN : ACROSS) && cosine > 0.5);
            cuts += is_cut;
        }
    surface_grid_close(&grid);
    return cuts;
}

static void slopes_are_cut_where_normals_say_so(void **state)
{
    (void)state;
    Random random = { 1 };
    int cuts = 0;
    for (int round = 0; round < ROUNDS; round++) {
        const double slope[2] = { random_between(&random, -4, 4), random_between(&random, -4, 4) };
        for (int any = 0; any < 2; any++) {
            DepthImage image = slope_image(&random, slope, any);
            const int found = check_cuts(&image, slope);
            assert_true(any || found == 0);
            cuts += found;
            depth_pixels_free(&image.front);
        }
    }
    assert_true(cuts > ROUNDS * SIDE);
}

/* A slope with a step in it: three times what is beside it is a jump, whatever normals say. */
static void jumps_are_cut(void **state)
{
    (void)state;
    Random random = { 2 };
    for (int jumps = 0; jumps < 2; jumps++) {
        const double slope[2] = { 2.5, 0 };
        DepthImage image = slope_image(&random, slope, false);
        SurfaceGrid grid;
        for (int i = 0; i < SIDE * SIDE; i++)
            image.front.depth[i] += i % SIDE > 5 ? jumps ? 5.1F : 4.9F : 0; /* 7.6 or 7.4 in all */
        assert_int_equal(surface_grid_open(&image, NULL, 1, CUT, &grid, NULL), GP_OK);
        for (int i = 0; i < SIDE * SIDE; i++)
            assert_int_equal(grid.cut[i], jumps && i % SIDE == 5 ? MERGE_CUT_RIGHT : 0);
        surface_grid_close(&grid);
        depth_pixels_free(&image.front);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slopes_are_cut_where_normals_say_so),
        cmocka_unit_test(jumps_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
