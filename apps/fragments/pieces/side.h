/* On which side of a plane through three points a fourth one lies, exactly. */
#ifndef APPS_FRAGMENTS_PIECES_SIDE_H
#define APPS_FRAGMENTS_PIECES_SIDE_H

/* in     a, b, c: corners of a triangle; p: a point; finite
 * returns 1 where p is on the side from which a, b, c turn counter-clockwise, -1 on the other, 0 on
 *        the plane, or where the triangle has none
 * source the sign of the determinant |b - a, c - a, p - a|: in double where its error cannot turn
 *        it, else exactly, by sums of doubles that do not overlap: Shewchuk, "Adaptive precision
 *        floating-point arithmetic and fast robust geometric predicates", 1997, section 2 */
int side_of_plane(const float a[3], const float b[3], const float c[3], const float p[3]);

#endif
