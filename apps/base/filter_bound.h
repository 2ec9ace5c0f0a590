/* How much of a splat's filter can be left out: bounds on what that does to a picture.
 *
 * A splat is a Gaussian of variance V = R + h I, where R is the projected disc's, with eigenvalues
 * l1 >= l2, and h the pixel's filter. Left out, one of the two leaves a Gaussian of the same centre
 * and other eigenvalues. A picture is a mean of colours by such weights, so with G for the true
 * weight and G' for the one drawn, each of integral 1, no colour channel in [0, 1] can change by
 * more than half of L = integral |G - G'|: what one takes away from places, it gives to others. By
 * Pinsker's inequality
 *
 *     L <= sqrt(2 KL(G' : G)) = sqrt(f(t1) + f(t2)),   f(t) = t - 1 - ln t,
 *
 * where t are the ratios of the eigenvalues of G' to those of G: l / (l + h) where the
 * reconstruction stays, h / (l + h) where the low-pass filter does. Both eigenvalues count: the
 * determinant alone, which the thesis looks at, hides a splat that is long and thin.
 * source ours; Kullback and Leibler's distance of Gaussians: any book on statistics
 */
#ifndef APPS_BASE_FILTER_BOUND_H
#define APPS_BASE_FILTER_BOUND_H

/* Upper bounds of L, from 0; a Gaussian that shrinks to a line or a point: infinite.
 * in   l1, l2: eigenvalues of R, h: of the pixel's filter; square pixels, at least 0 */
double filter_bound_reconstruction(double l1, double l2, double h);
double filter_bound_low_pass(double l1, double l2, double h);

#endif
