/* What every technique declares, so that its command, its chart and its benchmark are written once.
 *
 * tech_NAME.c turns a setting into passes. study_NAME.c declares the Technique: fields, sweep, truth,
 * measure. Nothing else knows one technique from another.
 */
#ifndef APPS_TECHNIQUES_TECHNIQUE_H
#define APPS_TECHNIQUES_TECHNIQUE_H

#include "apps/techniques/settings.h"
#include "apps/frame/frame.h"

enum { TECHNIQUE_MAX_METRICS = 8 };

/* Settings of one colour in the chart: a text of options in which a value may be a list, a|b|c; all
 * combinations are drawn. */
typedef struct TechniqueSweep {
    const char *method;  /* in the field's words: "hardware, 2x2"; NULL ends a table */
    const char *options; /* "--method hardware --map 512|1024|2048 --slope 1|2" */
} TechniqueSweep;

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
    const char *const
        *text; /* paragraphs for the page of charts: what grows with what; NULL ends */
    TechniquePanel panels[TECHNIQUE_PANELS];
} TechniqueScaling;

/* How far a frame is from the truth. */
typedef struct TechniqueError {
    double error;                          /* what the chart's axis shows; 0: none */
    double metrics[TECHNIQUE_MAX_METRICS]; /* as many as the technique names */
} TechniqueError;

typedef struct Technique {
    const char *name;  /* as the command: "shadow" */
    const char *title; /* of its chart: "Shadow maps: time against wrong pixels" */
    const char *scene; /* that the chart draws where none is named: a path */

    const SettingField *fields;
    const void *defaults; /* a setting */
    size_t setting_bytes;
    bool makes_volumes; /* work->color has no size that a user knows */

    const TechniqueSweep *sweep;
    const char *error_name;          /* of the axis: "wrong pixels" */
    const char *const *metrics;      /* names of further figures, NULL at the end: "acne", "leak" */
    const TechniqueScaling *scaling; /* NULL: none */

    /* Reads what all settings share. size 0 x 0: the scene's own.
     * errors as scene_load's; owns: the caller, until close */
    GpResult (*open)(const char *path, uint32_t width, uint32_t height, void **scene,
                     GpError *error);
    void (*close)(void *scene);

    /* The frame of a setting: its list, its picture (or a volume as one) in work->color.
     * in   work: zeroed. errors GP_ERROR_INVALID: the setting does not go with the scene, with the
     *      reason; *work is then empty */
    GpResult (*build)(void *scene, const void *setting, Frame *frame, GpError *error);

    /* Finds the truth, once for a scene. errors GP_ERROR_MEMORY; GP_ERROR_INVALID: the scene has
     * none, with the reason */
    GpResult (*find_truth)(void *scene, int threads, GpError *error);

    /* Holds a frame that has been drawn against the truth. */
    void (*measure)(const void *scene, const Frame *frame, TechniqueError *error);
} Technique;

/* All techniques, NULL at the end. */
extern const Technique *const techniques[];

/* The technique of a name, or NULL. */
const Technique *technique_find(const char *name);

/* Builds the frame of a setting that is given as a text of options, on top of the defaults.
 * in   work: zeroed. errors those of setting_parse and build, GP_ERROR_MEMORY; *work is then empty */
GpResult technique_build(const Technique *technique, void *scene, const char *options, Frame *frame,
                         GpError *error);

/* All combinations of a sweep's options, each as text; the last list varies fastest.
 * out     texts: as many as there is room for; NULL allowed where room is 0
 * returns how many there are */
size_t technique_expand(const char *options, char (*texts)[SETTING_MAX_TEXT], size_t room);

#endif
