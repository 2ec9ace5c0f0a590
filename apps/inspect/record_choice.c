#include "apps/inspect/record_choice.h"

#include <math.h>

enum {
    USUAL_PIXELS = 1200,    /* on the grid of a pass */
    TECHNIQUE_PIXELS = 300, /* the same of techniques, whose pixels are recorded in many passes */
    MOST_REGION = 4096,     /* pixels of a region or a draw */
    MOST_FATES = 3          /* pixels for every fate of a draw's fragments */
};

/* How fates are sampled where there is room for a share of the pixels: so many of every n-th
 * draw. */
typedef struct FateChoice {
    uint32_t each, every;
} FateChoice;

static FateChoice fate_choice(double share)
{
    if (share >= 0.5)
        return (FateChoice){ MOST_FATES, 1 };
    return (FateChoice){ 1, share < 0.25 ? (uint32_t)ceil(0.25 / share) : 1 };
}

/* Of the fragments of each draw with each verdict, in order of pixels, some evenly among them: the
 * first, one in the middle and so on. */
static GpResult choose_fates(const Fragments *fragments, uint32_t draws, FateChoice choice,
                             Histories *histories, GpError *error)
{
    uint32_t *counts = gp_alloc((size_t)draws * FRAGMENT_VERDICTS * 2, sizeof *counts);
    if (!counts)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the fragments of draws");
    uint32_t *seen = counts + (size_t)draws * FRAGMENT_VERDICTS;
    for (size_t i = 0; i < fragments->count; i++)
        counts[fragments->all[i].draw * FRAGMENT_VERDICTS + fragments->all[i].verdict]++;
    for (size_t i = 0; i < fragments->count; i++) {
        const Fragment *fragment = &fragments->all[i];
        const size_t kind = fragment->draw * FRAGMENT_VERDICTS + fragment->verdict;
        const uint32_t every = counts[kind] / choice.each ? counts[kind] / choice.each : 1;
        if (seen[kind]++ % every == every / 2 && fragment->draw % choice.every == 0)
            histories_choose(histories, (int32_t)(fragment->pixel % fragments->width),
                             (int32_t)(fragment->pixel / fragments->width));
    }
    gp_free(counts);
    return GP_OK;
}

static void choose_region(const GpRect *region, Histories *histories)
{
    const int64_t area = (int64_t)(region->x1 - region->x0) * (region->y1 - region->y0);
    const int32_t step = area > MOST_REGION ? (int32_t)ceil(sqrt((double)area / MOST_REGION)) : 1;
    for (int32_t y = region->y0; y < region->y1; y += step)
        for (int32_t x = region->x0; x < region->x1; x += step)
            histories_choose(histories, x, y);
}

static void choose_draw(const Fragments *fragments, uint32_t draw, Histories *histories)
{
    size_t count = 0, seen = 0;
    for (size_t i = 0; i < fragments->count; i++)
        count += fragments->all[i].draw == draw;
    const size_t every = count / USUAL_PIXELS + 1;
    for (size_t i = 0; i < fragments->count; i++)
        if (fragments->all[i].draw == draw && seen++ % every == 0)
            histories_choose(histories, (int32_t)(fragments->all[i].pixel % fragments->width),
                             (int32_t)(fragments->all[i].pixel / fragments->width));
}

static void choose_grid(uint32_t step, Histories *histories)
{
    for (uint32_t y = step / 2; y < histories->height; y += step)
        for (uint32_t x = step / 2; x < histories->width; x += step)
            histories_choose(histories, (int32_t)x, (int32_t)y);
}

/* The least step that leaves so many pixels. */
static uint32_t grid_step(const Histories *histories, uint32_t pixels)
{
    uint32_t step = 1;
    while ((histories->width / step) * (histories->height / step) > pixels)
        step++;
    return step;
}

/* A few for every fate that fragments of a draw had, the region, the draw's, and a grid over
 * all. */
static GpResult choose_of_pass(Record *record, uint32_t pass, GpError *error)
{
    const Inspect *inspect = record->inspect;
    const GpPass *of = &inspect->list->passes[pass];
    Histories *histories = &record->passes[pass].histories;
    const Fragments *fragments = &record->passes[pass].fragments;
    GpResult result = histories_begin(histories, of, error);
    if (!result && of->draw_count)
        result =
            choose_fates(fragments, of->draw_count, fate_choice(record->share), histories, error);
    if (result)
        return result;
    const bool last = pass + 1 == record->pass_count;
    const uint32_t usual = inspect->technique ? TECHNIQUE_PIXELS : USUAL_PIXELS;
    if (!gp_rect_is_empty(inspect->region))
        choose_region(&inspect->region, histories);
    if (inspect->draw >= 0)
        choose_draw(fragments, (uint32_t)inspect->draw, histories);
    const uint32_t asked = inspect->pixels ? inspect->pixels : usual;
    const uint32_t room = (uint32_t)fmax(record->share * asked, 1);
    const uint32_t step = grid_step(histories, last ? room : room / 4 + 1);
    if (last)
        record->step = step;
    choose_grid(step, histories);
    return GP_OK;
}

/* Of a technique's frame, once all passes have chosen: the pixels of the picture's pass in all
 * passes of its size, so that a pixel can be followed through them. */
static void choose_alike(Record *record)
{
    const Histories *last = &record->passes[record->pass_count - 1].histories;
    for (uint32_t p = 0; record->inspect->technique && p + 1 < record->pass_count; p++) {
        Histories *histories = &record->passes[p].histories;
        const bool same = histories->width == last->width && histories->height == last->height;
        for (uint32_t i = 0; same && i < last->count; i++)
            histories_choose(histories, last->pixel[i].x, last->pixel[i].y);
    }
}

GpResult record_choose(Record *record, GpError *error)
{
    GpResult result = GP_OK;
    for (uint32_t p = 0; p < record->pass_count && !result; p++) {
        histories_free(&record->passes[p].histories);
        result = choose_of_pass(record, p, error);
    }
    if (!result)
        choose_alike(record);
    for (uint32_t p = 0; p < record->pass_count && !result; p++)
        result = histories_ask(&record->passes[p].histories, &record->passes[p].fragments, error);
    return result;
}

/* About the bytes of histories of the chosen pixels. in: each: [pass] those of a fragment */
static double expected_bytes(const Record *record, const double *each)
{
    double bytes = 0;
    for (uint32_t p = 0; p < record->pass_count; p++)
        bytes += each[p] * (double)record->passes[p].histories.asked_count;
    return bytes;
}

GpResult record_choose_fewer(Record *record, double part, GpError *error)
{
    enum { HALVINGS = 7 };
    double *each = gp_alloc(record->pass_count, sizeof *each);
    if (!each)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the passes of a frame");
    for (uint32_t p = 0; p < record->pass_count; p++) {
        const Histories *histories = &record->passes[p].histories;
        each[p] = (double)histories->bytes / fmax((double)histories->asked_count, 1);
    }
    const double most = part * expected_bytes(record, each);
    double least = 0, over = record->share;
    GpResult result = GP_OK;
    for (int i = 0; i < HALVINGS && !result; i++) {
        record->share = (least + over) / 2;
        result = record_choose(record, error);
        if (expected_bytes(record, each) > most)
            over = record->share;
        else
            least = record->share;
    }
    gp_free(each);
    record->share = least > 0 ? least : over;
    return result ? result : record_choose(record, error);
}
