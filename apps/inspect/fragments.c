#include "apps/inspect/fragments.h"

#include "pipeline/base/grow.h"
#include "pipeline/io/bytes.h"

#include <stdlib.h>
#include <string.h>

const char *const fragment_verdict_names[FRAGMENT_VERDICTS] = {
    "written",
    "written, hidden later",
    "killed by its shader",
    "cut by a clip plane",
    "scissor test",
    "alpha test",
    "stencil test",
    "depth test",
    "culled",
    "clipped away",
};

/* --- taking events ---------------------------------------------------------------------------- */

/* Whether nothing of what the targets held is in what a draw leaves there. */
static bool replaces(const GpPass *pass, const GpDraw *draw)
{
    bool whole = true;
    for (int t = 0; t < GP_MAX_TARGETS; t++)
        if (pass->color[t].surface) {
            const GpBlend *blend = &draw->state.blend[t];
            whole = whole && blend->op == GP_BLEND_OFF && blend->alpha_op == GP_BLEND_OFF &&
                    !(blend->keep & 15) && t < gp_program_targets(draw->program);
        }
    return whole && !draw->state.depth.ternary;
}

static int place_of(const GpTraceEvent *event)
{
    return (event->x & 1) + 2 * (event->y & 1);
}

static uint32_t pixel_of(const Fragments *fragments, const GpTraceEvent *event)
{
    return (uint32_t)event->y * fragments->width + (uint32_t)event->x;
}

static void begin(Fragments *fragments, const GpPass *pass, const GpTraceEvent *event,
                  uint32_t draw)
{
    fragments->latest[place_of(event)] = 0;
    if (fragments->most && fragments->count >= fragments->most) {
        fragments->left_out++;
        return;
    }
    Fragment *list = gp_grown(fragments->all, fragments->count, &fragments->room, sizeof *list,
                              &fragments->failed);
    if (!list)
        return;
    fragments->all = list;
    fragments->all[fragments->count++] = (Fragment){
        .pixel = pixel_of(fragments, event),
        .sequence = fragments->sequence++,
        .draw = draw,
        .primitive = event->primitive,
        .front = event->kind == GP_TRACE_MISSED ? event->missed.front : event->raster.front,
        .replaces = replaces(pass, &pass->draws[draw]),
    };
    fragments->latest[place_of(event)] = fragments->count;
}

/* Fragments that waited come again, by pixel, which is rare enough to look through all. */
static void find_sorted(Fragments *fragments, const GpTraceEvent *event, uint32_t draw)
{
    const uint32_t pixel = pixel_of(fragments, event);
    fragments->latest[place_of(event)] = 0;
    size_t low = 0, high = fragments->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (fragments->all[middle].pixel < pixel)
            low = middle + 1;
        else
            high = middle;
    }
    for (size_t i = low; i < fragments->count && fragments->all[i].pixel == pixel; i++) {
        Fragment *fragment = &fragments->all[i];
        if (fragment->draw == draw && fragment->primitive == event->primitive &&
            fragment->verdict == FRAGMENT_WRITTEN) {
            fragment->sequence = fragments->sequence++;
            fragments->latest[place_of(event)] = i + 1;
        }
    }
}

static FragmentVerdict failed_by(const GpTraceTest *test)
{
    switch (test->unit[0]) {
    case 'c':
        return FRAGMENT_CLIP_PLANE;
    case 'a':
        return FRAGMENT_ALPHA;
    case 'd':
        return FRAGMENT_DEPTH;
    default:
        return strcmp(test->unit, "scissor") == 0 ? FRAGMENT_SCISSOR : FRAGMENT_STENCIL;
    }
}

static int by_sequence(const void *one, const void *other)
{
    const Fragment *a = one, *b = other;
    return a->sequence < b->sequence ? -1 : a->sequence > b->sequence;
}

/* Counts them out to their pixels. end: [pixels] zeros; as it returns, where each pixel's end. */
static void count_out(const Fragments *fragments, uint32_t *end, Fragment *sorted)
{
    uint32_t before = 0;
    for (size_t i = 0; i < fragments->count; i++)
        end[fragments->all[i].pixel]++;
    for (size_t p = 0; p < (size_t)fragments->width * fragments->height; p++) {
        const uint32_t count = end[p];
        end[p] = before;
        before += count;
    }
    for (size_t i = 0; i < fragments->count; i++)
        sorted[end[fragments->all[i].pixel]++] = fragments->all[i];
}

/* By pixel, those of a pixel by sequence, as which they mostly come. */
static void sort(Fragments *fragments)
{
    const size_t pixels = (size_t)fragments->width * fragments->height;
    uint32_t *end = gp_alloc(pixels, sizeof *end);
    Fragment *sorted = gp_alloc_unset(fragments->count * sizeof *sorted);
    if (!end || !sorted) {
        fragments->failed = true;
        gp_free(end);
        gp_free(sorted);
        return;
    }
    count_out(fragments, end, sorted);
    for (size_t p = 0, first = 0; p < pixels; first = end[p++])
        for (size_t i = first + 1; i < end[p]; i++)
            if (by_sequence(&sorted[i - 1], &sorted[i]) > 0) {
                qsort(sorted + first, end[p] - first, sizeof *sorted, by_sequence);
                break;
            }
    gp_free(end);
    gp_free(fragments->all);
    fragments->all = sorted;
    fragments->room = fragments->count;
}

static uint8_t lod_code(float lod)
{
    const float code = 128 + 16 * lod;
    return code > 255 ? 255 : code > 1 ? (uint8_t)code : 1;
}

void fragments_event(Fragments *fragments, const GpPass *pass, const GpTraceEvent *event,
                     uint32_t draw)
{
    if (event->kind == GP_TRACE_RASTER)
        begin(fragments, pass, event, draw);
    if (event->kind == GP_TRACE_MISSED) {
        begin(fragments, pass, event, draw);
        const size_t missed = fragments->latest[place_of(event)];
        if (missed)
            fragments->all[missed - 1].verdict =
                strcmp(event->missed.reason, "facing") == 0 ? FRAGMENT_CULLED : FRAGMENT_CLIPPED;
        fragments->latest[place_of(event)] = 0;
    }
    if (event->kind == GP_TRACE_SORT) {
        if (event->sort.place == 0 && fragments->sequence == fragments->count)
            sort(fragments); /* all are there: the first that has its turn */
        find_sorted(fragments, event, draw);
    }
    if (event->kind == GP_TRACE_TEXTURE && fragments->lod)
        fragments->lod[pixel_of(fragments, event)] = lod_code(event->texture.report.lod);
    if (event->kind != GP_TRACE_PIXEL && event->kind != GP_TRACE_TEST)
        return;
    const size_t latest = fragments->latest[place_of(event)];
    if (!latest || fragments->all[latest - 1].pixel != pixel_of(fragments, event))
        return;
    uint8_t *verdict = &fragments->all[latest - 1].verdict;
    if (event->kind == GP_TRACE_PIXEL && event->pixel.killed)
        *verdict = FRAGMENT_KILLED;
    else if (event->kind == GP_TRACE_TEST && !event->test.passed)
        *verdict = (uint8_t)failed_by(&event->test);
}

/* --- what became of them ---------------------------------------------------------------------- */

void fragments_finish(Fragments *fragments)
{
    sort(fragments);
    bool covered = false;
    for (size_t i = fragments->count; i-- > 0;) {
        Fragment *fragment = &fragments->all[i];
        if (i + 1 < fragments->count && fragment->pixel != fragments->all[i + 1].pixel)
            covered = false;
        if (fragment->verdict != FRAGMENT_WRITTEN)
            continue;
        if (covered)
            fragment->verdict = FRAGMENT_HIDDEN;
        covered = covered || fragment->replaces;
    }
}

static void add_number(GpBytes *bytes, uint32_t value)
{
    do {
        const uint8_t low = (uint8_t)((value & 127) | (value > 127 ? 128 : 0));
        gp_bytes_append(bytes, &low, 1);
        value >>= 7;
    } while (value);
}

static bool equal(const Fragment *a, const Fragment *b, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (a[i].draw != b[i].draw || a[i].primitive != b[i].primitive ||
            a[i].verdict != b[i].verdict || a[i].front != b[i].front)
            return false;
    return true;
}

static void add_run(GpBytes *bytes, uint32_t pixels, const Fragment *first, size_t count)
{
    if (!pixels)
        return;
    add_number(bytes, pixels);
    add_number(bytes, (uint32_t)count);
    for (size_t i = 0; i < count; i++) {
        add_number(bytes, first[i].draw);
        add_number(bytes, first[i].primitive);
        add_number(bytes, first[i].verdict + (first[i].front ? 16u : 0u));
    }
}

int fragments_blob(const Fragments *fragments, Blobs *blobs)
{
    GpBytes bytes = { .size = 0 };
    const Fragment *run = NULL;
    size_t run_count = 0, at = 0;
    uint32_t run_pixels = 0;
    for (uint32_t pixel = 0; pixel < fragments->width * fragments->height; pixel++) {
        const Fragment *first = fragments->all + at;
        size_t count = 0;
        while (at < fragments->count && fragments->all[at].pixel == pixel)
            at++, count++;
        if (!run_pixels || count != run_count || !equal(first, run, count)) {
            add_run(&bytes, run_pixels, run, run_count);
            run = first;
            run_count = count;
            run_pixels = 0;
        }
        run_pixels++;
    }
    add_run(&bytes, run_pixels, run, run_count);
    const int blob = bytes.failed ? BLOB_NONE : blobs_add(blobs, bytes.data, bytes.size);
    gp_free(bytes.data);
    return blob;
}

int fragments_lod_blob(const Fragments *fragments, Blobs *blobs)
{
    const size_t pixels = (size_t)fragments->width * fragments->height;
    for (size_t i = 0; fragments->lod && i < pixels; i++)
        if (fragments->lod[i])
            return blobs_add(blobs, fragments->lod, pixels);
    return BLOB_NONE;
}

void fragments_free(Fragments *fragments)
{
    gp_free(fragments->all);
    gp_free(fragments->lod);
    *fragments = (Fragments){ .count = 0 };
}
