/* What the targets of a pass hold at the pixels whose histories are recorded: taken before it is drawn there, and put
 * back. In whole quads of 2x2 pixels, as they are drawn. */
#ifndef APPS_INSPECT_HELD_TEXELS_H
#define APPS_INSPECT_HELD_TEXELS_H

#include "apps/inspect/histories.h"

/* A zeroed one is empty. */
typedef struct HeldTexels {
    uint8_t *bytes; /* [target][pixel][2][2], each as its format stores it */
    size_t room;
} HeldTexels;

/* Takes them, in place of those of before. errors GP_ERROR_MEMORY. owns: the caller, until held_texels_free */
GpResult held_texels_take(HeldTexels *held, const GpPass *pass, const Histories *histories,
                          GpError *error);

/* in: pass, histories: those that they were taken of */
void held_texels_put(const HeldTexels *held, const GpPass *pass, const Histories *histories);

void held_texels_free(HeldTexels *held); /* zeroes it */

#endif
