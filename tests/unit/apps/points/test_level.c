/* What is culled, and which levels are chosen. */
#include "apps/points/level.h"

#include "tests/support/surfel_shapes.h"
#include "tests/support/unit.h"

static GpPool *pool;
static Surfels surfels;
static Patches patches;
static LevelSelection selection;

static const PatchLimits limits = { .most_leaves = 1024, .least_leaves = 64 };

static int set_up(void **state)
{
    (void)state;
    if (gp_pool_create(2, &pool, NULL))
        return -1;
    shape_torus(&surfels, 40000, 0.4);
    return patches_build(&surfels, &limits, pool, NULL, &patches, NULL) ||
           level_selection_alloc(&patches, &selection);
}

static int tear_down(void **state)
{
    (void)state;
    level_selection_free(&selection);
    patches_free(&patches);
    surfels_free(&surfels);
    gp_pool_destroy(&pool);
    return 0;
}

static void widen(const float from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (double)from[i];
}

static Camera random_camera(Random *random)
{
    Camera camera = { .up = { 0, 1, 0.1 }, .near = 0.05, .far = random_int(random, 0, 3) ? 20 : 3 };
    for (int i = 0; i < 3; i++) {
        camera.eye[i] = (double)random_float(random, -3, 3);
        camera.at[i] = (double)random_float(random, -1, 1);
    }
    camera.fovy = random_int(random, 0, 4) ? (double)random_float(random, 5, 110) : 0;
    camera.height = 0.5;
    return camera;
}

/* --- culling ---------------------------------------------------------------------------------- */

/* By another way than planes: a point of the disc whose picture lies in the picture, and which
 * faces the eye. */
static bool is_seen(const Camera *camera, double aspect, const Surfel *surfel, double reach,
                    Random *random)
{
    double matrix[4][4], view[4][4], projection[4][4], at[3], normal[3], way[3];
    camera_view(camera, view);
    camera_projection(camera, aspect, projection);
    matrix_multiply(projection, view, matrix);
    widen(surfel->position, at);
    widen(surfel->normal, normal);
    const CameraAxes axes = camera_axes(camera, aspect);
    vector_subtract(camera->eye, at, way);
    if (vector_dot(normal, camera->fovy == 0 ? axes.forward : way) * (camera->fovy == 0 ? -1 : 1) <=
        0)
        return false;
    for (int i = 0; i < 8; i++) {
        double from[3], across[3], point[3], clip[4];
        for (int k = 0; k < 3; k++)
            from[k] = (double)random_float(random, -1, 1);
        vector_cross(normal, from, across);
        vector_normalize(across);
        vector_add_scaled(at, i == 0 ? 0 : reach * (double)surfel->radius, across, point);
        for (int k = 0; k < 4; k++)
            clip[k] = vector_dot(matrix[k], point) + matrix[k][3];
        if (fabs(clip[0]) <= clip[3] && fabs(clip[1]) <= clip[3] && clip[2] >= 0 &&
            clip[2] <= clip[3])
            return true;
    }
    return false;
}

/* Surfels of the levels in use that may be seen are all in ranges. */
static void culling_loses_no_surfel_that_is_seen(void **state)
{
    (void)state;
    Random random = { 5 };
    uint32_t seen = 0, culled = 0, silhouettes = 0;
    bool *is_drawn = gp_alloc(patches.patch_count, sizeof *is_drawn);
    for (int i = 0; i < 150; i++) {
        const Camera camera = random_camera(&random);
        const PointView view = point_view(&camera, 300, 200, 3, 2);
        /* leaves are lost or not; with what faces away, its facing is checked too */
        const LevelChoice choice = { .pixels = 0.5 * (i % 3),
                                     .all_leaves = i % 3 == 0,
                                     .keeps_back = i % 3 != 0 };
        assert_int_equal(level_select(&patches, &view, &choice, &selection, NULL), GP_OK);
        memset(is_drawn, 0, patches.patch_count * sizeof *is_drawn);
        for (uint32_t r = 0; r < selection.range_count; r++) {
            const PatchRange *range = &selection.ranges[r];
            is_drawn[range->patch] = true;
            silhouettes += range->is_silhouette;
            for (uint32_t k = range->first; k < range->first + range->count; k++) {
                double at[3], normal[3], way[3];
                widen(patches.surfels[k].position, at);
                widen(patches.surfels[k].normal, normal);
                vector_subtract(view.eye, at, way);
                if (view.is_parallel)
                    vector_set(way, -view.axes.forward[0], -view.axes.forward[1],
                               -view.axes.forward[2]);
                const double length = sqrt(vector_dot(way, way));
                const double cosine = vector_dot(normal, way) / length;
                assert_true(cosine >= range->facing.low && cosine <= range->facing.high);
                vector_subtract(at, view.eye, way);
                const double depth = vector_dot(view.axes.forward, way);
                assert_true(depth < view.near ||
                            (depth >= range->nearest && depth <= range->farthest));
            }
        }
        for (uint32_t p = 0; p < patches.patch_count; p++) {
            const PatchLevel *levels = patch_levels(&patches, &patches.patches[p]);
            const PatchLevel *last = levels + patches.patches[p].level_count - 1;
            culled += !is_drawn[p];
            for (uint32_t k = 0; k < last->count && choice.all_leaves; k += 2) {
                const bool see =
                    is_seen(&camera, 1.5, &patches.surfels[last->first + k], 3, &random);
                seen += see;
                if (see && !is_drawn[p])
                    fail_msg("camera %d: patch %u has a surfel that is seen", i, p);
            }
        }
    }
    /* and neither all nor nothing was culled */
    assert_in_range(culled, 150 * patches.patch_count / 5, 150 * patches.patch_count * 9 / 10);
    assert_true(seen > 100000 && silhouettes > 1000);
    gp_free(is_drawn);
}

static void patches_that_face_away_are_kept_where_wanted(void **state)
{
    (void)state;
    const Camera camera = { { 0, 0.5, 6 }, { 0, 0, 0 }, { 0, 1, 0 }, 40, 0, 0.1, 20 };
    const PointView view = point_view(&camera, 256, 256, 3, 2);
    LevelChoice choice = { .all_leaves = true, .keeps_back = true };
    assert_int_equal(level_select(&patches, &view, &choice, &selection, NULL), GP_OK);
    assert_int_equal(selection.range_count, patches.patch_count);
    assert_int_equal(selection.surfel_count, patches.leaf_count);
    choice.keeps_back = false;
    assert_int_equal(level_select(&patches, &view, &choice, &selection, NULL), GP_OK);
    assert_true(selection.surfel_count < patches.leaf_count * 3 / 4);
}

/* --- levels ----------------------------------------------------------------------------------- */

static double mean_width(uint32_t first, uint32_t count)
{
    double sum = 0, area = 0;
    for (uint32_t k = first; k < first + count; k++) {
        sum += surfel_area(&patches.surfels[k]) * (double)surfel_width(&patches.surfels[k]);
        area += surfel_area(&patches.surfels[k]);
    }
    return sum / area;
}

/* No patch is blurred more than asked for. */
static void patches_are_as_sharp_as_asked_for(void **state)
{
    (void)state;
    Random random = { 6 };
    for (int i = 0; i < 100; i++) {
        const Camera camera = random_camera(&random);
        const PointView view = point_view(&camera, 300, 200, 3, 2);
        const LevelChoice choice = { .pixels = (double)random_float(&random, 0.1f, 8) };
        assert_int_equal(level_select(&patches, &view, &choice, &selection, NULL), GP_OK);
        uint64_t count = 0;
        for (uint32_t r = 0; r < selection.range_count; r++) {
            const PatchRange *range = &selection.ranges[r];
            const Patch *patch = &patches.patches[range->patch];
            const PatchLevel *last = patch_levels(&patches, patch) + patch->level_count - 1;
            const double leaf = mean_width(last->first, last->count);
            const double unit = view.pixels / (view.is_parallel ? 1 : range->nearest);
            const double allowed = choice.pixels / unit;
            const double drawn = mean_width(range->first, range->count);
            assert_true(sqrt(fmax(drawn * drawn - leaf * leaf, 0)) <= allowed * (1 + 1e-6));
            double sum = 0;
            for (uint32_t k = range->first; k < range->first + range->count; k++) {
                assert_true(patches.surfels[k].radius <= range->most_radius);
                sum += (double)patches.surfels[k].radius;
            }
            assert_true(fabs(sum / range->count / (double)range->mean_radius - 1) < 0.25);
            count += range->count;
        }
        assert_int_equal(count, selection.surfel_count);
        assert_true(selection.pixels == choice.pixels);
    }
}

static void silhouettes_and_bends_are_finer(void **state)
{
    (void)state;
    const Camera camera = { { 0, 0.5, 6 }, { 0, 0, 0 }, { 0, 1, 0 }, 40, 0, 0.1, 20 };
    const PointView view = point_view(&camera, 256, 256, 3, 2);
    LevelChoice choice = { .pixels = 10, .silhouette = -1, .curvature = -1 };
    uint64_t counts[3];
    for (int i = 0; i < 3; i++) {
        choice.silhouette = i == 1 ? 1 : -1;
        choice.curvature = i == 2 ? 1 : -1;
        assert_int_equal(level_select(&patches, &view, &choice, &selection, NULL), GP_OK);
        counts[i] = selection.surfel_count;
    }
    assert_true(counts[1] > counts[0] && counts[2] > counts[0]);
}

static void a_budget_is_kept_and_used(void **state)
{
    (void)state;
    Random random = { 7 };
    int kept = 0;
    for (int i = 0; i < 100; i++) {
        const Camera camera = random_camera(&random);
        const PointView view = point_view(&camera, 300, 200, 3, 2);
        LevelChoice choice = { .all_leaves = true };
        assert_int_equal(level_select(&patches, &view, &choice, &selection, NULL), GP_OK);
        const uint64_t all = selection.surfel_count;
        choice = (LevelChoice){ .budget = (uint32_t)random_int(&random, 300, 30000) };
        GpError error;
        if (level_select(&patches, &view, &choice, &selection, &error)) {
            assert_non_null(strstr(error.text, "the coarsest levels in view have "));
            assert_true(choice.budget < 2 * patches.patch_count);
            continue;
        }
        kept++;
        assert_true(selection.surfel_count <= choice.budget);
        if (all > choice.budget)
            assert_true((double)selection.surfel_count > 0.97 * choice.budget - 50);
        else
            assert_true(selection.surfel_count == all);
        /* with a size: what is coarser of both */
        choice.pixels = 4;
        assert_int_equal(level_select(&patches, &view, &choice, &selection, NULL), GP_OK);
        assert_true(selection.surfel_count <= choice.budget && selection.pixels >= 4);
    }
    assert_true(kept > 80);
    const Camera camera = { { 0, 0.5, 6 }, { 0, 0, 0 }, { 0, 1, 0 }, 40, 0, 0.1, 20 };
    const PointView view = point_view(&camera, 256, 256, 3, 2);
    const LevelChoice tiny = { .budget = 3 };
    assert_int_equal(level_select(&patches, &view, &tiny, &selection, NULL), GP_ERROR_INVALID);
}

/* A camera that comes nearer by a hundredth of the way changes few surfels at a time; whole levels
 * change in jumps. */
static void levels_pass_over_into_each_other(void **state)
{
    (void)state;
    double jump[2] = { 0 };
    for (int switches = 0; switches < 2; switches++) {
        uint64_t last = 0;
        for (int step = 0; step < 400; step++) {
            const double away = 40 - 0.09 * step;
            const Camera camera = { { 0, 0, away }, { 0, 0, 0 }, { 0, 1, 0 }, 20, 0, 0.1, 100 };
            const PointView view = point_view(&camera, 512, 512, 3, 2);
            const LevelChoice choice = { .pixels = 12, .switches = switches };
            assert_int_equal(level_select(&patches, &view, &choice, &selection, NULL), GP_OK);
            const double count = (double)selection.surfel_count, before = (double)last;
            if (last > 0 && fabs(count - before) / before > jump[switches])
                jump[switches] = fabs(count - before) / before;
            last = selection.surfel_count;
        }
    }
    assert_true(jump[0] < 0.06 && jump[1] > 2 * jump[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(culling_loses_no_surfel_that_is_seen),
        cmocka_unit_test(patches_that_face_away_are_kept_where_wanted),
        cmocka_unit_test(patches_are_as_sharp_as_asked_for),
        cmocka_unit_test(silhouettes_and_bends_are_finer),
        cmocka_unit_test(a_budget_is_kept_and_used),
        cmocka_unit_test(levels_pass_over_into_each_other),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
