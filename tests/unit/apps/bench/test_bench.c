/* Benchmark cases: they are the peers' by name and amount, valid, and their pictures are right
 * where mathematics says what is right. */
#include "apps/bench/cases.h"
#include "apps/bench/data.h"
#include "shaders_c/bench/surface_maps.h"
#include "tests/support/unit.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

/* Builds a case; skips the test where its mesh is not there. */
static Frame build(const char *name)
{
    const BenchCase *bench = bench_case_find(name);
    assert_non_null(bench);
    Frame frame = { .color = NULL };
    GpError error = { "" };
    if (bench->build(bench, &frame, &error)) {
        frame_free(&frame);
        skip();
    }
    return frame;
}

static void run(const GpList *list)
{
    GpDevice *device;
    GpError error = { "" };
    assert_int_equal(gp_device_create(&(GpDeviceDesc){ .threads = 1 }, &device, &error), GP_OK);
    if (gp_device_run(device, list, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&device);
}

/* The picture of a case as RGBA8, to be freed with gp_free. */
static uint8_t *picture_of(const char *name)
{
    Frame frame = build(name);
    run(&frame.list);
    uint32_t width, height;
    bench_picture_size(&frame, &width, &height);
    uint8_t *rgba = gp_alloc((size_t)width * height, 4);
    const BenchCase *bench = bench_case_find(name);
    (bench->picture ? bench->picture : bench_show)(&frame, rgba);
    frame_free(&frame);
    return rgba;
}

/* --- the table -------------------------------------------------------------------------------- */

static void cases_are_those_of_the_peers(void **state)
{
    (void)state;
    static const char names[] =
        "clear fill fill_nozs fill_blend fill_blend16f fill_blend32f fill_tex_bi fill_tex_tri "
        "bunny_depth bunny_phong bunny_phong_cull grid_big grid_depth mrt4 shadow_hw shadow_near "
        "shadow_pcf4 points peel alu_mad alu_flat mandel dep_tex discard_tex sheets small_draws "
        "vox_add voxel_conservative voxel_thin voxel_solid voxel_twisted voxel_million "
        "voxel_union voxel_collide ";
    char all[sizeof names] = "";
    for (size_t i = 0; i < bench_case_count; i++) {
        strncat(all, bench_cases[i].name, sizeof all - strlen(all) - 1);
        strncat(all, " ", sizeof all - strlen(all) - 1);
    }
    assert_string_equal(all, names);
    assert_null(bench_case_find("no such case"));
}

/* Also that the rates divide by what is really drawn; some cases tell what that is in each
 * frame. */
static void every_case_is_valid_and_draws_what_the_table_says(void **state)
{
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < bench_case_count; i++) {
        Frame frame = { .color = NULL };
        GpError error = { "" };
        if (strstr(bench_cases[i].name, "_im") ||
            strstr(bench_cases[i].name, "_96")) /* gigabytes of draws; millions of triangles */
            continue;
        if (bench_cases[i].build(&bench_cases[i], &frame, &error) == GP_OK) {
            failed += gp_list_check(&frame.list, &error) != GP_OK;
            double primitives = 0;
            for (uint32_t p = 0; p < frame.list.pass_count; p++)
                for (uint32_t d = 0; d < frame.list.passes[p].draw_count; d++) {
                    const GpDraw *draw = &frame.list.passes[p].draws[d];
                    bool whole_screen =
                        draw->geometry.index_count == 6 && frame.list.pass_count > 2;
                    primitives += whole_screen ? 0 : gp_geometry_primitives(&draw->geometry);
                }
            const bool differs = !bench_cases[i].tell && primitives != bench_cases[i].primitives;
            failed += differs;
            if (error.text[0] || differs)
                print_error("%s: %g primitives; %s\n", bench_cases[i].name, primitives, error.text);
        }
        frame_free(&frame);
    }
    assert_int_equal(failed, 0);
}

/* Each pixel reads earlier layers at its own place only, so a tile can do all passes in turn. */
static void layers_are_one_group(void **state)
{
    (void)state;
    static const char *const names[] = { "sheets", "peel", "fragments_peel_bunny",
                                         "fragments_dual_bunny", "fragments_abuffer_bunny" };
    for (size_t i = 0; i < GP_COUNT(names); i++) {
        Frame frame = build(names[i]);
        uint32_t *groups = gp_alloc(frame.list.pass_count, sizeof *groups);
        assert_int_equal(gp_list_groups(&frame.list, groups), 1);
        gp_free(groups);
        frame_free(&frame);
    }
}

/* --- generators ------------------------------------------------------------------------------- */

/* The first is a published value; rows come last first. */
static void picture_hash_is_fnv_1a_from_the_bottom_up(void **state)
{
    (void)state;
    assert_int_equal(bench_picture_hash((const uint8_t *)"foob", 1, 1), 0x3f5076ef);
    uint64_t expected = 2166136261u;
    for (const char *p = "abcdefgh"; *p; p++)
        expected = (expected ^ (uint8_t)*p) * 16777619u % 4294967296u;
    assert_int_equal(bench_picture_hash((const uint8_t *)"efghabcd", 1, 2), expected);
}

/* Volume by the divergence theorem: positive, so outsides turn counter-clockwise. */
static void torus_has_the_volume_of_a_torus(void **state)
{
    (void)state;
    Frame frame = { .color = NULL };
    GpGeometry torus = bench_torus(&frame, 400, 200);
    const GpStream *stream = &torus.streams[GP_POSITION];
    double volume = 0;
    for (uint32_t i = 0; i < torus.index_count; i += 3) {
        double v[3][3], cross[3];
        for (uint32_t k = 0; k < 9; k++) {
            size_t offset = (size_t)torus.indices[i + k / 3] * stream->stride;
            const float *position =
                (const float *)(const void *)((const char *)stream->data + offset);
            v[k / 3][k % 3] = (double)position[k % 3];
        }
        vector_cross(v[1], v[2], cross);
        volume += vector_dot(v[0], cross) / 6;
    }
    double exact = 2 * pi * pi * 0.85 * 0.42 * 0.42;
    assert_true(fabs(volume / exact - 1) < 5e-4);
    frame_free(&frame);
}

static void rotated_corners_span_one_and_seven_tenths(void **state)
{
    (void)state;
    BenchCorner left = { .position = { -1, -1, 0 } }, right = { .position = { 1, -1, 0 } };
    bench_corner_rotated(7, 0, &left);
    bench_corner_rotated(7, 1, &right);
    double du = (double)right.value[0] - (double)left.value[0];
    double dv = (double)right.value[1] - (double)left.value[1];
    assert_true(fabs(hypot(du, dv) - 1.7) < 1e-6);
    assert_true(fabs(atan2(dv, du) - pi / 6) < 1e-6);
}

/* --- pictures --------------------------------------------------------------------------------- */

/* 255 (0.10, 0.12, 0.15), rounded; alpha says that nothing was drawn. */
static void clear_is_the_background(void **state)
{
    (void)state;
    uint8_t *rgba = picture_of("clear");
    const uint8_t expected[4] = { 26, 31, 38, 0 };
    for (size_t i = 0; i < (size_t)BENCH_SIZE * BENCH_SIZE; i++)
        assert_memory_equal(rgba + 4 * i, expected, 4);
    gp_free(rgba);
}

/* 64 steps v = v a + b have the sum v a^64 + b (1 - a^64) / (1 - a). */
static double after_64_steps(double v, double a, double b)
{
    double power = pow(a, 64);
    return v * power + b * (1 - power) / (1 - a);
}

static void multiply_adds_have_their_closed_form(void **state)
{
    (void)state;
    static const double a[3] = { 0.9990234375, 0.998046875, 0.99609375 };
    static const double b[3] = { 0.0009765625, 0.0009765625, 0.001953125 };
    uint8_t *loop = picture_of("alu_mad"), *flat = picture_of("alu_flat");
    assert_memory_equal(loop, flat, (size_t)BENCH_SIZE * BENCH_SIZE * 4);
    for (size_t i = 0; i < (size_t)BENCH_SIZE * BENCH_SIZE; i++) {
        double u = ((double)(i % BENCH_SIZE) + 0.5) / BENCH_SIZE;
        double v = 1 - ((double)(i / BENCH_SIZE) + 0.5) / BENCH_SIZE;
        const double start[3] = { u, v, 1 - u };
        for (int c = 0; c < 3; c++) {
            double sum = after_64_steps(start[c], a[c], b[c]) +
                         after_64_steps(start[c] * 0.5, a[c], b[c]) +
                         after_64_steps(start[c] + 0.25, a[c], b[c]) +
                         after_64_steps(start[c] * start[c], a[c], b[c]);
            double code = 255 * fmin(sum * 0.25, 1);
            assert_true(fabs(loop[4 * i + (size_t)c] - code) < 0.501);
        }
    }
    gp_free(loop);
    gp_free(flat);
}

static int escape_steps(float cx, float cy)
{
    float x = 0, y = 0;
    int steps = 0;
    for (; steps < 64; steps++) {
        float real = x * x - y * y + cx;
        y = 2 * x * y + cy;
        x = real;
        if (x * x + y * y > 4)
            break;
    }
    return steps;
}

/* Also that leaving the loop early changes nothing. The set is chaotic: where the interpolated u
 * or v is off by a last bit, the steps may differ. */
static void mandelbrot_counts_the_steps_to_escape(void **state)
{
    (void)state;
    uint8_t *rgba = picture_of("mandel");
    size_t differing = 0;
    for (size_t i = 0; i < (size_t)BENCH_SIZE * BENCH_SIZE; i++) {
        float u = ((float)(i % BENCH_SIZE) + 0.5f) / BENCH_SIZE;
        float v = 1 - ((float)(i / BENCH_SIZE) + 0.5f) / BENCH_SIZE;
        int steps = escape_steps(u * 2.6f - 1.9f, v * 2.6f - 1.3f);
        differing += rgba[4 * i] != gp_unorm_from_float((float)steps / 64, 8);
    }
    assert_in_range(differing, 0, BENCH_SIZE * BENCH_SIZE / 1000);
    gp_free(rgba);
}

/* Seen along its axis the torus is a ring, and each ray passes its surface twice. */
static void voxels_are_two_in_each_column_of_a_ring(void **state)
{
    (void)state;
    uint8_t *rgba = picture_of("vox_add");
    uint32_t covered = 0, pairs = 0;
    for (size_t i = 0; i < (size_t)BENCH_SMALL_SIZE * BENCH_SMALL_SIZE; i++) {
        int bits = rgba[4 * i] + rgba[4 * i + 1];
        covered += bits > 0;
        pairs += bits == 2;
    }
    double per_unit = BENCH_SMALL_SIZE / 2.6;
    double ring = pi * (1.27 * 1.27 - 0.43 * 0.43) * per_unit * per_unit;
    assert_true(fabs(covered / ring - 1) < 1e-3);
    assert_true(pairs > 0.99 * covered);
    gp_free(rgba);
}

/* The largest difference between what the pixel shader gets as depth and the depth buffer's, on a
 * torus between these planes; out: the pixels that it covers. */
static double worst_depth(double near, double far, uint32_t *covered)
{
    const uint32_t size = 256;
    const Camera camera = {
        .eye = { 0, 1, 2.5 }, .up = { 0, 1, 0 }, .fovy = 45, .near = near, .far = far
    };
    Frame frame = { .color = NULL };
    SurfaceMapsUniforms uniforms = { .light = BENCH_LIGHT, .albedo = BENCH_ALBEDO };
    camera_matrix(&camera, 1, uniforms.mvp);
    GpGeometry torus = bench_torus(&frame, 60, 30);
    GpSurface *depth = frame_surface(&frame, GP_D32F, size, size, 1);
    GpSurface *targets[GP_MAX_TARGETS];
    GpPass *pass = frame_pass(&frame, "maps", NULL, depth, NULL);
    for (int i = 0; i < GP_MAX_TARGETS; i++) {
        targets[i] = frame_surface(&frame, GP_A32B32G32R32F, size, size, 1);
        pass->color[i] = (GpColorTarget){ .surface = targets[i], .clear = true };
    }
    frame_draw(&frame, &surface_maps_program, &uniforms, &torus)->state.depth = bench_depth_less;
    run(&frame.list);

    double worst = 0;
    *covered = 0;
    for (uint32_t i = 0; i < size * size; i++) {
        float stored = ((const float *)(const void *)depth->level[0].texels)[i];
        float given = ((const float *)(const void *)targets[3]->level[0].texels)[4 * i];
        double difference = stored < 1 ? fabs((double)stored - (double)given) : 0;
        worst = difference > worst ? difference : worst;
        *covered += stored < 1;
    }
    frame_free(&frame);
    return worst;
}

/* What depth peeling relies on, where planes cut the model too: then depths reach from 0 to 1, and
 * those of corners that are cut off are larger. */
static void interpolated_depth_is_the_depth_buffers(void **state)
{
    (void)state;
    uint32_t whole, cut;
    assert_true(worst_depth(0.5, 10, &whole) < 1.5e-7);
    assert_true(worst_depth(2.2, 3, &cut) < 1e-6);
    assert_true(whole > 10000 && cut > 2000 && cut < whole);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cases_are_those_of_the_peers),
        cmocka_unit_test(every_case_is_valid_and_draws_what_the_table_says),
        cmocka_unit_test(layers_are_one_group),
        cmocka_unit_test(picture_hash_is_fnv_1a_from_the_bottom_up),
        cmocka_unit_test(torus_has_the_volume_of_a_torus),
        cmocka_unit_test(rotated_corners_span_one_and_seven_tenths),
        cmocka_unit_test(clear_is_the_background),
        cmocka_unit_test(multiply_adds_have_their_closed_form),
        cmocka_unit_test(mandelbrot_counts_the_steps_to_escape),
        cmocka_unit_test(voxels_are_two_in_each_column_of_a_ring),
        cmocka_unit_test(interpolated_depth_is_the_depth_buffers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
