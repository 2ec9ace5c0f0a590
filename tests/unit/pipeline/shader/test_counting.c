/* What shaders cost, by hand and by the counting build; and that programs are held to their
 * declarations and profiles. */
#include "pipeline/shader/profile.h"
#include "tests/shaders/count.h"
#include "tests/support/unit.h"

#include <pthread.h>
#include <stdio.h>

#include "shaders_c/common/blit.h"
#include "shaders_c/materials/deferred.h"
#include "shaders_c/materials/depth.h"
#include "shaders_c/common/depth_only.h"
#include "shaders_c/materials/gbuffer.h"
#include "shaders_c/materials/gouraud.h"
#include "shaders_c/materials/normals.h"
#include "shaders_c/materials/phong.h"
#include "shaders_c/materials/sprite.h"
#include "shaders_c/materials/textured.h"
#include "shaders_c/materials/textured_phong.h"
#include "shaders_c/materials/toon.h"
#include "shaders_c/materials/unlit.h"
#include "shaders_c/materials/vertex_color.h"

/* Skips the test in builds without a C++ compiler, which count nothing. */
static GpShaderCounts pixel_counts(const GpProgram *program)
{
    GpShaderCounts vertex, pixel;
    if (!program->count)
        skip();
    program->count(program, &vertex, &pixel);
    return pixel;
}

static GpShaderCounts vertex_counts(const GpProgram *program)
{
    GpShaderCounts vertex, pixel;
    if (!program->count)
        skip();
    program->count(program, &vertex, &pixel);
    return vertex;
}

/* Field by field: padding may hold anything. */
static void assert_same_counts(const GpShaderCounts *a, const GpShaderCounts *b)
{
    assert_memory_equal(a, b, offsetof(GpShaderCounts, dependent_reads));
    assert_int_equal(a->dependent_reads, b->dependent_reads);
    assert_int_equal(a->inputs_read, b->inputs_read);
    assert_int_equal(a->outputs_written, b->outputs_written);
    assert_memory_equal(&a->sampler_slots, &b->sampler_slots,
                        offsetof(GpShaderCounts, reads_face) + sizeof a->reads_face -
                            offsetof(GpShaderCounts, sampler_slots));
}

static void assert_accepted(const GpProgram *program)
{
    GpError error = { "" };
    if (gp_program_check(program, &error))
        fail_msg("%s", error.text);
}

static void assert_refused(const GpProgram *program, const char *message)
{
    GpError error = { "" };
    assert_int_equal(gp_program_check(program, &error), GP_ERROR_INVALID);
    assert_string_equal(error.text, message);
}

/* --- counting --------------------------------------------------------------------------------- */

typedef struct Priced {
    const GpProgram *program;
    int arithmetic, texture;
} Priced;

static void instructions_cost_what_table_a3_says(void **state)
{
    (void)state;
#define PRICED(id, arithmetic, texture, value) { &count_##id, arithmetic, texture },
    static const Priced rows[] = { COUNT_INSTRUCTIONS(PRICED) COUNT_INSTRUCTIONS_2(PRICED) };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        GpShaderCounts counts = pixel_counts(rows[i].program);
        if (counts.arithmetic_slots != rows[i].arithmetic ||
            counts.texture_slots != rows[i].texture)
            fail_msg("%s: %d + %d slots, by hand %d + %d", rows[i].program->name,
                     counts.arithmetic_slots, counts.texture_slots, rows[i].arithmetic,
                     rows[i].texture);
        assert_int_equal(counts.slots, rows[i].arithmetic + rows[i].texture);
        assert_accepted(rows[i].program);
    }
}

static void kills_are_texture_slots_and_dearer_in_model_3(void **state)
{
    (void)state;
    GpShaderCounts two = pixel_counts(&count_kills_2), three = pixel_counts(&count_kills);
    assert_true(two.discards && three.discards);
    assert_int_equal(two.texture_slots, 2);
    assert_int_equal(two.arithmetic_slots, 2); /* the comparison with 1, and the mov */
    assert_int_equal(three.texture_slots, 4);
    assert_int_equal(two.inputs_read, 0x1f); /* all of a, and b.x */
}

static void loops_are_counted_once(void **state)
{
    (void)state;
    const GpShaderCounts counts = pixel_counts(&count_looping_3);
    assert_true(counts.loops);
    assert_int_equal(counts.arithmetic_slots, 8 + 2);
    assert_int_equal(counts.texture_slots, 0);
    assert_accepted(&count_looping_3);
}

static void *check_chain(void *result)
{
    *(GpResult *)result = gp_program_check(&count_chain, NULL);
    return NULL;
}

/* In a thread whose stack has no room for a call an instruction. */
static void chains_need_no_stack(void **state)
{
    (void)state;
    assert_int_equal(pixel_counts(&count_chain).arithmetic_slots, COUNT_CHAIN);
    GpResult result = GP_ERROR_INVALID;
    pthread_t thread;
    pthread_attr_t attributes;
    assert_int_equal(pthread_attr_init(&attributes), 0);
    assert_int_equal(pthread_attr_setstacksize(&attributes, 512 << 10), 0);
    assert_int_equal(pthread_create(&thread, &attributes, check_chain, &result), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    assert_int_equal(pthread_attr_destroy(&attributes), 0);
    assert_int_equal(result, GP_OK);
}

/* slots: phong_ps is nrm 3, sub 1, nrm 3, add 1, nrm 3, dp3 1, max 1, dp3 1, max 1, pow 3, mad 1,
 * mad 1, mov 1. Constants: eye, light, ambient, diffuse, specular and shininess are 14 floats, and
 * 0 and 1. Temporaries: N beside H. */
static void phong_costs_what_it_does_by_hand(void **state)
{
    (void)state;
    GpShaderCounts pixel = pixel_counts(&phong_program), vertex = vertex_counts(&phong_program);
    assert_int_equal(pixel.slots, 21);
    assert_int_equal(pixel.texture_slots, 0);
    assert_int_equal(pixel.constants, 4 + 1);
    assert_int_equal(pixel.temporaries, 2);
    assert_int_equal(pixel.inputs, 2);
    assert_int_equal(pixel.inputs_read, 0x3f);
    assert_int_equal(pixel.outputs, 1);
    assert_int_equal(vertex.slots, 4 + 1 + 1); /* m4x4, and a mov for each interpolant */
    assert_int_equal(vertex.constants, 4);
    assert_int_equal(vertex.temporaries, 0); /* all goes straight to output registers */
    assert_int_equal(vertex.outputs, 2);
    assert_int_equal(vertex.outputs_written, 0x3f);
}

static void code_that_reaches_no_output_costs_nothing(void **state)
{
    (void)state;
    GpShaderCounts lean = pixel_counts(&count_lean), dead = pixel_counts(&count_with_dead_code);
    assert_int_equal(lean.slots, 2);
    assert_same_counts(&lean, &dead);
}

static void only_components_that_are_used_are_inputs(void **state)
{
    (void)state;
    GpShaderCounts counts = pixel_counts(&count_one_component);
    assert_int_equal(counts.inputs_read, 0x22);
    assert_int_equal(counts.inputs, 2);
}

static void dependent_reads_count_computed_coordinates_in_a_row(void **state)
{
    (void)state;
    const struct {
        const GpProgram *program;
        int order;
    } rows[] = {
        { &count_order0, 0 }, /* u / w is computed, but its read is not dependent */
        { &count_swizzled, 1 }, { &count_order1, 1 }, { &count_order2, 2 },
        { &count_order3, 3 },   { &count_order4, 4 },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        GpShaderCounts counts = pixel_counts(rows[i].program);
        assert_int_equal(counts.dependent_reads, rows[i].order);
        assert_false(counts.needs_quads); /* a texture with levels asks for them */
    }
    assert_true(pixel_counts(&count_gradients).needs_quads);
}

static void constants_are_packed_four_a_register(void **state)
{
    (void)state;
    /* 3 uniform floats in one; 0.5 (its sign is free), 2, 3 and 4 in another */
    assert_int_equal(pixel_counts(&count_numbers).constants, 1 + 1);
    assert_int_equal(pixel_counts(&count_over_constants).constants, 33);
    assert_int_equal(pixel_counts(&count_lean).constants, 1);
    assert_int_equal(pixel_counts(&count_add).constants, 0);
}

static void temporaries_are_registers_that_live_at_once(void **state)
{
    (void)state;
    assert_int_equal(pixel_counts(&count_three).temporaries, 3);
    assert_int_equal(pixel_counts(&count_two).temporaries, 2);
    assert_int_equal(pixel_counts(&count_shared).temporaries, 1); /* xyz and w of one register */
    assert_int_equal(pixel_counts(&count_over_temporaries).temporaries, 13);
    assert_int_equal(pixel_counts(&count_over_slots).temporaries, 1);
    assert_int_equal(pixel_counts(&count_copied).temporaries, 0);
}

static void vertex_shaders_report_size_textures_and_depth(void **state)
{
    (void)state;
    GpShaderCounts vertex = vertex_counts(&count_extras), pixel = pixel_counts(&count_extras);
    assert_true(vertex.writes_point_size && pixel.writes_depth);
    assert_int_equal(vertex.slots, 3); /* two movs, and the mul into the size */
    assert_int_equal(pixel.slots, 3);  /* the mul, and movs to colour and depth */
    assert_int_equal(vertex.outputs_written, 0xf);
    GpShaderCounts texture = vertex_counts(&count_vertex_texture);
    assert_true(texture.explicit_lod && !texture.implicit_lod);
    assert_int_equal(texture.samplers, 1);
    assert_int_equal(texture.sampler_slots, 1 << 2);
    assert_int_equal(texture.dependent_reads, 1);
}

static void counting_again_or_one_side_gives_the_same(void **state)
{
    (void)state;
    GpShaderCounts first = pixel_counts(&count_nrm3), vertex, pixel;
    count_order4.count(&count_order4, &vertex, NULL);
    count_nrm3.count(&count_nrm3, NULL, &pixel);
    assert_same_counts(&first, &pixel);
}

/* --- checking --------------------------------------------------------------------------------- */

static void programs_are_held_to_the_limits_of_their_profiles(void **state)
{
    (void)state;
    pixel_counts(&count_lean);
    const struct {
        const GpProgram *program;
        const char *message; /* after the program's name */
    } rows[] = {
        { &count_over_slots, ", ps_2_0: 101 slots, at most 96; ps_2_sw has no such limit" },
        { &count_full_arithmetic, NULL },
        { &count_over_arithmetic,
          ", ps_2_0: 65 arithmetic slots, at most 64; ps_2_sw has no such limit" },
        { &count_over_reads, ", ps_2_0: 33 texture slots, at most 32; ps_2_sw has no such limit" },
        { &count_over_constants, ", ps_2_0: 33 constants, at most 32; ps_2_sw has no such limit" },
        { &count_over_temporaries,
          ", ps_2_0: 13 temporaries, at most 12; ps_2_sw has no such limit" },
        { &count_order3, NULL },
        { &count_order4,
          ", ps_2_0: 4 orders of dependent reads, at most 3; ps_2_sw has no such limit" },
        { &count_gradients, ", ps_2_0: has no dsx, dsy or texldd; ps_2_a, ps_2_sw and 3_0 have" },
        { &count_explicit_level, ", ps_2_0: has no texldl; model 3 has" },
        { &count_looping, ", ps_2_0: has no loop that is left by a mask; model 3 has" },
        { &count_place, ", ps_2_0: has no vPos and vFace; ps_3_0 has" },
        { &count_facing, ", ps_2_0: has no vPos and vFace; ps_3_0 has" },
        { &count_long_vertex, ", vs_2_0: 257 slots, at most 256; vs_2_sw has no such limit" },
        { &count_vertex_texture, NULL },
        { &count_vertex_texld, ": the vertex shader uses what only pixels have: derivatives, "
                               "texld, discard, vpos ..." },
        { &count_unwritten_varying, ": varying 'b' is read, but not written whole" },
        { &count_unwritten_target, ": target 1 is not written whole" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        char message[256];
        snprintf(message, sizeof message, "program %s%s", rows[i].program->name,
                 rows[i].message ? rows[i].message : "");
        if (rows[i].message)
            assert_refused(rows[i].program, message);
        else
            assert_accepted(rows[i].program);
    }
}

static void wider_profiles_accept_what_narrow_ones_refuse(void **state)
{
    (void)state;
    pixel_counts(&count_lean);
    const struct {
        const GpProgram *program;
        GpProfile accepted[4]; /* GP_PROFILE_NONE ends; and is accepted always */
        GpProfile refused[4];
    } rows[] = {
        { &count_over_slots, { GP_PS_2_A, GP_PS_2_B, GP_PS_2_SW, GP_PS_3_0 }, { GP_PS_2_0 } },
        { &count_over_temporaries, { GP_PS_2_A, GP_PS_2_B, GP_PS_2_SW }, { GP_PS_2_0 } },
        { &count_over_constants, { GP_PS_3_0, GP_PS_2_SW }, { GP_PS_2_A, GP_PS_2_B } },
        { &count_order4, { GP_PS_2_A, GP_PS_3_0, GP_PS_2_SW }, { GP_PS_2_0, GP_PS_2_B } },
        { &count_gradients, { GP_PS_2_A, GP_PS_2_SW, GP_PS_3_0 }, { GP_PS_2_0, GP_PS_2_B } },
        { &count_explicit_level, { GP_PS_3_0, GP_PS_3_SW }, { GP_PS_2_A, GP_PS_2_B, GP_PS_2_SW } },
        { &count_place, { GP_PS_3_0, GP_PS_3_SW }, { GP_PS_2_A, GP_PS_2_B, GP_PS_2_SW } },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        GpProgram program = *rows[i].program;
        program.pixel_profile = GP_PROFILE_NONE;
        assert_accepted(&program);
        for (int k = 0; k < 4 && rows[i].accepted[k]; k++) {
            program.pixel_profile = rows[i].accepted[k];
            assert_accepted(&program);
        }
        for (int k = 0; k < 4 && rows[i].refused[k]; k++) {
            program.pixel_profile = rows[i].refused[k];
            assert_int_equal(gp_program_check(&program, NULL), GP_ERROR_INVALID);
        }
    }
}

/* Where there is no _sat: a max and a min. */
static void sat_is_dearer_in_vertex_shaders_of_model_2(void **state)
{
    (void)state;
    const struct {
        GpProfile profile;
        int slots;
    } rows[] = { { GP_VS_2_0, 5 },
                 { GP_VS_2_SW, 5 },
                 { GP_VS_3_0, 4 },
                 { GP_VS_3_SW, 4 },
                 { GP_PROFILE_NONE, 4 } };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        GpProgram program = count_vertex_sat;
        program.vertex_profile = rows[i].profile;
        assert_int_equal(vertex_counts(&program).slots, rows[i].slots);
    }
}

static void vertex_textures_need_model_3(void **state)
{
    (void)state;
    pixel_counts(&count_lean);
    GpProgram program = count_vertex_texture;
    program.vertex_profile = GP_VS_2_0;
    assert_refused(&program, "program count_vertex_texture, vs_2_0: 1 samplers, at most 0");
    program.vertex_profile = GP_VS_3_SW;
    assert_accepted(&program);
}

static void what_shaders_need_must_be_declared(void **state)
{
    (void)state;
    pixel_counts(&count_lean);
    GpProgram p = count_kills_2;
    p.may_discard = false;
    assert_refused(&p, "program count_kills_2: may_discard is not declared, but a shader needs it");
    p = count_extras;
    p.writes_depth = false;
    assert_refused(&p, "program count_extras: writes_depth is not declared, but a shader needs it");
    p = count_lean;
    p.writes_depth = true;
    assert_refused(&p, "program count_lean: writes_depth is declared, but no odepth reached");
    p = count_lean;
    p.writes_point_size = true;
    assert_refused(&p,
                   "program count_lean: writes_point_size is declared, but it is never written");
    p = count_place;
    p.uses_pixel = false;
    assert_refused(&p, "program count_place: uses_pixel is not declared, but a shader needs it");
    p = count_facing;
    p.uses_face = false;
    assert_refused(&p, "program count_facing: uses_face is not declared, but a shader needs it");
    p = count_gradients;
    p.uses_derivatives = false;
    assert_refused(
        &p, "program count_gradients: uses_derivatives is not declared, but a shader needs it");
    p = count_order0;
    p.samplers = 1;
    assert_refused(&p, "program count_order0: slot 1 is read, but not declared in samplers");
    p = count_load_local;
    p.local_reads = 0;
    assert_refused(&p, "program count_load_local: slot 1 is read, but not declared in local_reads");
    p = count_vertex_texture;
    p.vertex_samplers = 1;
    assert_refused(&p, "program count_vertex_texture: slot 2 is read, but not declared in "
                       "vertex_samplers");
}

static void declarations_must_agree_with_the_structs(void **state)
{
    (void)state;
    GpProgram p = count_lean;
    p.name = NULL;
    assert_refused(&p, "a program has no name");
    p = count_lean;
    p.code[0] = NULL;
    assert_refused(&p, "program count_lean: code[0] is missing: 4 lanes are always compiled");
    p = count_lean;
    p.inputs[1].components = 3;
    assert_refused(&p, "program count_lean: inputs declare 7 components, the vertex struct has 8");
    p = count_lean;
    p.inputs[1].semantic = GP_POSITION;
    assert_refused(&p, "program count_lean: inputs[1]: position appears twice");
    p = count_lean;
    p.varyings[2].components = 1;
    assert_refused(&p, "program count_lean: varyings declare 9 components, the struct has 10");
    p = count_lean;
    p.varyings[1].name = NULL;
    assert_refused(&p, "program count_lean: varyings[1] has no name");
    p = count_lean;
    p.varyings[1].name = "a";
    assert_refused(&p, "program count_lean: varying 'a' appears twice");
    p = count_lean;
    p.varyings[0].mode = GP_SPRITE_COORD;
    assert_refused(&p, "program count_lean: varying 'a': sprite coordinates have 2 components, not "
                       "4");
    p = count_lean;
    p.color_components = 20;
    assert_refused(&p, "program count_lean: 20 colour components are not 0 to 4 targets of 4");
    p = count_lean;
    p.samplers = p.local_reads = 1 << 3;
    assert_refused(&p, "program count_lean: slots 0x8 are both samplers and local reads");
    p = count_lean;
    p.vertex_profile = GP_PS_2_0;
    assert_refused(&p, "program count_lean: vertex_profile is not one of a vertex shader");
    p = count_lean;
    p.pixel_profile = GP_VS_2_0;
    assert_refused(&p, "program count_lean: pixel_profile is not one of a pixel shader");
    p = depth_only_program;
    p.may_discard = true;
    assert_refused(&p,
                   "program depth_only_program: declares things of a pixel shader, and has none");
}

static void programs_without_counting_are_checked_by_their_declarations(void **state)
{
    (void)state;
    GpProgram p = count_over_slots;
    p.count = NULL;
    assert_accepted(&p);
    p.color_components = 3;
    assert_int_equal(gp_program_check(&p, NULL), GP_ERROR_INVALID);
}

static void profiles_have_direct3d_s_names(void **state)
{
    (void)state;
    assert_string_equal(gp_profile_name(GP_VS_2_0), "vs_2_0");
    assert_string_equal(gp_profile_name(GP_PS_2_B), "ps_2_b");
    assert_string_equal(gp_profile_name(GP_PS_3_SW), "ps_3_sw");
    for (GpProfile p = GP_PROFILE_NONE; p < GP_PROFILES; p++) {
        GpProfile software = gp_profile_software(p);
        assert_int_equal(gp_profile_limits(software)->slots, GP_UNLIMITED);
        assert_int_equal(gp_profile_is_vertex(software), gp_profile_is_vertex(p));
        assert_int_equal(strncmp(gp_profile_name(p), gp_profile_name(software), 4), 0);
    }
}

/* --- the shaders of shaders_c ----------------------------------------------------------------- */

static void every_program_fits_its_profile_at_a_known_cost(void **state)
{
    (void)state;
    const struct {
        const GpProgram *program;
        int vertex, arithmetic, texture, temporaries, constants;
    } rows[] = {
        { &blit_program, 2, 1, 1, 1, 0 },
        { &deferred_program, 1, 39, 3, 5, 10 },
        { &depth_program, 9, 2, 0, 1, 1 },
        { &depth_only_program, 4, 0, 0, 0, 0 },
        { &gbuffer_program, 6, 6, 0, 1, 2 },
        { &gouraud_program, 22, 1, 0, 0, 1 },
        { &normals_program, 5, 5, 0, 1, 1 },
        { &phong_program, 6, 21, 0, 2, 5 },
        { &sprite_program, 21, 13, 1, 1, 2 },
        { &textured_program, 6, 8, 1, 2, 4 },
        { &textured_phong_program, 7, 22, 1, 2, 5 },
        { &toon_program, 6, 17, 0, 2, 6 },
        { &unlit_program, 4, 1, 0, 0, 1 },
        { &vertex_color_program, 5, 1, 0, 0, 0 },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        assert_accepted(rows[i].program);
        assert_string_not_equal(gp_profile_name(rows[i].program->vertex_profile), "none");
        GpShaderCounts pixel = pixel_counts(rows[i].program);
        int counted[] = { vertex_counts(rows[i].program).slots, pixel.arithmetic_slots,
                          pixel.texture_slots, pixel.temporaries, pixel.constants };
        const int *expected = &rows[i].vertex;
        for (size_t k = 0; k < GP_COUNT(counted); k++)
            if (counted[k] != expected[k])
                fail_msg("%s: figure %zu is %d, not %d", rows[i].program->name, k, counted[k],
                         expected[k]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(instructions_cost_what_table_a3_says),
        cmocka_unit_test(loops_are_counted_once),
        cmocka_unit_test(chains_need_no_stack),
        cmocka_unit_test(kills_are_texture_slots_and_dearer_in_model_3),
        cmocka_unit_test(phong_costs_what_it_does_by_hand),
        cmocka_unit_test(code_that_reaches_no_output_costs_nothing),
        cmocka_unit_test(only_components_that_are_used_are_inputs),
        cmocka_unit_test(dependent_reads_count_computed_coordinates_in_a_row),
        cmocka_unit_test(constants_are_packed_four_a_register),
        cmocka_unit_test(temporaries_are_registers_that_live_at_once),
        cmocka_unit_test(vertex_shaders_report_size_textures_and_depth),
        cmocka_unit_test(counting_again_or_one_side_gives_the_same),
        cmocka_unit_test(programs_are_held_to_the_limits_of_their_profiles),
        cmocka_unit_test(wider_profiles_accept_what_narrow_ones_refuse),
        cmocka_unit_test(sat_is_dearer_in_vertex_shaders_of_model_2),
        cmocka_unit_test(vertex_textures_need_model_3),
        cmocka_unit_test(what_shaders_need_must_be_declared),
        cmocka_unit_test(declarations_must_agree_with_the_structs),
        cmocka_unit_test(programs_without_counting_are_checked_by_their_declarations),
        cmocka_unit_test(profiles_have_direct3d_s_names),
        cmocka_unit_test(every_program_fits_its_profile_at_a_known_cost),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
