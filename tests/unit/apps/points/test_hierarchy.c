/* Cuts through a model's hierarchy: everything is shown once, at the size that was asked for. */
#include "apps/points/hierarchy.h"

#include "tests/support/surfel_shapes.h"
#include "tests/support/unit.h"

#include <string.h>

static GpPool *pool;
static Surfels surfels;
static Patches patches;
static PointView view;

enum { SIDE = 256 };
static const double details[] = { 1, 4, 10, 40 }; /* leaves are 2 to 3 pixels wide */

static int set_up(void **state)
{
    static const PatchLimits limits = { .most_leaves = 1024, .least_leaves = 64 };
    const Camera camera = {
        .eye = { 0, 1, 4 }, .up = { 0, 1, 0 }, .fovy = 60, .near = 0.1, .far = 20
    };
    (void)state;
    view = point_view(&camera, SIDE, SIDE, 1, 0);
    if (gp_pool_create(2, &pool, NULL))
        return -1;
    shape_sphere(&surfels, 20000);
    return patches_build(&surfels, &limits, pool, NULL, &patches, NULL);
}

static int tear_down(void **state)
{
    (void)state;
    patches_free(&patches);
    surfels_free(&surfels);
    gp_pool_destroy(&pool);
    return 0;
}

static double depth_of(const Surfel *surfel)
{
    double from[3];
    for (int k = 0; k < 3; k++)
        from[k] = (double)surfel->position[k] - view.eye[k];
    return vector_dot(view.axes.forward, from);
}

static double pixels_of(const Surfel *surfel)
{
    return 2 * (double)surfel->radius * view.pixels / depth_of(surfel);
}

/* All is in view, and what faces away too: areas add up to the ball's whatever the detail, since
 * each leaf is in one node, and nodes keep the areas of their leaves up to a share's rounding. */
static void a_walk_shows_every_leaf_once(void **state)
{
    (void)state;
    uint32_t before = UINT32_MAX;
    for (size_t i = 0; i < GP_COUNT(details); i++) {
        HierarchyCut cut;
        double area = 0;
        uint32_t wide = 0;
        assert_int_equal(hierarchy_walk(&patches, &view, details[i], true, &cut), GP_OK);
        for (uint32_t s = 0; s < cut.count; s++) {
            area += surfel_area(&cut.surfels[s]);
            wide += pixels_of(&cut.surfels[s]) > details[i] * (1 + 1e-6);
        }
        if (!(fabs(area / 12.566370614359172 - 1) < 0.02))
            fail_msg("detail %g: the area is %g", details[i], area);
        assert_true((wide > 0) == (i == 0)); /* leaves are as wide as they are */
        assert_true(cut.count < before || cut.count == surfels.count);
        before = cut.count;
        gp_free(cut.surfels);
    }
    assert_true(before < surfels.count / 50);
}

static bool is_drawn(const SequenceNode *node, double per_radius)
{
    const double depth = depth_of(&node->surfel);
    return depth >= (double)node->size[0] * per_radius &&
           depth < (double)node->size[1] * (per_radius + 1);
}

/* The other way to the same nodes: every one that a walk finds is in the prefix and is drawn, few
 * others are, and none behind the prefix. */
static void a_sequence_draws_what_a_walk_finds(void **state)
{
    (void)state;
    Sequence sequence;
    assert_int_equal(sequence_build(&patches, &sequence), GP_OK);
    assert_int_equal(sequence.count, patches.surfel_count);
    for (size_t i = 0; i < GP_COUNT(details); i++) {
        const double per_radius = 2 * view.pixels / details[i];
        HierarchyCut cut;
        double nearest = HUGE_VAL, area = 0, drawn_area = 0;
        uint32_t drawn = 0;
        assert_int_equal(hierarchy_walk(&patches, &view, details[i], true, &cut), GP_OK);
        for (uint32_t s = 0; s < patches.surfel_count; s++)
            nearest = fmin(nearest, depth_of(&patches.surfels[s]));
        const uint32_t prefix = sequence_prefix(&sequence, nearest, per_radius);
        for (uint32_t n = 0; n < sequence.count; n++) {
            if (!is_drawn(&sequence.nodes[n], per_radius))
                continue;
            assert_true(n < prefix);
            drawn++;
            drawn_area += surfel_area(&sequence.nodes[n].surfel);
        }
        for (uint32_t s = 0; s < cut.count; s++)
            area += surfel_area(&cut.surfels[s]);
        print_message("# %g pixels: %u nodes of a walk, %u drawn of %u\n", details[i], cut.count,
                      drawn, prefix);
        /* children of parents that are a radius from being too large */
        assert_true(drawn >= cut.count && drawn <= cut.count * (1 + 4 / per_radius));
        assert_true(drawn_area >= area * (1 - 1e-9) && drawn_area <= area * (1 + 4 / per_radius));
        gp_free(cut.surfels);
    }
    for (uint32_t n = 1; n < sequence.count; n++)
        assert_true(sequence.nodes[n].size[1] <= sequence.nodes[n - 1].size[1]);
    sequence_free(&sequence);
}

/* What faces away is left out patch by patch; nothing that faces the eye is. */
static void backs_are_left_out(void **state)
{
    (void)state;
    HierarchyCut all, front;
    uint32_t facing[2] = { 0, 0 };
    assert_int_equal(hierarchy_walk(&patches, &view, 2, true, &all), GP_OK);
    assert_int_equal(hierarchy_walk(&patches, &view, 2, false, &front), GP_OK);
    const HierarchyCut *const cuts[2] = { &all, &front };
    for (int i = 0; i < 2; i++)
        for (uint32_t s = 0; s < cuts[i]->count; s++) {
            const Surfel *surfel = &cuts[i]->surfels[s];
            double way[3], normal[3];
            for (int k = 0; k < 3; k++) {
                way[k] = view.eye[k] - (double)surfel->position[k];
                normal[k] = (double)surfel->normal[k];
            }
            facing[i] += vector_dot(way, normal) > 0;
        }
    assert_int_equal(facing[0], facing[1]);
    assert_true(front.count < 0.8 * all.count);
    gp_free(all.surfels);
    gp_free(front.surfels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_walk_shows_every_leaf_once),
        cmocka_unit_test(a_sequence_draws_what_a_walk_finds),
        cmocka_unit_test(backs_are_left_out),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
