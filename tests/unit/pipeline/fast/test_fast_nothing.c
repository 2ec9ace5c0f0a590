/* Draws that show nothing, and rectangles that hold nothing: what comes before and after them is as
 * if they were not there. */
#include "tests/support/devices.h"
#include "tests/support/lists/drawing.h"
#include "tests/support/unit.h"

#include <stdint.h>

static const Corner small[3] = { { { -0.9f, 0.9f, 0.5f, 1 }, { 0, 1, 0, 1 }, { 0, 0 } },
                                 { { -0.7f, 0.9f, 0.5f, 1 }, { 0, 1, 0, 1 }, { 0, 0 } },
                                 { { -0.9f, 0.7f, 0.5f, 1 }, { 0, 1, 0, 1 }, { 0, 0 } } };

static uint32_t pixel(const Drawing *f, uint32_t x, uint32_t y)
{
    uint32_t word;
    memcpy(&word, gp_surface_texel(&f->color->level[0], 4, x, y), sizeof word);
    return word;
}

/* The second draw meets the tile that the first one covers, and all of it is hidden, or it has no
 * colour: the tile has the first one's colours. */
static void a_hidden_draw_leaves_the_colours_of_what_covers_the_tile(void **state)
{
    (void)state;
    static const GpProgram *const hidden[] = { &exercise_texture, &exercise_depth_only };
    static const float depths[] = { 0, 1 };
    for (size_t i = 0; i < GP_COUNT(hidden) * GP_COUNT(depths); i++) {
        Drawing f = new_drawing(GP_A8R8G8B8);
        link_drawing(&f, 2, &exercise_color, full_screen, 6);
        f.uniforms.color[0] = f.uniforms.color[3] = 1;
        f.draw[1].program = hidden[i % 2];
        f.draw[1].geometry.vertex_count = 3;
        f.draw[1].geometry.streams[GP_POSITION].data = small->position;
        f.draw[1].state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
        f.pass.depth.depth_value = depths[i / 2];
        GpSurface *texture = NULL;
        const GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = 4, .height = 4 };
        assert_int_equal(gp_surface_create(&desc, &texture, NULL), GP_OK);
        for (int slot = 0; slot < GP_MAX_SAMPLERS; slot++)
            f.draw[1].textures[slot].surface = texture;
        run_list_everywhere(&f.list, "a draw that is hidden, or has no colour");
        f.pass.draw_count = 1;
        const uint32_t shown = pixel(&f, 60, 60);
        run_list(&f.list);
        assert_int_equal(shown, pixel(&f, 60, 60));
        assert_int_not_equal(shown, 0);
        gp_surface_destroy(&texture);
        free_drawing(&f);
    }
}

/* The ends of what is empty may be any numbers, as those of a union of no rectangles are. */
static const GpRect empty[] = {
    { INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN },
    { 10, 10, INT32_MIN, INT32_MIN },
    { INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN },
    { INT32_MAX, 0, INT32_MAX, 64 },
    { 20, 20, 20, 40 },
    { 40, 20, 20, 40 },
};

static void empty_rectangles_clear_nothing(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(empty); i++)
        for (uint32_t draws = 0; draws < 2; draws++) {
            Drawing f = new_drawing(GP_A8R8G8B8);
            gp_surface_clear_color(f.color, (const float[4]){ 0, 0, 1, 1 });
            link_drawing(&f, draws, &exercise_color, small, 3);
            f.pass.clear_rects = &empty[i];
            f.pass.clear_rect_count = 1;
            run_list_everywhere(&f.list, "an empty rectangle");
            assert_int_equal(pixel(&f, 30, 30), 0xff0000ff);
            free_drawing(&f);
        }
}

static void empty_scissors_let_nothing_through(void **state)
{
    (void)state;
    for (size_t i = 0; i < GP_COUNT(empty); i++) {
        const GpRect rect = empty[i];
        if (rect.x0 > rect.x1 || rect.y0 > rect.y1)
            continue; /* refused */
        Drawing f = new_drawing(GP_A8R8G8B8);
        link_drawing(&f, 1, &exercise_color, full_screen, 6);
        f.draw[0].state.raster.scissor = true;
        f.draw[0].state.raster.scissor_x0 = rect.x0;
        f.draw[0].state.raster.scissor_y0 = rect.y0;
        f.draw[0].state.raster.scissor_x1 = rect.x1;
        f.draw[0].state.raster.scissor_y1 = rect.y1;
        run_list_everywhere(&f.list, "an empty scissor");
        for (uint32_t at = 0; at < SIZE; at++)
            assert_int_equal(pixel(&f, at, at), 0);
        free_drawing(&f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hidden_draw_leaves_the_colours_of_what_covers_the_tile),
        cmocka_unit_test(empty_rectangles_clear_nothing),
        cmocka_unit_test(empty_scissors_let_nothing_through),
    };
    return cmocka_run_group_tests_name("fast, nothing", tests, NULL, NULL);
}
