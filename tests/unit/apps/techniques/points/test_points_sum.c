/* Pictures of splats against the sum over all of them, in double and without cut-off: what is
 * between is the cut, and the precision of the sums. */
#include "apps/techniques/points/technique.h"

#include "apps/points/surfels.h"
#include "apps/techniques/points/model.h"
#include "tests/support/splat_sum.h"
#include "tests/support/unit.h"

enum { SIDE = 64 };
static const double waves = 6;

static GpDevice *device;
static PointsModel *model;

static int set_up(void **state)
{
    (void)state;
    PointsOptions options = points_option_defaults;
    const TechniqueInput input = {
        .path = "builtin:torus", .width = SIDE, .height = SIDE, .setting = &options
    };
    void *opened;
    options.subdivide = 1;
    if (gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &device, NULL) ||
        points_technique.open(&input, &opened, NULL))
        return -1;
    model = opened;
    model->view.waves = waves;
    model->view.lit = false;
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    points_technique.close(model);
    gp_device_destroy(&device);
    return 0;
}

static SplatSum sum_all(SplatSumKind kind, double low_pass)
{
    const SplatSetting setting = points_option_defaults.splats;
    const uint32_t count = model->surfels.count;
    TruthSplat *splats = gp_alloc(count, sizeof *splats);
    for (uint32_t i = 0; i < count; i++) {
        const Surfel *surfel = &model->surfels.surfels[i];
        splats[i] = (TruthSplat){ .radius = (double)surfel->radius,
                                  .deviation = setting.spread * (double)surfel_width(surfel),
                                  .area = surfel_area(surfel) };
        for (int k = 0; k < 3; k++) {
            splats[i].position[k] = (double)surfel->position[k];
            splats[i].normal[k] = (double)surfel->normal[k];
            splats[i].color[k] = 0.5 + 0.5 * sin(waves * splats[i].position[k]);
        }
    }
    const SplatSumScene scene = { .splats = splats,
                                  .count = count,
                                  .camera = model->view.camera,
                                  .width = SIDE,
                                  .height = SIDE,
                                  .low_pass = low_pass,
                                  .epsilon = setting.epsilon,
                                  .kind = kind };
    SplatSum sum;
    GpPool *pool;
    assert_int_equal(gp_pool_create(2, &pool, NULL), GP_OK);
    assert_int_equal(splat_sum_make(&scene, pool, &sum), GP_OK);
    gp_pool_destroy(&pool);
    gp_free(splats);
    return sum;
}

/* The root of the mean square of what is between, in 255ths, where splats of one surface cover all
 * of a pixel and of its neighbours; and of how many values it is. */
static double distance(const SplatSum *sum, const char *text, int *count)
{
    GpError error;
    Frame frame = { .color = NULL };
    void *options;
    if (technique_setting(&points_technique, text, &options, &error) ||
        points_technique.build(model, options, device, &frame, &error) ||
        gp_device_run(device, &frame.list, &error))
        fail_msg("%s: %s", text, error.text);
    const uint8_t *texels = frame.color->level[0].texels;
    double square = 0;
    *count = 0;
    for (size_t y = 1; y + 1 < SIDE; y++)
        for (size_t x = 1; x + 1 < SIDE; x++) {
            bool is_inside = true;
            for (size_t i = 0; i < 9; i++)
                is_inside = is_inside &&
                            fabs(sum->weight[(y + i / 3 - 1) * SIDE + x + i % 3 - 1] - 1) < 0.2;
            for (size_t k = 0; k < 3 && is_inside; k++, ++*count) {
                const double off =
                    texels[4 * (y * SIDE + x) + 2 - k] - 255 * sum->color[3 * (y * SIDE + x) + k];
                square += off * off;
            }
        }
    frame_free(&frame);
    gp_free(options);
    return sqrt(square / fmax(*count, 1));
}

/* Rounding to 255ths alone is 0.29. */
static void both_filters_are_the_sum_but_for_cut_and_precision(void **state)
{
    (void)state;
    static const struct {
        const char *options;
        double most, least;
    } rows[] = {
        { "--method ewa --cut 5 --sums float", 0.3, 0 },
        { "--method ewa --cut 5 --sums half", 0.36, 0 },
        { "--method ewa --cut 3", 0.36, 0 },
        { "--method ewa", 0.7, 0 },
        { "--method adaptive", 0.7, 0 },
        { "--method reconstruction --cut 5 --sums float", 255, 1 },
        { "--method lowpass --cut 5 --sums float", 255, 0.4 },
    };
    SplatSum sum = sum_all(SPLAT_SUM_AFFINE, points_option_defaults.splats.low_pass);
    int failed = 0;
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        int count;
        const double off = distance(&sum, rows[i].options, &count);
        assert_true(count > 500);
        if (off <= rows[i].most && off >= rows[i].least)
            continue;
        print_error("%s: %g, not in [%g, %g]\n", rows[i].options, off, rows[i].least, rows[i].most);
        failed++;
    }
    splat_sum_free(&sum);
    assert_int_equal(failed, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_filters_are_the_sum_but_for_cut_and_precision),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
