/* What every technique declares, so that its command, its charts and its tables are written once.
 *
 * A technique is a folder beside this file, whose technique.c has the Technique, and a line of
 * registry.c. Nothing else knows one technique from another.
 */
#ifndef APPS_TECHNIQUES_TECHNIQUE_H
#define APPS_TECHNIQUES_TECHNIQUE_H

#include "apps/base/text.h"
#include "apps/frame/frame.h"
#include "apps/techniques/settings.h"
#include "pipeline/io/volume/volume_file.h"

#include <jansson.h>

/* --- experiments ------------------------------------------------------------------------------ */

enum { TECHNIQUE_MAX_METRICS = 8 };

/* What a name in a chart means, for one who was not there: a sentence. */
typedef struct TechniqueWord {
    const char *word; /* as the chart has it: a metric, a method; NULL ends a table */
    const char *sentence;
} TechniqueWord;

/* The sentence of a word, or NULL. */
const char *technique_word(const TechniqueWord *words, const char *word);

/* Settings of one colour in the chart: a text of options in which a value may be a list, a|b|c; all
 * combinations are drawn. */
typedef struct TechniqueSweep {
    const char *method;  /* in the field's words: "hardware, 2x2"; NULL ends a table */
    const char *options; /* "--method hardware --map 512|1024|2048 --slope 1|2" */
} TechniqueSweep;

/* How far a frame is from the truth. */
typedef struct TechniqueError {
    double error;                          /* what the chart's axis shows; 0: none */
    double metrics[TECHNIQUE_MAX_METRICS]; /* as many as the experiment names */
    double whole; /* 100 per cent of the error: pixels covered; 0 where there is no such */
} TechniqueError;

/* Speed against accuracy: a chart. */
typedef struct Experiment {
    const char *name;  /* of the chart and its files: "solids"; NULL ends a table */
    const char *title; /* "Solid voxels: time against wrong volume" */
    const char *scene; /* that is drawn where none is named: a path */
    const TechniqueSweep *sweep;
    /* methods of the sweep that are on the front of most scenes, NULL at the end: --error tries
     * them first where no chart is stored; NULL: none */
    const char *const *usual;
    const char *error_name;     /* of the axis: "wrong pixels" */
    const char *const *metrics; /* names of further numbers, NULL at the end: "acne", "leak" */
    const char *part_of; /* what the error is a part of: "the covered pixels"; NULL: of nothing */
    /* of the error's name, all metrics, all methods of the sweep, and of what else these sentences
     * need */
    const TechniqueWord *words;
    const char *truth; /* how the exact result is found: sentences */
    /* the options that mean this experiment of its technique, beside --error: "--kind solid"; NULL:
     * none does */
    const char *given;

    /* Finds the truth, once for a scene. errors GP_ERROR_MEMORY; GP_ERROR_INVALID: the scene has
     * none, with the reason */
    GpResult (*find_truth)(void *scene, int threads, GpError *error);

    /* Holds a frame that has been drawn against the truth. errors GP_ERROR_MEMORY */
    GpResult (*measure)(void *scene, const Frame *frame, TechniqueError *measured, GpError *error);
    /* The same for the error alone, without metrics, where that is quicker. NULL: those above */
    GpResult (*find_truth_error)(void *scene, int threads, GpError *error);
    GpResult (*measure_error)(void *scene, const Frame *frame, TechniqueError *measured,
                              GpError *error);

    /* An error that no frame of a setting is below, for certain and without drawing it, so that
     * --error draws only what may reach it; in roundings too. in scene: its truth is found; out
     * least: without metrics; 0: nothing is known. NULL: nothing ever is */
    void (*least_error)(void *scene, const void *setting, TechniqueError *least);

    /* How far each pixel of a frame's picture, as it was drawn and shown, is above that of the
     * truth, or below it; 0: nowhere. May append passes to the frame and draw them.
     * out  off: [height][width] of the picture
     * errors those of measure and show. NULL: pictures have no difference beside them */
    GpResult (*difference)(void *scene, const void *setting, GpDevice *device, Frame *frame,
                           float *off, GpError *error);
    const char *over, *under; /* what that means: "lit where the truth is dark, a leak" */
    /* charts have pictures of methods that are beaten, too: of each the setting farthest from the
     * truth */
    bool shows_failures;
} Experiment;

/* --- scaling ---------------------------------------------------------------------------------- */

/* A line of a scaling picture: all combinations of scenes and settings, lists as in a sweep, what
 * grows in rising order. */
typedef struct TechniqueLine {
    const char *name;    /* of the method; lines of one name share a colour; NULL ends a table */
    const char *scenes;  /* paths: "meshes/bunny.ply|meshes/horse.ply" */
    const char *options; /* "--method thin --size 64|128" */
} TechniqueLine;

/* A line to compare with: time as a power of the amount. */
typedef struct TechniqueSlope {
    double power;
    const char *name; /* "as the square"; NULL ends a table */
} TechniqueSlope;

/* Time against one thing that grows. */
typedef struct TechniquePanel {
    const char *title, *axis; /* "a larger volume"; "voxels a side" */
    bool doubles;             /* the axis is marked at powers of two */
    double (*amount)(const void *scene, const Frame *frame); /* place of a frame along the axis */
    const TechniqueLine *lines;
    const TechniqueSlope *slopes;
} TechniquePanel;

enum { TECHNIQUE_PANELS = 2 };

/* How time grows with what is asked for. */
typedef struct TechniqueScaling {
    const char *title;
    /* paragraphs for the page of charts: why what grows with what, and no figures, which are
     * measured anew each time; NULL ends */
    const char *const *text;
    const TechniqueWord *words; /* of all lines, and of both axes */
    TechniquePanel panels[TECHNIQUE_PANELS];
} TechniqueScaling;

/* --- a technique ------------------------------------------------------------------------------ */

typedef struct TechniqueInput {
    const char *path;
    uint32_t width, height; /* of the picture; 0 x 0: the scene's own */
    const void *setting;    /* its fields aside of the key hold for all frames of the scene */
    /* Hears how far long work on the scene is, until it is closed; NULL: nobody does. */
    void (*progress)(const void *user, uint32_t done, uint32_t total, const char *text);
    const void *user;
} TechniqueInput;

/* What is worth saying of a frame that has been drawn; zeroed before. Texts are lines, owned by the
 * caller. */
typedef struct TechniqueReport {
    Text lines, warnings;
    json_t *members; /* for --json; NULL: not asked for */
} TechniqueReport;

typedef struct PaperTable PaperTable;

typedef struct Technique {
    const char *name;      /* as the command: "shadow" */
    const char *arguments; /* "SCENE.json" */
    const char *input;     /* for messages: "a scene file" */
    const char *summary;   /* a line of the program's help */
    const char *help;      /* examples first; after \v what follows the options */

    const SettingField *settings;
    const void *defaults; /* a setting */
    size_t setting_bytes;

    const Experiment *experiments;   /* the first is the technique's own, and has its name */
    const TechniqueScaling *scaling; /* NULL: none */
    const PaperTable *const *tables; /* NULL at the end; NULL: none */

    /* Sets what the options that were given mean of those that were not: that of one method alone
     * means the method. Before check.
     * in   given: bit i: the user gave settings[i]. NULL: they mean nothing else */
    void (*imply)(void *setting, uint32_t given);

    /* Whether options go together, and with the extension of the file to be written.
     * in   given: bit i: the user gave settings[i]
     * errors GP_ERROR_INVALID, with the reason. NULL: always */
    GpResult (*check)(const void *setting, uint32_t given, const char *extension, GpError *error);

    /* Reads what all frames share.
     * errors as scene_load's; owns: the caller, until close */
    GpResult (*open)(const TechniqueInput *input, void **scene, GpError *error);
    void (*close)(void *scene);

    /* The frame of a setting: its list, its picture in frame->color, or what `volume` reads.
     * in   device: the caller's own, for passes that have to be drawn before; frame: zeroed
     * errors GP_ERROR_INVALID: the setting does not go with the scene, with the reason; *frame is
     *      then empty */
    GpResult (*build)(void *scene, const void *setting, GpDevice *device, Frame *frame,
                      GpError *error);

    /* Sets what a setting leaves to be chosen to what `build` chooses for the scene, so that it can
     * be told; what differs from part to part of the scene stays. NULL: nothing is left */
    void (*resolve)(const void *scene, void *setting);

    /* A member of the report that counts what a frame draws, and is told by the second too:
     * "splats" is followed by "splats_per_second". NULL: none */
    const char *rate;

    /* What the alpha of a picture is, which --output-NAME writes alone: "visibility". NULL:
     * nothing */
    const char *alpha;
    /* errors GP_ERROR_INVALID: it is not in this scene, with the reason. NULL: it always is */
    GpResult (*check_alpha)(const void *scene, GpError *error);

    /* Where the result is a volume: reads it once the list has run.
     * errors GP_ERROR_MEMORY; owns: the caller, until gp_volume_free. NULL: the result is a
     *      picture */
    GpResult (*volume)(const Frame *frame, GpVolume *volume, GpError *error);

    /* the first experiment's truth is found in about the time of a picture, and so that a page of a
     * frame may have it unasked */
    bool quick_truth;

    /* Appends the passes that draw a picture of such a volume into frame->color.
     * errors as those of build, but the frame is not emptied. NULL: there is none */
    GpResult (*show)(void *scene, const void *setting, Frame *frame, GpError *error);

    /* Says what there is to say. errors those of what it looks into. NULL: nothing */
    GpResult (*report)(void *scene, const void *setting, const Frame *frame, GpDevice *device,
                       TechniqueReport *report, GpError *error);
} Technique;

/* Opens a scene with the technique's defaults. */
GpResult technique_open(const Technique *technique, const char *path, uint32_t width,
                        uint32_t height, void **scene, GpError *error);

/* A setting from a text of options, on top of the defaults.
 * errors those of setting_parse, GP_ERROR_MEMORY. owns: the caller, until gp_free */
GpResult technique_setting(const Technique *technique, const char *options, void **setting,
                           GpError *error);

/* Builds the frame of such a setting.
 * in   frame: zeroed. errors those of setting_parse and build, GP_ERROR_MEMORY; *frame is then
 *      empty */
GpResult technique_build(const Technique *technique, void *scene, const char *options,
                         GpDevice *device, Frame *frame, GpError *error);

/* All combinations of a sweep's options, each as text; the last list varies fastest.
 * out     texts: as many as there is room for; NULL allowed where room is 0
 * returns how many there are */
size_t technique_expand(const char *options, SettingText *texts, size_t room);

/* The same into memory of their own; also of paths, which are longer than settings, but not so
 * long.
 * errors GP_ERROR_MEMORY; owns: the caller, until gp_free */
GpResult technique_expand_all(const char *options, SettingText **texts, size_t *count,
                              GpError *error);

#endif
