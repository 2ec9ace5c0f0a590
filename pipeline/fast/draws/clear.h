/* Clearing surfaces where nothing is drawn. */
#ifndef GP_FAST_CLEAR_H
#define GP_FAST_CLEAR_H

#include "pipeline/fast/draws/draw.h"

/* Of the parts in which a pass clears, number i, as far as it lies in a box of pixels; may be
 * empty. */
FastBox fast_clear_part(const GpPass *pass, uint32_t i, const FastBox *box);

/* Clears what a pass clears inside a box of its pixels, straight in the surfaces.
 * non_temporal: past the caches, where surfaces are large and no one draws there soon */
void fast_clear_box(const GpPass *pass, const FastBox *box, bool non_temporal);

#endif
