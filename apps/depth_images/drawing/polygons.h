/* A mesh as polygons: what depth images of it are held against. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_POLYGONS_H
#define APPS_DEPTH_IMAGES_DRAWING_POLYGONS_H

#include "apps/depth_images/drawing/view.h"

/* Borrowed until the frame has run. */
typedef struct Polygons {
    const float *positions, *normals; /* [vertex_count][3]; normals: where it is lit */
    const float *colors;              /* [vertex_count][4] */
    const uint32_t *indices;          /* [3 * triangle_count] */
    uint32_t vertex_count, triangle_count;
    double waves; /* above 0: colours are 0.5 + 0.5 sin(waves * place) instead, and not lit */
} Polygons;

/* Appends a pass that draws the triangles, both of whose sides are seen, over what the target
 * holds.
 * errors GP_ERROR_MEMORY */
GpResult polygons_add(const Polygons *polygons, const WarpView *view, const WarpTarget *target,
                      Frame *frame, GpError *error);

#endif
