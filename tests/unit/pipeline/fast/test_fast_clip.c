/* Clipping on the fast executor: the reference's bits at user planes of any distance, nothing
 * shaded of what they cut away, and colours of corners that are nowhere. */
#include "shaders_c/materials/unlit.h"
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>

enum { SIDE = 256, TRIANGLES = 60, PLANES = 3 };

typedef struct Clipped {
    float corners[TRIANGLES][3][3];
    UnlitUniforms uniforms;
    GpSurface *target;
    GpDraw draw;
    GpPass pass;
} Clipped;

static void open_case(Random *random, Clipped *c)
{
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = SIDE, .height = SIDE };
    GpError error;
    *c = (Clipped){ .uniforms = { .color = { 0.3f, 0.2f, 0.1f, 1 } } };
    assert_int_equal(gp_surface_create(&desc, &c->target, &error), GP_OK);
    for (int t = 0; t < TRIANGLES; t++)
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++)
                c->corners[t][i][k] = random_float(random, -1, 1);
    for (int k = 0; k < 4; k++)
        c->uniforms.mvp[k][k] = 1;
    c->uniforms.mvp[2][2] = 0.25f;
    c->uniforms.mvp[2][3] = 0.5f;
    c->draw = (GpDraw){ .program = &unlit_program, .uniforms = &c->uniforms };
    c->draw.geometry.streams[GP_POSITION] = (GpStream){ .data = c->corners, .components = 3 };
    c->draw.geometry.vertex_count = 3 * TRIANGLES;
    c->draw.state.raster.cull = GP_CULL_NONE;
    c->draw.state.blend[0].op = GP_BLEND_LOGIC_XOR;
}

static void set_pass(Clipped *c)
{
    c->pass = (GpPass){ .name = "clipped",
                        .color = { { .surface = c->target, .clear = true } },
                        .draws = &c->draw,
                        .draw_count = 1 };
}

/* From the least denormal to what overflows in the next step. */
static float any_size(Random *random)
{
    const float mantissa = random_float(random, -2, 2);
    return mantissa * (float)ldexp(1, random_int(random, 0, 3) ? random_int(random, -3, 3)
                                                               : random_int(random, -149, 126));
}

static void planes_of_any_size_cut_as_the_reference_does(void **state)
{
    (void)state;
    Random random = { 5 };
    for (int seed = 0; seed < 40; seed++) {
        Clipped c;
        open_case(&random, &c);
        c.draw.state.raster.clip_planes = (1u << PLANES) - 1;
        for (int p = 0; p < PLANES; p++)
            for (int k = 0; k < 4; k++)
                c.draw.state.raster.clip_plane[p][k] = any_size(&random);
        if (seed % 2) /* seen in perspective, w from denormal to large */
            for (int k = 0; k < 3; k++)
                c.uniforms.mvp[3][k] = any_size(&random);
        set_pass(&c);
        run_seed_everywhere(&c.pass, seed);
        gp_surface_destroy(&c.target);
    }
}

static uint64_t shaded(const GpPass *pass)
{
    GpDevice *device = device_open(&(GpDeviceDesc){ .threads = 1 });
    GpError error;
    assert_int_equal(gp_device_run(device, &(GpList){ pass, 1 }, &error), GP_OK);
    const uint64_t fragments = gp_device_counters(device)->fragments_shaded;
    gp_device_destroy(&device);
    return fragments;
}

static void what_planes_cut_away_is_not_shaded(void **state)
{
    (void)state;
    static const float away[4] = { 0, 0, 0, -1 }, through[4] = { 0, 1, 0, 0.01f };
    Random random = { 6 };
    Clipped c;
    open_case(&random, &c);
    set_pass(&c);
    const uint64_t whole = shaded(&c.pass);
    c.draw.state.raster.clip_planes = 1;
    memcpy(c.draw.state.raster.clip_plane[0], through, sizeof through);
    const uint64_t upper = shaded(&c.pass);
    for (int k = 0; k < 4; k++)
        c.draw.state.raster.clip_plane[0][k] = -through[k];
    const uint64_t lower = shaded(&c.pass);
    memcpy(c.draw.state.raster.clip_plane[0], away, sizeof away);
    assert_true(upper > whole / 4 && lower > whole / 4);
    assert_int_equal(upper + lower, whole); /* no centre lies on the plane */
    assert_int_equal(shaded(&c.pass), 0);
    gp_surface_destroy(&c.target);
}

/* One behind the near plane, one beyond the far one, one beyond the guard band: what is left
 * between them has their colours all the same. */
static void triangles_with_no_corner_inside_have_their_colours(void **state)
{
    (void)state;
    static const float corners[3][10] = { { -0.9f, -0.9f, -1, 1, 0.2f, 0.9f, 0.1f, 1, 0, 1 },
                                          { -0.5f, 0.9f, 2, 1, 0.8f, 0.3f, 0.7f, 1, 1, 1 },
                                          { 600, 0.1f, 0.5f, 1, 0.4f, 0.5f, 0.6f, 1, 1, 0 } };
    static const float black[4] = { 0, 0, 0, 0 };
    Clipped c;
    Random random = { 7 };
    open_case(&random, &c);
    ExerciseUniforms uniforms = { .color = { 0.125f, 0.25f, 0.125f, 0 } };
    memcpy(uniforms.matrix, c.uniforms.mvp, sizeof uniforms.matrix);
    uniforms.matrix[2][2] = 1;
    uniforms.matrix[2][3] = 0;
    const uint32_t stride = sizeof corners[0];
    c.draw = (GpDraw){
        .program = &exercise_color,
        .uniforms = &uniforms,
        .geometry = { .vertex_count = 3,
                      .streams = { [GP_POSITION] = { corners[0], stride, 4, GP_FLOAT32 },
                                   [GP_COLOR] = { corners[0] + 4, stride, 4, GP_FLOAT32 },
                                   [GP_TEXCOORD0] = { corners[0] + 8, stride, 2, GP_FLOAT32 } } },
    };
    set_pass(&c);
    run_seed_everywhere(&c.pass, 7);
    float middle[4];
    const GpRect pixel = { SIDE / 2, SIDE / 2, SIDE / 2 + 1, SIDE / 2 + 1 };
    assert_int_equal(gp_surface_read_floats(c.target, 0, &pixel, middle, NULL), GP_OK);
    assert_memory_not_equal(middle, black, sizeof middle);
    gp_surface_destroy(&c.target);
}

/* Each corner is beyond another side of the guard band: no plane has all of them outside. */
static void a_triangle_beyond_three_sides_covers_what_it_holds(void **state)
{
    (void)state;
    static const float plain[3][2] = { { -1, 3 }, { 3, -1 }, { -1, -1 } };
    static const float wide[3][2] = { { -1000, -5 }, { 0, 1000 }, { 1000, -5 } };
    Random random = { 1 };
    for (int turn = 0; turn < 12; turn++) {
        uint64_t hash[2];
        for (int i = 0; i < 2; i++) {
            Clipped c;
            open_case(&random, &c);
            c.draw.geometry.vertex_count = 3;
            for (int k = 0; k < 3; k++) {
                const int from = (turn / 2 + (turn % 2 ? 3 - k : k)) % 3;
                const float *corner = i ? wide[from] : plain[from];
                c.corners[0][k][0] = corner[0];
                c.corners[0][k][1] = i && turn / 6 ? -corner[1] : corner[1];
                c.corners[0][k][2] = 0;
            }
            set_pass(&c);
            run_seed_everywhere(&c.pass, turn);
            hash[i] = gp_surface_hash(c.target);
            gp_surface_destroy(&c.target);
        }
        assert_int_equal(hash[0], hash[1]);
    }
}

/* One edge is as long as edges are, and runs by the target at some rows' distance: of two rows, or
 * columns, at the end of tiles it is far outside or inside, where its value hardly fits into 32
 * bits. */
static void long_edges_pass_by_as_they_do_in_the_reference(void **state)
{
    (void)state;
    Random random = { 9 };
    for (int seed = 0; seed < 24; seed++) {
        Clipped c;
        const int along = seed % 2;
        open_case(&random, &c);
        for (int t = 0; t < TRIANGLES; t++)
            for (int k = 0; k < 3; k++) {
                float *corner = c.corners[t][k];
                const float far = (float)random_int(&random, 20000, 32000), side = SIDE / 2;
                const bool last = k == 2;
                corner[along] = (k == 1 ? -far : far) / side;
                corner[!along] =
                    (last ? (t % 2 ? far : -far) : random_float(&random, -500, 500)) / side;
                corner[2] = 0;
            }
        const int32_t end = 64 * random_int(&random, 1, SIDE / 64);
        GpRasterState *raster = &c.draw.state.raster;
        raster->scissor = true;
        *(along ? &raster->scissor_x0 : &raster->scissor_y0) = end - 2;
        *(along ? &raster->scissor_x1 : &raster->scissor_y1) = end;
        *(along ? &raster->scissor_y1 : &raster->scissor_x1) = SIDE;
        set_pass(&c);
        run_seed_everywhere(&c.pass, seed);
        gp_surface_destroy(&c.target);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(long_edges_pass_by_as_they_do_in_the_reference),
        cmocka_unit_test(a_triangle_beyond_three_sides_covers_what_it_holds),
        cmocka_unit_test(planes_of_any_size_cut_as_the_reference_does),
        cmocka_unit_test(what_planes_cut_away_is_not_shaded),
        cmocka_unit_test(triangles_with_no_corner_inside_have_their_colours),
    };
    return cmocka_run_group_tests_name("clipping, fast", tests, NULL, NULL);
}
