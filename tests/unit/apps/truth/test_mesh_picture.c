/* The truth of splats: every sample against every triangle by rays, and what geometry says. */
#include "apps/truth/mesh_picture.h"
#include "apps/truth/ray_triangle.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

/* 8 pixels a unit at distance 1, looking along -z. */
enum { WIDTH = 24, HEIGHT = 16, FOCAL = 8, SIDE = 4 };

static Camera camera_along_z(double near)
{
    return (Camera){ .at = { 0, 0, -1 }, .up = { 0, 1, 0 }, .fovy = 90, .near = near, .far = 1e6 };
}

/* Colour: the corners' shares, scaled by a number of the triangle's own. */
static void share_color(const void *context, uint32_t triangle, const double share[3],
                        double color[3])
{
    (void)context;
    for (int k = 0; k < 3; k++)
        color[k] = share[k] * (1 + triangle % 7);
}

static MeshPicture make(const float *positions, const uint32_t *indices, uint32_t triangles,
                        double near, uint32_t samples, int threads)
{
    const MeshPictureScene scene = { .positions = positions,
                                     .stride = 3 * sizeof *positions,
                                     .indices = indices,
                                     .triangle_count = triangles,
                                     .camera = camera_along_z(near),
                                     .width = WIDTH,
                                     .height = HEIGHT,
                                     .samples = samples,
                                     .color = share_color };
    MeshPicture picture;
    GpPool *pool;
    assert_int_equal(gp_pool_create(threads, &pool, NULL), GP_OK);
    assert_int_equal(mesh_picture_make(&scene, pool, &picture), GP_OK);
    gp_pool_destroy(&pool);
    return picture;
}

/* --- against rays ----------------------------------------------------------------------------- */

enum { SOUP = 60 };

typedef struct Soup {
    float positions[9 * SOUP];
    uint32_t indices[3 * SOUP];
} Soup;

/* Around the eye too, so that the near plane cuts a third of them. */
static void fill_soup(Random *random, Soup *soup)
{
    for (int i = 0; i < SOUP; i++) {
        const float size = i % 3 ? 0.5f : 3;
        float centre[3];
        for (int k = 0; k < 3; k++)
            centre[k] = k < 2 ? random_float(random, -2, 2) : random_float(random, -5, 0.5f);
        for (int at = 9 * i; at < 9 * i + 9; at++)
            soup->positions[at] = centre[at % 3] + random_float(random, -size, size);
    }
    for (uint32_t i = 0; i < 3 * SOUP; i++)
        soup->indices[i] = i;
}

/* The nearest of all triangles that is at least `near` away along the view; false: none. */
static bool cast(const Soup *soup, double near, double x, double y, double color[3])
{
    const double eye[3] = { 0, 0, 0 };
    const double way[3] = { (x - WIDTH / 2.0) / FOCAL, (HEIGHT / 2.0 - y) / FOCAL, -1 };
    const TruthRay ray = truth_ray(eye, way); /* t is the depth */
    double nearest = 1e9;
    for (uint32_t i = 0; i < SOUP; i++) {
        TruthTriangle triangle;
        double t, share[3];
        for (int k = 0; k < 9; k++)
            triangle.corner[k / 3][k % 3] = (double)soup->positions[9 * i + (uint32_t)k];
        if (!truth_ray_triangle(&ray, &triangle, &t, share) || t < near || t >= nearest)
            continue;
        nearest = t;
        share_color(NULL, i, share, color);
    }
    return nearest < 1e9;
}

static void every_sample_is_what_a_ray_meets_first(void **state)
{
    (void)state;
    Random random = { 5 };
    uint32_t part_covered = 0;
    for (int round = 0; round < 20; round++) {
        Soup soup;
        const double near = round % 2 ? 0.5 : 0.01;
        fill_soup(&random, &soup);
        MeshPicture picture = make(soup.positions, soup.indices, SOUP, near, SIDE, 1);
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            double sum[3] = { 0, 0, 0 };
            int covered = 0;
            for (int i = 0; i < SIDE * SIDE; i++) {
                double color[3];
                if (!cast(&soup, near, pixel % WIDTH + (i % SIDE + 0.5) / SIDE,
                          pixel / WIDTH + (i / SIDE + 0.5) / SIDE, color))
                    continue;
                covered++;
                for (int k = 0; k < 3; k++)
                    sum[k] += color[k];
            }
            part_covered += covered > 0 && covered < SIDE * SIDE;
            assert_int_equal(picture.covered[pixel], covered);
            for (int k = 0; k < 3 && covered; k++)
                if (!(fabs(picture.color[3 * pixel + k] - sum[k] / covered) < 1e-9))
                    fail_msg("round %d, pixel %d, %d: %.12g, by rays %.12g", round, pixel, k,
                             picture.color[3 * pixel + k], sum[k] / covered);
        }
        mesh_picture_free(&picture);
    }
    assert_true(part_covered > 100);
}

static void threads_change_no_bit(void **state)
{
    (void)state;
    Random random = { 9 };
    Soup soup;
    fill_soup(&random, &soup);
    MeshPicture one = make(soup.positions, soup.indices, SOUP, 0.1, SIDE, 1);
    MeshPicture three = make(soup.positions, soup.indices, SOUP, 0.1, SIDE, 3);
    assert_memory_equal(one.color, three.color, WIDTH * HEIGHT * 3 * sizeof *one.color);
    assert_memory_equal(one.covered, three.covered, WIDTH * HEIGHT);
    mesh_picture_free(&one);
    mesh_picture_free(&three);
}

/* --- against mathematics ---------------------------------------------------------------------- */

/* At distance 8 a unit is a pixel: a rectangle from 3 1/4 left of the middle to 5 right of it, 2
 * 1/2 below and 4 above. */
static void a_rectangle_covers_its_area(void **state)
{
    (void)state;
    static const float corners[] = { -3.25f, -2.5f, -8, 5, -2.5f, -8, 5, 4, -8, -3.25f, 4, -8 };
    static const uint32_t indices[] = { 0, 1, 2, 0, 2, 3 };
    MeshPicture picture = make(corners, indices, 2, 0.1, 8, 1);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const int across = x == 8 ? 2 : x > 8 && x < 17 ? 8 : 0; /* of 8 */
            const int down = y == 10 ? 4 : y > 3 && y < 10 ? 8 : 0;
            assert_int_equal(picture.covered[y * WIDTH + x], across * down);
            assert_int_equal(mesh_picture_is_interior(&picture, (uint32_t)x, (uint32_t)y),
                             x > 9 && x < 16 && y > 4 && y < 9);
        }
    mesh_picture_free(&picture);
}

/* A floor one below the eye, from behind it to where it cannot be told from the horizon, is seen
 * from the near plane on, which it meets at 2: four rows below the middle. */
static void a_triangle_across_the_near_plane_is_cut_there(void **state)
{
    (void)state;
    static const float corners[] = { -1e6f, -1, 1e5f, 1e6f, -1, 1e5f, 0, -1, -9e5f };
    static const uint32_t indices[] = { 0, 1, 2 };
    MeshPicture picture = make(corners, indices, 1, 2, 8, 1);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            assert_int_equal(picture.covered[y * WIDTH + x], y >= 8 && y < 12 ? 64 : 0);
    /* the third corner's share is how far a place is on the way from z = 1e5 to -9e5 */
    double expected = 0;
    for (int i = 0; i < 8; i++)
        expected += (1e5 + FOCAL / (2 + (i + 0.5) / 8)) / 1e6 / 8;
    assert_true(fabs(picture.color[3 * (10 * WIDTH + 12) + 2] - expected) < 1e-12);
    mesh_picture_free(&picture);
}

static void nothing_is_behind_the_eye(void **state)
{
    (void)state;
    static const float corners[] = { -9, -9, 5, 9, -9, 5, 0, 9, 5 };
    static const uint32_t indices[] = { 0, 1, 2 };
    MeshPicture picture = make(corners, indices, 1, 0.1, 2, 1);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        assert_int_equal(picture.covered[i], 0);
    mesh_picture_free(&picture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_sample_is_what_a_ray_meets_first),
        cmocka_unit_test(threads_change_no_bit),
        cmocka_unit_test(a_rectangle_covers_its_area),
        cmocka_unit_test(a_triangle_across_the_near_plane_is_cut_there),
        cmocka_unit_test(nothing_is_behind_the_eye),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
