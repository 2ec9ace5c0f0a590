/* Clearing surfaces where nothing is drawn. */
#ifndef GP_FAST_CLEAR_H
#define GP_FAST_CLEAR_H

#include "pipeline/fast/frame.h"

/* Clears what a pass clears inside a box of its pixels, straight in the surfaces. */
void fast_clear_box(const GpPass *pass, const FastBox *box);

#endif
