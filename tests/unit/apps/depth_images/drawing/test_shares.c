/* Shares of images that see the same: no place is lost, what is seen twice is drawn once, and
 * triangles are left
 * out only where nothing of a share is. */
#include "apps/depth_images/drawing/merge.h"
#include "apps/depth_images/drawing/shares.h"
#include "tests/support/depth/depth_shapes.h"
#include "tests/support/unit.h"

enum { WIDTH = 128, HEIGHT = 96, CAP = 96 };

static const char *const shapes[] = { "builtin:sphere", "builtin:torus", "builtin:teapot",
                                      "builtin:knot" };

static DepthModel capture(const char *name, bool normals)
{
    DepthShape shape = depth_shape_open(name, 9, 0);
    const DepthModel model = depth_shape_capture(&shape, WIDTH, HEIGHT, CAP, normals);
    depth_shape_close(&shape);
    return model;
}

static void point_of(const DepthImage *image, uint32_t x, uint32_t y, double point[3])
{
    const double depth = (double)image->front.depth[(size_t)y * image->front.width + x];
    if (image->is_cylinder)
        depth_cylinder_point(&image->cylinder, &image->front, x + 0.5, y + 0.5, depth, point);
    else
        depth_plane_point(&image->plane, &image->front, x + 0.5, y + 0.5, depth, point);
}

/* Whether an image has a point within two pixels of where it shows it, as its own, about as
 * deep. */
static bool owns(const DepthImage *image, const uint8_t *own, const double point[3])
{
    double place[2], depth;
    const int64_t width = image->front.width, height = image->front.height;
    if (image->is_cylinder
            ? !depth_cylinder_place(&image->cylinder, &image->front, point, place, &depth)
            : !depth_plane_place(&image->plane, &image->front, point, place, &depth))
        return false;
    const double near = 0.1 * (image->is_cylinder ? image->cylinder.radius : image->plane.height);
    for (int64_t v = (int64_t)place[1] - 2; v <= (int64_t)place[1] + 2; v++)
        for (int64_t u = (int64_t)place[0] - 2; u <= (int64_t)place[0] + 2; u++) {
            const int64_t x = image->is_cylinder ? (u + width) % width : u;
            if (x >= 0 && x < width && v >= 0 && v < height && own[v * width + x] &&
                fabs((double)image->front.depth[v * width + x] - depth) < near)
                return true;
        }
    return false;
}

static void find_shares(const DepthModel *model, uint8_t *own[DEPTH_MODEL_IMAGES])
{
    for (uint32_t i = 0; i < model->count; i++)
        assert_int_equal(shares_find(model, i, &own[i]), GP_OK);
}

static void free_shares(DepthModel *model, uint8_t *own[DEPTH_MODEL_IMAGES])
{
    for (uint32_t i = 0; i < model->count; i++)
        gp_free(own[i]);
    depth_model_free(model);
}

static bool some_owns(const DepthModel *model, uint8_t *const own[DEPTH_MODEL_IMAGES],
                      const double point[3])
{
    for (uint32_t i = 0; i < model->count; i++)
        if (owns(&model->images[i], own[i], point))
            return true;
    return false;
}

static void every_place_is_some_images_own(void **state)
{
    (void)state;
    for (size_t n = 0; n < GP_COUNT(shapes); n++) {
        DepthModel model = capture(shapes[n], true);
        uint8_t *own[DEPTH_MODEL_IMAGES];
        uint32_t shown = 0, drawn = 0;
        find_shares(&model, own);
        for (uint32_t i = 0; i < model.count; i++) {
            const DepthPixels *pixels = &model.images[i].front;
            for (uint32_t at = 0; at < pixels->width * pixels->height; at++) {
                double point[3];
                if (!isfinite(pixels->depth[at])) {
                    assert_false(own[i][at]);
                    continue;
                }
                shown++;
                drawn += own[i][at];
                point_of(&model.images[i], at % pixels->width, at / pixels->width, point);
                if (!own[i][at] && !some_owns(&model, own, point))
                    fail_msg("%s, image %u: pixel %u is nobody's", shapes[n], i, at);
            }
        }
        print_message("# %s: %u of %u pixels are drawn\n", shapes[n], drawn, shown);
        assert_true(drawn < shown);
        free_shares(&model, own);
    }
}

static void without_normals_all_is_kept(void **state)
{
    (void)state;
    DepthModel model = capture("builtin:sphere", false);
    uint8_t *own[DEPTH_MODEL_IMAGES];
    find_shares(&model, own);
    for (uint32_t i = 0; i < model.count; i++)
        for (uint32_t at = 0; at < model.images[i].front.width * model.images[i].front.height; at++)
            assert_int_equal(own[i][at], isfinite(model.images[i].front.depth[at]) != 0);
    free_shares(&model, own);
}

/* Of a flat sheet whose share is a spot: triangles whose box holds some of it, and no others. */
static void triangles_of_other_shares_are_left_out(void **state)
{
    (void)state;
    enum { SIDE = 65, SPOT = 40, STEP = 2 };
    static float positions[SIDE * SIDE][3];
    static uint8_t own[SIDE * STEP * SIDE * STEP];
    const DepthImage image = { .front = { .width = SIDE * STEP, .height = SIDE * STEP } };
    MergeGrid grid = { .columns = SIDE, .rows = SIDE, .position = (const float(*)[3])positions };
    MergedMesh mesh;
    uint32_t *sums;
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int k = 0; k < 2; k++)
            positions[i][k] = (float)(k ? -i / SIDE : i % SIDE);
    own[SPOT * STEP * SIDE * STEP + SPOT * STEP] = 1;
    assert_int_equal(shares_sum(&image, own, STEP, SIDE, SIDE, &sums), GP_OK);
    grid.needed = sums;
    assert_int_equal(merge_grid(&grid, -1, &mesh, NULL), GP_OK);
    assert_true(mesh.index_count > 0);
    for (uint32_t i = 0; i < mesh.index_count; i++) {
        const uint32_t point = mesh.points[mesh.indices[i]];
        assert_in_range(point % SIDE, SPOT - 2, SPOT + 2);
        assert_in_range(point / SIDE, SPOT - 2, SPOT + 2);
    }
    bool found = false;
    for (uint32_t i = 0; i < mesh.index_count; i++)
        found = found || mesh.points[mesh.indices[i]] == SPOT * SIDE + SPOT;
    assert_true(found);
    merged_free(&mesh);
    gp_free(sums);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_place_is_some_images_own),
        cmocka_unit_test(without_normals_all_is_kept),
        cmocka_unit_test(triangles_of_other_shares_are_left_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
