/* Which pixels of a pass are recorded whole. */
#ifndef APPS_INSPECT_RECORD_CHOICE_H
#define APPS_INSPECT_RECORD_CHOICE_H

#include "apps/inspect/record.h"

/* Chooses pixels once the fragments are known: a few for every fate that fragments of a draw had, the
 * region, the draw's, and a grid over all. errors GP_ERROR_MEMORY */
GpResult record_choose(Record *record, uint32_t pass, GpError *error);

/* Of a technique's frame, once all passes have chosen: the pixels of the picture's pass in all passes of its
 * size, so that a pixel can be followed through them. */
void record_choose_alike(Record *record);

#endif
