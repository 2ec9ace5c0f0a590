/* What passes draw into, on every device: X8R8G8B8, clears of rectangles, memory of the
 * caller's. */
#include <glasspipe/glasspipe.h>
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

#include <stdlib.h>

typedef struct Vertex {
    float position[4], color[4], uv[2];
} Vertex;

/* exercise_discard gives the vertices' colour; two triangles over all of the screen. */
typedef struct Quad {
    Vertex corner[4];
    ExerciseUniforms uniforms;
    GpDraw draw;
} Quad;

static void set_up_quad(Quad *quad, const float color[4])
{
    memset(quad, 0, sizeof *quad);
    for (int i = 0; i < 4; i++) {
        Vertex *v = &quad->corner[i];
        *v = (Vertex){ .position = { i % 2 ? 1 : -1, i / 2 ? -1 : 1, 0.5f, 1 } };
        memcpy(v->color, color, sizeof v->color);
        quad->uniforms.matrix[i][i] = 1;
    }
    const Vertex *v = quad->corner;
    quad->draw = (GpDraw){ .program = &exercise_discard,
                           .uniforms = &quad->uniforms,
                           .geometry = { .primitive = GP_TRIANGLE_STRIP, .vertex_count = 4 } };
    GpStream *streams = quad->draw.geometry.streams;
    streams[GP_POSITION] = (GpStream){ v->position, sizeof *v, 4, GP_FLOAT32 };
    streams[GP_COLOR] = (GpStream){ v->color, sizeof *v, 4, GP_FLOAT32 };
    streams[GP_TEXCOORD0] = (GpStream){ v->uv, sizeof *v, 2, GP_FLOAT32 };
}

static GpSurface *make(GpFormat format, uint32_t width, uint32_t height)
{
    GpSurface *surface = NULL;
    const GpSurfaceDesc desc = { .format = format, .width = width, .height = height };
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    return surface;
}

static uint32_t word_at(const GpSurface *surface, int32_t x, int32_t y)
{
    uint32_t word;
    memcpy(&word, gp_surface_texel(&surface->level[0], 4, (uint32_t)x, (uint32_t)y), 4);
    return word;
}

/* --- X8R8G8B8 --------------------------------------------------------------------------------- */

enum { SMALL = 24 };

/* Draws (1, 0.4, 0.2, 0.6) over 0x12003366 with a blend; returns what stands there then. */
static uint32_t drawn_opaque(const GpDeviceDesc *device, const GpProgram *program, GpBlend blend)
{
    Quad quad;
    set_up_quad(&quad, (const float[4]){ 1, 0.4f, 0.2f, 0.6f });
    quad.draw.program = program;
    quad.draw.state.blend[0] = blend;
    GpSurface *target = make(GP_X8R8G8B8, SMALL, SMALL);
    for (uint32_t i = 0; i < SMALL * SMALL; i++)
        memcpy(target->level[0].texels + 4 * i, "\x66\x33\x00\x12", 4);
    const GpPass pass = { .color[0].surface = target, .draws = &quad.draw, .draw_count = 1 };
    run_list_on(device, &(GpList){ &pass, 1 });
    const uint32_t word = word_at(target, 5, 7);
    for (int i = 0; i < SMALL * SMALL; i++)
        assert_int_equal(word_at(target, i % SMALL, i / SMALL), word);
    gp_surface_destroy(&target);
    return word;
}

/* Alpha of the target reads 1, whatever its byte holds; the byte is 255 where anything is
 * stored. */
static void r37_x8r8g8b8_has_an_alpha_of_one(void **state)
{
    (void)state;
    static const struct {
        GpBlend blend;
        uint32_t expected;
    } cases[] = {
        { { .op = GP_BLEND_OFF }, 0xffff6633 },
        { { .op = GP_BLEND_ADD, .src = GP_DEST_ALPHA, .dst = GP_ZERO }, 0xffff6633 },
        { { .op = GP_BLEND_ADD, .src = GP_INV_DEST_ALPHA, .dst = GP_ONE }, 0xff003366 },
        { { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA_SAT, .dst = GP_ONE }, 0xff003366 },
        { { .op = GP_BLEND_ADD, .src = GP_ZERO, .dst = GP_DEST_ALPHA }, 0xff003366 },
        { { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE }, 0xffff9999 },
        { { .op = GP_BLEND_OFF, .keep = 1 | 4 }, 0xff006666 },
        { { .op = GP_BLEND_OFF, .keep = 7 }, 0xff003366 },
        { { .op = GP_BLEND_OFF, .keep = 15 }, 0x12003366 },
        { { .op = GP_BLEND_LOGIC_XOR }, 0xffff5555 },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        for (size_t n = 0; device_here(n); n++) {
            static const GpProgram *const programs[] = { &exercise_discard, &exercise_color };
            for (size_t p = 0; p < GP_COUNT(programs); p++) {
                const uint32_t word = drawn_opaque(device_here(n), programs[p], cases[i].blend);
                if (word != cases[i].expected)
                    fail_msg("case %zu, %s: %08x", i, device_name(device_here(n)), word);
            }
        }
}

static void x8r8g8b8_is_cleared_with_its_byte_and_left_alone_elsewhere(void **state)
{
    (void)state;
    const GpRect left = { 0, 0, SMALL / 2, SMALL };
    GpSurface *target = make(GP_X8R8G8B8, SMALL, SMALL);
    const GpPass pass = { .color[0] = { target, true, { 1, 0, 0, 0 } },
                          .clear_rects = &left,
                          .clear_rect_count = 1 };
    for (size_t n = 0; device_here(n); n++) {
        memset(target->level[0].texels, 0x21, 4 * SMALL * SMALL);
        run_list_on(device_here(n), &(GpList){ &pass, 1 });
        for (int i = 0; i < SMALL * SMALL; i++)
            assert_int_equal(word_at(target, i % SMALL, i / SMALL),
                             i % SMALL < SMALL / 2 ? 0xffff0000 : 0x21212121);
    }
    gp_surface_destroy(&target);
}

/* --- clears of rectangles --------------------------------------------------------------------- */

enum { WIDTH = 201, HEIGHT = 147 };

/* Inside, beyond every side, backwards, empty, one on the other, and one that covers whole
 * tiles. */
static const GpRect rects[] = {
    { 3, 5, 9, 6 },       { -20, -30, 7, 4 },      { 190, 140, 500, 500 }, { 50, 50, 40, 60 },
    { 70, 70, 70, 90 },   { 30, 20, 140, 135 },    { 100, 100, 160, 110 }, { -5, 120, 300, 122 },
    { 400, 0, 410, 500 }, { 128, 64, WIDTH, 128 },
};

static bool is_inside(int x, int y)
{
    for (size_t i = 0; i < GP_COUNT(rects); i++)
        if (x >= rects[i].x0 && x < rects[i].x1 && y >= rects[i].y0 && y < rects[i].y1)
            return true;
    return false;
}

/* A clear of some of colour, depth and stencil, alone or before a draw of a few pixels. */
static void check_cleared(const GpDeviceDesc *device, unsigned what, bool draws)
{
    Quad quad;
    set_up_quad(&quad, (const float[4]){ 0, 1, 0, 1 });
    quad.draw.state.raster = (GpRasterState){
        .scissor = true, .scissor_x0 = 60, .scissor_y0 = 60, .scissor_x1 = 62, .scissor_y1 = 131
    };
    GpSurface *color = make(GP_A8R8G8B8, WIDTH, HEIGHT), *depth = make(GP_D24S8, WIDTH, HEIGHT);
    memset(color->level[0].texels, 0x11, 4 * WIDTH * HEIGHT);
    memset(depth->level[0].texels, 0x22, 4 * WIDTH * HEIGHT);
    const GpPass pass = { .color[0] = { color, what & 1, { 0, 0, 1, 0 } },
                          .depth = { depth, what & 2, what & 4, 1, 0x77 },
                          .draws = &quad.draw,
                          .draw_count = draws,
                          .clear_rects = rects,
                          .clear_rect_count = GP_COUNT(rects) };
    run_list_on(device, &(GpList){ &pass, 1 });
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const bool in = is_inside(x, y), drawn = draws && x / 2 == 30 && y >= 60 && y < 131;
            const uint32_t depth_code = in && (what & 2) ? 0xffffff00 : 0x22222200;
            const uint32_t stencil = in && (what & 4) ? 0x77 : 0x22;
            const uint32_t expected = drawn              ? 0xff00ff00
                                      : in && (what & 1) ? 0x000000ff
                                                         : 0x11111111;
            if (word_at(color, x, y) != expected || word_at(depth, x, y) != (depth_code | stencil))
                fail_msg("%s, clear %u, draws %d: pixel %d, %d", device_name(device), what, draws,
                         x, y);
        }
    gp_surface_destroy(&color);
    gp_surface_destroy(&depth);
}

static void rectangles_are_cut_to_the_surface_and_scissor_is_not_asked(void **state)
{
    (void)state;
    for (size_t n = 0; device_here(n); n++)
        for (unsigned what = 1; what < 8; what++)
            for (int draws = 0; draws < 2; draws++)
                check_cleared(device_here(n), what, draws);
}

/* A later pass of a group clears a part of what an earlier one drew. */
static void a_pass_clears_a_part_of_what_was_drawn(void **state)
{
    (void)state;
    Quad quad;
    set_up_quad(&quad, (const float[4]){ 0, 1, 0, 1 });
    GpSurface *color = make(GP_A16B16G16R16F, WIDTH, HEIGHT);
    const GpPass passes[2] = {
        { .color[0].surface = color, .draws = &quad.draw, .draw_count = 1 },
        { .color[0] = { color, true, { 0.5f, 0, 0, 0 } },
          .clear_rects = rects,
          .clear_rect_count = GP_COUNT(rects) },
    };
    for (size_t n = 0; device_here(n); n++) {
        run_list_on(device_here(n), &(GpList){ passes, 2 });
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                assert_memory_equal(gp_surface_texel(&color->level[0], 8, (uint32_t)x, (uint32_t)y),
                                    is_inside(x, y) ? "\0\x38\0\0\0\0\0" : "\0\0\0\x3c\0\0\0\x3c",
                                    8);
    }
    gp_surface_destroy(&color);
}

static void note_clears(void *user, const GpTraceEvent *event)
{
    *(int *)user += event->kind == GP_TRACE_CLEAR;
}

static void a_watched_pixel_is_cleared_where_a_rectangle_has_it(void **state)
{
    (void)state;
    static const int places[][3] = { { 3, 5, 1 }, { 9, 5, 0 }, { 0, 0, 1 }, { 7, 4, 0 } };
    GpSurface *color = make(GP_A8R8G8B8, WIDTH, HEIGHT);
    const GpPass pass = { .color[0] = { color, true, { 0 } },
                          .clear_rects = rects,
                          .clear_rect_count = GP_COUNT(rects) };
    for (size_t i = 0; i < GP_COUNT(places); i++) {
        int seen = 0;
        const GpDeviceDesc desc = { .executor = GP_EXECUTOR_REFERENCE,
                                    .trace = { .event = note_clears,
                                               .user = &seen,
                                               .one_pixel = true,
                                               .x = places[i][0],
                                               .y = places[i][1] } };
        run_list_on(&desc, &(GpList){ &pass, 1 });
        assert_int_equal(seen, places[i][2]);
    }
    gp_surface_destroy(&color);
}

/* --- memory of the caller's ------------------------------------------------------------------- */

enum { GUARD = 0x5a };

/* Clears half and draws half of a surface; both halves of the same picture in any memory. */
static void paint(const GpDeviceDesc *device, GpSurface *target)
{
    Quad quad;
    set_up_quad(&quad, (const float[4]){ 0.25f, 0.5f, 1, 1 });
    const GpRect upper = { 0, 0, (int32_t)target->width, (int32_t)target->height / 2 };
    quad.draw.state.raster = (GpRasterState){ .scissor = true,
                                              .scissor_y0 = upper.y1,
                                              .scissor_x1 = upper.x1,
                                              .scissor_y1 = (int32_t)target->height };
    const GpPass passes[2] = {
        { .color[0] = { target, true, { 1, 0.5f, 0.25f, 0 } } },
        { .color[0].surface = target, .draws = &quad.draw, .draw_count = 1 },
    };
    run_list_on(device, &(GpList){ passes, 2 });
}

static void check_borrowed(GpFormat format, uint32_t width, uint32_t height, size_t start,
                           size_t gap)
{
    const size_t row = width * gp_format_info(format)->bytes, pitch = row + gap;
    uint8_t *memory = malloc(start + height * pitch + 64);
    assert_non_null(memory);
    GpSurface *own = make(format, width, height), *borrowed = NULL;
    const GpSurfaceDesc desc = {
        .format = format, .width = width, .height = height, .memory = memory + start, .pitch = pitch
    };
    for (size_t n = 0; device_here(n); n++) {
        memset(memory, GUARD, start + height * pitch + 64);
        assert_int_equal(gp_surface_create(&desc, &borrowed, NULL), GP_OK);
        paint(device_here(n), own);
        paint(device_here(n), borrowed);
        assert_true(gp_surface_hash(own) == gp_surface_hash(borrowed));
        gp_surface_destroy(&borrowed); /* the memory stays */
        for (uint32_t y = 0; y < height; y++)
            assert_memory_equal(memory + start + y * pitch, own->level[0].texels + y * row, row);
        for (size_t i = 0; i < start + height * pitch + 64; i++)
            if (i < start || i >= start + height * pitch || (i - start) % pitch >= row)
                assert_int_equal(memory[i], GUARD);
    }
    gp_surface_destroy(&own);
    free(memory);
}

static void borrowed_memory_holds_the_same_picture_and_nothing_else_changes(void **state)
{
    (void)state;
    for (GpFormat format = GP_A8R8G8B8; format < GP_D16; format++)
        if (gp_format_info(format)->is_target) {
            check_borrowed(format, 70, 67, 3, 5);
            check_borrowed(format, 65, 9, 0, 0);
        }
    /* over the size from which stores go past the caches, which wants aligned addresses */
    check_borrowed(GP_A8R8G8B8, 1088, 1000, 4, 64);
    check_borrowed(GP_A8R8G8B8, 1088, 1000, 64, 60);
}

/* The same memory as two surfaces: what one pass draws by one name the next reads by the other. */
static void one_memory_under_two_names_is_read_after_it_was_written(void **state)
{
    (void)state;
    Quad green, copy;
    set_up_quad(&green, (const float[4]){ 0, 1, 0, 0 });
    set_up_quad(&copy, (const float[4]){ 0, 0, 0, 0 });
    GpSurface *target = make(GP_A8R8G8B8, WIDTH, HEIGHT), *name = NULL;
    GpSurface *result = make(GP_A8R8G8B8, WIDTH, HEIGHT);
    const GpSurfaceDesc desc = {
        .format = GP_X8R8G8B8, .width = WIDTH, .height = HEIGHT, .memory = target->level[0].texels
    };
    assert_int_equal(gp_surface_create(&desc, &name, NULL), GP_OK);
    copy.draw.program = &exercise_local; /* what slot 3 holds, and the vertex's colour: nothing */
    copy.draw.textures[3].surface = name;
    const GpPass passes[2] = {
        { .color[0].surface = target, .draws = &green.draw, .draw_count = 1 },
        { .color[0].surface = result, .draws = &copy.draw, .draw_count = 1 },
    };
    const GpList list = { passes, 2 };
    uint32_t group[2];
    assert_int_equal(gp_list_groups(&list, group), 2);
    uint64_t first = 0;
    for (size_t n = 0; device_here(n); n++) {
        memset(target->level[0].texels, 0, 4 * WIDTH * HEIGHT);
        run_list_on(device_here(n), &list);
        first = n ? first : gp_surface_hash(result);
        assert_true(gp_surface_hash(result) == first);
        assert_int_equal(word_at(result, 100, 100), 0xff00ff00);
    }
    gp_surface_destroy(&name);
    gp_surface_destroy(&target);
    gp_surface_destroy(&result);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r37_x8r8g8b8_has_an_alpha_of_one),
        cmocka_unit_test(x8r8g8b8_is_cleared_with_its_byte_and_left_alone_elsewhere),
        cmocka_unit_test(rectangles_are_cut_to_the_surface_and_scissor_is_not_asked),
        cmocka_unit_test(a_pass_clears_a_part_of_what_was_drawn),
        cmocka_unit_test(a_watched_pixel_is_cleared_where_a_rectangle_has_it),
        cmocka_unit_test(borrowed_memory_holds_the_same_picture_and_nothing_else_changes),
        cmocka_unit_test(one_memory_under_two_names_is_read_after_it_was_written),
    };
    return cmocka_run_group_tests_name("targets", tests, NULL, NULL);
}
