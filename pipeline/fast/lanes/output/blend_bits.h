/* Blends that combine the stored words of A8R8G8B8. */
#ifndef GP_FAST_BLEND_BITS_H
#define GP_FAST_BLEND_BITS_H

#include "pipeline/fast/lanes/output/shaded.h"

/* Blends packets into one target; color: of the first, in that target. A gathered packet may hold a
 * pixel several times. */
void fast_blend_bits(const GpBlend *blend, FastPlanes *planes, const FastShaded *shaded,
                     const flt *color);

/* The same of a box of words of another plane, as they are. */
void fast_copy_words(const GpBlend *blend, const FastBox *box, const uint32_t *from, uint32_t *to);

#endif
