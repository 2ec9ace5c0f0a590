/* Input assembly: what streams hold, at any stride and alignment, and which vertices primitives
 * have. */
#include "pipeline/units/input_assembly.h"
#include "tests/support/unit.h"

#include <math.h>

static void components_that_a_stream_lacks_are_0_0_0_1(void **state)
{
    (void)state;
    static const float data[8] = { 5, 6, 7, 8, 15, 16, 17, 18 };
    static const float rest[4] = { 0, 0, 0, 1 };
    for (uint8_t has = 1; has <= 4; has++)
        for (int wants = 1; wants <= 4; wants++) {
            const GpStream stream = { data, 16, has, GP_FLOAT32 };
            float input[5] = { -1, -1, -1, -1, -1 };
            gp_fetch_input(&stream, wants, 1, input);
            for (int c = 0; c < wants; c++)
                assert_true(input[c] == (c < has ? data[4 + c] : rest[c]));
            assert_true(input[wants] == -1);
        }
}

static void strides_are_packed_by_default_and_need_no_alignment(void **state)
{
    (void)state;
    static const GpStream packed = { NULL, 0, 3, GP_FLOAT32 }, bytes = { NULL, 0, 3, GP_UNORM8 };
    assert_int_equal(gp_stream_stride(&packed), 12);
    assert_int_equal(gp_stream_stride(&bytes), 3);
    const float values[2] = { 1.5f, -2.25f };
    uint8_t memory[1 + 2 * 7] = { 0 };
    for (int i = 0; i < 2; i++)
        memcpy(memory + 1 + 7 * i, &values[i], sizeof values[i]);
    const GpStream odd = { memory + 1, 7, 1, GP_FLOAT32 };
    for (uint32_t i = 0; i < 2; i++) {
        float input;
        gp_fetch_input(&odd, 1, i, &input);
        assert_true(input == values[i]);
    }
}

static void r23_bytes_are_divided_by_255(void **state)
{
    (void)state;
    uint8_t codes[256];
    for (int i = 0; i < 256; i++)
        codes[i] = (uint8_t)i;
    const GpStream stream = { codes, 0, 1, GP_UNORM8 };
    for (uint32_t i = 0; i < 256; i++) {
        float input;
        gp_fetch_input(&stream, 1, i, &input);
        assert_true(input == (float)((double)i / 255));
    }
}

/* Every type of D3DDECLTYPE and of OpenGL ES 2 that is here, by its page's words. */
static void types_mean_what_their_documentation_says(void **state)
{
    (void)state;
    static const uint8_t color[4] = { 0x33, 0x22, 0x11, 0x44 }; /* 0x44112233 */
    static const uint8_t bytes[4] = { 0, 127, 128, 255 };
    static const int16_t shorts[4] = { -32768, -32767, 1, 32767 };
    static const uint16_t halves[4] = { 0x3c00, 0xc000, 0x7c00, 0x0001 };
    static const struct {
        GpComponentType type;
        const void *data;
        double expected[4];
    } cases[] = {
        { GP_UNORM8, bytes, { 0, 127 / 255.0, 128 / 255.0, 1 } },
        { GP_D3DCOLOR, color, { 0x11 / 255.0, 0x22 / 255.0, 0x33 / 255.0, 0x44 / 255.0 } },
        { GP_UINT8, bytes, { 0, 127, 128, 255 } },
        { GP_INT8, bytes, { 0, 127, -128, -1 } },
        { GP_SNORM8, bytes, { 0, 1, -1, -1 / 127.0 } },
        { GP_UINT16, shorts, { 32768, 32769, 1, 32767 } },
        { GP_INT16, shorts, { -32768, -32767, 1, 32767 } },
        { GP_UNORM16, shorts, { 32768 / 65535.0, 32769 / 65535.0, 1 / 65535.0, 32767 / 65535.0 } },
        { GP_SNORM16, shorts, { -1, -1, 1 / 32767.0, 1 } },
        { GP_FLOAT16, halves, { 1, -2, (double)INFINITY, 0x1p-24 } },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        float input[4], fewer[4];
        GpStream stream = { cases[i].data, 0, 4, cases[i].type };
        assert_int_equal(gp_stream_stride(&stream), 4 * gp_component_bytes(cases[i].type));
        gp_fetch_input(&stream, 4, 0, input);
        for (int c = 0; c < 4; c++)
            if (input[c] != (float)cases[i].expected[c])
                fail_msg("case %zu, component %d: %.9g", i, c, (double)input[c]);
        stream.components = 2; /* expanded to (x, y, 0, 1) */
        gp_fetch_input(&stream, 4, 0, fewer);
        assert_true(fewer[2] == 0 && fewer[3] == 1);
        if (cases[i].type != GP_D3DCOLOR)
            assert_memory_equal(fewer, input, 2 * sizeof(float));
    }
}

/* The correctly rounded quotient of every code, and each negative one the mirror of a positive. */
static void r25_snorm_is_exact_and_symmetric(void **state)
{
    (void)state;
    for (int32_t code = -32768; code < 32768; code++) {
        const double exact = code == -32768 ? -1 : code / 32767.0;
        assert_true(gp_float_from_snorm(code, 16) == (float)exact);
        if (code > -128 && code < 128)
            assert_true(gp_float_from_snorm(code, 8) == (float)(code / 127.0));
        if (code > 0)
            assert_true(gp_float_from_snorm(-code, 16) == -gp_float_from_snorm(code, 16));
    }
    assert_true(gp_float_from_snorm(-128, 8) == -1);
}

static void signalling_nans_are_quieted_and_all_else_keeps_its_bits(void **state)
{
    (void)state;
    static const uint32_t bits[] = { 0x7f800001, 0xffbfffff, 0x7fc01234, 0x00000001,
                                     0x80000000, 0x7f800000, 0x3f800001 };
    const GpStream stream = { bits, 0, 1, GP_FLOAT32 };
    for (uint32_t i = 0; i < GP_COUNT(bits); i++) {
        float input;
        gp_fetch_input(&stream, 1, i, &input);
        assert_int_equal(gp_float_bits(input), i < 3 ? GP_QUIET_NAN : bits[i]);
    }
}

static void inputs_come_in_the_order_of_the_program(void **state)
{
    (void)state;
    static const float positions[6] = { 1, 2, 3, 4, 5, 6 }, sizes[2] = { 8, 9 };
    GpGeometry geometry = { .vertex_count = 2 };
    geometry.streams[GP_POSITION] = (GpStream){ positions, 0, 3, GP_FLOAT32 };
    geometry.streams[GP_POINT_SIZE] = (GpStream){ sizes, 0, 1, GP_FLOAT32 };
    const GpProgram program = { .inputs = { { GP_POINT_SIZE, 1 }, { GP_POSITION, 4 } } };
    float inputs[5];
    gp_fetch_vertex(&geometry, &program, 1, inputs);
    static const float expected[5] = { 9, 4, 5, 6, 1 };
    assert_memory_equal(inputs, expected, sizeof expected);
}

static void primitives_take_their_vertices_in_order(void **state)
{
    (void)state;
    static const uint32_t indices[6] = { 9, 3, 7, 3, 9, 1 };
    for (int indexed = 0; indexed < 2; indexed++)
        for (uint32_t p = 0; p < 2; p++) {
            GpGeometry geometry = { .primitive = GP_TRIANGLES,
                                    .vertex_count = 10,
                                    .indices = indexed ? indices : NULL,
                                    .index_count = 6 };
            uint32_t vertices[3];
            gp_assemble(&geometry, p, vertices);
            for (uint32_t i = 0; i < 3; i++)
                assert_int_equal(vertices[i], indexed ? indices[3 * p + i] : 3 * p + i);
            geometry.primitive = GP_POINTS;
            gp_assemble(&geometry, p, vertices);
            assert_int_equal(vertices[0], indexed ? indices[p] : p);
        }
}

/* The triangles of Direct3D 9's pages, whose vertices count from 1. */
static void strips_and_fans_turn_as_direct3d_9_says(void **state)
{
    (void)state;
    static const uint32_t strip[4][3] = { { 1, 2, 3 }, { 2, 4, 3 }, { 3, 4, 5 }, { 4, 6, 5 } };
    static const uint32_t fan[4][3] = { { 2, 3, 1 }, { 3, 4, 1 }, { 4, 5, 1 }, { 5, 6, 1 } };
    static const uint32_t wide[6] = { 9, 3, 7, 1, 5, 0 };
    static const uint16_t narrow[6] = { 9, 3, 7, 1, 5, 0 };
    for (int kind = 0; kind < 6; kind++) {
        const bool is_strip = kind % 2;
        const GpGeometry geometry = { .primitive = is_strip ? GP_TRIANGLE_STRIP : GP_TRIANGLE_FAN,
                                      .vertex_count = kind < 2 ? 6 : 10,
                                      .indices = kind / 2 == 1 ? wide : NULL,
                                      .indices16 = kind / 2 == 2 ? narrow : NULL,
                                      .index_count = kind < 2 ? 0 : 6 };
        assert_int_equal(gp_geometry_primitives(&geometry), 4);
        for (uint32_t p = 0; p < 4; p++) {
            uint32_t vertices[3];
            gp_assemble(&geometry, p, vertices);
            for (int i = 0; i < 3; i++) {
                const uint32_t at = (is_strip ? strip : fan)[p][i] - 1;
                assert_int_equal(vertices[i], kind < 2 ? at : wide[at]);
            }
        }
    }
}

static void strips_of_less_than_three_have_no_triangle(void **state)
{
    (void)state;
    for (uint32_t count = 0; count < 3; count++) {
        GpGeometry geometry = { .primitive = GP_TRIANGLE_STRIP, .vertex_count = count };
        assert_int_equal(gp_geometry_primitives(&geometry), 0);
        geometry.primitive = GP_TRIANGLE_FAN;
        assert_int_equal(gp_geometry_primitives(&geometry), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(components_that_a_stream_lacks_are_0_0_0_1),
        cmocka_unit_test(strides_are_packed_by_default_and_need_no_alignment),
        cmocka_unit_test(r23_bytes_are_divided_by_255),
        cmocka_unit_test(types_mean_what_their_documentation_says),
        cmocka_unit_test(r25_snorm_is_exact_and_symmetric),
        cmocka_unit_test(signalling_nans_are_quieted_and_all_else_keeps_its_bits),
        cmocka_unit_test(inputs_come_in_the_order_of_the_program),
        cmocka_unit_test(primitives_take_their_vertices_in_order),
        cmocka_unit_test(strips_and_fans_turn_as_direct3d_9_says),
        cmocka_unit_test(strips_of_less_than_three_have_no_triangle),
    };
    return cmocka_run_group_tests_name("input_assembly", tests, NULL, NULL);
}
