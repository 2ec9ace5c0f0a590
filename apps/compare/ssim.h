/* Structural similarity of two pictures. */
#ifndef APPS_COMPARE_SSIM_H
#define APPS_COMPARE_SSIM_H

#include "apps/frame/picture.h"

enum { SSIM_WINDOW = 11 }; /* pixels a side of the Gaussian window */

/* Mean similarity of the luminance (Rec. 709 weights; channel 0 of pictures with one or two
 * channels) over all windows inside the pictures; NaN where they are smaller than a window.
 * in     pictures of one size and number of channels
 * order  row by row from the top, in double: the same figure everywhere
 * source Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from error visibility to
 *        structural similarity", IEEE TIP 13(4), 2004, equations 13 to 17: Gaussian weights of
 *        sigma 1.5, K1 0.01, K2 0.03, dynamic range 1 */
double ssim_of(const Picture *a, const Picture *b);
double ssim_of_same(uint32_t width,
                    uint32_t height); /* of two pictures of this size that are the same */

#endif
