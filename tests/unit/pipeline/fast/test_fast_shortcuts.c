/* Draws for which there is a shorter way, and the same but for one thing, for which there is none:
 * tiles of one colour that are covered whole, words that are brought over, triangles of one colour.
 * On every device the bits are the reference's. */
#include "shaders_c/common/texel_copy.h"
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { WIDTH = 300, HEIGHT = 200, TRIANGLES = 40, CORNER_FLOATS = 10, CORNERS = 3 * TRIANGLES };

typedef struct Case {
    float corners[CORNERS][CORNER_FLOATS];
    uint32_t indices[CORNERS];
    ExerciseUniforms uniforms;
    GpProgram program;
    GpSurface *from, *to, *depth, *texture;
    GpDraw draw;
    GpPass passes[2];
    GpList list;
} Case;

static GpSurface *surface(GpFormat format)
{
    GpSurface *s = NULL;
    const GpSurfaceDesc desc = { .format = format, .width = WIDTH, .height = HEIGHT };
    assert_int_equal(gp_surface_create(&desc, &s, NULL), GP_OK);
    return s;
}

static void point_at(Case *c, uint32_t count)
{
    const uint32_t stride = sizeof c->corners[0];
    c->draw.geometry = (GpGeometry){
        .vertex_count = count,
        .streams = { [GP_POSITION] = { c->corners[0], stride, 4, GP_FLOAT32 },
                     [GP_COLOR] = { c->corners[0] + 4, stride, 4, GP_FLOAT32 },
                     [GP_TEXCOORD0] = { c->corners[0] + 8, stride, 2, GP_FLOAT32 } },
    };
}

static void begin(Case *c, const GpProgram *program)
{
    memset(c, 0, sizeof *c);
    for (int i = 0; i < 4; i++)
        c->uniforms.matrix[i][i] = 1;
    for (uint32_t i = 0; i < CORNERS; i++)
        c->indices[i] = i;
    c->program = *program;
    c->from = surface(GP_A8R8G8B8);
    c->to = surface(GP_A8R8G8B8);
    c->depth = surface(GP_D24S8);
    c->texture = surface(GP_A8R8G8B8);
    gp_surface_clear_color(c->texture, (float[]){ 0.1f, 0.2f, 0.3f, 0.4f });
    c->draw = (GpDraw){ .program = &c->program, .uniforms = &c->uniforms };
    c->passes[0] = (GpPass){ .color = { { .surface = c->from,
                                          .clear = true,
                                          .clear_color = { 0.2f, 0.7f, 0.4f, 0.6f } } } };
    c->passes[1] = (GpPass){
        .color = { { .surface = c->to, .clear = true, .clear_color = { 0.9f, 0.3f, 0.1f, 0.8f } } },
        .draws = &c->draw,
        .draw_count = 1
    };
    c->list = (GpList){ c->passes, 2 };
}

/* One triangle that covers the target, with texels of `from` in place. */
static void begin_cover(Case *c)
{
    static const float corners[3][2] = { { -1, 1 }, { 3, 1 }, { -1, -3 } };
    begin(c, &texel_copy_program);
    for (int i = 0; i < CORNERS; i++)
        memcpy(c->corners[i], (float[]){ corners[i % 3][0], corners[i % 3][1], 0.25f, 1 }, 16);
    point_at(c, 3);
    c->draw.textures[0].surface = c->from;
}

/* Triangles of one colour each, of which the nearest fragments are shaded. */
static void begin_flat(Case *c)
{
    Random random = { 8 };
    begin(c, &exercise_flat);
    for (int i = 0; i < CORNERS; i++)
        for (int k = 0; k < CORNER_FLOATS; k++)
            c->corners[i][k] = k == 3 ? 1 : random_float(&random, k == 2 || k > 3 ? 0 : -1, 1);
    point_at(c, CORNERS);
    c->passes[1].depth = (GpDepthTarget){
        .surface = c->depth, .clear_depth = true, .clear_stencil = true, .depth_value = 0.9f
    };
    c->draw.state.depth = (GpDepthState){ .test = GP_LESS };
    c->draw.state.blend[0] =
        (GpBlend){ .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA };
    c->passes[1].order = GP_ORDER_DEPTH;
    for (int i = 0; i < GP_MAX_SAMPLERS; i++)
        c->draw.textures[i].surface = c->texture;
}

/* Opaque triangles, of which the last covers the target. */
static void begin_hidden(Case *c)
{
    begin_flat(c);
    c->program = exercise_color;
    c->passes[1].order = GP_ORDER_SUBMITTED;
    c->passes[1].depth = (GpDepthTarget){ .surface = NULL };
    memset(&c->draw.state, 0, sizeof c->draw.state);
    for (int i = 0; i < 3; i++) {
        float *corner = c->corners[CORNERS - 3 + i];
        corner[0] = i == 1 ? 3 : -1;
        corner[1] = i == 2 ? -3 : 1;
    }
}

static void give_target(Case *c, GpFormat format)
{
    gp_surface_destroy(&c->to);
    c->passes[1].color[0].surface = c->to = surface(format);
}

static void give_source(Case *c, GpFormat format)
{
    gp_surface_destroy(&c->from);
    c->draw.textures[0].surface = c->passes[0].color[0].surface = c->from = surface(format);
}

static void finish(Case *c, const char *what)
{
    GpError error;
    if (gp_list_check(&c->list, &error))
        fail_msg("%s: %s", what, error.text);
    const float before[4] = { 0.5f, 0.25f, 0.75f, 0.125f };
    gp_surface_clear_color(c->to, before);
    gp_surface_clear_color_rect(c->from, (GpRect){ 9, 7, 60, 150 }, before);
    run_list_everywhere(&c->list, what);
    GpSurface **all[] = { &c->from, &c->to, &c->depth, &c->texture };
    for (size_t i = 0; i < GP_COUNT(all); i++)
        gp_surface_destroy(all[i]);
}

/* What is done to the draw, or to its pass. */
#define OTHER(begin_it, change)                                                                    \
    do {                                                                                           \
        Case c;                                                                                    \
        begin_it(&c);                                                                              \
        GpState *s = &c.draw.state;                                                                \
        GpRasterState *raster = &s->raster;                                                        \
        GpPass *pass = &c.passes[1];                                                               \
        (void)s, (void)raster, (void)pass;                                                         \
        change;                                                                                    \
        finish(&c, #change);                                                                       \
    } while (0)

static void depth_target(Case *c)
{
    c->passes[1].depth =
        (GpDepthTarget){ .surface = c->depth, .clear_depth = true, .depth_value = 0.5f };
}

static void even_tiles_but_for_one_thing(void **state)
{
    (void)state;
    OTHER(begin_cover, (void)pass);
    OTHER(begin_cover, c.program = texel_complement_program);
    OTHER(begin_cover, c.passes[0].color[0].clear = false);
    OTHER(begin_cover, pass->color[0].clear = false);
    OTHER(begin_cover, point_at(&c, 6));                           /* twice the same */
    OTHER(begin_cover, (point_at(&c, 6), c.corners[3][0] = 0.5f)); /* a second one in a part */
    OTHER(begin_cover, (point_at(&c, 6), c.corners[3][0] = c.corners[4][0] = c.corners[5][0] = 7));
    OTHER(begin_cover, (c.corners[0][0] = -0.5f));
    OTHER(begin_cover, (c.corners[0][0] = 0.9f)); /* tiles in its box of which it covers nothing */
    OTHER(begin_cover, (c.corners[1][2] = 2));    /* beyond the far plane */
    OTHER(begin_cover, (c.corners[2][3] = -1));
    OTHER(begin_cover, (c.draw.geometry.indices = c.indices, c.draw.geometry.index_count = 3));
    OTHER(begin_cover, (c.draw.geometry.indices = c.indices, c.draw.geometry.index_count = 3,
                        c.indices[0] = 2, c.indices[2] = 0));
    OTHER(begin_cover, c.draw.geometry.primitive = GP_POINTS);
    OTHER(begin_cover, c.draw.viewport = ((GpViewport){ .width = 150, .height = HEIGHT }));
    OTHER(begin_cover, c.draw.viewport = ((GpViewport){ .width = WIDTH, .height = 100 }));
    OTHER(begin_cover, raster->cull = GP_CULL_CW);
    OTHER(begin_cover, raster->cull = GP_CULL_CCW);
    OTHER(begin_cover,
          (raster->scissor = true, raster->scissor_x1 = 50, raster->scissor_y1 = HEIGHT));
    OTHER(begin_cover, (raster->clip_planes = 1, raster->clip_plane[0][0] = 1));
    OTHER(begin_cover, (raster->clip_planes = 1, raster->clip_plane[0][3] = 1));
    OTHER(begin_cover, s->alpha_test = ((GpAlphaTest){ GP_GREATER, 100 }));
    OTHER(begin_cover, (depth_target(&c), s->depth.test = GP_LESS));
    OTHER(begin_cover, (depth_target(&c), s->depth.test = GP_GREATER));
    OTHER(begin_cover, c.program.uses_pixel = true);
    OTHER(begin_cover, c.program.uses_face = true);
    OTHER(begin_cover, c.program.uses_derivatives = true);
    OTHER(begin_cover, c.program.may_discard = true);
    for (GpBlendOp op = GP_BLEND_ADD; op < GP_BLEND_OPS; op++) {
        OTHER(begin_cover, s->blend[0] = ((GpBlend){ .op = op, .src = GP_ONE, .dst = GP_ONE }));
        OTHER(begin_cover, s->blend[0] = ((GpBlend){ .op = op, .keep = 5 }));
    }
}

/* Layers that cover tiles and add the same everywhere: one packet tells what all are. */
static void begin_layers(Case *c)
{
    begin_cover(c);
    point_at(c, 9);
    c->draw.state.blend[0] = (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
    c->draw.textures[1].surface = c->texture;
}

static void copies_between_all_formats(void **state)
{
    (void)state;
    for (GpFormat format = GP_FORMAT_NONE + 1; format < GP_FORMATS; format++)
        if (gp_format_info(format)->is_target) {
            OTHER(begin_cover, give_target(&c, format));
            OTHER(begin_cover, give_source(&c, format));
            OTHER(begin_cover, (give_target(&c, format), give_source(&c, format)));
            OTHER(begin_cover, (give_target(&c, format), pass->color[0].clear = false,
                                c.passes[0].color[0].clear = false));
            OTHER(begin_layers, (give_source(&c, format), c.passes[0].color[0].clear = false,
                                 s->blend[0] = ((GpBlend){ .op = GP_BLEND_LOGIC_OR })));
        }
}

static void even_layers_but_for_one_thing(void **state)
{
    (void)state;
    OTHER(begin_layers, (void)pass);
    OTHER(begin_layers,
          c.corners[3][0] = c.corners[5][0] = -0.9f);              /* a box of its own: it begins */
    OTHER(begin_layers, c.corners[3][1] = c.corners[4][1] = 0.9f); /* further on, or ends earlier */
    OTHER(begin_layers, (c.corners[3][0] = c.corners[5][0] = 0.9f, c.corners[4][0] = -3));
    OTHER(begin_layers, (c.corners[3][1] = c.corners[4][1] = -0.9f, c.corners[5][1] = 3));
    OTHER(begin_layers, c.program.samplers = 2);
    OTHER(begin_layers, c.program.uses_pixel = true);
    OTHER(begin_layers, c.program.uses_face = true);
    OTHER(begin_layers, c.program.may_discard = true);
    OTHER(begin_layers, s->alpha_test = ((GpAlphaTest){ GP_GREATER, 100 }));
    OTHER(begin_layers, s->alpha_test = ((GpAlphaTest){ GP_GREATER, 200 }));
}

/* So that several are found at a time. */
static void make_small(Case *c)
{
    for (int i = 0; i < CORNERS; i++)
        for (int k = 0; k < 2 && i % 3; k++)
            c->corners[i][k] = c->corners[i - i % 3][k] + 0.1f * c->corners[i][k];
}

static void triangles_of_one_colour_but_for_one_thing(void **state)
{
    (void)state;
    OTHER(begin_flat, (void)pass);
    OTHER(begin_flat, pass->order = GP_ORDER_DEPTH_NEAR_FIRST);
    OTHER(begin_flat, pass->order = GP_ORDER_SUBMITTED);
    OTHER(begin_flat, c.draw.geometry.primitive = GP_POINTS);
    OTHER(begin_flat, c.draw.geometry.primitive = GP_TRIANGLE_STRIP);
    OTHER(begin_flat, c.program.varyings[0].mode = GP_PERSPECTIVE);
    OTHER(begin_flat, c.program.varyings[0].mode = GP_LINEAR_SCREEN);
    OTHER(begin_flat, c.program.uses_pixel = true);
    OTHER(begin_flat, c.program.uses_derivatives = true);
    OTHER(begin_flat, c.program.may_discard = true);
    OTHER(begin_flat, c.program.samplers = 2);
    OTHER(begin_flat, c.program.local_reads = 2);
    OTHER(begin_flat, s->alpha_test = ((GpAlphaTest){ GP_GREATER, 100 }));
    OTHER(begin_flat, (raster->clip_planes = 1, raster->clip_plane[0][0] = 1));
    OTHER(begin_flat,
          (raster->scissor = true, raster->scissor_x1 = 50, raster->scissor_y1 = HEIGHT));
    OTHER(begin_flat, (c.program = exercise_depth, c.program.varyings[0].mode = GP_FLAT,
                       c.program.varyings[1].mode = GP_FLAT));
    OTHER(begin_flat, s->depth.write = true);
    OTHER(begin_flat, s->depth = ((GpDepthState){ .test = GP_ALWAYS }));
    OTHER(begin_flat, s->depth = ((GpDepthState){ GP_LESS_EQUAL, true, true, 0.1f }));
    OTHER(begin_flat, (s->stencil.enable = true, s->stencil.front.pass = GP_STENCIL_INCR));
    OTHER(begin_flat, (make_small(&c), s->stencil.enable = s->stencil.two_sided = true,
                       s->stencil.reference = 3, s->stencil.back.pass = GP_STENCIL_REPLACE));
    OTHER(begin_flat, s->blend[0].op = GP_BLEND_OFF);
    OTHER(begin_flat, s->blend[0].keep = 15);
    OTHER(begin_flat, (c.program = exercise_targets2, pass->color[1].surface = c.from,
                       s->blend[1] = s->blend[0], s->blend[0].keep = 15));
    for (GpFormat format = GP_FORMAT_NONE + 1; format < GP_FORMATS; format++)
        if (gp_format_info(format)->is_target)
            OTHER(begin_flat, give_target(&c, format));
}

/* A scissor that leaves out a part on one side, or ends beyond the target. */
static GpRasterState scissor(int32_t x0, int32_t y0, int32_t x1, int32_t y1)
{
    return (GpRasterState){
        .scissor = true, .scissor_x0 = x0, .scissor_y0 = y0, .scissor_x1 = x1, .scissor_y1 = y1
    };
}

static void hidden_tiles_but_for_one_thing(void **state)
{
    (void)state;
    static const GpViewport viewports[] = { { .width = WIDTH, .height = 100 },
                                            { .width = 100, .height = HEIGHT },
                                            { .x = 0, .y = 77, .width = WIDTH, .height = 123 },
                                            { .x = 77, .y = 0, .width = 223, .height = HEIGHT },
                                            { .x = -50, .y = -50, .width = 400, .height = 300 },
                                            { .x = 64, .y = 64, .width = 128, .height = 64 } };
    OTHER(begin_hidden, (void)pass);
    for (size_t i = 0; i < GP_COUNT(viewports); i++)
        OTHER(begin_hidden, c.draw.viewport = viewports[i]);
    OTHER(begin_hidden, *raster = scissor(0, 0, WIDTH, 100));
    OTHER(begin_hidden, *raster = scissor(0, 0, 100, HEIGHT));
    OTHER(begin_hidden, *raster = scissor(0, 77, WIDTH, HEIGHT));
    OTHER(begin_hidden, *raster = scissor(77, 0, WIDTH, HEIGHT));
    OTHER(begin_hidden, *raster = scissor(-9, -9, WIDTH + 9, HEIGHT + 9));
    OTHER(begin_hidden, (raster->clip_planes = 1, raster->clip_plane[0][1] = 1));
    OTHER(begin_hidden, c.corners[CORNERS - 2][0] = 2.5f);
    OTHER(begin_hidden, c.corners[CORNERS - 1][1] = -2.5f);
    OTHER(begin_hidden, (depth_target(&c), s->depth = ((GpDepthState){ GP_LESS, true, false, 0 })));
    OTHER(begin_hidden, s->alpha_test = ((GpAlphaTest){ GP_GREATER, 100 }));
    OTHER(begin_hidden, s->blend[0].keep = 6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(even_tiles_but_for_one_thing),
        cmocka_unit_test(copies_between_all_formats),
        cmocka_unit_test(even_layers_but_for_one_thing),
        cmocka_unit_test(hidden_tiles_but_for_one_thing),
        cmocka_unit_test(triangles_of_one_colour_but_for_one_thing),
    };
    return cmocka_run_group_tests_name("shortcuts", tests, NULL, NULL);
}
