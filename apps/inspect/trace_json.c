#include "apps/inspect/trace_json.h"

#include "apps/base/json.h"

static json_t *clear_event(const GpTraceEvent *event)
{
    const GpPass *pass = event->clear.pass;
    json_t *targets = json_array(), *object = json_object();
    for (int i = 0; i < GP_MAX_TARGETS; i++)
        if (pass->color[i].surface && pass->color[i].clear)
            json_array_append_new(targets,
                                  json_pack("{s:i, s:s, s:o}", "target", i, "format",
                                            gp_format_info(pass->color[i].surface->format)->name,
                                            "color", json_floats(pass->color[i].clear_color, 4)));
    json_object_set_new(object, "targets", targets);
    if (pass->depth.surface && pass->depth.clear_depth)
        json_object_set_new(object, "depth", json_number((double)pass->depth.depth_value));
    if (pass->depth.surface && pass->depth.clear_stencil)
        json_object_set_new(object, "stencil", json_integer(pass->depth.stencil_value));
    return object;
}

static json_t *vertex_event(const GpTraceEvent *event)
{
    const GpTraceVertex *vertex = &event->vertex;
    return json_pack("{s:I, s:o, s:o, s:o}", "vertex", (json_int_t)vertex->vertex, "inputs",
                     json_floats(vertex->inputs, vertex->input_components), "clip",
                     json_floats(vertex->clip, 4), "varyings",
                     json_floats(vertex->varyings, vertex->varying_components));
}

static json_t *clip_event(const GpTraceEvent *event)
{
    const GpTraceClip *clip = &event->clip;
    json_t *corners = json_array();
    json_t *left = json_array();
    for (int i = 0; i < 3; i++)
        json_array_append_new(corners, json_floats(clip->clip[i], 4));
    for (int i = 0; i < clip->corners; i++)
        json_array_append_new(left, json_floats(clip->corner[i], 4));
    return json_pack("{s:o, s:i, s:i, s:o, s:o}", "clip", corners, "planes", (int)clip->planes,
                     "corners", clip->corners, "polygon", left, "band", json_floats(clip->band, 4));
}

static json_t *edges_json(const GpTraceSetup *setup)
{
    json_t *edges = json_array();
    for (int i = 0; i < 3; i++)
        json_array_append_new(edges,
                              json_pack("{s:I, s:I, s:I, s:b}", "a", (json_int_t)setup->a[i], "b",
                                        (json_int_t)setup->b[i], "c", (json_int_t)setup->c[i],
                                        "accepts_zero", (int)setup->accepts_zero[i]));
    return edges;
}

static json_t *setup_event(const GpTraceEvent *event)
{
    const GpTraceSetup *setup = &event->setup;
    json_t *places = json_array(), *moved = json_array();
    for (int i = 0; i < 3; i++) {
        const double by[2] = { setup->x[i] / 256.0 - (double)setup->place[i][0],
                               setup->y[i] / 256.0 - (double)setup->place[i][1] };
        json_array_append_new(places, json_floats(setup->place[i], 2));
        json_array_append_new(moved, json_pack("[o, o]", json_number(by[0]), json_number(by[1])));
    }
    json_t *object =
        json_pack("{s:i, s:o, s:o, s:[iii], s:[iii], s:o, s:o, s:I, s:b, s:o}", "part", setup->part,
                  "place", places, "moved", moved, "x", setup->x[0], setup->x[1], setup->x[2], "y",
                  setup->y[0], setup->y[1], setup->y[2], "z", json_floats(setup->z, 3), "rw",
                  json_floats(setup->rw, 3), "area2", (json_int_t)setup->area2, "culled",
                  (int)setup->culled, "reason", json_text(setup->reason));
    if (!setup->culled)
        json_object_set_new(object, "edges", edges_json(setup));
    return object;
}

static json_t *raster_event(const GpTraceEvent *event)
{
    const GpTraceRaster *raster = &event->raster;
    return json_pack("{s:[III], s:b}", "edge", (json_int_t)raster->edge[0],
                     (json_int_t)raster->edge[1], (json_int_t)raster->edge[2], "front",
                     raster->front);
}

/* Beside the values, their differences: to the right and downward in the quad, as dsx and dsy have
 * them, and of what is linear on the screen to what is drawn. */
static json_t *interpolate_event(const GpTraceEvent *event)
{
    const GpTraceInterpolate *interpolate = &event->interpolate;
    const int components = interpolate->components, right = event->x & 1, low = event->y & 1;
    json_t *quad = json_array(), *steps = json_array(), *gap = json_array();
    for (int c = 0; c < components; c++) {
        const float *value = interpolate->quad + 4 * c;
        const float step[2] = { value[2 * low + 1] - value[2 * low],
                                value[2 + right] - value[right] };
        json_array_append_new(quad, json_floats(value, 4));
        json_array_append_new(steps, json_floats(step, 2));
        json_array_append_new(gap, json_number((double)interpolate->screen_varyings[c] -
                                               (double)interpolate->varyings[c]));
    }
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:i, s:o}", "differences", steps, "gap",
                     gap, "barycentric", json_floats(interpolate->barycentric, 3), "depth",
                     json_number((double)interpolate->depth), "varyings",
                     json_floats(interpolate->varyings, components), "screen",
                     json_floats(interpolate->screen, 3), "screen_varyings",
                     json_floats(interpolate->screen_varyings, components), "mask",
                     (int)interpolate->mask, "quad", quad);
}

static json_t *texture_event(const GpTraceEvent *event)
{
    const GpTraceTexture *texture = &event->texture;
    json_t *texels = json_array();
    for (int i = 0; i < texture->report.count; i++) {
        const GpTexelUse *texel = &texture->report.texel[i];
        json_t *told = json_pack("{s:i, s:i, s:i, s:o, s:o}", "level", texel->level, "x", texel->x,
                                 "y", texel->y, "weight", json_number((double)texel->weight),
                                 "value", json_floats(texel->value, 4));
        if (texture->report.compares) {
            const float ahead = texel->value[0] - texture->coord[2];
            json_object_set_new(told, "passes", json_boolean(texel->passes));
            json_object_set_new(told, "ahead", json_number((double)ahead));
        }
        json_array_append_new(texels, told);
    }
    const GpSurface *surface = texture->surface;
    return json_pack("{s:i, s:o, s:o, s:o, s:o, s:b, s:b, s:o, s:o}", "slot", texture->slot,
                     "surface", json_text(surface ? surface->name : NULL), "format",
                     json_text(surface ? gp_format_info(surface->format)->name : NULL), "coord",
                     json_floats(texture->coord, 4), "lod",
                     json_number((double)texture->report.lod), "magnified",
                     texture->report.magnified, "compares", texture->report.compares, "texels",
                     texels, "result", json_floats(texture->texel, 4));
}

static json_t *pixel_event(const GpTraceEvent *event)
{
    const GpTracePixel *pixel = &event->pixel;
    json_t *colors = json_array();
    for (int i = 0; i < pixel->targets; i++)
        json_array_append_new(colors, json_floats(pixel->color[i], 4));
    return json_pack("{s:o, s:o, s:b}", "color", colors, "depth", json_number((double)pixel->depth),
                     "killed", pixel->killed);
}

static json_t *sort_event(const GpTraceEvent *event)
{
    const GpTraceSort *sort = &event->sort;
    return json_pack("{s:s, s:i, s:i, s:o}", "order", gp_order_names[sort->order], "place",
                     (int)sort->place, "count", (int)sort->count, "depth",
                     json_number((double)sort->depth));
}

static json_t *test_event(const GpTraceEvent *event)
{
    const GpTraceTest *test = &event->test;
    json_t *object =
        json_pack("{s:s, s:s, s:o, s:o, s:b}", "unit", test->unit, "compare",
                  gp_compare_names[test->compare], "incoming", json_number(test->incoming),
                  "stored", json_number(test->stored), "passed", test->passed);
    json_object_set_new(object, "incoming_code", json_integer(test->incoming_code));
    json_object_set_new(object, "stored_code", json_integer(test->stored_code));
    if (test->ternary) {
        json_object_set_new(object, "ternary", json_string(gp_trace_ternary(test)));
        json_object_set_new(object, "epsilon", json_number(test->epsilon));
    }
    if (test->stencil_before >= 0) {
        json_object_set_new(object, "stencil_before", json_integer(test->stencil_before));
        json_object_set_new(object, "stencil_after", json_integer(test->stencil_after));
    }
    return object;
}

static json_t *output_event(const GpTraceEvent *event)
{
    const GpTraceOutput *output = &event->output;
    const GpBlend *blend = &output->blend;
    bool separate = blend->alpha_op != GP_BLEND_OFF;
    json_t *state = json_pack(
        "{s:s, s:s, s:s, s:s, s:s, s:s, s:i}", "op", gp_blend_op_names[blend->op], "src",
        gp_blend_factor_names[blend->src], "dst", gp_blend_factor_names[blend->dst], "alpha_op",
        gp_blend_op_names[separate ? blend->alpha_op : blend->op], "alpha_src",
        gp_blend_factor_names[separate ? blend->alpha_src : blend->src], "alpha_dst",
        gp_blend_factor_names[separate ? blend->alpha_dst : blend->dst], "keep", blend->keep);
    return json_pack("{s:i, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "target", output->target,
                     "format", gp_format_info(output->surface->format)->name, "blend", state,
                     "source", json_floats(output->source, 4), "destination",
                     json_floats(output->destination, 4), "source_factor",
                     json_floats(output->factor[0], 4), "destination_factor",
                     json_floats(output->factor[1], 4), "blended", json_floats(output->blended, 4),
                     "result", json_floats(output->result, 4));
}

/* The steps themselves have a form of their own: steps_json.h. */
static json_t *steps_event(const GpTraceEvent *event)
{
    json_t *object =
        json_pack("{s:i, s:b}", "steps", event->steps.steps, "agrees", (int)event->steps.agrees);
    if (event->steps.of_vertex)
        json_object_set_new(object, "corner", json_integer(event->steps.lane));
    return object;
}

static json_t *missed_event(const GpTraceEvent *event)
{
    const GpTraceMissed *missed = &event->missed;
    return json_pack("{s:s, s:b, s:o}", "reason", missed->reason, "front", (int)missed->front,
                     "depth", missed->has_depth ? json_number((double)missed->depth) : json_null());
}

json_t *trace_json(const GpTraceEvent *event)
{
    static json_t *(*const members[GP_TRACE_KINDS])(const GpTraceEvent *) = {
        [GP_TRACE_CLEAR] = clear_event,     [GP_TRACE_VERTEX] = vertex_event,
        [GP_TRACE_CLIP] = clip_event,       [GP_TRACE_SETUP] = setup_event,
        [GP_TRACE_RASTER] = raster_event,   [GP_TRACE_INTERPOLATE] = interpolate_event,
        [GP_TRACE_TEXTURE] = texture_event, [GP_TRACE_PIXEL] = pixel_event,
        [GP_TRACE_SORT] = sort_event,       [GP_TRACE_TEST] = test_event,
        [GP_TRACE_OUTPUT] = output_event,   [GP_TRACE_STEPS] = steps_event,
        [GP_TRACE_MISSED] = missed_event,
    };
    json_t *object = json_pack("{s:s, s:I, s:o}", "kind", gp_trace_kind_names[event->kind], "pass",
                               (json_int_t)event->pass, "pass_name", json_text(event->pass_name));
    if (event->kind != GP_TRACE_CLEAR) {
        json_object_set_new(object, "draw", json_integer(event->draw));
        json_object_set_new(object, "draw_name", json_text(event->draw_name));
        json_object_set_new(object, "primitive", json_integer(event->primitive));
        json_object_set_new(object, "program", json_text(event->program_name));
    }
    json_t *rest = members[event->kind](event);
    json_object_update(object, rest);
    json_decref(rest);
    return object;
}
