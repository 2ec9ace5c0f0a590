/* The colour of a mesh at a place of a triangle, lit as programs light it, in double: what the
 * truths of pictures of meshes show. */
#ifndef APPS_TRUTH_MESH_PAINT_H
#define APPS_TRUTH_MESH_PAINT_H

#include "apps/base/vector.h"
#include "apps/truth/ray_triangle.h"

#include <stddef.h>
#include <stdint.h>

/* Colour at a place of a triangle.
 * in  share: of each corner, at least 0, sum 1; out color: red, green, blue */
typedef void TruthColor(const void *context, uint32_t triangle, const double share[3],
                        double color[3]);

/* Blinn-Phong; places have a fourth component of 1, directions, which point towards eye or light,
 * 0. */
typedef struct TruthLight {
    double eye[4], source[4];
    double ambient[3], diffuse[3], specular[3], shininess;
} TruthLight;

typedef struct MeshPaint {
    const float *positions, *normals; /* three a vertex; normals: where there is light */
    const float *colors;              /* four a vertex, unless all have one, or waves */
    const uint32_t *indices;
    const double *color;     /* red, green, blue of all of it; NULL: the vertices' own */
    double waves;            /* above 0: colours are 0.5 + 0.5 sin(waves * place) */
    const TruthLight *light; /* on both sides of the mesh; NULL: colours as they are */
} MeshPaint;

TruthColor mesh_paint_color; /* context: a MeshPaint */

#endif
