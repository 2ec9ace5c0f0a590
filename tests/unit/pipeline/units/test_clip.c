/* Clipping: what is left, that it is inside, that shared edges are cut alike. */
#include "pipeline/units/clip.h"
#include "pipeline/units/viewport.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

static GpGuardBand band_of(uint32_t width, uint32_t height)
{
    GpViewport v = gp_viewport_resolve(&(GpViewport){ 0 }, width, height);
    return gp_guard_band(&v);
}

static GpVertex vertex_at(float x, float y, float z, float w)
{
    return (GpVertex){ .clip = { x, y, z, w }, .varying = { x, y, z, w } };
}

static GpClipPolygon clip(const GpGuardBand *band, const GpVertex v[3], uint64_t flat)
{
    GpClipPolygon polygon;
    gp_clip_triangle(band, (const GpVertex *const[3]){ &v[0], &v[1], &v[2] },
                     &(GpClipVaryings){ .components = 4, .flat = flat }, &polygon);
    return polygon;
}

static void r03_triangles_inside_the_guard_band_are_not_cut(void **state)
{
    (void)state;
    GpGuardBand band = band_of(1024, 1024);
    GpVertex v[3] = { vertex_at(-60, 0, 0.5f, 1), vertex_at(60, 0, 0.5f, 1),
                      vertex_at(0, 60, 0.5f, 1) };
    GpClipPolygon polygon = clip(&band, v, 0);
    assert_int_equal(polygon.corners, 3);
    assert_false(polygon.cut);
    assert_memory_equal(polygon.corner, v, sizeof v);
}

static void r03_nothing_that_is_left_leaves_the_fixed_point_range(void **state)
{
    (void)state;
    Random random = { 3 };
    for (int i = 0; i < 30000; i++) {
        uint32_t size = 1u << random_int(&random, 0, 13);
        GpViewport viewport = gp_viewport_resolve(&(GpViewport){ 0 }, size, size);
        GpGuardBand band = gp_guard_band(&viewport);
        GpVertex v[3];
        for (int k = 0; k < 3; k++) {
            float reach = powf(10, random_float(&random, -1, 7));
            v[k] = vertex_at(random_float(&random, -reach, reach),
                             random_float(&random, -reach, reach), random_float(&random, -2, 3),
                             random_float(&random, -2, 3));
        }
        GpClipPolygon polygon = clip(&band, v, 0);
        for (int k = 0; k < polygon.corners; k++) {
            GpScreenVertex s;
            assert_true(gp_viewport_position(&viewport, polygon.corner[k].clip, &s));
            assert_true(s.z >= -1e-5f && s.z <= 1 + 1e-5f);
        }
    }
}

static void near_and_far_planes_cut_where_z_is_0_and_w(void **state)
{
    (void)state;
    GpGuardBand band = band_of(256, 256);
    GpVertex near_cut[3] = { vertex_at(0, 0, -1, 1), vertex_at(1, 0, 1, 2), vertex_at(0, 1, 1, 2) };
    GpClipPolygon polygon = clip(&band, near_cut, 0);
    assert_int_equal(polygon.corners, 4);
    assert_int_equal(polygon.planes, 1u << GP_CLIP_NEAR);
    int on_plane = 0;
    for (int i = 0; i < 4; i++)
        on_plane += polygon.corner[i].clip[2] == 0;
    assert_int_equal(on_plane, 2);
    GpVertex gone[3] = { vertex_at(0, 0, 2, 1), vertex_at(1, 0, 3, 2), vertex_at(0, 1, 9, 8) };
    assert_int_equal(clip(&band, gone, 0).corners, 0);
}

static void r10_not_a_number_discards_the_triangle(void **state)
{
    (void)state;
    GpGuardBand band = band_of(64, 64);
    for (int corner = 0; corner < 3; corner++)
        for (int c = 0; c < 4; c++) {
            GpVertex v[3] = { vertex_at(0, 0, 0.5f, 1), vertex_at(1, 0, 0.5f, 1),
                              vertex_at(0, 1, 0.5f, 1) };
            assert_int_equal(clip(&band, v, 0).corners, 3);
            v[corner].clip[c] = NAN;
            assert_int_equal(clip(&band, v, 0).corners, 0);
        }
}

/* A part of a picture that is larger than a surface: the band ends where the picture does. */
static void r03_a_viewport_at_the_end_of_a_large_picture_is_reached(void **state)
{
    (void)state;
    const GpViewport part = gp_viewport_resolve(
        &(GpViewport){ .x = 16384, .y = 100, .width = 16384, .height = 28 }, 32768, 128);
    const GpGuardBand band = gp_guard_band(&part);
    assert_true(band.left < -1 && band.right > 1 && band.bottom < -1 && band.top > 1);
    GpScreenVertex s;
    assert_true(gp_viewport_position(&part, (const float[4]){ 1, 0, 0.5f, 1 }, &s));
    assert_int_equal(s.x, 32768 * 256);
}

static void r10_only_positive_w_survives(void **state)
{
    (void)state;
    GpGuardBand band = band_of(64, 64);
    GpVertex zero[3] = { vertex_at(0, 0, 0, 0), vertex_at(1, 0, 0, 0), vertex_at(0, 1, 0, 0) };
    assert_int_equal(clip(&band, zero, 0).corners, 0);
    Random random = { 10 };
    for (int i = 0; i < 20000; i++) {
        GpVertex v[3];
        for (int k = 0; k < 3; k++)
            v[k] = vertex_at(random_float(&random, -3, 3), random_float(&random, -3, 3),
                             random_float(&random, -3, 3), random_float(&random, -3, 3));
        GpClipPolygon polygon = clip(&band, v, 0);
        for (int k = 0; k < polygon.corners; k++)
            assert_true(polygon.corner[k].clip[3] > 0);
    }
}

static void infinite_positions_leave_nothing_or_finite_corners(void **state)
{
    (void)state;
    GpGuardBand band = band_of(64, 64);
    for (int c = 0; c < 4; c++)
        for (int sign = -1; sign <= 1; sign += 2) {
            GpVertex v[3] = { vertex_at(0, 0, 0.5f, 1), vertex_at(1, 0, 0.5f, 1),
                              vertex_at(0, 1, 0.5f, 1) };
            v[1].clip[c] = (float)sign * INFINITY;
            GpClipPolygon polygon = clip(&band, v, 0);
            for (int k = 0; k < polygon.corners; k++)
                assert_true(polygon.corner[k].clip[3] > 0);
        }
}

/* Two triangles on the two sides of an edge, in both directions, get the same new corners. */
/* Corners of most different sizes: rounding bends the triangle, which has no width to speak of, so
 * that planes cut it in four places, and it would have more corners than there is room for. */
static void what_rounding_bends_too_far_leaves_nothing(void **state)
{
    (void)state;
    const GpGuardBand band = band_of(512, 512);
    const GpVertex v[3] = {
        vertex_at(0x1.9da5fcp-24f, -0x1.ee8888p-24f, 0x1.f3690ep-32f, 0x1.f3690ep-31f),
        vertex_at(0x1.82f986p-18f, -0.0f, -0x1.1f657ep-26f, -0x1.80b872p-25f),
        vertex_at(-0x1.be635ep40f, -0x1.db870ep-46f, 0x1.22e936p42f, -0x1.f83212p46f),
    };
    for (int first = 0; first < 3; first++) {
        const GpVertex turned[3] = { v[first], v[(first + 1) % 3], v[(first + 2) % 3] };
        const GpClipPolygon polygon = clip(&band, turned, 0);
        assert_in_range(polygon.corners, 0, GP_MAX_CLIPPED);
        assert_true(polygon.cut);
    }
    assert_int_equal(clip(&band, v, 0).corners, 0);
}

static void shared_edges_are_cut_at_the_same_point(void **state)
{
    (void)state;
    GpGuardBand band = band_of(640, 480);
    Random random = { 11 };
    int compared = 0;
    for (int i = 0; i < 5000; i++) {
        GpVertex a = vertex_at(random_float(&random, -9, 9), random_float(&random, -9, 9), -1,
                               random_float(&random, 0.1f, 1));
        GpVertex b = vertex_at(random_float(&random, -9, 9), random_float(&random, -9, 9), 0.5f,
                               random_float(&random, 1, 4));
        GpVertex c = vertex_at(0, 9, -2, 1), d = vertex_at(0, -9, -3, 1);
        GpClipPolygon one = clip(&band, (GpVertex[3]){ a, b, c }, 0);
        GpClipPolygon two = clip(&band, (GpVertex[3]){ b, a, d }, 0);
        int matches = 0;
        for (int k = 0; k < one.corners; k++)
            for (int m = 0; m < two.corners; m++)
                matches += memcmp(&one.corner[k], &two.corner[m], sizeof one.corner[k]) == 0;
        assert_int_equal(matches, 2); /* b itself, and the cut of the edge ab */
        compared++;
    }
    assert_int_equal(compared, 5000);
}

static void flat_values_survive_the_loss_of_the_first_corner(void **state)
{
    (void)state;
    GpGuardBand band = band_of(256, 256);
    GpVertex v[3] = { vertex_at(0, 0, -1, 1), vertex_at(1, 0, 1, 2), vertex_at(0, 1, 1, 2) };
    for (int k = 0; k < 3; k++)
        v[k].varying[3] = (float)(40 + k);
    GpClipPolygon polygon = clip(&band, v, 1u << 3);
    assert_int_equal(polygon.corners, 4);
    for (int k = 0; k < polygon.corners; k++)
        assert_true(polygon.corner[k].varying[3] == 40);
}

static void varyings_stay_affine_in_clip_space(void **state)
{
    (void)state;
    GpGuardBand band = band_of(256, 256);
    Random random = { 12 };
    for (int i = 0; i < 5000; i++) {
        GpVertex v[3];
        for (int k = 0; k < 3; k++)
            v[k] = vertex_at(random_float(&random, -2, 2), random_float(&random, -2, 2),
                             random_float(&random, -1, 2), random_float(&random, 0.5f, 2));
        GpClipPolygon polygon = clip(&band, v, 0);
        for (int k = 0; k < polygon.corners; k++)
            /* the varyings were the position itself; the position is also settled onto the planes,
             * by rounding errors */
            for (int c = 0; c < 4; c++)
                assert_true(fabsf(polygon.corner[k].varying[c] - polygon.corner[k].clip[c]) <=
                            0x1p-20f);
    }
}

/* z/w is linear on the screen: a new corner has that of its own place, whatever the planes that
 * cut, and where the end outside is behind the eye too. */
static void what_is_linear_on_the_screen_stays_so_on_cut_edges(void **state)
{
    (void)state;
    GpGuardBand band = band_of(256, 256);
    Random random = { 13 };
    unsigned planes = 0;
    int behind = 0;
    for (int i = 0; i < 20000; i++) {
        GpVertex v[3];
        for (int k = 0; k < 3; k++) {
            float w = random_float(&random, 0.25f, 4) * (random_int(&random, 0, 9) < 3 ? -1 : 1);
            float x = random_int(&random, 0, 4) == 0 ? 1000 : 2;
            v[k] = vertex_at(random_float(&random, -x, x), random_float(&random, -x, x),
                             random_float(&random, -1, 3), w);
            v[k].varying[1] = v[k].clip[2] / w;
            behind += w < 0;
        }
        GpClipPolygon polygon;
        gp_clip_triangle(&band, (const GpVertex *const[3]){ &v[0], &v[1], &v[2] },
                         &(GpClipVaryings){ .components = 4, .screen = 1 << 1 }, &polygon);
        planes |= polygon.corners ? polygon.planes : 0;
        for (int k = 0; k < polygon.corners; k++) {
            const float *at = polygon.corner[k].clip;
            /* the vertices' own roundings, for w up to 4 there */
            const float rounding = 1e-6f * (1 + 4 / at[3]);
            assert_true(fabsf(polygon.corner[k].varying[1] - at[2] / at[3]) < rounding);
        }
    }
    assert_int_equal(planes, (1u << GP_CLIP_PLANES) - 1);
    assert_true(behind > 1000);
}

static void points_are_kept_by_their_vertex_alone(void **state)
{
    (void)state;
    GpVertex inside = vertex_at(5, -7, 0.5f, 1), before = vertex_at(0, 0, -0.1f, 1);
    GpVertex behind = vertex_at(0, 0, 1.1f, 1), no_number = vertex_at(NAN, 0, 0.5f, 1);
    assert_true(gp_clip_point(&inside)); /* outside in x and y: still drawn where it reaches in */
    assert_false(gp_clip_point(&before));
    assert_false(gp_clip_point(&behind));
    assert_false(gp_clip_point(&no_number));
    GpVertex at_eye = vertex_at(0, 0, 0, 0), at_end = vertex_at(0, 0, INFINITY, INFINITY);
    assert_false(gp_clip_point(&at_eye));
    assert_true(gp_clip_point(&at_end));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r03_triangles_inside_the_guard_band_are_not_cut),
        cmocka_unit_test(r03_nothing_that_is_left_leaves_the_fixed_point_range),
        cmocka_unit_test(near_and_far_planes_cut_where_z_is_0_and_w),
        cmocka_unit_test(r10_not_a_number_discards_the_triangle),
        cmocka_unit_test(r03_a_viewport_at_the_end_of_a_large_picture_is_reached),
        cmocka_unit_test(r10_only_positive_w_survives),
        cmocka_unit_test(infinite_positions_leave_nothing_or_finite_corners),
        cmocka_unit_test(what_rounding_bends_too_far_leaves_nothing),
        cmocka_unit_test(shared_edges_are_cut_at_the_same_point),
        cmocka_unit_test(flat_values_survive_the_loss_of_the_first_corner),
        cmocka_unit_test(varyings_stay_affine_in_clip_space),
        cmocka_unit_test(what_is_linear_on_the_screen_stays_so_on_cut_edges),
        cmocka_unit_test(points_are_kept_by_their_vertex_alone),
    };
    return cmocka_run_group_tests_name("clip", tests, NULL, NULL);
}
