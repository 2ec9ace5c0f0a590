/* What is recorded of a frame while it is walked through. */
#ifndef APPS_INSPECT_RECORD_H
#define APPS_INSPECT_RECORD_H

#include "apps/inspect/fragments.h"
#include "apps/inspect/histories.h"
#include "apps/inspect/inspect.h"
#include "apps/inspect/tally.h"
#include "apps/inspect/targets.h"

typedef struct RecordPass {
    Fragments fragments;
    Histories histories;
    int fragments_blob, lod_blob; /* once they are told; else 0 */
    json_t *stops, *told;         /* told: histories_tell; NULL: not yet */
} RecordPass;

typedef struct Record {
    const Inspect *inspect;
    Blobs *blobs;
    Targets targets;
    RecordPass *passes;
    uint32_t pass_count;
    uint32_t step; /* of the grid of pixels that are recorded whole, in pixels */
    double share;  /* of the pixels that would be chosen, were there room; 1: all */
    /* private */
    Walk walk;
    Tally tally;
    bool wholly; /* the second walk */
    uint32_t done, total;
} Record;

/* Walks through the frame twice: for every fragment and every target, then for the whole histories
 * of chosen pixels. The targets end as the frame leaves them.
 * errors those of gp_device_run, GP_ERROR_MEMORY. owns: the caller, until record_free, also then */
GpResult record_frame(const Inspect *inspect, Blobs *blobs, Record *record, GpError *error);

/* Chooses fewer pixels and records their histories once more: about such a part of their bytes.
 * errors as above */
GpResult record_fewer(Record *record, double part, GpError *error);

void record_free(Record *record);

#endif
