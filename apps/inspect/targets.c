#include "apps/inspect/targets.h"

#include "apps/base/json.h"
#include "apps/inspect/ranges.h"
#include "pipeline/list/pass_target.h"

#include <string.h>

static size_t bytes_of(const GpSurface *surface)
{
    return (size_t)surface->width * surface->height * gp_format_info(surface->format)->bytes;
}

int targets_number(const Targets *targets, const GpSurface *surface)
{
    for (uint32_t i = 0; i < targets->count; i++)
        if (targets->state[i].surface == surface)
            return (int)i;
    return -1;
}

static bool add(Targets *targets, const GpSurface *surface)
{
    const size_t bytes = bytes_of(surface);
    TargetState *state = &targets->state[targets->count++];
    *state = (TargetState){ .surface = surface,
                            .initial = gp_alloc(bytes, 1),
                            .before = gp_alloc(bytes, 1),
                            .now = gp_alloc(bytes, 1),
                            .planes = gp_alloc(bytes, 1) };
    if (!state->initial || !state->before || !state->now || !state->planes)
        return false;
    gp_surface_read_bytes(surface, 0, NULL, state->initial, 0, NULL);
    memcpy(state->before, state->initial, bytes);
    return true;
}

GpResult targets_find(const GpList *list, Targets *targets, GpError *error)
{
    Targets found = { .state =
                          gp_alloc(list->pass_count * (GP_MAX_TARGETS + 1), sizeof *found.state) };
    bool fits = found.state != NULL;
    for (uint32_t p = 0; p < list->pass_count && fits; p++)
        for (int slot = 0; slot <= GP_MAX_TARGETS && fits; slot++) {
            const GpSurface *surface = gp_pass_target(&list->passes[p], slot);
            if (surface && targets_number(&found, surface) < 0)
                fits = add(&found, surface);
        }
    if (!fits) {
        targets_free(&found);
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the states of a frame's targets");
    }
    *targets = found;
    return GP_OK;
}

void targets_free(Targets *targets)
{
    for (uint32_t i = 0; i < targets->count; i++) {
        gp_free(targets->state[i].initial);
        gp_free(targets->state[i].before);
        gp_free(targets->state[i].now);
        gp_free(targets->state[i].planes);
    }
    gp_free(targets->state);
    *targets = (Targets){ .count = 0 };
}

/* The form of the header, into state->planes. */
static void difference(TargetState *state)
{
    const size_t width = state->surface->width, height = state->surface->height;
    const size_t texel = gp_format_info(state->surface->format)->bytes;
    uint8_t *out = state->planes;
    for (size_t plane = 0; plane < texel; plane++)
        for (size_t y = 0; y < height; y++) {
            uint8_t left = 0;
            for (size_t x = 0; x < width; x++) {
                const size_t at = (y * width + x) * texel + plane;
                const uint8_t byte = state->now[at] ^ state->before[at];
                *out++ = (uint8_t)(byte - left);
                left = byte;
            }
        }
}

/* A target's texels whose ranges are found later. */
typedef struct RangesErrand {
    json_t *told;
    const GpSurface *surface;
    uint8_t texels[];
} RangesErrand;

static void tell_ranges(void *context)
{
    RangesErrand *errand = context;
    json_object_set_new(errand->told, "ranges", ranges_tell(errand->surface, errand->texels));
    json_decref(errand->told);
    gp_free(errand);
}

/* Adds ranges_tell of the target as it is now. */
static void add_ranges(json_t *told, const TargetState *state, Blobs *blobs)
{
    const size_t bytes = bytes_of(state->surface);
    RangesErrand *errand = gp_alloc_unset(sizeof *errand + bytes);
    if (!errand) {
        blobs->failed = true;
        return;
    }
    *errand = (RangesErrand){ json_incref(told), state->surface };
    memcpy(errand->texels, state->now, bytes);
    errands_give(blobs->errands, tell_ranges, errand);
}

static json_t *changed(TargetState *state, int number, Blobs *blobs)
{
    const size_t bytes = bytes_of(state->surface);
    gp_surface_read_bytes(state->surface, 0, NULL, state->now, 0, NULL);
    if (memcmp(state->now, state->before, bytes) == 0)
        return NULL;
    difference(state);
    memcpy(state->before, state->now, bytes);
    json_t *told =
        json_pack("{s:i, s:i}", "surface", number, "blob", blobs_add(blobs, state->planes, bytes));
    add_ranges(told, state, blobs);
    return told;
}

json_t *targets_changed(Targets *targets, const GpPass *pass, Blobs *blobs)
{
    json_t *list = json_array();
    for (int slot = 0; slot <= GP_MAX_TARGETS; slot++) {
        const int number = targets_number(targets, gp_pass_target(pass, slot));
        json_t *one = number < 0 ? NULL : changed(&targets->state[number], number, blobs);
        if (one)
            json_array_append_new(list, one);
    }
    return list;
}

/* "main.depth": by the first pass that draws there, where it has no name of its own. */
static json_t *name_of(const GpSurface *surface, const GpList *list)
{
    if (surface->name[0])
        return json_string(surface->name);
    for (uint32_t p = 0; p < list->pass_count; p++)
        for (int slot = 0; slot <= GP_MAX_TARGETS; slot++)
            if (gp_pass_target(&list->passes[p], slot) == surface) {
                const char *pass = list->passes[p].name ? list->passes[p].name : "";
                return slot == GP_MAX_TARGETS ? json_sprintf("%s.depth", pass)
                                              : json_sprintf("%s.%d", pass, slot);
            }
    return json_string("");
}

/* The blob of the header's form, or null where all is zero. */
static json_t *initial_blob(TargetState *state, Blobs *blobs)
{
    const size_t bytes = bytes_of(state->surface);
    bool empty = true;
    for (size_t i = 0; i < bytes && empty; i++)
        empty = state->initial[i] == 0;
    if (empty)
        return json_null();
    memcpy(state->now, state->initial, bytes);
    memset(state->before, 0, bytes);
    difference(state);
    return json_integer(blobs_add(blobs, state->planes, bytes));
}

void targets_restore(const Targets *targets)
{
    for (uint32_t i = 0; i < targets->count; i++) {
        const TargetState *state = &targets->state[i];
        const GpLevel *level = &state->surface->level[0];
        const size_t row = level->width * (size_t)gp_format_info(state->surface->format)->bytes;
        for (uint32_t y = 0; y < level->height; y++)
            memcpy(level->texels + y * level->pitch, state->initial + y * row, row);
    }
}

const GpSurface *targets_differ(Targets *targets)
{
    for (uint32_t i = 0; i < targets->count; i++) {
        TargetState *state = &targets->state[i];
        gp_surface_read_bytes(state->surface, 0, NULL, state->now, 0, NULL);
        if (memcmp(state->now, state->before, bytes_of(state->surface)) != 0)
            return state->surface;
    }
    return NULL;
}

json_t *targets_tell(const Targets *targets, const GpList *list, Blobs *blobs)
{
    json_t *told = json_array();
    for (uint32_t i = 0; i < targets->count; i++) {
        const GpSurface *surface = targets->state[i].surface;
        const GpFormatInfo *info = gp_format_info(surface->format);
        json_array_append_new(told,
                              json_pack("{s:o, s:s, s:i, s:i, s:i, s:b, s:o, s:o}", "name",
                                        name_of(surface, list), "format", info->name, "width",
                                        (int)surface->width, "height", (int)surface->height,
                                        "bytes", (int)info->bytes, "depth", (int)info->is_depth,
                                        "initial", initial_blob(&targets->state[i], blobs),
                                        "ranges", ranges_tell(surface, targets->state[i].initial)));
    }
    return told;
}
