/* Blending: source and destination to what is stored (R32-R36). */
#ifndef GP_BLEND_H
#define GP_BLEND_H

#include "pipeline/resources/packet.h"

/* Whether a blend state reads the destination. */
bool gp_blend_reads_target(const GpBlend *blend);

/* Blends one colour.
 * in   format: of the target: unorm formats clamp source and constant to [0,1] first (R32);
 *      source, destination, constant: r g b a, linear
 * out  result, not yet rounded to the format; may be source itself
 * note a factor of 0 is multiplied like any other, so NaN and infinity propagate (R34) */
void gp_blend(const GpBlend *blend, const float constant[4], GpFormat format, const float source[4],
              const float destination[4], float result[4]);

/* The factors that it multiplies with, of the source and of the destination: 0 where the operation
 * has none. in: as gp_blend */
void gp_blend_factors(const GpBlend *blend, const float constant[4], GpFormat format,
                      const float source[4], const float destination[4], float factors[2][4]);

#endif
