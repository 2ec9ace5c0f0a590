/* The truth of fragments against something plainer: each pixel's ray at each triangle, one by
 * one. */
#include "apps/truth/fragments.h"
#include "tests/support/groups/pool.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>
#include <string.h>

enum { TRIANGLES = 60, WIDTH = 40, HEIGHT = 30 };

typedef struct Soup {
    float positions[3 * TRIANGLES][3], colors[TRIANGLES][4];
    uint32_t indices[3 * TRIANGLES];
} Soup;

static void make_soup(uint64_t seed, Soup *soup)
{
    Random random = { seed };
    for (uint32_t i = 0; i < 3 * TRIANGLES; i++) {
        soup->indices[i] = i;
        for (int k = 0; k < 3; k++)
            soup->positions[i][k] = random_float(&random, -2, 2);
    }
    for (uint32_t i = 0; i < TRIANGLES; i++)
        for (int k = 0; k < 4; k++)
            soup->colors[i][k] = random_float(&random, 0, 0.9f);
}

/* Tetrahedra in cells of their own, closed, with their corners counter-clockwise seen from
 * outside. */
static void make_bodies(Soup *soup)
{
    static const int faces[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
    static const float shape[4][3] = {
        { 0, 0, 0.1f }, { 0.9f, 0.1f, 0 }, { 0.3f, 0.8f, 0.2f }, { 0.4f, 0.3f, 0.9f }
    };
    make_soup(7, soup);
    for (int i = 0; i < 3 * TRIANGLES; i++) {
        const int body = i / 12, corner = faces[i / 3 % 4][i % 3];
        const float cell[3] = { (float)(body % 3) - 1.5f, (float)(body / 3 % 2) - 1,
                                (float)(body / 6) - 1.5f };
        for (int k = 0; k < 3; k++)
            soup->positions[i][k] = cell[k] + shape[corner][k];
    }
}

static FragmentTruthScene scene_of(const Soup *soup, const Camera *camera)
{
    return (FragmentTruthScene){ .positions = soup->positions,
                                 .indices = soup->indices,
                                 .triangle_count = TRIANGLES,
                                 .colors = soup->colors,
                                 .camera = *camera,
                                 .width = WIDTH,
                                 .height = HEIGHT };
}

/* --- plainly ---------------------------------------------------------------------------------- */

typedef struct Hit {
    double along, length; /* along the view; along the ray */
    double cosine;        /* of the ray and the outer normal: below 0, it faces the eye */
    uint32_t triangle;
} Hit;

/* Solves begin + t way = corner0 + u edge0 + v edge1 by Cramer's rule. */
static bool meets(const Soup *soup, uint32_t triangle, const double begin[3], const double way[3],
                  Hit *hit)
{
    double corner[3][3], edge[2][3], from[3], normal[3], aside[3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            corner[i][k] = (double)soup->positions[3 * triangle + (uint32_t)i][k];
    vector_subtract(corner[1], corner[0], edge[0]);
    vector_subtract(corner[2], corner[0], edge[1]);
    vector_subtract(begin, corner[0], from);
    vector_cross(edge[0], edge[1], normal);
    vector_cross(from, way, aside);
    const double d = -vector_dot(way, normal);
    const double u = vector_dot(aside, edge[1]) / d, v = -vector_dot(aside, edge[0]) / d;
    const double size = sqrt(vector_dot(way, way));
    hit->length = vector_dot(from, normal) / d * size;
    hit->cosine = vector_dot(way, normal) / size / sqrt(vector_dot(normal, normal));
    hit->triangle = triangle;
    return u >= 0 && v >= 0 && u + v <= 1;
}

static void sort(Hit *hits, int count)
{
    for (int i = 1; i < count; i++)
        for (int k = i; k > 0 && hits[k].along < hits[k - 1].along; k--) {
            const Hit kept = hits[k];
            hits[k] = hits[k - 1];
            hits[k - 1] = kept;
        }
}

/* Light is taken step by step between the surfaces, inside by so many as have been entered and not
 * left. */
static void put_together(const FragmentTruthScene *scene, const Hit *hits, int count, double slant,
                         double rgba[4])
{
    double left = 1, before = scene->begin * slant;
    int inside = 0;
    memset(rgba, 0, 4 * sizeof *rgba);
    for (int i = 0; i < count; i++) {
        const float *color = scene->colors[hits[i].triangle];
        double through = 1 - (double)color[3];
        if (scene->is_glass) {
            left *= exp(-scene->sigma * inside * (hits[i].length - before));
            through *= (1 - scene->reflected) * (1 - pow(1 - fabs(hits[i].cosine), 5));
            before = hits[i].length;
            inside += hits[i].cosine < 0 ? 1 : -1;
        }
        for (int k = 0; k < 3; k++)
            rgba[k] += left * (1 - through) * (double)color[k];
        left *= through;
    }
    rgba[3] = 1 - left;
}

static int see(const FragmentTruthScene *scene, const Soup *soup, uint32_t x, uint32_t y,
               double rgba[4])
{
    const Camera *camera = &scene->camera;
    const CameraAxes axes = camera_axes(camera, (double)WIDTH / HEIGHT);
    const double right = (2 * (x + 0.5) / WIDTH - 1) * axes.half_width,
                 up = (1 - 2 * (y + 0.5) / HEIGHT) * axes.half_height;
    const bool is_parallel = !(camera->fovy > 0);
    double begin[3], way[3];
    Hit hits[TRIANGLES];
    int count = 0;
    for (int k = 0; k < 3; k++) {
        const double across = right * axes.right[k] + up * axes.up[k];
        begin[k] = camera->eye[k] + (is_parallel ? across : 0);
        way[k] = axes.forward[k] + (is_parallel ? 0 : across);
    }
    const double slant = sqrt(vector_dot(way, way));
    for (uint32_t i = 0; i < TRIANGLES; i++) {
        Hit *hit = &hits[count];
        if (!meets(soup, i, begin, way, hit))
            continue;
        hit->along = hit->length / slant;
        count += hit->along >= camera->near && hit->along <= camera->far;
    }
    sort(hits, count);
    put_together(scene, hits, count, slant, rgba);
    return count;
}

static void compare(const FragmentTruthScene *scene, const Soup *soup)
{
    FragmentTruth truth;
    uint64_t fragments = 0;
    uint32_t layers = 0;
    assert_int_equal(fragment_truth_make(scene, pool, &truth), GP_OK);
    for (uint32_t y = 0; y < HEIGHT; y++)
        for (uint32_t x = 0; x < WIDTH; x++) {
            double rgba[4];
            const double *found = truth.rgba + 4 * (y * WIDTH + x);
            const uint32_t here = (uint32_t)see(scene, soup, x, y, rgba);
            fragments += here;
            layers = here > layers ? here : layers;
            for (int k = 0; k < 4; k++)
                if (fabs(rgba[k] - found[k]) > 1e-9 * fmax(1, fabs(rgba[k])))
                    fail_msg("(%u, %u) channel %d: %.12g, by rays %.12g", x, y, k, found[k],
                             rgba[k]);
        }
    assert_int_equal(truth.fragments, fragments);
    assert_int_equal(truth.layers, layers);
    assert_true(layers > 3);
    fragment_truth_free(&truth);
}

/* Some triangles are cut by the near plane, some are behind the eye. */
static const Camera cameras[] = {
    { .eye = { 0.5, 0.7, 7 }, .up = { 0, 1, 0 }, .fovy = 40, .near = 1, .far = 12 },
    { .eye = { 0.1, 0.2, 1 }, .up = { 0, 1, 0 }, .fovy = 70, .near = 0.4, .far = 3 },
    { .eye = { 1, 2, 3 }, .up = { 0, 1, 0 }, .height = 3, .near = 0.5, .far = 9 },
};

static void fragments_are_those_that_rays_meet(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 3; seed++)
        for (size_t i = 0; i < GP_COUNT(cameras); i++) {
            Soup soup;
            make_soup(seed, &soup);
            const FragmentTruthScene scene = scene_of(&soup, &cameras[i]);
            compare(&scene, &soup);
        }
}

/* What is said fragment by fragment is what light loses on its way between them. */
static void glass_takes_light_between_its_surfaces(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(cameras); i += 2) {
        Soup soup;
        make_bodies(&soup);
        FragmentTruthScene scene = scene_of(&soup, &cameras[i]);
        scene.is_glass = true;
        scene.sigma = 0.3;
        scene.reflected = i ? 0 : 0.04;
        scene.begin = cameras[i].near;
        compare(&scene, &soup);
    }
}

/* --- edges and ties --------------------------------------------------------------------------- */

static FragmentTruth truth_of(const FragmentTruthScene *scene)
{
    FragmentTruth truth;
    assert_int_equal(fragment_truth_make(scene, pool, &truth), GP_OK);
    return truth;
}

/* A square of two triangles over the whole picture of 8 x 8, whose diagonal goes through
 * centres. */
static void a_centre_on_a_shared_edge_has_one_fragment_and_is_told(void **state)
{
    (void)state;
    static const float positions[][3] = { { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 } };
    static const uint32_t indices[] = { 0, 1, 2, 0, 2, 3 };
    static const float colors[][4] = { { 1, 0, 0, 0.5f }, { 0, 1, 0, 0.5f } };
    const FragmentTruthScene scene = {
        .positions = positions,
        .indices = indices,
        .triangle_count = 2,
        .colors = colors,
        .camera = { .eye = { 0, 0, 2 }, .up = { 0, 1, 0 }, .height = 2, .near = 1, .far = 3 },
        .width = 8,
        .height = 8
    };
    FragmentTruth truth = truth_of(&scene);
    assert_int_equal(truth.fragments, 64);
    assert_int_equal(truth.layers, 1);
    for (uint32_t i = 0; i < 64; i++)
        assert_int_equal(truth.is_edge[i], i % 8 == 7 - i / 8);
    fragment_truth_free(&truth);
}

/* Triangles over a picture of 8 x 8 that is seen from along z; their planes rise to the right by
 * `slopes`, and are at `height` so many pixels right of the centres of the fourth column. */
static FragmentTruth truth_of_slopes(const double slopes[2], uint32_t triangles, double height,
                                     double aside)
{
    static const float colors[2][4] = { { 1, 0, 0, 0.5f }, { 0, 1, 0, 0.5f } };
    static const float corners[3][2] = { { -9, -9 }, { 9, -9 }, { 0, 9 } };
    static const uint32_t indices[] = { 0, 1, 2, 5, 4, 3 };
    float positions[6][3];
    for (int i = 0; i < 6; i++) {
        memcpy(positions[i], corners[i % 3], sizeof corners[0]);
        positions[i][2] =
            (float)(height + slopes[i / 3] * ((double)corners[i % 3][0] + 0.125 - aside / 4));
    }
    const FragmentTruthScene scene = {
        .positions = (const float(*)[3])positions,
        .indices = indices,
        .triangle_count = triangles,
        .colors = colors,
        .camera = { .eye = { 0, 0, 2 }, .up = { 0, 1, 0 }, .height = 2, .near = 1, .far = 3 },
        .width = 8,
        .height = 8
    };
    return truth_of(&scene);
}

static void expect_in_fourth_column(const uint8_t *marks, bool there)
{
    for (uint32_t i = 0; i < 64; i++)
        assert_int_equal(marks[i], there && i % 8 == 3);
}

/* The near plane cuts at 1, the far plane at -1. */
static void where_a_triangle_is_cut_it_has_an_edge(void **state)
{
    (void)state;
    for (int plane = -1; plane <= 1; plane += 2)
        for (int near = 0; near < 2; near++) {
            const double aside = near ? -0.9 / 256 : 1.1 / 256;
            FragmentTruth truth = truth_of_slopes((const double[]){ 0.4, 0 }, 1, plane, aside);
            assert_int_equal(truth.fragments, !near ? 32 : plane > 0 ? 24 : 40);
            expect_in_fourth_column(truth.is_edge, near);
            fragment_truth_free(&truth);
        }
}

/* Corners move by half of 1/256 pixel, of either triangle. */
static void where_triangles_cross_is_told_but_not_of_twins(void **state)
{
    (void)state;
    static const double crossing[2] = { 0.4, -0.4 }, steep[2] = { 0.8, 0.1 },
                        twins[2] = { 0.4, 0.4 };
    static const struct {
        const double *slopes;
        double aside;
        bool is_told;
    } rows[] = { { crossing, 0.4 / 256, true },
                 { crossing, -0.6 / 256, false },
                 { steep, 0.6 / 256, true },
                 { steep, 0.7 / 256, false },
                 { twins, 0, false } };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        FragmentTruth truth = truth_of_slopes(rows[i].slopes, 2, 0, rows[i].aside);
        assert_int_equal(truth.fragments, 128);
        expect_in_fourth_column(truth.is_crossing, rows[i].is_told);
        fragment_truth_free(&truth);
    }
}

static void fragments_of_one_depth_go_by_the_order_of_triangles(void **state)
{
    (void)state;
    static const float positions[][3] = { { -9, -9, 0 }, { 9, -9, 0 }, { 0, 9, 0 } };
    static const float colors[][4] = { { 1, 0, 0, 0.5f }, { 0, 1, 0, 0.5f } };
    for (uint32_t first = 0; first < 2; first++) {
        const uint32_t indices[] = { 0, 1, 2, 2, 1, 0 };
        const float turned[2][4] = { { colors[first][0], colors[first][1], 0, 0.5f },
                                     { colors[!first][0], colors[!first][1], 0, 0.5f } };
        const FragmentTruthScene scene = {
            .positions = positions,
            .indices = indices,
            .triangle_count = 2,
            .colors = turned,
            .camera = { .eye = { 0, 0, 2 }, .up = { 0, 1, 0 }, .fovy = 30, .near = 1, .far = 3 },
            .width = 1,
            .height = 1
        };
        FragmentTruth truth = truth_of(&scene);
        assert_int_equal(truth.layers, 2);
        assert_true(truth.rgba[first] == 0.5 && truth.rgba[!first] == 0.25);
        fragment_truth_free(&truth);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fragments_are_those_that_rays_meet),
        cmocka_unit_test(glass_takes_light_between_its_surfaces),
        cmocka_unit_test(a_centre_on_a_shared_edge_has_one_fragment_and_is_told),
        cmocka_unit_test(where_a_triangle_is_cut_it_has_an_edge),
        cmocka_unit_test(where_triangles_cross_is_told_but_not_of_twins),
        cmocka_unit_test(fragments_of_one_depth_go_by_the_order_of_triangles),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
