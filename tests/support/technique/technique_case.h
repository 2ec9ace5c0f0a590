/* Claims about techniques as tables: on this scene, with these options, this figure lies between
 * these two. What fails, and what mends it, is a pair of rows.
 */
#ifndef TESTS_TECHNIQUE_CASE_H
#define TESTS_TECHNIQUE_CASE_H

#include "apps/techniques/technique.h"

typedef struct TechniqueCase {
    const char *name;
    const char *scene;   /* a path; or the scene itself, from its {, where ' may stand for " */
    const char *options; /* "--map 512 --bias 0" */
    const char *metric;  /* one of the technique's, or "error" */
    double low, high;    /* both included */
} TechniqueCase;

/* Checks a table, row by row; the truth is found once for rows of the same scene that follow each
 * other.
 * errors the first row that does not hold: GP_ERROR_INVALID, with its name and its metric; or what
 *        kept it from being measured. All rows that do not hold are printed, as TAP comments */
GpResult technique_cases_check(const Technique *technique, const TechniqueCase *cases, size_t count,
                               GpError *error);

/* --- what tables are checked with, for claims of other forms ---------------------------------- */

/* A scene with the truth of the technique's first experiment, and a device to draw it on. Owned by
 * the caller until closed. */
typedef struct TechniqueStage {
    const Technique *technique;
    void *scene;
    GpDevice *device;
} TechniqueStage;

/* in     scene: as a case's; width, height: of the picture, 0 x 0: the scene's own
 * errors those of the technique's functions; *stage is then zeroed */
GpResult technique_stage_open(const Technique *technique, const char *scene, uint32_t width,
                              uint32_t height, TechniqueStage *stage, GpError *error);
void technique_stage_close(TechniqueStage *stage); /* a zeroed one is fine */

/* Draws with these options.
 * owns   the caller frees *frame */
GpResult technique_stage_draw(const TechniqueStage *stage, const char *options, Frame *frame,
                              GpError *error);

/* Draws, has the technique say what there is to say, and hashes all targets of the frame, those of
 * passes before the picture's too. errors fails the running test where it cannot be drawn, or told
 * of */
uint64_t technique_stage_hash(const TechniqueStage *stage, const char *options);

/* Draws and measures. */
GpResult technique_stage_measure(const TechniqueStage *stage, const char *options,
                                 TechniqueError *measured, GpError *error);

/* A figure by name, or "error"; NaN where there is none. */
double technique_metric(const Technique *technique, const TechniqueError *measured,
                        const char *name);

#endif
