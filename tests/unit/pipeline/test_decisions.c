/* Decisions of the fill rule and of the tests, condition by condition. */
#include "pipeline/resources/compare.h"
#include "pipeline/units/alpha_test.h"
#include "pipeline/units/depth_stencil.h"
#include "pipeline/units/fragment_order.h"
#include "pipeline/units/raster.h"
#include "pipeline/units/scissor.h"
#include "pipeline/units/setup.h"
#include "tests/support/decision.h"

#include <math.h>

/* --- the fill rule ---------------------------------------------------------------------------- */

/* Whether pixel (x, y) is covered. */
static bool covers(GpRasterWalk walk, int32_t x, int32_t y)
{
    GpQuad quad;
    bool covered = false;
    while (gp_raster_next(&walk, &quad))
        if (quad.x == (x & ~1) && quad.y == (y & ~1))
            covered = quad.mask >> ((x & 1) + 2 * (y & 1)) & 1;
    return covered;
}

/* dy < 0 || (dy == 0 && dx > 0): an edge through the centre of pixel (4, 4), each corner first in
 * turn. */
static void r05_an_edge_takes_centres_where_it_is_top_or_left(void **state)
{
    (void)state;
    static const struct {
        const char *conditions;
        bool inside;
        int32_t corner[3][2]; /* clockwise; the edge from the first to the second */
    } rows[] = {
        { "T--", true, { { 1152, 2000 }, { 1152, 300 }, { 2500, 1152 } } }, /* goes up: left */
        { "FF-", false, { { 1152, 300 }, { 1152, 2000 }, { 0, 1152 } } },   /* down: right */
        { "FTT", true, { { 300, 1152 }, { 2000, 1152 }, { 1152, 2500 } } }, /* right: top */
        { "FTF", false, { { 2000, 1152 }, { 300, 1152 }, { 1152, 0 } } },   /* left: bottom */
    };
    for (int first = 0; first < 3; first++) {
        Decision decision = { .name = "top or left" };
        for (size_t i = 0; i < GP_COUNT(rows); i++) {
            GpScreenVertex corner[3] = { { .rw = 1 }, { .rw = 1 }, { .rw = 1 } };
            for (int k = 0; k < 3; k++) {
                corner[(k + first) % 3].x = rows[i].corner[k][0];
                corner[(k + first) % 3].y = rows[i].corner[k][1];
            }
            GpTriangle t;
            const GpRect rect = { 0, 0, 16, 16 };
            assert_int_equal(gp_setup_triangle(corner, &(GpRasterState){ 0 }, &rect, &t),
                             GP_SETUP_DRAWN);
            decided(&decision, rows[i].conditions, rows[i].inside,
                    covers(gp_raster_triangle(&t), 4, 4));
        }
        every_condition_decides(&decision);
    }
}

/* edge > 0 || (edge == 0 && accepts_zero), of each edge, while the other two are inside. */
static void r05_each_edge_decides_by_its_sign(void **state)
{
    (void)state;
    static const struct {
        const char *conditions;
        bool inside;
        int64_t edge;
        bool accepts_zero;
    } rows[] = {
        { "T--", true, 1, false },
        { "FF-", false, -1, true },
        { "FTT", true, 0, true },
        { "FTF", false, 0, false },
    };
    Decision all = { .name = "all edges" };
    decided(&all, "TTT", true, true); /* the first row of each below */
    for (int k = 0; k < 3; k++) {
        static const char *const outside[3] = { "FTT", "TFT", "TTF" };
        Decision decision = { .name = "edge" };
        for (size_t i = 0; i < GP_COUNT(rows); i++) {
            GpTriangle t = { .x0 = 4, .y0 = 4, .x1 = 4, .y1 = 4, .c = { 1, 1, 1 } };
            t.c[k] = rows[i].edge;
            t.accepts_zero[k] = rows[i].accepts_zero;
            decided(&decision, rows[i].conditions, rows[i].inside,
                    covers(gp_raster_triangle(&t), 4, 4));
        }
        every_condition_decides(&decision);
        decided(&all, outside[k], false, decision.outcome[1]);
    }
    every_condition_decides(&all);
}

/* x >= x0 && x <= x1 && y >= y0 && y <= y1, with a box whose ends lie inside quads. */
static void pixels_beside_a_box_are_outside(void **state)
{
    (void)state;
    static const struct {
        const char *conditions;
        bool inside;
        int32_t x, y;
    } rows[] = {
        { "TTTT", true, 5, 5 },  { "F---", false, 4, 5 }, { "TF--", false, 7, 5 },
        { "TTF-", false, 5, 4 }, { "TTTF", false, 5, 7 },
    };
    const GpTriangle t = { .x0 = 5, .y0 = 5, .x1 = 6, .y1 = 6, .c = { 1, 1, 1 } };
    Decision decision = { .name = "box" };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        decided(&decision, rows[i].conditions, rows[i].inside,
                covers(gp_raster_triangle(&t), rows[i].x, rows[i].y));
    every_condition_decides(&decision);
}

/* sprite || triangle->front */
static void sprites_and_front_triangles_are_front(void **state)
{
    (void)state;
    const GpTriangle front = { .c = { 1, 1, 1 }, .front = true }, back = { .c = { 1, 1, 1 } };
    const GpPointSprite sprite = { .right = 256, .bottom = 256 };
    GpRasterWalk walks[] = { gp_raster_sprite(&sprite), gp_raster_triangle(&front),
                             gp_raster_triangle(&back) };
    static const char *const conditions[] = { "T-", "FT", "FF" };
    Decision decision = { .name = "front" };
    for (size_t i = 0; i < GP_COUNT(walks); i++) {
        GpQuad quad;
        assert_true(gp_raster_next(&walks[i], &quad));
        decided(&decision, conditions[i], i < 2, quad.front);
    }
    every_condition_decides(&decision);
}

/* x0 <= x1 && y0 <= y1: a triangle between the centres, in x and in y; and the facing that is
 * culled. */
static void set_up_leaves_out_what_faces_away_or_holds_no_centre(void **state)
{
    (void)state;
    static const struct {
        const char *conditions;
        int32_t width, height;
        GpSetupResult result;
    } boxes[] = {
        { "TT", 1000, 1000, GP_SETUP_DRAWN },
        { "F-", 100, 1000, GP_SETUP_OUTSIDE },
        { "TF", 1000, 100, GP_SETUP_OUTSIDE },
    };
    const GpRect rect = { 0, 0, 16, 16 };
    Decision box = { .name = "holds a centre" };
    for (size_t i = 0; i < GP_COUNT(boxes); i++) {
        const GpScreenVertex corner[3] = { { .x = 1, .y = 1, .rw = 1 },
                                           { .x = boxes[i].width, .y = 1, .rw = 1 },
                                           { .x = 1, .y = boxes[i].height, .rw = 1 } };
        const GpScreenVertex back[3] = { corner[0], corner[2], corner[1] };
        GpTriangle t;
        const GpSetupResult result = gp_setup_triangle(corner, &(GpRasterState){ 0 }, &rect, &t);
        assert_int_equal(result, boxes[i].result);
        decided(&box, boxes[i].conditions, i == 0, result == GP_SETUP_DRAWN);
        for (GpCull cull = 0; i == 0 && cull < GP_CULLS; cull++) {
            const GpRasterState raster = { .cull = cull };
            assert_int_equal(gp_setup_triangle(corner, &raster, &rect, &t),
                             cull == GP_CULL_CW ? GP_SETUP_CULLED : GP_SETUP_DRAWN);
            assert_int_equal(gp_setup_triangle(back, &raster, &rect, &t),
                             cull == GP_CULL_CCW ? GP_SETUP_CULLED : GP_SETUP_DRAWN);
        }
    }
    every_condition_decides(&box);
}

/* size > 0 and a sub-pixel of it; x0 <= x1 && y0 <= y1, of a square beside the target on either
 * side. */
static void points_are_drawn_where_they_hold_a_centre(void **state)
{
    (void)state;
    static const struct {
        const char *conditions;
        int32_t x, y;
        float size;
        GpSetupResult result;
    } rows[] = {
        { "TTTT", 1000, 1000, 3, GP_SETUP_DRAWN },
        { "F---", 1000, 1000, 0, GP_SETUP_ZERO_AREA },
        { "TF--", 1000, 1000, 0.001f, GP_SETUP_ZERO_AREA },
        { "TTF-", -1000, 1000, 3, GP_SETUP_OUTSIDE },
        { "TTF-", 9000, 1000, 3, GP_SETUP_OUTSIDE },
        { "TTTF", 1000, -1000, 3, GP_SETUP_OUTSIDE },
        { "TTTF", 1000, 9000, 3, GP_SETUP_OUTSIDE },
    };
    const GpRect rect = { 0, 0, 16, 16 };
    Decision decision = { .name = "point" };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const GpScreenVertex center = { .x = rows[i].x, .y = rows[i].y, .rw = 1 };
        GpPointSprite sprite;
        const GpSetupResult result = gp_setup_point(&center, rows[i].size, &rect, &sprite);
        assert_int_equal(result, rows[i].result);
        decided(&decision, rows[i].conditions, i == 0, result == GP_SETUP_DRAWN);
    }
    every_condition_decides(&decision);
}

/* --- tests ------------------------------------------------------------------------------------ */

/* x < x0 || x >= x1 || y < y0 || y >= y1 */
static void each_side_of_the_scissor_cuts(void **state)
{
    (void)state;
    static const struct {
        const char *conditions;
        int32_t x, y;
    } rows[] = {
        { "FFFF", 5, 6 }, { "T---", 4, 6 }, { "FT--", 7, 6 }, { "FFT-", 5, 5 }, { "FFFT", 5, 8 }
    };
    const GpRasterState raster = {
        .scissor_x0 = 5, .scissor_y0 = 6, .scissor_x1 = 7, .scissor_y1 = 8
    };
    Decision decision = { .name = "scissor" };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const unsigned bit = 1u << ((rows[i].x & 1) + 2 * (rows[i].y & 1));
        GpQuad quad = { .x = rows[i].x & ~1, .y = rows[i].y & ~1, .mask = bit };
        gp_scissor(&raster, &quad);
        decided(&decision, rows[i].conditions, i > 0, quad.mask == 0);
    }
    every_condition_decides(&decision);
}

/* How the two values relate, and of each function which relations it lets pass: less, equal,
 * greater, none. */
static void r30_every_comparison_by_every_relation(void **state)
{
    (void)state;
    static const char *const passes[GP_COMPARES] = {
        [GP_ALWAYS] = "TTTT",    [GP_NEVER] = "FFFF",         [GP_LESS] = "TFFF",
        [GP_EQUAL] = "FTFF",     [GP_LESS_EQUAL] = "TTFF",    [GP_GREATER] = "FFTF",
        [GP_NOT_EQUAL] = "TFTT", [GP_GREATER_EQUAL] = "FTTF",
    };
    const float values[4] = { 0.25f, 0.4f, 0.75f, NAN };
    for (GpCompare test = 0; test < GP_COMPARES; test++)
        for (int relation = 0; relation < 4; relation++) {
            const bool passed = passes[test][relation] == 'T';
            assert_int_equal(gp_compare_floats(test, values[relation], 0.4f), passed);
            if (relation < 3)
                assert_int_equal(gp_compare_codes(test, 4 + (uint32_t)relation, 5), passed);
            GpQuad quad = { .mask = 1 };
            quad.color[0][3][0] = values[relation]; /* 102 / 255 is the nearest float to 0.4 */
            gp_alpha_test(&(GpAlphaTest){ test, 102 }, &quad);
            assert_int_equal(quad.mask, passed);
        }
}

typedef struct Tested {
    unsigned mask, replaced;
    uint32_t code;
    uint8_t stencil;
} Tested;

/* One pixel of depth before a stored 0.5 and a stencil of 100. */
static Tested test_one(GpFormat format, const GpDepthStencil *desc, float depth, bool front)
{
    GpDepthStencil unit = *desc;
    const GpSurfaceDesc one = { .format = format, .width = 1, .height = 1 };
    assert_int_equal(gp_surface_create(&one, &unit.surface, NULL), GP_OK);
    gp_surface_clear_depth(unit.surface, 0.5f, 100, true, true);
    GpQuad quad = { .mask = 1, .front = front, .depth = { depth } };
    gp_depth_stencil(&unit, &quad);
    Tested result = { .mask = quad.mask, .replaced = quad.replaced };
    gp_depth_load(format, unit.surface->level[0].texels, &result.code, &result.stencil);
    gp_surface_destroy(&unit.surface);
    return result;
}

/* surface && mask: without a depth target no test is asked. */
static void pixels_pass_where_there_is_no_depth_target(void **state)
{
    (void)state;
    const GpDepthStencil unit = { .depth = { .test = GP_NEVER, .write = true },
                                  .stencil = { .enable = true, .front.test = GP_NEVER } };
    GpQuad quad = { .mask = 0xb, .front = true };
    gp_depth_stencil(&unit, &quad);
    assert_int_equal(quad.mask, 0xb);
    assert_false(test_one(GP_D24S8, &unit, 0, true).mask);
}

/* stencil passed && depth passed && write: whether depth is stored; the first two: whether the
 * pixel lives, and which of the three operations is applied. */
static void depth_is_stored_where_both_tests_pass_and_it_is_written(void **state)
{
    (void)state;
    static const struct {
        const char *conditions;
        bool stencil_passes, depth_passes, write;
        uint8_t stencil; /* after */
    } rows[] = {
        { "TTT", true, true, true, 103 },
        { "F--", false, true, true, 101 },
        { "TF-", true, false, true, 102 },
        { "TTF", true, true, false, 103 },
    };
    Decision stored = { .name = "depth is stored" };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        for (uint8_t operation = 101; operation <= 103; operation++) {
            GpDepthStencil unit = { .depth = { .test = GP_LESS, .write = rows[i].write },
                                    .stencil = { .enable = true, .reference = operation },
                                    .max_depth = 1 };
            GpStencilFace *face = &unit.stencil.front;
            *(operation == 101   ? &face->fail
              : operation == 102 ? &face->depth_fail
                                 : &face->pass) = GP_STENCIL_REPLACE;
            face->test = rows[i].stencil_passes ? GP_ALWAYS : GP_NEVER;
            const Tested got =
                test_one(GP_D24S8, &unit, rows[i].depth_passes ? 0.25f : 0.75f, true);
            assert_int_equal(got.stencil, operation == rows[i].stencil ? operation : 100);
            assert_int_equal(got.mask, rows[i].stencil_passes && rows[i].depth_passes);
            if (operation == 101)
                decided(&stored, rows[i].conditions, i == 0,
                        got.code == gp_depth_code(GP_D24S8, 0.25f));
        }
    every_condition_decides(&stored);
}

/* enable && two_sided && !front: whether the back's state serves. */
static void the_back_serves_two_sided_stencils_of_backs(void **state)
{
    (void)state;
    static const struct {
        const char *conditions;
        bool enable, two_sided, front;
        uint8_t after;
    } rows[] = {
        { "TTT", true, true, false, 99 },
        { "F--", false, true, false, 100 },
        { "TF-", true, false, false, 101 },
        { "TTF", true, true, true, 101 },
    };
    Decision decision = { .name = "back" };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const GpDepthStencil unit = { .stencil = { .enable = rows[i].enable,
                                                   .two_sided = rows[i].two_sided,
                                                   .front = { .pass = GP_STENCIL_INCR },
                                                   .back = { .pass = GP_STENCIL_DECR } },
                                      .max_depth = 1 };
        const Tested got = test_one(GP_D24S8, &unit, 0.5f, rows[i].front);
        assert_int_equal(got.stencil, rows[i].after);
        decided(&decision, rows[i].conditions, i == 0, got.stencil == 99);
    }
    every_condition_decides(&decision);
}

/* depth < min, then depth > max: what is compared and stored (R18). */
static void r18_each_end_of_the_range_clamps(void **state)
{
    (void)state;
    static const struct {
        float depth, stored;
    } rows[] = {
        { 0.1f, 0.25f }, { 0.25f, 0.25f }, { 0.6f, 0.6f }, { 0.75f, 0.75f }, { 0.9f, 0.75f }
    };
    const GpDepthStencil unit = { .depth.write = true, .min_depth = 0.25f, .max_depth = 0.75f };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        assert_int_equal(test_one(GP_D32F, &unit, rows[i].depth, true).code,
                         gp_float_bits(rows[i].stored));
        for (GpOrder order = GP_ORDER_DEPTH; order < GP_ORDERS; order++)
            assert_int_equal(gp_order_key(order, rows[i].depth, 0.25f, 0.75f),
                             gp_order_key(order, rows[i].stored, 0, 1));
    }
}

/* stencil passed && z <= back(stored) && back(z) < stored: whether it replaces. */
static void ternary_replaces_what_passes_and_lies_in_front_by_more_than_epsilon(void **state)
{
    (void)state;
    static const struct {
        const char *conditions;
        GpCompare stencil;
        float depth;
        bool lives;
        float stored;
    } rows[] = {
        { "TTT", GP_ALWAYS, 0.25f, true, 0.25f },  { "F--", GP_NEVER, 0.25f, false, 0.5f },
        { "TF-", GP_ALWAYS, 0.75f, false, 0.5f },  { "TTF", GP_ALWAYS, 0.4375f, true, 0.4375f },
        { "TTF", GP_ALWAYS, 0.5625f, true, 0.5f }, /* the nearer depth stays */
    };
    Decision decision = { .name = "replaces" };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        const GpDepthStencil unit = {
            .depth = { GP_LESS_EQUAL, true, true, 0.125f },
            .stencil = { .enable = true, .front.test = rows[i].stencil },
            .max_depth = 1,
        };
        const Tested got = test_one(GP_D24S8, &unit, rows[i].depth, true);
        assert_int_equal(got.mask, rows[i].lives);
        assert_int_equal(got.code, gp_depth_code(GP_D24S8, rows[i].stored));
        decided(&decision, rows[i].conditions, i == 0, got.replaced);
    }
    every_condition_decides(&decision);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r05_an_edge_takes_centres_where_it_is_top_or_left),
        cmocka_unit_test(r05_each_edge_decides_by_its_sign),
        cmocka_unit_test(pixels_beside_a_box_are_outside),
        cmocka_unit_test(sprites_and_front_triangles_are_front),
        cmocka_unit_test(set_up_leaves_out_what_faces_away_or_holds_no_centre),
        cmocka_unit_test(points_are_drawn_where_they_hold_a_centre),
        cmocka_unit_test(each_side_of_the_scissor_cuts),
        cmocka_unit_test(r30_every_comparison_by_every_relation),
        cmocka_unit_test(pixels_pass_where_there_is_no_depth_target),
        cmocka_unit_test(depth_is_stored_where_both_tests_pass_and_it_is_written),
        cmocka_unit_test(the_back_serves_two_sided_stencils_of_backs),
        cmocka_unit_test(r18_each_end_of_the_range_clamps),
        cmocka_unit_test(ternary_replaces_what_passes_and_lies_in_front_by_more_than_epsilon),
    };
    return cmocka_run_group_tests_name("decisions", tests, NULL, NULL);
}
