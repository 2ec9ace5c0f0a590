#include "apps/inspect/frame_tell.h"

#include "apps/base/json.h"
#include "apps/inspect/uniforms.h"
#include "pipeline/shader/counts.h"

/* --- state ------------------------------------------------------------------------------------ */

static void set_text(json_t *object, const char *key, const char *text)
{
    json_object_set_new(object, key, json_string(text));
}

static void set_number(json_t *object, const char *key, float value)
{
    json_object_set_new(object, key, json_number((double)value));
}

static void tell_raster(json_t *state, const GpDraw *draw)
{
    const GpRasterState *raster = &draw->state.raster;
    const GpViewport *viewport = &draw->viewport;
    set_text(state, "cull", gp_cull_names[raster->cull]);
    json_object_set_new(state, "scissor",
                        raster->scissor
                            ? json_pack("[i, i, i, i]", raster->scissor_x0, raster->scissor_y0,
                                        raster->scissor_x1, raster->scissor_y1)
                            : json_string("off"));
    set_number(state, "depth bias", raster->depth_bias);
    set_number(state, "slope depth bias", raster->slope_depth_bias);
    json_object_set_new(state, "clip planes", json_integer(raster->clip_planes));
    const float rect[] = { viewport->x, viewport->y, viewport->width, viewport->height };
    json_object_set_new(state, "viewport",
                        viewport->width != 0 ? json_floats(rect, 4) : json_string("whole target"));
}

static void tell_depth(json_t *state, const GpState *draw)
{
    set_text(state, "depth test", gp_compare_names[draw->depth.test]);
    set_text(state, "depth write", draw->depth.write ? "on" : "off");
    if (draw->depth.ternary)
        set_number(state, "ternary epsilon", draw->depth.epsilon);
    set_text(state, "alpha test", gp_compare_names[draw->alpha_test.test]);
    json_object_set_new(state, "alpha reference", json_integer(draw->alpha_test.reference));
}

static json_t *stencil_face(const GpStencilFace *face)
{
    return json_sprintf("%s; fail %s, depth fail %s, pass %s", gp_compare_names[face->test],
                        gp_stencil_op_names[face->fail], gp_stencil_op_names[face->depth_fail],
                        gp_stencil_op_names[face->pass]);
}

static void tell_stencil(json_t *state, const GpStencilState *stencil)
{
    json_object_set_new(state, "stencil",
                        stencil->enable ? stencil_face(&stencil->front) : json_string("off"));
    if (!stencil->enable)
        return;
    if (stencil->two_sided)
        json_object_set_new(state, "stencil of back faces", stencil_face(&stencil->back));
    json_object_set_new(state, "stencil reference", json_integer(stencil->reference));
    json_object_set_new(state, "stencil read mask", json_integer((uint8_t)~stencil->ignore));
    json_object_set_new(state, "stencil write mask", json_integer((uint8_t)~stencil->keep));
}

static json_t *blend_text(const GpBlend *blend)
{
    if (blend->op == GP_BLEND_OFF)
        return json_string("off");
    if (blend->op > GP_BLEND_REV_SUBTRACT)
        return json_string(gp_blend_op_names[blend->op]);
    return json_sprintf("%s: source * %s, target * %s", gp_blend_op_names[blend->op],
                        gp_blend_factor_names[blend->src], gp_blend_factor_names[blend->dst]);
}

static void tell_blend(json_t *state, const GpPass *pass, const GpState *draw)
{
    for (int t = 0; t < GP_MAX_TARGETS; t++) {
        const GpBlend *blend = &draw->blend[t];
        char key[32];
        if (!pass->color[t].surface)
            continue;
        snprintf(key, sizeof key, "blend %d", t);
        json_object_set_new(state, key, blend_text(blend));
        if (blend->alpha_op != GP_BLEND_OFF) {
            snprintf(key, sizeof key, "blend alpha %d", t);
            json_object_set_new(state, key,
                                json_sprintf("%s: source * %s, target * %s",
                                             gp_blend_op_names[blend->alpha_op],
                                             gp_blend_factor_names[blend->alpha_src],
                                             gp_blend_factor_names[blend->alpha_dst]));
        }
        snprintf(key, sizeof key, "write mask %d", t);
        json_object_set_new(state, key,
                            json_sprintf("%s%s%s%s", blend->keep & 1 ? "-" : "r",
                                         blend->keep & 2 ? "-" : "g", blend->keep & 4 ? "-" : "b",
                                         blend->keep & 8 ? "-" : "a"));
    }
    json_object_set_new(state, "blend constant", json_floats(draw->blend_constant, 4));
}

static json_t *tell_state(const GpPass *pass, const GpDraw *draw)
{
    json_t *state = json_object();
    set_text(state, "program", draw->program->name);
    tell_raster(state, draw);
    tell_depth(state, &draw->state);
    tell_stencil(state, &draw->state.stencil);
    tell_blend(state, pass, &draw->state);
    return state;
}

/* --- draws ------------------------------------------------------------------------------------ */

static json_t *tell_units(const GpNeeds *needs)
{
    GpUnitNeed rows[GP_UNIT_NEEDS];
    gp_needs_explain(needs, rows);
    json_t *units = json_array();
    for (size_t i = 0; i < GP_UNIT_NEEDS; i++)
        json_array_append_new(units, json_pack("{s:s, s:b, s:s}", "unit", rows[i].unit, "runs",
                                               (int)rows[i].runs, "why", rows[i].why));
    return units;
}

json_t *frame_tell_textures(const GpDraw *draw)
{
    json_t *textures = json_array();
    for (int slot = 0; slot < GP_MAX_SAMPLERS; slot++) {
        const GpTexture *texture = &draw->textures[slot];
        const GpSurface *surface = texture->surface;
        if (!surface)
            continue;
        json_array_append_new(
            textures,
            json_pack("{s:i, s:s, s:s, s:i, s:i, s:i, s:s, s:s, s:s, s:s, s:s, s:b}", "slot", slot,
                      "name", surface->name, "format", gp_format_info(surface->format)->name,
                      "width", (int)surface->width, "height", (int)surface->height, "levels",
                      (int)surface->levels, "min", gp_filter_names[texture->sampler.min], "mag",
                      gp_filter_names[texture->sampler.mag], "mip",
                      gp_mip_filter_names[texture->sampler.mip], "u",
                      gp_address_names[texture->sampler.address_u], "v",
                      gp_address_names[texture->sampler.address_v], "compare",
                      (int)texture->sampler.compare));
    }
    return textures;
}

static json_t *tell_inputs(const GpDraw *draw)
{
    static const char *const types[GP_COMPONENT_TYPES] = {
        "float32", "unorm8", "d3dcolor", "uint8",   "int8",    "snorm8",
        "uint16",  "int16",  "unorm16",  "snorm16", "float16",
    };
    const GpProgram *program = draw->program;
    json_t *inputs = json_array();
    for (size_t i = 0; i < GP_COUNT(program->inputs) && program->inputs[i].components; i++) {
        const GpStream *stream = &draw->geometry.streams[program->inputs[i].semantic];
        json_array_append_new(inputs,
                              json_pack("{s:s, s:i, s:s, s:i, s:i}", "name",
                                        gp_semantic_names[program->inputs[i].semantic],
                                        "components", (int)program->inputs[i].components, "type",
                                        types[stream->type], "stored", (int)stream->components,
                                        "stride", (int)gp_stream_stride(stream)));
    }
    return inputs;
}

static json_t *tell_varyings(const GpProgram *program)
{
    static const char *const modes[GP_INTERPOLATIONS] = { "perspective", "linear on the screen",
                                                          "flat", "sprite coordinate" };
    json_t *varyings = json_array();
    for (size_t i = 0; i < GP_COUNT(program->varyings) && program->varyings[i].components; i++)
        json_array_append_new(varyings,
                              json_pack("{s:s, s:i, s:s}", "name", program->varyings[i].name,
                                        "components", (int)program->varyings[i].components, "mode",
                                        modes[program->varyings[i].mode]));
    return varyings;
}

static json_t *tell_costs(const GpProgram *program, bool pixel)
{
    GpShaderCounts counts[2] = { { 0 }, { 0 } };
    if (!program->count || !program->count(program, &counts[0], &counts[1]))
        return json_null();
    const GpShaderCounts *of = &counts[pixel];
    return json_pack("{s:s, s:i, s:i, s:i, s:i}", "profile",
                     gp_profile_name(pixel ? program->pixel_profile : program->vertex_profile),
                     "slots", of->slots, "temporaries", of->temporaries, "constants", of->constants,
                     "samplers", of->samplers);
}

static json_t *tell_draw(const GpPass *pass, uint32_t number)
{
    const GpDraw *draw = &pass->draws[number];
    const GpGeometry *geometry = &draw->geometry;
    const GpNeeds needs = gp_draw_needs(pass, draw, gp_pixel_facts(draw->program).varyings_read);
    json_t *told = json_pack("{s:I, s:s, s:s, s:s, s:I, s:I, s:I, s:b}", "draw", (json_int_t)number,
                             "name", draw->name ? draw->name : "", "program", draw->program->name,
                             "geometry", gp_primitive_names[geometry->primitive], "primitives",
                             (json_int_t)gp_geometry_primitives(geometry), "vertices",
                             (json_int_t)geometry->vertex_count, "elements",
                             (json_int_t)gp_geometry_elements(geometry), "indexed",
                             (int)gp_geometry_is_indexed(geometry));
    json_object_set_new(told, "units", tell_units(&needs));
    json_object_set_new(told, "state", tell_state(pass, draw));
    json_object_set_new(told, "textures", frame_tell_textures(draw));
    json_object_set_new(told, "uniforms", uniforms_tell(draw));
    json_object_set_new(told, "inputs", tell_inputs(draw));
    json_object_set_new(told, "varyings", tell_varyings(draw->program));
    json_object_set_new(told, "vertex_shader", tell_costs(draw->program, false));
    json_object_set_new(told, "pixel_shader", tell_costs(draw->program, true));
    return told;
}

/* --- passes ----------------------------------------------------------------------------------- */

static json_t *tell_targets(const GpPass *pass, const Targets *targets)
{
    json_t *list = json_array();
    for (int t = 0; t < GP_MAX_TARGETS; t++) {
        const GpColorTarget *target = &pass->color[t];
        if (target->surface)
            json_array_append_new(
                list, json_pack("{s:o, s:i, s:o}", "slot", json_sprintf("%d", t), "surface",
                                targets_number(targets, target->surface), "clear",
                                target->clear ? json_floats(target->clear_color, 4) : json_null()));
    }
    const GpDepthTarget *depth = &pass->depth;
    if (depth->surface)
        json_array_append_new(
            list,
            json_pack("{s:s, s:i, s:o, s:o}", "slot", "depth", "surface",
                      targets_number(targets, depth->surface), "clear",
                      depth->clear_depth ? json_number((double)depth->depth_value) : json_null(),
                      "clear_stencil",
                      depth->clear_stencil ? json_integer(depth->stencil_value) : json_null()));
    return list;
}

json_t *frame_tell_pass(const GpList *list, uint32_t number, uint32_t group, uint32_t draws,
                        const Targets *targets)
{
    const GpPass *pass = &list->passes[number];
    uint32_t width, height;
    gp_pass_size(pass, &width, &height);
    json_t *told = json_pack("{s:I, s:s, s:I, s:I, s:s, s:I, s:I, s:o}", "pass", (json_int_t)number,
                             "name", pass->name ? pass->name : "", "width", (json_int_t)width,
                             "height", (json_int_t)height, "order", gp_order_names[pass->order],
                             "group", (json_int_t)group, "draw_count", (json_int_t)pass->draw_count,
                             "targets", tell_targets(pass, targets));
    json_t *list_of_draws = json_array();
    for (uint32_t i = 0; i < pass->draw_count && i < draws; i++)
        json_array_append_new(list_of_draws, tell_draw(pass, i));
    json_object_set_new(told, "draws", list_of_draws);
    return told;
}
