/* Surfaces that earlier frames made, read in place: of every format, with any bits in them, and
 * more of them than tile memory has slots. As the reference executor reads them, texel by texel. */
#include "shaders_c/common/texel_copy.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

enum { MOST = 150, CASES = 150, READS = 8, WHOLE = 512 };

/* Of WHOLE x WHOLE pixels. */
static const GpRect window = { 128, 256, 384, 384 };

static void fill(Random *random, GpSurface *surface)
{
    const GpRect *there = &surface->window;
    const size_t texel_bytes = gp_format_info(surface->format)->bytes;
    for (int32_t y = there->y0; y < there->y1; y++) {
        uint8_t *row =
            gp_surface_texel(&surface->level[0], texel_bytes, (uint32_t)there->x0, (uint32_t)y);
        for (size_t i = 0; i < texel_bytes * (size_t)(there->x1 - there->x0); i++)
            row[i] = (uint8_t)random_bits(random);
    }
}

static void fill_depth(Random *random, GpSurface *surface)
{
    const size_t texel_bytes = gp_format_info(surface->format)->bytes;
    const GpRect *there = &surface->window;
    for (int32_t y = there->y0; y < there->y1; y++)
        for (int32_t x = there->x0; x < there->x1; x++)
            gp_depth_store(
                surface->format,
                gp_surface_texel(&surface->level[0], texel_bytes, (uint32_t)x, (uint32_t)y),
                gp_depth_code(surface->format, random_float(random, 0, 1)),
                (uint8_t)random_word(random));
}

/* Some triangles that cover parts of the target, so that packets of every kind read. */
static GpGeometry some_triangles(Random *random, Frame *frame)
{
    const uint32_t corners = 3 * (uint32_t)random_int(random, 1, 4);
    float *corner = frame_alloc(frame, corners * 3, sizeof *corner);
    for (uint32_t i = 0; i < corners * 3; i++)
        corner[i] = i % 3 == 2 ? 0.5f : random_float(random, -1.5f, 1.5f);
    return (GpGeometry){ .vertex_count = corners,
                         .streams = { [GP_POSITION] = { .data = corner, .components = 3 } } };
}

static void build(Random *random, bool windowed, Frame *frame)
{
    static const float black[4] = { 0 };
    const uint32_t width = windowed ? WHOLE : (uint32_t)random_int(random, 1, MOST);
    const uint32_t height = windowed ? WHOLE : (uint32_t)random_int(random, 1, MOST);
    const int reads = random_int(random, 1, READS);
    if (windowed) {
        frame->window = window;
        frame->window_of[0] = frame->window_of[1] = WHOLE;
    }
    GpSurface *target = frame_target(frame, GP_A32B32G32R32F, width, height);
    frame_pass(frame, "sum", target, NULL, black);
    for (int i = 0; i < reads; i++) {
        const GpFormat format = (GpFormat)random_int(random, GP_A8R8G8B8, GP_FORMATS - 1);
        GpSurface *from = frame_target(frame, format, width, height);
        const GpGeometry triangles = some_triangles(random, frame);
        GpDraw *draw = frame_draw(frame, &texel_copy_program, "", &triangles);
        if (gp_format_info(format)->is_depth)
            fill_depth(random, from);
        else
            fill(random, from);
        draw->textures[0].surface = from;
        draw->state.blend[0].op = random_int(random, 0, 1) ? GP_BLEND_OFF : GP_BLEND_MAX;
    }
}

static void reads_in_place_are_those_of_the_reference(void **state)
{
    (void)state;
    Random random = { 2207 };
    for (int i = 0; i < CASES; i++) {
        Frame frame = { 0 };
        build(&random, i % 8 == 7, &frame);
        run_everywhere(&frame);
        frame_free(&frame);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_in_place_are_those_of_the_reference),
    };
    return cmocka_run_group_tests_name("framebuffer fetch", tests, NULL, NULL);
}
