/* Scenes that are to look as they did: each is drawn and held against what is stored beside it.
 *
 * Beside SCENE.json stand SCENE.hash, the line that `render` prints of it, which holds for every
 * bit; or a picture, SCENE.png, .exr, .pfm or .ppm, as `render` writes it, which holds within
 * limits; or both, and both must hold. SCENE.limits has limits for that scene, as one would type
 * them.
 */
#ifndef APPS_GOLDEN_GOLDEN_H
#define APPS_GOLDEN_GOLDEN_H

#include "apps/base/text.h"
#include "apps/compare/comparison.h"

#include <glasspipe/glasspipe.h>

typedef enum GoldenState {
    GOLDEN_SAME,    /* as stored, or within the limits */
    GOLDEN_DIFFERS, /* from what is stored */
    GOLDEN_MISSING, /* nothing is stored */
    GOLDEN_BROKEN, /* the scene, or what is stored, cannot be read or drawn; or its report not written */
    GOLDEN_STATES
} GoldenState;

/* "same", "differs", "missing", "broken" */
const char *golden_state_name(GoldenState state);

/* What holds for all scenes of a folder. Borrowed. */
typedef struct GoldenTask {
    const char *folder;
    uint32_t size[2];            /* 0: each scene's own */
    ComparisonSettings settings; /* a scene's own limits are set over these */
    const char *reports; /* folder for pages and pictures of what is not the same; NULL: none */
} GoldenTask;

/* One scene's result. */
typedef struct GoldenResult {
    GoldenState state;
    Text message;      /* one line; empty of GOLDEN_SAME with the same bits. Owned, text_free */
    bool is_unwritten; /* broken, since its report could not be written */
    double seconds;
} GoldenResult;

/* Draws the scene of this name and compares it.
 * in     device, pool: for this call alone; the pool serves FLIP
 * errors GP_ERROR_MEMORY; all else that goes wrong is the result's state and message */
GpResult golden_run(const GoldenTask *task, const char *name, GpDevice *device, GpPool *pool,
                    GoldenResult *result, GpError *error);

/* Draws the scene and stores it: in those of the files that are there, else as .hash and .png.
 * out    wrote: a line for each file; text_free
 *        is_unwritten: the error is of what was to be written
 * errors those of scene_load, gp_device_run and gp_file_write; what was stored then stays or is
 *        whole */
GpResult golden_bless(const GoldenTask *task, const char *name, GpDevice *device, Text *wrote,
                      bool *is_unwritten, GpError *error);

/* Hash of what is stored beside a scene: its line, its picture, its limits. in: seed: what was
 * hashed before */
uint64_t golden_stored_hash(const GoldenTask *task, const char *name, uint64_t seed);

#endif
