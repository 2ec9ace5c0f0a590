/* Every mistake of a program is answered with one line that names the program and what is wrong, in
 * both executors, whether the program was counted or compiled once by a plain compiler. A trial,
 * which finds some of them, leaves the processor as it was. */
#include <glasspipe/glasspipe.h>
#include "pipeline/list/isa.h"
#include "pipeline/shader/counts.h"
#include "tests/shaders/mistakes.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

#include <stdio.h>

/* Only what one plain call of a compiler makes: four lanes, and no counting. */
static GpProgram plainly_built(const GpProgram *program)
{
    GpProgram plain = *program;
    plain.count = NULL;
    plain.code[1] = plain.code[2] = NULL;
    return plain;
}

/* Draws one triangle with a program. */
static GpResult draw_with(const GpProgram *program, GpExecutor executor, uint64_t *hash,
                          GpError *error)
{
    static const float corners[3][6] = { { -1, -1, 0, 1, 0, 0 },
                                         { 1, -1, 0, 0, 1, 0 },
                                         { 0, 1, 1, 0, 0, 1 } };
    static const GpStream stream = { corners[0], sizeof corners[0], 3, GP_FLOAT32 };
    MistakesUniforms uniforms = { .scale = 0.75f };
    GpDraw draw = { .program = program, .uniforms = &uniforms, .geometry = { .vertex_count = 3 } };
    draw.geometry.streams[GP_POSITION] = draw.geometry.streams[GP_COLOR] = stream;
    GpSurface *target[2] = { NULL };
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = 16, .height = 16 };
    for (int i = 0; i < 2; i++)
        assert_int_equal(gp_surface_create(&desc, &target[i], NULL), GP_OK);
    GpPass pass = { .draws = &draw, .draw_count = 1 };
    for (int i = 0; i < 2; i++)
        pass.color[i] = (GpColorTarget){ .surface = target[i], .clear = true };
    GpDevice *device = device_open(&(GpDeviceDesc){ .executor = executor, .threads = 1 });
    const GpResult result = gp_device_run(device, &(GpList){ &pass, 1 }, error);
    *hash = gp_surface_hash(target[0]);
    gp_device_destroy(&device);
    for (int i = 0; i < 2; i++)
        gp_surface_destroy(&target[i]);
    return result;
}

/* What is said of a program as it is must be one line, with its name and these words. */
static void assert_refused_as(const GpProgram *program, const char *says)
{
    for (GpExecutor executor = 0; executor < GP_EXECUTORS; executor++) {
        GpError error = { "" };
        uint64_t hash;
        char name[80];
        snprintf(name, sizeof name, "program %s: ", program->name);
        if (draw_with(program, executor, &hash, &error) != GP_ERROR_INVALID ||
            !strstr(error.text, name) || !strstr(error.text, says) || strchr(error.text, '\n'))
            fail_msg("%s, %s, executor %d: '%s', expected '%s'", program->name,
                     program->count ? "counted" : "plain", (int)executor, error.text, says);
    }
}

static void assert_refused(const GpProgram *counted, const char *says)
{
    const GpProgram plain = plainly_built(counted);
    assert_refused_as(counted, says);
    assert_refused_as(&plain, says);
}

static void what_shaders_use_must_be_declared(void **state)
{
    (void)state;
    static const struct {
        const GpProgram *program;
        const char *says;
    } rows[] = {
        { &mistake_samplers, "slot 5 is read, but not declared in samplers" },
        { &mistake_samplers_in_loop, "slot 5 is read, but not declared in samplers" },
        { &mistake_vertex_samplers, "slot 3 is read, but not declared in vertex_samplers" },
        { &mistake_local_reads, "slot 2 is read, but not declared in local_reads" },
        { &mistake_may_discard, "may_discard is not declared" },
        { &mistake_texkill, "may_discard is not declared" },
        { &mistake_writes_depth, "writes_depth is not declared" },
        { &mistake_writes_point_size, "writes_point_size is not declared" },
        { &mistake_uses_pixel, "uses_pixel is not declared" },
        { &mistake_uses_face, "uses_face is not declared" },
        { &mistake_uses_derivatives, "uses_derivatives is not declared" },
        { &mistake_slot, "slot 16 is read, but there are samplers 0 to 15 only" },
        { &mistake_negative_slot, "slot -1 is read, but there are samplers 0 to 15 only" },
        { &mistake_far_slot, "slot 40 is read, but there are samplers 0 to 15 only" },
        { &mistake_no_depth, "writes_depth is declared, but no odepth reached" },
        { &mistake_no_point_size, "writes_point_size is declared, but it is never written" },
        { &mistake_inputs_sum, "inputs declare 6 components, the vertex struct has 5" },
        { &mistake_varyings_sum, "varyings declare 3 components, the struct has 5" },
        { &mistake_varying_unwritten, "varying 'place' is read, but not written whole" },
        { &mistake_target_unwritten, "target 1 is not written whole" },
        { &mistake_position_unwritten, "the vertex shader does not write all of *position" },
        { &mistake_vertex_place, "the vertex shader uses what only pixels have" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        assert_refused(rows[i].program, rows[i].says);
}

/* What cannot be drawn with, for it would be asked for code that is not there. */
static void refused_by_check(const GpProgram *program, const char *says)
{
    GpError error = { "" };
    if (gp_program_check(program, &error) != GP_ERROR_INVALID || !strstr(error.text, says))
        fail_msg("'%s', expected '%s'", error.text, says);
}

/* One field of a good program is changed. */
#define WRONG(change, says)                                                                        \
    do {                                                                                           \
        GpProgram p = mistake_none;                                                                \
        change;                                                                                    \
        assert_refused(&p, says);                                                                  \
    } while (0)

static void every_wrong_field_is_named(void **state)
{
    (void)state;
    WRONG(p.vertex_profile = GP_PS_2_0, "vertex_profile");
    WRONG(p.vertex_profile = GP_PROFILES, "vertex_profile");
    WRONG(p.pixel_profile = GP_VS_2_0, "pixel_profile");
    WRONG(p.pixel_profile = (GpProfile)-1, "pixel_profile");
    WRONG(p.inputs[0].semantic = GP_SEMANTICS, "inputs[0]");
    WRONG(p.inputs[0].components = 5, "inputs[0]");
    WRONG(p.inputs[1].semantic = GP_POSITION, "inputs[1]: position appears twice");
    WRONG(p.inputs[1].components = 0, "inputs declare 2 components");
    WRONG(p.varyings[0].name = NULL, "varyings[0] has no name");
    WRONG(p.varyings[0].name = "", "varyings[0] has no name");
    WRONG((p.varyings[0] = p.varyings[1], p.varyings[0].name = "first",
           p.varyings[0].mode = p.varyings[1].mode = GP_SPRITE_COORD),
          "a program has one varying of sprite coordinates");
    WRONG(p.varyings[1].name = "color", "varying 'color' appears twice");
    WRONG(p.varyings[1].components = 5, "varying 'place'");
    WRONG(p.varyings[1].mode = GP_INTERPOLATIONS, "varying 'place'");
    WRONG(p.varyings[0].mode = GP_SPRITE_COORD, "varying 'color': sprite coordinates");
    WRONG(p.varyings[1].components = 1, "varyings declare 4 components");
    WRONG(p.samplers = p.local_reads = 4, "both samplers and local reads");
    WRONG(p.may_discard = false, "may_discard");
    WRONG(p.writes_point_size = false, "writes_point_size");
    WRONG(p.input_components = 6, "the vertex struct has 6");
    WRONG(p.varying_components = 6, "the struct has 6");
    WRONG(p.pixel_input_components = 6, "the pixel shader reads 6");
    WRONG(p.color_components = 3, "3 colour components");
    WRONG(p.color_components = 20, "20 colour components");
    WRONG(p.code[0] = NULL, "code[0] is missing");
    GpProgramCode code = *mistake_none.code[0];
    WRONG((p.code[0] = &code, code.lanes = 8), "code[0]");
    code = *mistake_none.code[0];
    WRONG((p.code[0] = &code, code.vertex = NULL), "code[0]");
    code = *mistake_none.code[0];
    WRONG((p.code[0] = &code, code.isa = NULL), "code[0]");
    const GpProgramCode eight = { .lanes = 8,
                                  .isa = mistake_none.code[0]->isa,
                                  .vertex = mistake_none.code[0]->vertex };
    GpProgram uneven = mistake_none;
    uneven.code[1] = &eight;
    refused_by_check(&uneven, "code[1]: some widths have a pixel shader, some do not");
    GpProgram nameless = mistake_none;
    nameless.name = "";
    GpError error = { "" };
    assert_int_equal(gp_program_check(&nameless, &error), GP_ERROR_INVALID);
    assert_string_equal(error.text, "a program has no name");
}

static void without_a_pixel_shader_nothing_of_one_is_declared(void **state)
{
    (void)state;
    const GpProgramCode code = { .lanes = 4,
                                 .isa = mistake_none.code[0]->isa,
                                 .vertex = mistake_none.code[0]->vertex };
    GpProgram none = plainly_built(&mistake_none);
    none.code[0] = &code;
    none.pixel_profile = 0;
    none.color_components = 0;
    none.samplers = none.local_reads = 0;
    none.may_discard = none.writes_depth = false;
    assert_int_equal(gp_program_check(&none, NULL), GP_OK);
    const struct {
        uint8_t color_components;
        GpProfile pixel_profile;
        uint16_t samplers, local_reads;
        bool may_discard, writes_depth;
    } rows[] = {
        { .color_components = 4 }, { .pixel_profile = GP_PS_2_0 }, { .samplers = 1 },
        { .local_reads = 1 },      { .may_discard = true },        { .writes_depth = true }
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        GpProgram p = none;
        p.color_components = rows[i].color_components;
        p.pixel_profile = rows[i].pixel_profile;
        p.samplers = rows[i].samplers;
        p.local_reads = rows[i].local_reads;
        p.may_discard = rows[i].may_discard;
        p.writes_depth = rows[i].writes_depth;
        refused_by_check(&p, "declares things of a pixel shader, and has none");
    }
}

/* A counting build that reports one thing more than that of a good program. */
static struct {
    size_t offset;
    bool no_memory;
} reported;

static bool count_one_thing(const GpProgram *program, GpShaderCounts *vertex, GpShaderCounts *pixel)
{
    (void)program;
    *pixel =
        (GpShaderCounts){ .discards = true, .writes_depth = true, .outputs_written = ~(uint64_t)0 };
    *vertex = (GpShaderCounts){ .writes_point_size = true, .outputs_written = ~(uint64_t)0 };
    memset((char *)vertex + reported.offset, 1, 1);
    return !reported.no_memory;
}

static void vertex_shaders_use_nothing_of_pixels(void **state)
{
    (void)state;
    GpProgram p = mistake_none;
    p.count = count_one_thing;
    p.writes_depth = p.may_discard = p.writes_point_size = true;
    reported.offset = offsetof(GpShaderCounts, writes_point_size); /* which is true already */
    assert_int_equal(gp_program_check(&p, NULL), GP_OK);
    static const size_t of_pixels[] = {
        offsetof(GpShaderCounts, gradients),   offsetof(GpShaderCounts, implicit_lod),
        offsetof(GpShaderCounts, local_slots), offsetof(GpShaderCounts, discards),
        offsetof(GpShaderCounts, reads_pixel), offsetof(GpShaderCounts, reads_face),
    };
    for (size_t i = 0; i < GP_COUNT(of_pixels); i++) {
        reported.offset = of_pixels[i];
        refused_by_check(&p, "the vertex shader uses what only pixels have");
    }
    reported.no_memory = true;
    assert_int_equal(gp_program_check(&p, NULL), GP_ERROR_MEMORY);
    reported.no_memory = false;
}

/* By the names of the struct's members where they are counted, else by what the position
 * follows. */
static void inputs_in_another_order_are_refused(void **state)
{
    (void)state;
    static const GpProgram *const swapped[] = { &mistake_inputs_swapped,
                                                &mistake_inputs_swapped_equal };
    for (size_t i = 0; i < GP_COUNT(swapped); i++) {
        const GpProgram plain = plainly_built(swapped[i]);
        assert_refused_as(&plain, ": inputs: the clip-space position follows other inputs, but not "
                                  "position");
        if (swapped[i]->count)
            assert_refused_as(swapped[i], ": expected the order of the struct");
    }
}

static void inputs_of_one_width_are_told_by_the_names_of_members(void **state)
{
    (void)state;
    GpError error = { "" };
    if (!mistake_inputs_named.count)
        skip();
    assert_int_equal(gp_program_check(&mistake_inputs_named, &error), GP_ERROR_INVALID);
    assert_string_equal(
        error.text, "program mistake_inputs_named: inputs[1]: color is declared at component 2, "
                    "but the vertex struct has 'color' at 5: expected the order of the struct");
}

static void a_program_without_mistakes_draws_the_same_however_it_was_built(void **state)
{
    (void)state;
    const GpProgram plain = plainly_built(&mistake_none);
    uint64_t hash[4];
    for (GpExecutor executor = 0; executor < GP_EXECUTORS; executor++) {
        GpError error = { "" };
        if (draw_with(&mistake_none, executor, &hash[2 * executor], &error) ||
            draw_with(&plain, executor, &hash[2 * executor + 1], &error))
            fail_msg("%s", error.text);
    }
    for (int i = 1; i < 4; i++)
        assert_true(hash[i] == hash[0]);
}

/* Whether a bit above the lowest 16 bytes of one of AVX's registers is set. Plain code touches none
 * of them. */
static bool upper_halves_are_in_use(void)
{
    uint32_t registers[16][8] = { { 0 } }, bits = 0;
#ifdef __x86_64__
    __asm__ volatile(".irp n, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15\n"
                     "vmovups %%ymm\\n, 32 * \\n(%0)\n"
                     ".endr" ::"r"(registers)
                     : "memory");
#endif
    for (int i = 0; i < 16; i++)
        for (int k = 4; k < 8; k++)
            bits |= registers[i][k];
    return bits != 0;
}

static void a_trial_leaves_the_upper_halves_of_registers_unused(void **state)
{
    (void)state;
    const MistakesUniforms uniforms = { .scale = 0.75f };
    if (!gp_isa_runs("avx2")) /* has no such registers */
        skip();
    for (int i = 0; i < GP_CODE_WIDTHS; i++) {
        const GpProgramCode *code = mistake_none.code[i];
        if (!code || code->lanes == 4 || !gp_isa_runs(code->isa))
            continue;
        if (gp_program_try(&mistake_none, code, &uniforms, NULL))
            fail_msg("lanes%d: refused", code->lanes);
        if (upper_halves_are_in_use())
            fail_msg("lanes%d: plain code is slow from here on", code->lanes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_shaders_use_must_be_declared),
        cmocka_unit_test(every_wrong_field_is_named),
        cmocka_unit_test(without_a_pixel_shader_nothing_of_one_is_declared),
        cmocka_unit_test(vertex_shaders_use_nothing_of_pixels),
        cmocka_unit_test(inputs_in_another_order_are_refused),
        cmocka_unit_test(inputs_of_one_width_are_told_by_the_names_of_members),
        cmocka_unit_test(a_program_without_mistakes_draws_the_same_however_it_was_built),
        cmocka_unit_test(a_trial_leaves_the_upper_halves_of_registers_unused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
