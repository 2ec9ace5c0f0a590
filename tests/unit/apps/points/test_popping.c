/* What is seen of a change of level: pictures by plain sums in double, of a ball with a chequered
 * skin, as the camera comes nearer. The camera stands still and `pixels` falls instead, by a
 * hundredth a frame, which chooses as coming nearer by as much does, and moves nothing else in the
 * picture. */
#include "apps/points/level.h"

#include "tests/support/surfel_shapes.h"
#include "tests/support/unit.h"

enum { SIDE = 64, FRAMES = 72 };

static GpPool *pool;
static Surfels surfels;
static Patches patches;
static LevelSelection selection;
static PointView view;

typedef struct Picture {
    double sum[SIDE * SIDE][2]; /* weight, weighted colour */
} Picture;

static int set_up(void **state)
{
    (void)state;
    const PatchLimits limits = { .most_leaves = 2048, .least_leaves = 1024 };
    const Camera camera = { { 0, 0, 4 }, { 0, 0, 0 }, { 0, 1, 0 }, 32, 0, 0.1, 20 };
    view = point_view(&camera, SIDE, SIDE, 3, 3);
    if (gp_pool_create(2, &pool, NULL))
        return -1;
    shape_sphere(&surfels, 60000);
    for (uint32_t i = 0; i < surfels.count; i++) {
        int parity = 0;
        for (int k = 0; k < 3; k++)
            parity += (int)floor((double)surfels.surfels[i].position[k] / 0.2 + 100);
        surfels.surfels[i].color[0] = parity % 2 ? 230 : 30;
    }
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

/* A splat: the Gaussian of the surfel as if it faced the eye, widened by the pixel's. */
static void add_splat(const Surfel *surfel, Picture *picture)
{
    double from[3], normal[3];
    for (int k = 0; k < 3; k++) {
        from[k] = (double)surfel->position[k] - view.eye[k];
        normal[k] = (double)surfel->normal[k];
    }
    const double cosine = -vector_dot(from, normal) / sqrt(vector_dot(from, from));
    if (cosine <= 0)
        return;
    const double unit = view.pixels / vector_dot(from, view.axes.forward);
    const double x = SIDE / 2.0 + unit * vector_dot(from, view.axes.right) - 0.5;
    const double y = SIDE / 2.0 - unit * vector_dot(from, view.axes.up) - 0.5;
    const double radius = (double)surfel_width(surfel) * unit;
    const double variance = radius * radius + 0.25, reach = 3 * sqrt(variance);
    const double weight = surfel_area(surfel) * unit * unit * cosine / variance;
    const int low = (int)fmax(x - reach, 0), high = (int)fmin(x + reach, SIDE - 1);
    double along[SIDE];
    for (int column = low; column <= high; column++)
        along[column] = exp(-0.5 * (column - x) * (column - x) / variance);
    for (int row = (int)fmax(y - reach, 0); row <= (int)fmin(y + reach, SIDE - 1); row++) {
        const double w = weight * exp(-0.5 * (row - y) * (row - y) / variance);
        for (int column = low; column <= high; column++) {
            picture->sum[row * SIDE + column][0] += w * along[column];
            picture->sum[row * SIDE + column][1] += w * along[column] * surfel->color[0];
        }
    }
}

static void draw(const LevelChoice *choice, Picture *picture)
{
    memset(picture, 0, sizeof *picture);
    assert_int_equal(level_select(&patches, &view, choice, &selection, NULL), GP_OK);
    for (uint32_t r = 0; r < selection.range_count; r++)
        for (uint32_t i = 0; i < selection.ranges[r].count; i++)
            add_splat(&patches.surfels[selection.ranges[r].first + i], picture);
}

/* Mean difference over the pixels that the ball covers, in 255ths. */
static double change(const Picture *a, const Picture *b)
{
    double sum = 0;
    int covered = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        if (a->sum[i][0] > 0.5 && b->sum[i][0] > 0.5) {
            sum += fabs(a->sum[i][1] / a->sum[i][0] - b->sum[i][1] / b->sum[i][0]);
            covered++;
        }
    assert_true(covered > SIDE * SIDE / 2);
    return sum / covered;
}

/* The largest change from one frame to the next, and the surfels of the first and the last. */
static double largest_change(bool switches, uint64_t counts[2])
{
    static Picture pictures[2];
    double largest = 0;
    LevelChoice choice = { .pixels = 2.4, .switches = switches };
    for (int frame = 0; frame < FRAMES; frame++) {
        choice.pixels *= 0.99;
        draw(&choice, &pictures[frame % 2]);
        counts[frame > 0] = selection.surfel_count;
        if (frame > 0)
            largest = fmax(largest, change(&pictures[0], &pictures[1]));
    }
    return largest;
}

static void a_change_of_level_is_not_seen(void **state)
{
    (void)state;
    uint64_t counts[2][2];
    const double passing = largest_change(false, counts[0]);
    const double switching = largest_change(true, counts[1]);
    print_message("largest mean change of a frame in 255ths: %.3f, by whole levels %.3f\n", passing,
                  switching);
    /* the path passes levels */
    assert_true(counts[0][1] * 2 > 3 * counts[0][0] && counts[1][1] * 2 > 3 * counts[1][0]);
    assert_true(passing < 1);
    assert_true(switching > 2 * passing);
}

static void levels_look_like_leaves(void **state)
{
    (void)state;
    static Picture leaves, coarse;
    const LevelChoice all = { .all_leaves = true }, some = { .pixels = 1.18 };
    draw(&all, &leaves);
    const uint64_t count = selection.surfel_count;
    draw(&some, &coarse);
    print_message("mean difference %.3f of 255, %llu surfels instead of %llu\n",
                  change(&leaves, &coarse), (unsigned long long)selection.surfel_count,
                  (unsigned long long)count);
    assert_true(selection.surfel_count < count * 9 / 10);
    assert_true(change(&leaves, &coarse) < 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_change_of_level_is_not_seen),
        cmocka_unit_test(levels_look_like_leaves),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
