/* Paper 003's tree of oriented boxes, against every patch for itself. */
#include "apps/points/boxes.h"

#include "tests/support/surfel_shapes.h"
#include "tests/support/unit.h"

static Patches patches;
static BoxTree tree;

static int set_up(void **state)
{
    (void)state;
    GpPool *pool;
    Surfels surfels;
    const PatchLimits limits = { .most_leaves = 256, .least_leaves = 64 };
    if (gp_pool_create(2, &pool, NULL))
        return -1;
    shape_torus(&surfels, 40000, 0.4);
    for (uint32_t i = 0; i < surfels.count; i++)
        surfels.surfels[i].radius *= 1 + 0.5f * surfels.surfels[i].normal[2];
    const GpResult result = patches_build(&surfels, &limits, pool, NULL, &patches, NULL);
    surfels_free(&surfels);
    gp_pool_destroy(&pool);
    return result || box_tree_build(&patches, &tree);
}

static int tear_down(void **state)
{
    (void)state;
    box_tree_free(&tree);
    patches_free(&patches);
    return 0;
}

static void boxes_hold_all_below_them(void **state)
{
    (void)state;
    assert_int_equal(tree.node_count, 2 * patches.patch_count - 1);
    for (uint32_t n = 0; n < tree.node_count; n++) {
        const BoxNode *node = &tree.nodes[n];
        for (uint32_t p = node->first; p < node->first + node->count; p++) {
            const PatchLevel *leaves =
                patch_levels(&patches, &patches.patches[p]) + patches.patches[p].level_count - 1;
            for (uint32_t i = leaves->first; i < leaves->first + leaves->count; i++) {
                const Surfel *surfel = &patches.surfels[i];
                double from[3];
                for (int k = 0; k < 3; k++)
                    from[k] = (double)surfel->position[k] - (double)node->box.centre[k];
                for (int k = 0; k < 3; k++) {
                    double axis[3];
                    for (int c = 0; c < 3; c++)
                        axis[c] = (double)node->box.axes[k][c];
                    assert_true(fabs(vector_dot(axis, from)) <= (double)node->box.half[k]);
                }
                assert_true(surfel->radius >= node->least_radius &&
                            surfel->radius <= node->most_radius);
            }
        }
    }
}

/* Whatever a box decided holds for each of its surfels, and few boxes had to be asked. */
static void what_boxes_decide_holds_for_every_surfel(void **state)
{
    (void)state;
    Random random = { 9 };
    int8_t *class_of = gp_alloc(patches.patch_count, sizeof *class_of);
    uint32_t counts[4] = { 0 }, looked_at = 0;
    for (int round = 0; round < 60; round++) {
        Camera camera = { .up = { 0, 1, 0.1 }, .fovy = 30, .near = 0.05, .far = 30 };
        const float far = random_float(&random, 0.7f, 7);
        for (int k = 0; k < 3; k++)
            camera.eye[k] = (double)random_float(&random, -far, far);
        for (int k = 0; k < 3; k++)
            camera.at[k] = (double)random_float(&random, -1.5f, 1.5f);
        const PointView view = point_view(&camera, 512, 512, 3, 2);
        const DistanceRule rule = { 0.7, 0.03 * random_int(&random, 1, 3), 0.15 };
        looked_at +=
            box_tree_classify(&tree, &patches, &view, box_class_by_distance, &rule, 2, class_of);
        for (uint32_t p = 0; p < patches.patch_count; p++) {
            const PatchLevel *leaves =
                patch_levels(&patches, &patches.patches[p]) + patches.patches[p].level_count - 1;
            counts[class_of[p] + 1]++;
            for (uint32_t i = leaves->first; i < leaves->first + leaves->count; i++) {
                double from[3];
                for (int k = 0; k < 3; k++)
                    from[k] = (double)patches.surfels[i].position[k] - camera.eye[k];
                const double depth = vector_dot(view.axes.forward, from);
                const double unit = view.pixels / rule.low_pass * (double)patches.surfels[i].radius;
                if (class_of[p] == 0)
                    assert_true(depth <= rule.near * unit);
                if (class_of[p] == 1)
                    assert_true(depth < view.near || depth >= rule.far * unit);
                if (class_of[p] == -1) /* its disc is outside of the frustum */
                    for (int side = 0; side < 4; side++) {
                        double at[3];
                        for (int k = 0; k < 3; k++)
                            at[k] = (double)patches.surfels[i].position[k];
                        if (vector_dot(view.sides[side], at) - view.side_offset[side] > 0)
                            break;
                        if (side == 3)
                            assert_true(depth < view.near || depth > view.far);
                    }
            }
        }
    }
    for (int i = 0; i < 4; i++)
        if (counts[i] < 10)
            fail_msg("class %d: %u patches only", i - 1, counts[i]);
    assert_true(looked_at < 60 * patches.patch_count);
    gp_free(class_of);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes_hold_all_below_them),
        cmocka_unit_test(what_boxes_decide_holds_for_every_surfel),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
