/* Passes that draw again what an earlier one drew, but for one thing: what is kept of the earlier
 * serves them only where that thing does not matter. On every device the bits are the
 * reference's. */
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { SIDE = 96, TRIANGLES = 48, CORNER_FLOATS = 10 };

typedef struct Repeat {
    float corners[3 * TRIANGLES][CORNER_FLOATS], others[3 * TRIANGLES][CORNER_FLOATS];
    ExerciseUniforms uniforms, same, other;
    GpProgram variant; /* of exercise_color, whose vertex shader it has */
    GpSurface *color, *second, *depth, *texture;
    GpDraw draws[3][2];
    GpPass passes[3];
    GpList list;
} Repeat;

static void scatter(Random *random, float corners[3 * TRIANGLES][CORNER_FLOATS])
{
    for (int i = 0; i < 3 * TRIANGLES; i++)
        for (int c = 0; c < CORNER_FLOATS; c++)
            corners[i][c] = c == 3 ? 1 : random_float(random, c == 2 || c > 3 ? 0 : -1.1f, 1);
}

static void point_at(GpDraw *draw, float corners[3 * TRIANGLES][CORNER_FLOATS])
{
    const uint32_t stride = CORNER_FLOATS * sizeof(float);
    draw->geometry.vertex_count = 3 * TRIANGLES;
    draw->geometry.streams[GP_POSITION] = (GpStream){ corners[0], stride, 4, GP_FLOAT32 };
    draw->geometry.streams[GP_COLOR] = (GpStream){ corners[0] + 4, stride, 4, GP_FLOAT32 };
    draw->geometry.streams[GP_NORMAL] = draw->geometry.streams[GP_COLOR];
    draw->geometry.streams[GP_TEXCOORD0] = (GpStream){ corners[0] + 8, stride, 2, GP_FLOAT32 };
}

/* Three passes of the same triangles, all shaded and added up. */
static void begin(Repeat *r)
{
    Random random = { 3 };
    memset(r, 0, sizeof *r);
    scatter(&random, r->corners);
    scatter(&random, r->others);
    for (int i = 0; i < 4; i++)
        r->uniforms.matrix[i][i] = 1;
    r->uniforms.color[1] = 0.25f;
    r->same = r->other = r->uniforms;
    r->other.matrix[0][3] = 0.5f;
    r->variant = exercise_color;
    GpSurfaceDesc desc = { .format = GP_A16B16G16R16F, .width = SIDE, .height = SIDE };
    assert_int_equal(gp_surface_create(&desc, &r->color, NULL), GP_OK);
    assert_int_equal(gp_surface_create(&desc, &r->second, NULL), GP_OK);
    assert_int_equal(gp_surface_create(&desc, &r->texture, NULL), GP_OK);
    desc.format = GP_D24S8;
    assert_int_equal(gp_surface_create(&desc, &r->depth, NULL), GP_OK);
    for (int p = 0; p < 3; p++) {
        for (int d = 0; d < 2; d++) {
            GpDraw *draw = &r->draws[p][d];
            *draw = (GpDraw){ .program = &exercise_color, .uniforms = &r->uniforms };
            draw->state.blend[0] = (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
            draw->state.blend[1] = draw->state.blend[0];
            point_at(draw, r->corners);
        }
        r->passes[p] = (GpPass){ .color = { { .surface = r->color, .clear = p == 0 },
                                            { .surface = r->second, .clear = p == 0 } },
                                 .depth = { .surface = r->depth,
                                            .clear_depth = p == 0,
                                            .clear_stencil = p == 0,
                                            .depth_value = 0.75f },
                                 .draws = r->draws[p],
                                 .draw_count = 1 };
    }
    r->list = (GpList){ r->passes, 3 };
}

static void finish(Repeat *r, const char *what)
{
    GpError error;
    if (gp_list_check(&r->list, &error))
        fail_msg("%s: %s", what, error.text);
    run_list_everywhere(&r->list, what);
    GpSurface **all[] = { &r->color, &r->second, &r->depth, &r->texture };
    for (size_t i = 0; i < GP_COUNT(all); i++)
        gp_surface_destroy(all[i]);
}

/* What is done to the draw, or the pass, in the middle. */
#define OTHER(change)                                                                              \
    do {                                                                                           \
        Repeat r;                                                                                  \
        begin(&r);                                                                                 \
        GpDraw *draw = &r.draws[1][0];                                                             \
        GpPass *pass = &r.passes[1];                                                               \
        GpRasterState *raster = &draw->state.raster;                                               \
        (void)pass, (void)raster;                                                                  \
        change;                                                                                    \
        finish(&r, #change);                                                                       \
    } while (0)

static void primitives_that_differ_in_one_thing(void **state)
{
    (void)state;
    OTHER((void)draw);
    OTHER(draw->uniforms = &r.same);
    OTHER(draw->uniforms = &r.other);
    OTHER(point_at(draw, r.others));
    OTHER(draw->geometry.vertex_count -= 3);
    OTHER(draw->geometry.primitive = GP_TRIANGLE_STRIP);
    OTHER(draw->geometry.primitive = GP_POINTS);
    OTHER(draw->viewport = ((GpViewport){ .x = 7, .y = 9, .width = 60, .height = 50 }));
    OTHER(draw->viewport = ((GpViewport){ .max_depth = 0.5f }));
    OTHER(raster->cull = GP_CULL_CW);
    OTHER((raster->scissor = true, raster->scissor_x1 = 50, raster->scissor_y1 = 40));
    OTHER(raster->depth_bias = 0.25f);
    OTHER((raster->clip_planes = 1, raster->clip_plane[0][0] = 1));
    OTHER(pass->draw_count = 2);
    OTHER((pass->draw_count = 2, point_at(&r.draws[1][1], r.others)));
    OTHER(pass->draw_count = 0);
    OTHER(pass->order = GP_ORDER_DEPTH);
    OTHER(r.passes[0].order = GP_ORDER_DEPTH);
}

static void programs_that_differ_in_one_thing(void **state)
{
    (void)state;
    OTHER(draw->program = &exercise_flat);
    OTHER(draw->program = &exercise_position);
    OTHER(draw->program = &exercise_targets2);
    OTHER(draw->program = &exercise_depth_only);
    OTHER((r.variant.varyings[0].mode = GP_LINEAR_SCREEN, draw->program = &r.variant));
    OTHER((r.variant.varyings[1].mode = GP_PERSPECTIVE, draw->program = &r.variant));
    OTHER((r.variant.varyings[2].mode = GP_PERSPECTIVE, draw->program = &r.variant));
    OTHER((r.variant.inputs[1].semantic = GP_NORMAL, draw->program = &r.variant));
    OTHER((r.variant.uniform_bytes -= sizeof r.uniforms.scale, draw->program = &r.variant));
    OTHER((r.variant.vertex_samplers = 1, draw->textures[0].surface = r.texture,
           draw->program = &r.variant));
    OTHER((r.variant.uses_face = true, draw->program = &r.variant));
    OTHER((r.variant.uses_pixel = true, draw->program = &r.variant));
    OTHER((r.variant.uses_derivatives = true, draw->program = &r.variant));
    OTHER((r.variant.may_discard = true, draw->program = &r.variant));
}

static void tests_and_blends_that_differ_in_one_thing(void **state)
{
    (void)state;
    OTHER(draw->state.depth = ((GpDepthState){ .test = GP_LESS }));
    OTHER(draw->state.depth = ((GpDepthState){ .test = GP_LESS, .write = true }));
    OTHER(draw->state.depth = ((GpDepthState){ GP_LESS_EQUAL, true, true, 0.1f }));
    OTHER(draw->state.stencil =
              ((GpStencilState){ .enable = true, .front = { .pass = GP_STENCIL_INCR } }));
    OTHER(draw->state.alpha_test = ((GpAlphaTest){ GP_GREATER, 100 }));
    OTHER(draw->state.blend[0].dst = GP_INV_SRC_ALPHA);
    OTHER(draw->state.blend[0].op = GP_BLEND_MAX);
    OTHER(draw->state.blend[0] = (GpBlend){ .op = GP_BLEND_OFF });
    OTHER(draw->state.blend[0].keep = 15);
    OTHER(pass->color[1] = (GpColorTarget){ .surface = NULL });
    OTHER(pass->depth = (GpDepthTarget){ .surface = NULL });
    OTHER((pass->color[0].clear = true, pass->color[0].clear_color[2] = 0.5f));
}

/* More repeats in a group than are kept of it (64), and a repeat of what lies further back. */
static void many_that_are_repeated(void **state)
{
    (void)state;
    enum { PASSES = 136 };
    Repeat r;
    begin(&r);
    static GpPass passes[PASSES];
    static GpDraw draws[PASSES];
    static ExerciseUniforms uniforms[PASSES];
    for (int p = 0; p < PASSES; p++) {
        uniforms[p] = r.uniforms;
        uniforms[p].matrix[0][3] = 0.125f * (float)(p / 2 % 6);
        draws[p] = r.draws[0][0];
        draws[p].uniforms = &uniforms[p];
        draws[p].viewport = (GpViewport){ .width = 24, .height = 24 };
        passes[p] = r.passes[p ? 1 : 0];
        passes[p].draws = &draws[p];
    }
    r.list = (GpList){ passes, PASSES };
    finish(&r, "many");
}

/* A pass of so many draws is drawn in parts, of which the next one repeats none. */
static void a_pass_that_is_drawn_in_parts_is_not_repeated(void **state)
{
    (void)state;
    enum { DRAWS = 4100 };
    Repeat r;
    begin(&r);
    static GpDraw draws[DRAWS];
    for (int i = 0; i < DRAWS; i++) {
        draws[i] = r.draws[0][0];
        draws[i].geometry.vertex_count = 3;
        draws[i].viewport = (GpViewport){ .width = 12, .height = 12 };
        for (int s = 0; s < GP_SEMANTICS; s++) {
            const GpStream *all = &r.draws[0][0].geometry.streams[s];
            if (all->data)
                draws[i].geometry.streams[s].data =
                    (const uint8_t *)all->data + (size_t)(i % TRIANGLES * 3) * all->stride;
        }
    }
    for (int p = 0; p < 2; p++) {
        r.passes[p].draws = draws;
        r.passes[p].draw_count = DRAWS;
    }
    r.list.pass_count = 2;
    finish(&r, "in parts");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(primitives_that_differ_in_one_thing),
        cmocka_unit_test(programs_that_differ_in_one_thing),
        cmocka_unit_test(tests_and_blends_that_differ_in_one_thing),
        cmocka_unit_test(many_that_are_repeated),
        cmocka_unit_test(a_pass_that_is_drawn_in_parts_is_not_repeated),
    };
    return cmocka_run_group_tests_name("repeats", tests, NULL, NULL);
}
