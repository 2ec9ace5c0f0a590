#include "apps/inspect/histories.h"

#include "apps/inspect/trace_json.h"
#include "pipeline/base/grow.h"

#include <stdlib.h>
#include <string.h>

GpResult histories_begin(Histories *histories, const GpPass *pass, GpError *error)
{
    *histories = (Histories){ .pass = pass };
    gp_pass_size(pass, &histories->width, &histories->height);
    histories->number =
        gp_alloc((size_t)histories->width * histories->height, sizeof *histories->number);
    histories->primitives = json_object();
    histories->told = json_array();
    return histories->number ? GP_OK
                             : gp_fail(error, GP_ERROR_MEMORY, "no memory for pixels' histories");
}

void histories_choose(Histories *histories, int32_t x, int32_t y)
{
    if (x < 0 || y < 0 || x >= (int32_t)histories->width || y >= (int32_t)histories->height ||
        histories_want(histories, x, y))
        return;
    HistoryPixel *list = gp_grown(histories->pixel, histories->count, &histories->room,
                                  sizeof *list, &histories->failed);
    if (!list)
        return;
    histories->pixel = list;
    histories->pixel[histories->count++] = (HistoryPixel){ .x = x, .y = y };
    histories->number[(uint32_t)y * histories->width + (uint32_t)x] = histories->count;
}

static int by_number(const void *one, const void *other)
{
    const uint64_t a = *(const uint64_t *)one, b = *(const uint64_t *)other;
    return (a > b) - (a < b);
}

static uint64_t key_of(uint32_t draw, uint32_t primitive)
{
    return (uint64_t)draw << 32 | primitive;
}

GpResult histories_ask(Histories *histories, const Fragments *fragments, GpError *error)
{
    size_t count = 0;
    for (size_t i = 0; i < fragments->count; i++)
        count += histories->number[fragments->all[i].pixel] != 0;
    uint64_t *asked = gp_alloc(count + 1, sizeof *asked);
    if (!asked)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the primitives of pixels");
    count = 0;
    for (size_t i = 0; i < fragments->count; i++)
        if (histories->number[fragments->all[i].pixel])
            asked[count++] = key_of(fragments->all[i].draw, fragments->all[i].primitive);
    qsort(asked, count, sizeof *asked, by_number);
    gp_free(histories->asked);
    histories->asked = asked;
    histories->asked_count = count;
    return GP_OK;
}

static bool is_asked(const Histories *histories, uint32_t draw, uint32_t primitive)
{
    const uint64_t key = key_of(draw, primitive);
    return histories->asked_count &&
           bsearch(&key, histories->asked, histories->asked_count, sizeof key, by_number);
}

/* --- primitives ------------------------------------------------------------------------------- */

static void primitive_key(char key[32], uint32_t draw, uint32_t primitive)
{
    snprintf(key, 32, "%u/%u", draw, primitive);
}

/* What a primitive's events have in common with it. */
static json_t *bare(const GpTraceEvent *event)
{
    static const char *const names[] = { "pass", "pass_name", "draw_name", "program" };
    json_t *object = trace_json(event);
    for (size_t i = 0; i < GP_COUNT(names); i++)
        json_object_del(object, names[i]);
    return object;
}

static json_t *bare_of_primitive(const GpTraceEvent *event)
{
    json_t *object = bare(event);
    json_object_del(object, "draw");
    json_object_del(object, "primitive");
    json_object_del(object, "kind");
    return object;
}

/* The bytes of a vertex's inputs as its streams hold them, in hexadecimal. */
static json_t *raw_json(const GpDraw *draw, uint32_t vertex)
{
    const GpProgram *program = draw->program;
    json_t *raw = json_array();
    for (size_t i = 0; i < GP_COUNT(program->inputs) && program->inputs[i].components; i++) {
        const GpStream *stream = &draw->geometry.streams[program->inputs[i].semantic];
        const size_t bytes = stream->components * gp_component_bytes(stream->type);
        const size_t stride = gp_stream_stride(stream);
        char text[64] = "";
        for (size_t b = 0, at = 0; stream->data && b < bytes; b++)
            at += (size_t)snprintf(text + at, sizeof text - at, b % 4 || !b ? "%02x" : " %02x",
                                   ((const uint8_t *)stream->data)[vertex * stride + b]);
        json_array_append_new(raw, json_string(text));
    }
    return raw;
}

enum { MOST_ELEMENTS = 1 << 16 }; /* that are looked through for each vertex */

/* Elements of a draw that name a vertex; 0 where there are too many to look through. */
static uint32_t uses_of(const GpGeometry *geometry, uint32_t vertex)
{
    uint32_t uses = 0;
    if (gp_geometry_elements(geometry) > MOST_ELEMENTS)
        return 0;
    for (uint32_t i = 0; i < gp_geometry_elements(geometry); i++)
        uses += gp_geometry_vertex(geometry, i) == vertex;
    return uses;
}

static void add_streams(const Histories *histories, json_t *primitive)
{
    const GpDraw *draw =
        &histories->pass->draws[json_integer_value(json_object_get(primitive, "draw"))];
    size_t i;
    json_t *vertex;
    json_array_foreach(json_object_get(primitive, "vertices"), i, vertex)
    {
        const uint32_t number = (uint32_t)json_integer_value(json_object_get(vertex, "vertex"));
        json_object_set_new(vertex, "raw", raw_json(draw, number));
        json_object_set_new(vertex, "reuse", json_integer(uses_of(&draw->geometry, number)));
    }
}

static void close_primitive(Histories *histories)
{
    if (histories->open && histories->open_is_asked) {
        char key[32];
        primitive_key(key, (uint32_t)json_integer_value(json_object_get(histories->open, "draw")),
                      (uint32_t)json_integer_value(json_object_get(histories->open, "primitive")));
        if (!json_object_get(histories->primitives, key)) {
            json_object_set_new(histories->primitives, key,
                                json_integer((json_int_t)json_array_size(histories->told)));
            add_streams(histories, histories->open);
            json_array_append(histories->told, histories->open);
        }
    }
    json_decref(histories->open);
    histories->open = NULL;
    histories->open_is_asked = false;
}

static bool is_open(const Histories *histories, const GpTraceEvent *event, uint32_t draw)
{
    return histories->open &&
           json_integer_value(json_object_get(histories->open, "draw")) == draw &&
           json_integer_value(json_object_get(histories->open, "primitive")) == event->primitive;
}

/* The steps of a corner's vertex shader, beside what else is known of the vertex. */
static void add_vertex_steps(Histories *histories, const GpTraceSteps *steps)
{
    json_t *vertex =
        json_array_get(json_object_get(histories->open, "vertices"), (size_t)steps->lane);
    if (!vertex || !histories_want_steps(histories))
        return;
    json_object_set_new(vertex, "steps", steps_json(&histories->listings, steps));
    histories->bytes += 12 * (size_t)steps->steps; /* about what it takes */
}

static void primitive_event(Histories *histories, const GpTraceEvent *event, uint32_t draw)
{
    if (!is_open(histories, event, draw)) {
        close_primitive(histories);
        if (!is_asked(histories, draw, event->primitive))
            return;
        histories->open =
            json_pack("{s:I, s:I, s:[], s:n, s:[]}", "draw", (json_int_t)draw, "primitive",
                      (json_int_t)event->primitive, "vertices", "clip", "setup");
    }
    if (event->kind == GP_TRACE_STEPS) {
        add_vertex_steps(histories, &event->steps);
        return;
    }
    json_t *told = bare_of_primitive(event);
    if (event->kind == GP_TRACE_VERTEX)
        json_array_append_new(json_object_get(histories->open, "vertices"), told);
    else if (event->kind == GP_TRACE_SETUP)
        json_array_append_new(json_object_get(histories->open, "setup"), told);
    else
        json_object_set_new(histories->open, "clip", told);
}

/* --- events ----------------------------------------------------------------------------------- */

static void add_event(Histories *histories, HistoryPixel *pixel, json_t *event)
{
    char *text = event ? json_dumps(event, JSON_COMPACT | JSON_REAL_PRECISION(9)) : NULL;
    json_decref(event);
    if (text) {
        text_add(&pixel->events, "%s%s", pixel->events.length ? "," : "", text);
        histories->bytes += strlen(text);
    } else {
        pixel->events.failed = true;
    }
    free(text);
}

void histories_event(Histories *histories, const GpTraceEvent *event, uint32_t draw)
{
    if (!histories->number || event->kind == GP_TRACE_CLEAR)
        return;
    if (event->x < 0) {
        primitive_event(histories, event, draw);
        return;
    }
    if (!histories_want(histories, event->x, event->y))
        return;
    if (histories->bytes > HISTORY_MOST) {
        histories->left_out++;
        return;
    }
    json_t *told = bare(event);
    json_object_set_new(told, "draw", json_integer(draw));
    const bool covers = event->kind == GP_TRACE_RASTER || event->kind == GP_TRACE_MISSED;
    if (covers && is_open(histories, event, draw)) {
        const size_t setups = json_array_size(json_object_get(histories->open, "setup"));
        json_object_set_new(told, "part", json_integer((json_int_t)setups - 1));
        histories->open_is_asked = true;
    }
    if (event->kind == GP_TRACE_STEPS) {
        json_t *steps = steps_json(&histories->listings, &event->steps);
        json_object_update(told, steps);
        json_decref(steps);
    }
    histories->left_out += event->kind == GP_TRACE_PIXEL && !histories_want_steps(histories);
    const uint32_t number =
        histories->number[(uint32_t)event->y * histories->width + (uint32_t)event->x];
    add_event(histories, &histories->pixel[number - 1], told);
}

void histories_finish(Histories *histories)
{
    close_primitive(histories);
}

/* --- telling ---------------------------------------------------------------------------------- */

/* Pixels [first, end) as one blob. */
static int pixel_blob(const Histories *histories, uint32_t first, uint32_t end, Blobs *blobs)
{
    Text text = { .data = NULL };
    for (uint32_t i = first; i < end; i++) {
        const HistoryPixel *pixel = &histories->pixel[i];
        blobs->failed = blobs->failed || pixel->events.failed;
        text_add(&text, "%s{\"x\":%d,\"y\":%d,\"events\":[", i > first ? "," : "[", pixel->x,
                 pixel->y);
        if (pixel->events.data)
            text_add(&text, "%s", pixel->events.data);
        text_add(&text, "]}");
    }
    text_add(&text, "]");
    const int blob = text.failed ? BLOB_NONE : blobs_add(blobs, text.data, text.length);
    blobs->failed = blobs->failed || text.failed;
    text_free(&text);
    return blob;
}

static json_t *primitive_blobs(const Histories *histories, Blobs *blobs)
{
    json_t *list = json_array();
    for (size_t first = 0; first < json_array_size(histories->told); first += HISTORY_CHUNK) {
        json_t *chunk = json_array();
        for (size_t i = first; i < first + HISTORY_CHUNK; i++)
            json_array_append(chunk, json_array_get(histories->told, i));
        json_array_append_new(list, json_integer(blobs_add_json(blobs, chunk)));
    }
    return list;
}

json_t *histories_tell(const Histories *histories, Blobs *blobs)
{
    json_t *pixels = json_array(), *list = json_array();
    for (uint32_t i = 0; i < histories->count; i++)
        json_array_append_new(pixels,
                              json_pack("[i, i]", histories->pixel[i].x, histories->pixel[i].y));
    for (uint32_t first = 0; first < histories->count; first += HISTORY_CHUNK) {
        const uint32_t left = histories->count - first;
        const uint32_t end = first + (left < HISTORY_CHUNK ? left : HISTORY_CHUNK);
        json_array_append_new(list, json_integer(pixel_blob(histories, first, end, blobs)));
    }
    json_t *listings =
        histories->listings.all ? json_incref(histories->listings.all) : json_array();
    json_t *primitives = primitive_blobs(histories, blobs); /* blobs in an order of their own: */
    const int listing = blobs_add_json(blobs, listings);    /* arguments have none */
    return json_pack("{s:o, s:o, s:O, s:o, s:i, s:I}", "pixels", pixels, "blobs", list,
                     "primitives", histories->primitives, "primitive_blobs", primitives, "listings",
                     listing, "left_out", (json_int_t)histories->left_out);
}

void histories_free(Histories *histories)
{
    for (uint32_t i = 0; i < histories->count; i++)
        text_free(&histories->pixel[i].events);
    gp_free(histories->pixel);
    gp_free(histories->number);
    gp_free(histories->asked);
    step_listings_free(&histories->listings);
    json_decref(histories->primitives);
    json_decref(histories->told);
    json_decref(histories->open);
    *histories = (Histories){ .count = 0 };
}
