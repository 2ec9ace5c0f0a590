/* What a draw needs, from its program and state; and the same in words. */
#include "pipeline/list/needs.h"

#include "pipeline/units/blend.h"

static bool needs_mip_levels(const GpDraw *draw)
{
    for (int i = 0; i < GP_MAX_SAMPLERS; i++) {
        const GpTexture *texture = &draw->textures[i];
        if (!(draw->program->samplers >> i & 1) || !texture->surface)
            continue;
        const GpSampler *s = &texture->sampler;
        bool levels = s->mip != GP_MIP_NONE && texture->surface->levels > 1;
        if (levels || s->min != s->mag)
            return true;
    }
    return false;
}

GpNeeds gp_draw_needs(const GpPass *pass, const GpDraw *draw, uint64_t varyings_read)
{
    const GpProgram *program = draw->program;
    const GpState *state = &draw->state;
    GpNeeds needs = { 0 };

    for (int i = 0; i < gp_program_targets(program) && i < GP_MAX_TARGETS; i++) {
        if (!pass->color[i].surface || (state->blend[i].keep & 15) == 15)
            continue;
        needs.color = true;
        needs.blend = needs.blend || gp_blend_reads_target(&state->blend[i]);
    }
    needs.discard = program->may_discard;
    needs.shader_depth = program->writes_depth && (pass->depth.surface || pass->order);
    needs.alpha_test = state->alpha_test.test != GP_ALWAYS && gp_program_targets(program) > 0;
    needs.depth_test = pass->depth.surface && state->depth.test != GP_ALWAYS;
    needs.ternary = needs.depth_test && state->depth.ternary;
    needs.depth_write = pass->depth.surface && state->depth.write;
    needs.stencil = pass->depth.surface && state->stencil.enable;
    bool anything = needs.color || needs.depth_write || needs.stencil;
    needs.sorted = pass->order != GP_ORDER_SUBMITTED && anything;
    needs.depth = (needs.depth_test || needs.depth_write || needs.sorted) && !needs.shader_depth;
    needs.pixel_shader = anything && program->code[0]->pixel &&
                         (needs.color || needs.discard || needs.shader_depth || needs.alpha_test);
    if (needs.pixel_shader) {
        needs.varyings = varyings_read;
        needs.textures = program->samplers != 0;
        needs.local_reads = program->local_reads != 0;
        needs.quads = program->uses_derivatives || needs_mip_levels(draw);
    }
    needs.interpolate = needs.varyings != 0;
    needs.vertex_textures = program->vertex_samplers != 0;
    needs.clip_planes = state->raster.clip_planes & ((1u << GP_MAX_CLIP_PLANES) - 1);
    needs.scissor = state->raster.scissor;
    needs.cull = state->raster.cull != GP_CULL_NONE;
    needs.depth_bias =
        needs.depth && (state->raster.depth_bias != 0 || state->raster.slope_depth_bias != 0);
    needs.late_depth = (needs.depth_test || needs.depth_write || needs.stencil) &&
                       needs.pixel_shader &&
                       (needs.discard || needs.alpha_test || needs.shader_depth);
    return needs;
}

void gp_needs_explain(const GpNeeds *needs, GpUnitNeed rows[GP_UNIT_NEEDS])
{
    const struct {
        const char *unit;
        bool runs;
        const char *why, *why_not;
    } units[GP_UNIT_NEEDS] = {
        { "vertex textures", needs->vertex_textures, "the vertex shader reads textures",
          "the vertex shader reads none" },
        { "culling", needs->cull, "one facing is culled", "both facings are drawn" },
        { "clip planes", needs->clip_planes != 0, "user planes are on", "no user plane" },
        { "depth bias", needs->depth_bias, "a bias is set", "no bias, or no depth" },
        { "interpolate depth", needs->depth, "depth is tested, written or sorted by",
          "no depth test, write or order, or the shader's own depth" },
        { "interpolate varyings", needs->interpolate, "the pixel shader reads them",
          "nothing reads them" },
        { "pixel shader", needs->pixel_shader, "colour, discard or depth depends on it",
          "nothing that it computes is kept" },
        { "whole quads", needs->quads, "derivatives or levels of detail", "no derivative is used" },
        { "textures", needs->textures, "the pixel shader reads them", "no texture read" },
        { "local reads", needs->local_reads, "earlier targets are read in place",
          "no earlier target is read in place" },
        { "scissor", needs->scissor, "a rectangle is set", "off" },
        { "alpha test", needs->alpha_test, "a function is set", "off" },
        { "sorting", needs->sorted, "the pass has an order by depth", "as submitted" },
        { "stencil", needs->stencil, "enabled", "off, or no stencil target" },
        { "depth test", needs->depth_test, "a function is set", "off, or no depth target" },
        { "ternary test", needs->ternary, "an epsilon tells replaced, added and dropped", "off" },
        { "depth write", needs->depth_write, "on", "off, or no depth target" },
        { "blending", needs->blend, "a target is read before it is written", "no target is read" },
        { "colour write", needs->color, "a target keeps some channel written",
          "no target, or all channels kept" },
    };
    for (size_t i = 0; i < GP_UNIT_NEEDS; i++)
        rows[i] = (GpUnitNeed){ units[i].unit, units[i].runs,
                                units[i].runs ? units[i].why : units[i].why_not };
}
