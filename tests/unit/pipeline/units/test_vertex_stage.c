/* Vertex stage: how vertices are laid out for a shader, and what becomes of its results. */
#include "pipeline/units/vertex_stage.h"
#include "tests/support/unit.h"

enum { INPUTS = 3, VARYINGS = 2 };

/* A shader by hand: each lane's outputs tell its inputs and the lane's number. */
static void shade(const GpShaderCall *call)
{
    const int lanes = *(const int *)call->uniforms;
    assert_int_equal(call->packets, 1);
    assert_true(call->executor == call->uniforms);
    for (int lane = 0; lane < lanes; lane++) {
        const float *in = call->in + lane;
        for (int c = 0; c < 4; c++)
            call->position[c * lanes + lane] = c < INPUTS ? in[c * lanes] : (float)lane;
        call->varying[lane] = in[0] + in[lanes];
        call->varying[lanes + lane] = -in[2 * lanes];
        if (call->point_size)
            call->point_size[lane] = 10 + in[0];
    }
    for (int lane = 1; lane < lanes; lane++) /* lanes beyond the last vertex repeat it */
        assert_true(call->in[lane] == call->in[lane - 1] + 1 ||
                    call->in[lane] == call->in[lane - 1]);
}

static void vertices_of_any_count_go_through_lanes_of_any_width(void **state)
{
    (void)state;
    GpProgram program = { .input_components = INPUTS, .varying_components = VARYINGS };
    float inputs[16 * INPUTS];
    for (int i = 0; i < 16; i++)
        for (int c = 0; c < INPUTS; c++)
            inputs[i * INPUTS + c] = (float)(100 * c + i);
    for (int sized = 0; sized < 2; sized++)
        for (int lanes = 4; lanes <= 16; lanes *= 2)
            for (int count = 1; count <= lanes; count++) {
                program.writes_point_size = sized;
                const GpProgramCode code = { .lanes = lanes, .vertex = shade };
                const GpVertexStage stage = {
                    .program = &program, .code = &code, .uniforms = &lanes, .executor = &lanes
                };
                GpVertex vertices[17];
                vertices[count].point_size = -1;
                gp_shade_vertices(&stage, inputs, count, vertices);
                for (int i = 0; i < count; i++) {
                    const GpVertex *v = &vertices[i];
                    assert_true(v->clip[0] == (float)i && v->clip[1] == (float)(100 + i));
                    assert_true(v->clip[2] == (float)(200 + i) && v->clip[3] == (float)i);
                    assert_true(v->varying[0] == (float)(100 + 2 * i));
                    assert_true(v->varying[1] == (float)(-200 - i));
                    assert_true(v->point_size == (sized ? (float)(10 + i) : 1));
                }
                assert_true(vertices[count].point_size == -1);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_of_any_count_go_through_lanes_of_any_width),
    };
    return cmocka_run_group_tests_name("vertex_stage", tests, NULL, NULL);
}
