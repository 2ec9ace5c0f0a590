/* Input assembly: what streams hold, at any stride and alignment, and which vertices primitives have. */
#include "pipeline/units/input_assembly.h"
#include "tests/support/unit.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(components_that_a_stream_lacks_are_0_0_0_1),
        cmocka_unit_test(strides_are_packed_by_default_and_need_no_alignment),
        cmocka_unit_test(r23_bytes_are_divided_by_255),
        cmocka_unit_test(signalling_nans_are_quieted_and_all_else_keeps_its_bits),
        cmocka_unit_test(inputs_come_in_the_order_of_the_program),
        cmocka_unit_test(primitives_take_their_vertices_in_order),
    };
    return cmocka_run_group_tests_name("input_assembly", tests, NULL, NULL);
}
