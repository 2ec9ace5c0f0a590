/* Colours as FLIP sees them: from sRGB by way of opponent colours, which are filtered, to lightness
 * and chroma, whose distance is what an eye would notice. */
#ifndef APPS_COMPARE_FLIP_COLOR_H
#define APPS_COMPARE_FLIP_COLOR_H

#include "apps/base/stable_math.h"

/* Of two pixels at once. */

/* sRGB in [0, 1] to opponent colours Y C_x C_z, linear in light: Y 116 Y/Yn - 16, from -16 to 100,
 * C_x red against green, C_z blue against yellow.
 * source section 4.1; primaries of Rec. 709, white at x 0.31271, y 0.32902 (D65) */
void flip_opponent(const StablePair srgb[3], StablePair opponent[3]);

/* Distance of two opponent colours: both are cut to what linear RGB in [0, 1] can show, brought to
 * L*a*b*, their chroma scaled by L* / 100 (Hunt), and measured by HyAB; the distance is raised to
 * 0.7 and mapped to [0, 1], so that 0.4 of the largest takes 0.95 of the range. 1: green against
 * blue.
 * source section 4.1, equations for HyAB and the redistribution of errors */
StablePair flip_color_difference(const StablePair a[3], const StablePair b[3]);

#endif
