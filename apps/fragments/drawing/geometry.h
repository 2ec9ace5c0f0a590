/* A mesh whose triangles have a colour each, as vertices that a draw takes. */
#ifndef APPS_FRAGMENTS_DRAWING_GEOMETRY_H
#define APPS_FRAGMENTS_DRAWING_GEOMETRY_H

#include "apps/fragments/drawing/view.h"

/* GP_POSITION, 3; GP_COLOR, 4, as the mesh has them; GP_NORMAL, 3, of unit length (0: none), to the
 * side from which corners turn counter-clockwise. Colour and normal are those of the triangle whose
 * first corner a vertex is, and no other's: they are for flat varyings. Triangle i stands at
 * indices 3 i, with its corners in their turn; which is the first may differ. */
typedef struct FragmentGeometry {
    GpGeometry drawn, backwards;                        /* backwards: the last triangle first */
    float (*positions)[3], (*colors)[4], (*normals)[3]; /* normals: NULL: without */
    uint32_t *indices, *reversed;
} FragmentGeometry;

/* A triangle's normal, of unit length (0: none), to the side from which its corners turn
 * counter-clockwise.
 * in     positions: three floats a vertex */
void fragment_normal(const float *positions, const uint32_t corner[3], double normal[3]);

/* in     has_normals: glass reads them, and nothing else does
 * errors GP_ERROR_MEMORY; owns: the caller, until fragment_geometry_free */
GpResult fragment_geometry_make(const FragmentMesh *mesh, bool has_normals,
                                FragmentGeometry *geometry, GpError *error);

void fragment_geometry_free(FragmentGeometry *geometry); /* zeroes it; a zeroed one is fine */

#endif
