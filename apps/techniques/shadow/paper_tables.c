#include "apps/techniques/shadow/paper_tables.h"

enum { PLAIN, HARDWARE, METHODS, GAIN = METHODS };

static const PaperColumn columns[] = {
    [PLAIN] = { "plain", PAPER_BOTH, 1 },
    [HARDWARE] = { "hardware", PAPER_BOTH, 1 },
    [GAIN] = { "gain", PAPER_BOTH, 2 },
    { .name = NULL },
};

/* The thesis does not give its scenes away: these are ours, of about the same kind. */
#define SCENE_1 "scenes/shadow_bunny.json"
#define SCENE_2 "scenes/shadow.json"

static const PaperRow nearest_rows[] = {
    { "scene 1", SCENE_1, false, { 160, 220, 220.0 / 160 } },
    { "scene 2", SCENE_2, false, { 125, 176, 176.0 / 125 } },
    { .name = NULL },
};

static const PaperRow bilinear_rows[] = {
    { "scene 1", SCENE_1, false, { 110, 217, 217.0 / 110 } },
    { "scene 2", SCENE_2, false, { 85, 173, 173.0 / 85 } },
    { .name = NULL },
};

#define AS_PRINTED " --bias 0.002 --fit light --facing smooth --outside printed"

static const char *const nearest[METHODS] = {
    "--method plain --filter nearest" AS_PRINTED,
    "--method hardware --filter nearest --slope 0" AS_PRINTED,
};

static const char *const bilinear[METHODS] = {
    "--method plain --filter bilinear" AS_PRINTED,
    "--method hardware --filter bilinear --slope 0" AS_PRINTED,
};

static GpResult measure(const PaperTable *table, const PaperRow *row, const Technique *technique,
                        void *scene, const TechniqueClock *clock,
                        double measured[PAPER_MAX_COLUMNS], GpError *error)
{
    const char *const *options = table->content;
    (void)row;
    for (int i = 0; i < METHODS; i++) {
        double ms = 0;
        GpResult result = technique_time_ms(clock, technique, scene, options[i], &ms, error);
        if (result)
            return result;
        measured[i] = 1e3 / ms;
    }
    measured[GAIN] = measured[HARDWARE] / measured[PLAIN];
    return GP_OK;
}

#define THESIS "thesis, chapter 4; GeForce 5950, Pentium 4 at 2.8 GHz"
#define NOTE   "frames a second; gain: hardware over plain"

static const PaperTable table_nearest = {
    .id = "4.1",
    .title = "efficiency of the two shadow mapping methods",
    .source = THESIS,
    .note = NOTE,
    .columns = columns,
    .rows = nearest_rows,
    .measure = measure,
    .content = nearest,
};

static const PaperTable table_bilinear = {
    .id = "4.2",
    .title = "the same, both with bilinear filtering",
    .source = THESIS,
    .note = NOTE,
    .columns = columns,
    .rows = bilinear_rows,
    .measure = measure,
    .content = bilinear,
};

const PaperTable *const shadow_tables[] = { &table_nearest, &table_bilinear, NULL };
