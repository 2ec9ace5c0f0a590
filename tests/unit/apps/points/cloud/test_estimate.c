/* Normals look outwards all over, discs close the surface, and areas add up to its own. */
#define POOL_THREADS 3
#include "apps/points/cloud/cells.h"
#include "apps/points/cloud/planes.h"
#include "tests/support/groups/pool.h"
#include "tests/support/meshes/named_mesh.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>
#include <string.h>

/* Points of a surface whose normals are known. */
typedef struct Cloud {
    uint32_t count;
    float *positions, *normals; /* [3 * count] */
    double area;
} Cloud;

static Cloud cloud_alloc(uint32_t count, double area)
{
    return (Cloud){ .count = count,
                    .positions = gp_alloc(3 * (size_t)count, sizeof(float)),
                    .normals = gp_alloc(3 * (size_t)count, sizeof(float)),
                    .area = area };
}

static void cloud_free(Cloud *cloud)
{
    gp_free(cloud->positions);
    gp_free(cloud->normals);
}

/* A spiral over a ball of that radius, evenly. */
static Cloud ball(uint32_t count, double radius)
{
    Cloud cloud = cloud_alloc(count, 4 * M_PI * radius * radius);
    for (uint32_t i = 0; i < count; i++) {
        const double y = 1 - (2 * i + 1.0) / count, across = sqrt(1 - y * y);
        const double turn = i * 2.399963229728653;
        const double at[3] = { across * cos(turn), y, across * sin(turn) };
        for (size_t k = 0; k < 3; k++) {
            cloud.normals[3 * i + k] = (float)at[k];
            cloud.positions[3 * i + k] = (float)(at[k] * radius);
        }
    }
    return cloud;
}

/* Places of a mesh's vertices, each once, and their normals. */
static Cloud vertices_of(const char *name)
{
    GpMesh mesh = named_mesh(name);
    Cloud cloud = cloud_alloc(mesh.vertex_count, 0);
    cloud.count = 0;
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        bool is_new = true;
        for (size_t i = 0; i < cloud.count && is_new; i++)
            is_new = memcmp(cloud.positions + 3 * i, mesh.positions + 3 * v, 12) != 0;
        if (!is_new)
            continue;
        memcpy(cloud.positions + 3 * (size_t)cloud.count, mesh.positions + 3 * v, 12);
        memcpy(cloud.normals + 3 * (size_t)cloud.count, mesh.normals + 3 * v, 12);
        cloud.count++;
    }
    gp_mesh_free(&mesh);
    return cloud;
}

static NeighbourTree tree_of(const Cloud *cloud)
{
    NeighbourTree tree;
    assert_int_equal(neighbour_tree_build(cloud->positions, cloud->count, pool, &tree), GP_OK);
    return tree;
}

/* Cosine of the largest angle to the true normals. */
static double worst_normal(const Cloud *cloud, const float *normals)
{
    double worst = 1;
    for (size_t i = 0; i < cloud->count; i++) {
        double dot = 0;
        for (size_t k = 0; k < 3; k++)
            dot += (double)normals[3 * i + k] * (double)cloud->normals[3 * i + k];
        worst = dot < worst ? dot : worst;
    }
    return worst;
}

static PlaneFacts estimate(const Cloud *cloud, float *normals)
{
    PlaneFacts facts;
    NeighbourTree tree = tree_of(cloud);
    assert_int_equal(planes_estimate(&tree, pool, normals, &facts), GP_OK);
    neighbour_tree_free(&tree);
    return facts;
}

static void normals_of_closed_surfaces_look_outwards_everywhere(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double cosine;
    } cases[] = { { NULL, 0.9995 }, { "builtin:torus", 0.99 }, { "builtin:knot", 0.97 } };
    for (size_t c = 0; c < GP_COUNT(cases); c++) {
        Cloud cloud = cases[c].name ? vertices_of(cases[c].name) : ball(5000, 3);
        float *normals = gp_alloc(3 * (size_t)cloud.count, sizeof *normals);
        const PlaneFacts facts = estimate(&cloud, normals);
        const double worst = worst_normal(&cloud, normals);
        if (!(worst > cases[c].cosine))
            fail_msg("%s: a normal is off by a cosine of %g",
                     cases[c].name ? cases[c].name : "ball", worst);
        assert_int_equal(facts.components, 1);
        assert_int_equal(facts.estimated, cloud.count);
        assert_int_equal(facts.undefined, 0);
        gp_free(normals);
        cloud_free(&cloud);
    }
}

static void each_component_is_turned_by_itself(void **state)
{
    (void)state;
    Cloud one = ball(700, 1), two = cloud_alloc(1400, 0);
    for (size_t i = 0; i < 3 * (size_t)one.count; i++) {
        two.positions[i] = one.positions[i] - 100;
        two.positions[2100 + i] = one.positions[i] * 0.1F + 100;
        two.normals[i] = two.normals[2100 + i] = one.normals[i];
    }
    float *normals = gp_alloc(3 * (size_t)two.count, sizeof *normals);
    assert_int_equal(estimate(&two, normals).components, 2);
    assert_true(worst_normal(&two, normals) > 0.99);
    gp_free(normals);
    cloud_free(&one);
    cloud_free(&two);
}

/* A ball seen from outside and from inside. */
static void given_normals_stay_and_turn_the_others(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        Cloud cloud = ball(2000, 1);
        float *normals = gp_alloc(3 * (size_t)cloud.count, sizeof *normals);
        uint32_t given = 0;
        for (size_t i = 0; i < 3 * (size_t)cloud.count; i++)
            cloud.normals[i] *= (float)side;
        for (size_t i = 0; i < cloud.count; i += 100, given++) {
            for (size_t k = 0; k < 3; k++)
                normals[3 * i + k] = 7 * cloud.normals[3 * i + k];
        }
        const PlaneFacts facts = estimate(&cloud, normals);
        assert_int_equal(facts.estimated, cloud.count - given);
        assert_true(worst_normal(&cloud, normals) > 0.99);
        for (size_t i = 0; i < 3 * (size_t)cloud.count; i += 300)
            assert_true(fabsf(normals[i] - cloud.normals[i]) < 1e-6F);
        gp_free(normals);
        cloud_free(&cloud);
    }
}

static void flat_and_thin_clouds_have_stated_normals(void **state)
{
    (void)state;
    static const struct {
        float x[3], y[3], normal[3]; /* steps of a grid */
        uint32_t undefined;
    } cases[] = {
        { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, 0 },
        { { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 }, 0 },
        { { 0, 0, 1 }, { 0, 1, 0 }, { 1, 0, 0 }, 0 },
        { { 1, 0, 0 }, { 10, 0, 0 }, { 0, 0, 1 }, 100 },
        { { 0, 0, 1 }, { 0, 0, 10 }, { 0, 1, 0 }, 100 },
    };
    for (size_t c = 0; c < GP_COUNT(cases); c++) {
        Cloud cloud = cloud_alloc(100, 0);
        float *normals = gp_alloc(300, sizeof *normals);
        for (size_t i = 0; i < 300; i++) {
            const size_t point = i / 3, k = i % 3;
            cloud.positions[i] =
                50 + (float)(point % 10) * cases[c].x[k] + (float)(point / 10) * cases[c].y[k];
            cloud.normals[i] = cases[c].normal[k];
        }
        assert_int_equal(estimate(&cloud, normals).undefined, cases[c].undefined);
        if (!(worst_normal(&cloud, normals) > 0.999999))
            fail_msg("case %zu: %g %g %g", c, (double)normals[0], (double)normals[1],
                     (double)normals[2]);
        gp_free(normals);
        cloud_free(&cloud);
    }
}

/* --- radii and areas -------------------------------------------------------------------------- */

typedef struct Discs {
    NeighbourTree tree;
    float *radii, *areas;
    CellFacts facts;
} Discs;

static Discs discs_of(const Cloud *cloud)
{
    Discs discs = { .tree = tree_of(cloud),
                    .radii = gp_alloc(cloud->count, sizeof(float)),
                    .areas = gp_alloc(cloud->count, sizeof(float)) };
    assert_int_equal(
        cells_measure(&discs.tree, cloud->normals, pool, discs.radii, discs.areas, &discs.facts),
        GP_OK);
    return discs;
}

static void discs_free(Discs *discs)
{
    neighbour_tree_free(&discs->tree);
    gp_free(discs->radii);
    gp_free(discs->areas);
}

static void assert_area(const char *what, const Cloud *cloud, const Discs *discs, double tolerance)
{
    double sum = 0;
    for (size_t i = 0; i < cloud->count; i++)
        sum += (double)discs->areas[i];
    if (!(fabs(sum / cloud->area - 1) < tolerance))
        fail_msg("%s: points stand for %g, the area is %g", what, sum, cloud->area);
}

/* The least over all discs of distance / radius; at most 1 where one holds the place. */
static double covered(const Cloud *cloud, const Discs *discs, const double place[3])
{
    double least = HUGE_VAL;
    for (size_t i = 0; i < cloud->count; i++) {
        double distance2 = 0;
        for (size_t k = 0; k < 3; k++) {
            const double d = (double)cloud->positions[3 * i + k] - place[k];
            distance2 += d * d;
        }
        least = fmin(least, sqrt(distance2) / (double)discs->radii[i]);
    }
    return least;
}

static void discs_close_a_ball_and_areas_add_up(void **state)
{
    (void)state;
    Cloud cloud = ball(3000, 2);
    Discs discs = discs_of(&cloud);
    Random random = { .state = 5 };
    double widest = 0;
    for (int i = 0; i < 3000; i++) {
        double place[3], length = 0;
        for (int k = 0; k < 3; k++)
            place[k] = (double)random_float(&random, -1, 1);
        length = sqrt(place[0] * place[0] + place[1] * place[1] + place[2] * place[2]);
        for (int k = 0; k < 3; k++)
            place[k] *= 2 / length;
        widest = fmax(widest, covered(&cloud, &discs, place));
    }
    if (!(widest < 1.01 && widest > 0.9))
        fail_msg("the widest gap between discs is at %g of their radius", widest);
    assert_area("ball", &cloud, &discs, 0.01);
    assert_int_equal(discs.facts.boundary, 0);
    const double spacing = sqrt(cloud.area / cloud.count);
    assert_true(discs.facts.nearest_sum / cloud.count > 0.8 * spacing);
    assert_true(discs.facts.nearest_most < 1.2 * spacing);
    discs_free(&discs);
    cloud_free(&cloud);
}

/* Random points of a square, and of one with a hole: white noise, the worst that comes. It has
 * voids of its own, beyond the sixteenth neighbour of points beside them, which may stay open. */
static void discs_close_white_noise_and_find_its_boundary(void **state)
{
    (void)state;
    enum { POINTS = 4000 };
    int gaps = 0;
    for (int hole = 0; hole < 2; hole++) {
        Random random = { .state = 9 };
        Cloud cloud = cloud_alloc(POINTS, hole ? 1 - 0.2 * 0.2 : 1);
        for (uint32_t i = 0; i < POINTS; i++) {
            float *place = cloud.positions + 3 * (size_t)i;
            do {
                place[0] = random_float(&random, 0, 1);
                place[1] = random_float(&random, 0, 1);
            } while (hole && fabsf(place[0] - 0.5F) < 0.1F && fabsf(place[1] - 0.5F) < 0.1F);
            cloud.normals[3 * i + 2] = 1;
        }
        Discs discs = discs_of(&cloud);
        for (int i = 0; i < 2500; i++) {
            const double place[3] = { 0.05 + 0.9 * (i % 50) / 49.0, 0.05 + 0.9 * (i / 50) / 49.0 };
            const bool in_hole = fabs(place[0] - 0.5) < 0.15 && fabs(place[1] - 0.5) < 0.15;
            const double nearest = covered(&cloud, &discs, place);
            gaps += !(hole && in_hole) && !(nearest < 1.0001);
        }
        const double in_the_hole[3] = { 0.5, 0.5 };
        assert_true(!hole || covered(&cloud, &discs, in_the_hole) > 1);
        assert_area("square", &cloud, &discs, 0.02);
        /* About the root of 4000 along each side; more around the hole. */
        assert_true(discs.facts.boundary > 150 && discs.facts.boundary < 600);
        discs_free(&discs);
        cloud_free(&cloud);
    }
    if (gaps > 5)
        fail_msg("%d of 5000 places are in no disc", gaps);
}

static void a_point_far_from_all_others_stays_small(void **state)
{
    (void)state;
    Cloud cloud = cloud_alloc(402, 400);
    for (uint32_t i = 0; i < cloud.count; i++) {
        cloud.positions[3 * i] = (float)(i < 400 ? i % 20 : 500 + i);
        cloud.positions[3 * i + 1] = (float)(i < 400 ? i / 20 : 7);
        cloud.normals[3 * i + 2] = 1;
    }
    Discs discs = discs_of(&cloud);
    for (uint32_t i = 0; i < cloud.count; i++)
        assert_true(discs.radii[i] > 0.4F && discs.radii[i] <= 1.5F);
    assert_area("square", &cloud, &discs, 0.05);
    discs_free(&discs);
    cloud_free(&cloud);
}

/* Two sheets nearer to each other than their points are apart: each closes by itself. */
static void a_sheet_does_not_count_the_points_of_another(void **state)
{
    (void)state;
    enum { SIDE = 30 };
    Cloud cloud = cloud_alloc(2 * SIDE * SIDE, 2 * SIDE * SIDE);
    for (uint32_t i = 0; i < cloud.count; i++) {
        const uint32_t at = i / 2, sheet = i % 2;
        cloud.positions[3 * i] = (float)(at % SIDE) + (sheet ? 0.5F : 0);
        cloud.positions[3 * i + 1] = (float)(at / SIDE) + (sheet ? 0.5F : 0);
        cloud.positions[3 * i + 2] = sheet ? 0 : 0.1F;
        cloud.normals[3 * i + 2] = sheet ? -1 : 1;
    }
    Discs discs = discs_of(&cloud);
    const size_t middle = 2 * (SIDE / 2 * SIDE + SIDE / 2);
    for (size_t i = middle; i < middle + 2; i++) {
        assert_true(fabsf(discs.radii[i] - sqrtf(0.5F)) < 1e-5F);
        assert_true(fabsf(discs.areas[i] - 1) < 1e-5F);
    }
    discs_free(&discs);
    cloud_free(&cloud);
}

static void estimates_do_not_depend_on_the_threads(void **state)
{
    (void)state;
    GpPool *pools[2] = { pool, NULL };
    Cloud cloud = ball(6000, 1);
    float *normals[2], *radii[2], *areas[2];
    assert_int_equal(gp_pool_create(1, &pools[1], NULL), GP_OK);
    for (int p = 0; p < 2; p++) {
        PlaneFacts planes;
        CellFacts cells;
        NeighbourTree tree;
        normals[p] = gp_alloc(3 * (size_t)cloud.count, sizeof(float));
        radii[p] = gp_alloc(cloud.count, sizeof(float));
        areas[p] = gp_alloc(cloud.count, sizeof(float));
        assert_int_equal(neighbour_tree_build(cloud.positions, cloud.count, pools[p], &tree),
                         GP_OK);
        assert_int_equal(planes_estimate(&tree, pools[p], normals[p], &planes), GP_OK);
        assert_int_equal(cells_measure(&tree, normals[p], pools[p], radii[p], areas[p], &cells),
                         GP_OK);
        neighbour_tree_free(&tree);
    }
    assert_memory_equal(normals[0], normals[1], 3 * cloud.count * sizeof(float));
    assert_memory_equal(radii[0], radii[1], cloud.count * sizeof(float));
    assert_memory_equal(areas[0], areas[1], cloud.count * sizeof(float));
    for (int p = 0; p < 2; p++) {
        gp_free(normals[p]);
        gp_free(radii[p]);
        gp_free(areas[p]);
    }
    cloud_free(&cloud);
    gp_pool_destroy(&pools[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_of_closed_surfaces_look_outwards_everywhere),
        cmocka_unit_test(each_component_is_turned_by_itself),
        cmocka_unit_test(given_normals_stay_and_turn_the_others),
        cmocka_unit_test(flat_and_thin_clouds_have_stated_normals),
        cmocka_unit_test(discs_close_a_ball_and_areas_add_up),
        cmocka_unit_test(discs_close_white_noise_and_find_its_boundary),
        cmocka_unit_test(a_point_far_from_all_others_stays_small),
        cmocka_unit_test(a_sheet_does_not_count_the_points_of_another),
        cmocka_unit_test(estimates_do_not_depend_on_the_threads),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
