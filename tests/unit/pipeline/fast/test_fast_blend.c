/* Every operation with every pair of factors into every format of a target: cells of one picture,
 * in which large and tiny triangles are blended by one state each. On every device the bits are the
 * reference's. */
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

enum { SIDE = 8, CELLS = 27, MOST = CELLS * CELLS, CORNER_FLOATS = 10, TINY = 32 };

static GpBlend blends[MOST];
static int blend_count;

static void add_blend(GpBlend blend)
{
    assert_true(blend_count < MOST);
    blend.keep = (uint8_t)(blend_count % 5 ? 0 : blend_count / 5 % 15);
    blends[blend_count++] = blend;
}

/* Colour by all states; then alpha by one of its own, of which the factors are all pairs. */
static void list_blends(void)
{
    blend_count = 0;
    for (GpBlendOp op = GP_BLEND_OFF; op < GP_BLEND_OPS; op++)
        for (GpBlendFactor src = 0; src < GP_BLEND_FACTORS; src++)
            for (GpBlendFactor dst = 0; dst < GP_BLEND_FACTORS; dst++) {
                const bool has_factors = op >= GP_BLEND_ADD && op <= GP_BLEND_REV_SUBTRACT;
                if (dst != GP_SRC_ALPHA_SAT && (has_factors || (src == 0 && dst == 0)))
                    add_blend((GpBlend){ .op = op, .src = src, .dst = dst });
            }
    for (GpBlendFactor src = 0; src < GP_BLEND_FACTORS; src++)
        for (GpBlendFactor dst = 0; dst < GP_BLEND_FACTORS; dst++)
            if (dst != GP_SRC_ALPHA_SAT)
                add_blend((GpBlend){ .op = GP_BLEND_ADD,
                                     .src = GP_SRC_ALPHA,
                                     .dst = GP_INV_SRC_ALPHA,
                                     .alpha_op = (GpBlendOp)(1 + (src + dst) % 5),
                                     .alpha_src = src,
                                     .alpha_dst = dst });
}

/* States that have code of their own where they are exactly these, and each with one thing
 * changed. */
static void list_neighbours(void)
{
    static const GpBlend known[] = {
        { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE },
        { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA },
        { .op = GP_BLEND_ADD, .src = GP_INV_DEST_ALPHA, .dst = GP_ONE },
        { GP_BLEND_ADD, GP_ONE, GP_SRC_ALPHA, GP_BLEND_ADD, GP_ZERO, GP_SRC_ALPHA, 0 },
        { GP_BLEND_ADD, GP_DEST_ALPHA, GP_ONE, GP_BLEND_ADD, GP_ZERO, GP_SRC_ALPHA, 0 },
    };
    enum { CHANGES = 8 };
    for (size_t i = 0; i < CHANGES * GP_COUNT(known); i++) {
        GpBlend blend = known[i / CHANGES];
        const bool separate = blend.alpha_op != GP_BLEND_OFF;
        switch (i % CHANGES) {
        case 1:
            blend.src = GP_DEST_COLOR;
            break;
        case 2:
            blend.dst = GP_DEST_COLOR;
            break;
        case 3:
            blend.op = GP_BLEND_SUBTRACT;
            break;
        case 4:
            blend.alpha_op = separate ? GP_BLEND_OFF : GP_BLEND_MAX;
            break;
        case 5:
            blend.alpha_src = GP_DEST_COLOR;
            break;
        case 6:
            blend.alpha_dst = GP_DEST_COLOR;
            break;
        case 7:
            blend.keep = 2;
            break;
        default:
            break;
        }
        assert_true(blend_count < MOST);
        blends[blend_count++] = blend;
    }
}

/* Bits are combined in unorm targets alone. */
static GpBlend blend_for(GpFormat format, int number)
{
    GpBlend blend = blends[number % blend_count];
    if (gp_blend_is_logic(blend.op) && gp_format_info(format)->is_float)
        blend.op = GP_BLEND_MAX;
    return blend;
}

/* A triangle that covers a cell, or tiny ones all over it; colours from -0.5 to 1.5. */
static uint32_t make_corners(bool tiny, float corners[3 * TINY][CORNER_FLOATS])
{
    const int triangles = tiny ? TINY : 1;
    const float size = tiny ? 0.3f : 4;
    for (int i = 0; i < 3 * triangles; i++) {
        const int triangle = i / 3, k = i % 3;
        const float x = (tiny ? -1 + 0.25f * (float)(triangle % 8) : -1) + (k == 1 ? size : 0);
        const float y = (tiny ? -1 + 0.5f * (float)(triangle / 8) : -1) + (k == 2 ? size : 0);
        const float corner[CORNER_FLOATS] = { x,
                                              y,
                                              0,
                                              1,
                                              -0.5f + (float)k,
                                              0.25f + 0.5f * (float)(i % 2),
                                              1.5f - (float)k,
                                              0.125f + 0.4f * (float)k,
                                              x,
                                              y };
        memcpy(corners[i], corner, sizeof corner);
    }
    return (uint32_t)(3 * triangles);
}

/* As many formats as a pass has targets, from one on. */
static int take_formats(GpFormat *next, GpFormat formats[GP_MAX_TARGETS])
{
    int count = 0;
    for (; *next < GP_FORMATS && count < GP_MAX_TARGETS; ++*next)
        if (gp_format_info(*next)->is_target)
            formats[count++] = *next;
    for (int i = count; count && i < GP_MAX_TARGETS; i++)
        formats[i] = formats[0];
    return count;
}

static void draw_cells(const GpFormat formats[GP_MAX_TARGETS], bool tiny)
{
    static GpDraw draws[MOST];
    static float corners[3 * TINY][CORNER_FLOATS];
    ExerciseUniforms uniforms = { .color = { 0.75f, -0.25f, 1.25f, 0.5f } };
    for (int i = 0; i < 4; i++)
        uniforms.matrix[i][i] = 1;
    GpPass pass = { .draws = draws, .draw_count = (uint32_t)blend_count };
    const GpSurfaceDesc size = { .width = SIDE * CELLS, .height = SIDE * CELLS };
    for (int t = 0; t < GP_MAX_TARGETS; t++) {
        GpSurfaceDesc desc = size;
        desc.format = formats[t];
        assert_int_equal(gp_surface_create(&desc, &pass.color[t].surface, NULL), GP_OK);
        pass.color[t].clear = true;
        memcpy(pass.color[t].clear_color, (float[]){ 0.6f, 0.3f, 0.9f, 0.4f }, 4 * sizeof(float));
    }
    const uint32_t count = make_corners(tiny, corners), stride = sizeof corners[0];
    for (int i = 0; i < blend_count; i++) {
        draws[i] = (GpDraw){
            .program = &exercise_targets4,
            .uniforms = &uniforms,
            .geometry = { .vertex_count = count,
                          .streams = { [GP_POSITION] = { corners[0], stride, 4, GP_FLOAT32 },
                                       [GP_COLOR] = { corners[0] + 4, stride, 4, GP_FLOAT32 },
                                       [GP_TEXCOORD0] = { corners[0] + 8, stride, 2,
                                                          GP_FLOAT32 } } },
            .viewport = { .x = (float)(i % CELLS * SIDE),
                          .y = (float)(i / CELLS * SIDE),
                          .width = SIDE,
                          .height = SIDE },
            .state.blend_constant = { 0.25f, -0.5f, 1.5f, 0.75f },
        };
        for (int t = 0; t < GP_MAX_TARGETS; t++)
            draws[i].state.blend[t] = blend_for(formats[t], i + 7 * t);
    }
    run_seed_everywhere(&pass, (int)formats[0]);
    for (int t = 0; t < GP_MAX_TARGETS; t++)
        gp_surface_destroy(&pass.color[t].surface);
}

static void every_blend_into_every_format(void **state)
{
    (void)state;
    GpFormat next = GP_FORMAT_NONE + 1, formats[GP_MAX_TARGETS];
    list_blends();
    list_neighbours();
    while (take_formats(&next, formats)) {
        draw_cells(formats, false);
        draw_cells(formats, true);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(every_blend_into_every_format) };
    return cmocka_run_group_tests_name("fast blending", tests, NULL, NULL);
}
