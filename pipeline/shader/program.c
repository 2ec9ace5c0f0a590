/* The check of a program: its declarations against each other, and its shaders, counted or tried,
 * against its declarations; counted ones against its profiles too. */
#include "pipeline/shader/program.h"

#include "pipeline/base/fpcontrol.h"
#include "pipeline/shader/profile.h"
#include "pipeline/shader/trial.h"

#include <string.h>

#define REFUSE(...) gp_fail(error, GP_ERROR_INVALID, __VA_ARGS__)

/* --- the program against itself --------------------------------------------------------------- */

static GpResult check_inputs(const GpProgram *p, GpError *error)
{
    int sum = 0;
    unsigned seen = 0;
    for (size_t i = 0; i < GP_COUNT(p->inputs) && p->inputs[i].components; i++) {
        const GpInputDecl *input = &p->inputs[i];
        if ((unsigned)input->semantic >= GP_SEMANTICS || input->components > 4)
            return REFUSE("program %s: inputs[%d]: unknown semantic, or more than 4 components",
                          p->name, (int)i);
        if (seen >> input->semantic & 1)
            return REFUSE("program %s: inputs[%d]: %s appears twice", p->name, (int)i,
                          gp_semantic_names[input->semantic]);
        seen |= 1u << input->semantic;
        sum += input->components;
    }
    if (sum != p->input_components || sum > GP_MAX_INPUTS)
        return REFUSE("program %s: inputs declare %d components, the vertex struct has %d", p->name,
                      sum, p->input_components);
    return GP_OK;
}

static GpResult check_varyings(const GpProgram *p, GpError *error)
{
    int sum = 0;
    for (size_t i = 0; i < GP_COUNT(p->varyings) && p->varyings[i].components; i++) {
        const GpVaryingDecl *varying = &p->varyings[i];
        if (!varying->name || !varying->name[0])
            return REFUSE("program %s: varyings[%d] has no name", p->name, (int)i);
        if (varying->components > 4 || (unsigned)varying->mode >= GP_INTERPOLATIONS)
            return REFUSE("program %s: varying '%s': more than 4 components, or an unknown mode",
                          p->name, varying->name);
        const bool sprite = varying->mode == GP_SPRITE_COORD;
        if (sprite && varying->components != 2)
            return REFUSE("program %s: varying '%s': sprite coordinates have 2 components, not %d",
                          p->name, varying->name, varying->components);
        for (size_t j = 0; j < i; j++) {
            if (strcmp(p->varyings[j].name, varying->name) == 0)
                return REFUSE("program %s: varying '%s' appears twice", p->name, varying->name);
            if (sprite && p->varyings[j].mode == GP_SPRITE_COORD)
                return REFUSE("program %s: varying '%s': a program has one varying of sprite "
                              "coordinates",
                              p->name, varying->name);
        }
        sum += varying->components;
    }
    if (sum != p->varying_components || sum > GP_MAX_VARYINGS)
        return REFUSE("program %s: varyings declare %d components, the struct has %d", p->name, sum,
                      p->varying_components);
    return GP_OK;
}

static GpResult check_code(const GpProgram *p, GpError *error)
{
    if (!p->code[0])
        return REFUSE("program %s: code[0] is missing: 4 lanes are always compiled", p->name);
    for (int i = 0; i < GP_CODE_WIDTHS; i++) {
        const GpProgramCode *code = p->code[i];
        if (!code)
            continue;
        if (code->lanes != 4 << i || !code->vertex || !code->isa)
            return REFUSE(
                "program %s: code[%d]: not of %d lanes, or without a vertex shader or an isa",
                p->name, i, 4 << i);
        if (!code->pixel != !p->code[0]->pixel)
            return REFUSE("program %s: code[%d]: some widths have a pixel shader, some do not",
                          p->name, i);
    }
    return GP_OK;
}

static GpResult check_pixel_side(const GpProgram *p, GpError *error)
{
    bool pixel = p->code[0]->pixel;
    int targets = gp_program_targets(p);
    if (p->color_components % 4 || targets > GP_MAX_TARGETS)
        return REFUSE("program %s: %d colour components are not 0 to %d targets of 4", p->name,
                      p->color_components, GP_MAX_TARGETS);
    if (pixel && p->pixel_input_components != p->varying_components)
        return REFUSE(
            "program %s: the vertex shader writes %d components, the pixel shader reads %d",
            p->name, p->varying_components, p->pixel_input_components);
    if (!pixel && (targets || p->pixel_profile || p->samplers || p->local_reads || p->may_discard ||
                   p->writes_depth))
        return REFUSE("program %s: declares things of a pixel shader, and has none", p->name);
    if (p->samplers & p->local_reads)
        return REFUSE("program %s: slots %#x are both samplers and local reads", p->name,
                      (unsigned)(p->samplers & p->local_reads));
    if ((unsigned)p->vertex_profile >= GP_PROFILES || gp_profile_is_pixel(p->vertex_profile))
        return REFUSE("program %s: vertex_profile is not one of a vertex shader", p->name);
    if ((unsigned)p->pixel_profile >= GP_PROFILES || gp_profile_is_vertex(p->pixel_profile))
        return REFUSE("program %s: pixel_profile is not one of a pixel shader", p->name);
    return GP_OK;
}

/* --- the shaders against the declarations ----------------------------------------------------- */

static GpResult check_slots_declared(const GpProgram *p, const char *field, unsigned read,
                                     unsigned declared, GpError *error)
{
    if (read & ~declared)
        return REFUSE("program %s: slot %d is read, but not declared in %s", p->name,
                      __builtin_ctz(read & ~declared), field);
    return GP_OK;
}

/* What an executor prepares only where it is declared. */
static GpResult check_features_declared(const GpProgram *p, const GpShaderCounts *vertex,
                                        const GpShaderCounts *pixel, GpError *error)
{
    const struct {
        const char *field;
        bool used, declared;
    } features[] = {
        { "may_discard", pixel->discards, p->may_discard },
        { "writes_depth", pixel->writes_depth, p->writes_depth },
        { "writes_point_size", vertex->writes_point_size, p->writes_point_size },
        { "uses_pixel", pixel->reads_pixel, p->uses_pixel },
        { "uses_face", pixel->reads_face, p->uses_face },
        { "uses_derivatives", pixel->needs_quads, p->uses_derivatives },
    };
    for (size_t i = 0; i < GP_COUNT(features); i++)
        if (features[i].used && !features[i].declared)
            return REFUSE("program %s: %s is not declared, but a shader needs it", p->name,
                          features[i].field);
    if (p->writes_depth && !pixel->writes_depth)
        return REFUSE("program %s: writes_depth is declared, but no odepth reached", p->name);
    if (p->writes_point_size && !vertex->writes_point_size)
        return REFUSE("program %s: writes_point_size is declared, but it is never written",
                      p->name);

    GpResult result = check_slots_declared(p, "samplers", pixel->sampler_slots, p->samplers, error);
    if (!result)
        result = check_slots_declared(p, "local_reads", pixel->local_slots, p->local_reads, error);
    if (!result)
        result = check_slots_declared(p, "vertex_samplers", vertex->sampler_slots,
                                      p->vertex_samplers, error);
    return result;
}

/* An output that is read, or stored to a target, must have been written: else a picture would hold
 * whatever was in memory. */
static GpResult check_outputs_written(const GpProgram *p, const GpShaderCounts *vertex,
                                      const GpShaderCounts *pixel, GpError *error)
{
    uint64_t missing = pixel->inputs_read & ~vertex->outputs_written;
    int first = 0;
    for (size_t i = 0; missing && i < GP_COUNT(p->varyings); i++) {
        uint64_t own = ((uint64_t)1 << p->varyings[i].components) - 1;
        if (missing >> first & own)
            return REFUSE("program %s: varying '%s' is read, but not written whole", p->name,
                          p->varyings[i].name);
        first += p->varyings[i].components;
    }
    for (int t = 0; t < gp_program_targets(p); t++)
        if ((pixel->outputs_written >> 4 * t & 15) != 15)
            return REFUSE("program %s: target %d is not written whole", p->name, t);
    return GP_OK;
}

/* Inputs of one width in another order than the struct's: told where its members are named as
 * semantics are. */
static GpResult check_named_inputs(const GpProgram *p, const GpShaderCounts *vertex, GpError *error)
{
    int first = 0;
    for (size_t i = 0; i < GP_COUNT(p->inputs) && p->inputs[i].components; i++) {
        const GpSemantic semantic = p->inputs[i].semantic;
        const int named = vertex->named_inputs[semantic];
        if (named && named != 1 + first)
            return REFUSE("program %s: inputs[%d]: %s is declared at component %d, but the vertex "
                          "struct has '%s' at %d: expected the order of the struct",
                          p->name, (int)i, gp_semantic_names[semantic], first,
                          gp_semantic_names[semantic], named - 1);
        first += p->inputs[i].components;
    }
    return GP_OK;
}

/* --- the counted shaders against their profiles ----------------------------------------------- */

/* Declared to have no counts, where that would help. */
static GpResult refuse_count(const GpProgram *p, GpProfile profile, const char *what, int count,
                             int limit, GpError *error)
{
    return REFUSE("program %s, %s: %d %s, at most %d; %s has no such limit", p->name,
                  gp_profile_name(profile), count, what, limit,
                  gp_profile_name(gp_profile_software(profile)));
}

static GpResult check_counts(const GpProgram *p, GpProfile profile, const GpShaderCounts *counts,
                             GpError *error)
{
    const GpProfileLimits *limits = gp_profile_limits(profile);
    const struct {
        const char *what;
        int count, limit;
    } rows[] = {
        { "slots", counts->slots, limits->slots },
        { "arithmetic slots", counts->arithmetic_slots, limits->arithmetic_slots },
        { "texture slots", counts->texture_slots, limits->texture_slots },
        { "temporaries", counts->temporaries, limits->temporaries },
        { "constants", counts->constants, limits->constants },
        { "inputs", counts->inputs, limits->inputs },
        { "orders of dependent reads", counts->dependent_reads, limits->dependent_reads },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        if (rows[i].count > rows[i].limit)
            return refuse_count(p, profile, rows[i].what, rows[i].count, rows[i].limit, error);
    if (counts->samplers > limits->samplers)
        return REFUSE("program %s, %s: %d samplers, at most %d", p->name, gp_profile_name(profile),
                      counts->samplers, limits->samplers);
    return GP_OK;
}

static GpResult check_instructions(const GpProgram *p, GpProfile profile,
                                   const GpShaderCounts *counts, GpError *error)
{
    const GpProfileLimits *limits = gp_profile_limits(profile);
    const char *name = gp_profile_name(profile);
    if (counts->gradients && !limits->gradients)
        return REFUSE("program %s, %s: has no dsx, dsy or texldd; ps_2_a, ps_2_sw and 3_0 have",
                      p->name, name);
    if (counts->explicit_lod && !limits->explicit_lod)
        return REFUSE("program %s, %s: has no texldl; model 3 has", p->name, name);
    if (counts->loops && !limits->explicit_lod) /* model 3 brought both */
        return REFUSE("program %s, %s: has no loop that is left by a mask; model 3 has", p->name,
                      name);
    if ((counts->reads_pixel || counts->reads_face) && !limits->pixel_registers)
        return REFUSE("program %s, %s: has no vPos and vFace; ps_3_0 has", p->name, name);
    return GP_OK;
}

/* The shaders against the declarations, and the vertex shader against what only pixels have. */
static GpResult check_uses(const GpProgram *p, const GpShaderCounts *vertex,
                           const GpShaderCounts *pixel, GpError *error)
{
    if (vertex->gradients || vertex->implicit_lod || vertex->local_slots || vertex->discards ||
        vertex->reads_pixel || vertex->reads_face)
        return REFUSE("program %s: the vertex shader uses what only pixels have: derivatives, "
                      "texld, discard, vpos ...",
                      p->name);
    GpResult result = check_features_declared(p, vertex, pixel, error);
    if (!result)
        result = check_outputs_written(p, vertex, pixel, error);
    return result;
}

static GpResult check_profiles(const GpProgram *p, const GpShaderCounts *vertex,
                               const GpShaderCounts *pixel, GpError *error)
{
    GpResult result = check_counts(p, p->vertex_profile, vertex, error);
    if (!result)
        result = check_instructions(p, p->vertex_profile, vertex, error);
    if (!result)
        result = check_counts(p, p->pixel_profile, pixel, error);
    if (!result)
        result = check_instructions(p, p->pixel_profile, pixel, error);
    return result;
}

static bool declares_position(const GpProgram *p)
{
    for (size_t i = 0; i < GP_COUNT(p->inputs) && p->inputs[i].components; i++)
        if (p->inputs[i].semantic == GP_POSITION)
            return true;
    return false;
}

GpResult gp_program_check(const GpProgram *program, GpError *error)
{
    if (!program->name || !program->name[0])
        return REFUSE("a program has no name");
    GpResult (*const checks[])(const GpProgram *, GpError *) = { check_inputs, check_varyings,
                                                                 check_code, check_pixel_side };
    for (size_t i = 0; i < GP_COUNT(checks); i++)
        if (checks[i](program, error))
            return GP_ERROR_INVALID;
    if (!program->count)
        return GP_OK;

    GpShaderCounts vertex, pixel;
    const GpFpControl control = gp_fp_enter(); /* it runs the shaders, on denormal numbers too */
    const bool counted = program->count(program, &vertex, &pixel);
    gp_fp_leave(control);
    if (!counted)
        return gp_fail(error, GP_ERROR_MEMORY, "program %s: no memory to count its instructions",
                       program->name);
    GpResult result = check_named_inputs(program, &vertex, error);
    if (!result)
        result = check_uses(program, &vertex, &pixel, error);
    if (!result)
        result = check_profiles(program, &vertex, &pixel, error);
    return result;
}

GpResult gp_program_try(const GpProgram *p, const GpProgramCode *code, const void *uniforms,
                        GpError *error)
{
    const GpFpControl control = gp_fp_enter();
    const GpTrial trial = gp_program_trial(p, code, uniforms);
    gp_fp_leave(control);
    if (trial.fused)
        return REFUSE("program %s: its %s code rounds a * b + c once, which makes other pictures: "
                      "compile it with -ffp-contract=off",
                      p->name, code->isa);
    if (trial.wrong_slot)
        return REFUSE("program %s: slot %d is read, but there are samplers 0 to %d only", p->name,
                      trial.wrong_slot, GP_MAX_SAMPLERS - 1);
    if (!trial.writes_position)
        return REFUSE("program %s: the vertex shader does not write all of *position", p->name);
    GpResult result = check_uses(p, &trial.vertex, &trial.pixel, error);
    if (!result && trial.other_input_moves && !trial.position_moves && declares_position(p))
        return REFUSE(
            "program %s: inputs: the clip-space position follows other inputs, but not %s: "
            "expected the order of the vertex struct",
            p->name, gp_semantic_names[GP_POSITION]);
    return result;
}
