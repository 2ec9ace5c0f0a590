/* Meshes of which all fragments count: how they are looked at, and what their passes draw into. */
#ifndef APPS_FRAGMENTS_DRAWING_VIEW_H
#define APPS_FRAGMENTS_DRAWING_VIEW_H

#include "apps/base/camera.h"
#include "apps/frame/frame.h"

/* What is drawn; borrowed. World space. */
typedef struct FragmentMesh {
    const float (*positions)[3];
    uint32_t vertex_count;
    const uint32_t *indices; /* three a triangle; both sides are seen, and count */
    uint32_t triangle_count;
    const float (
        *colors)[4]; /* red, green, blue of each triangle, 0..1, not multiplied by alpha, and its
                                 alpha in the order of triangles */
} FragmentMesh;

/* Light on its way through what is between two surfaces. */
typedef struct FragmentGlass {
    bool is_on;         /* false: each fragment hides alpha of what is behind it, and that is all */
    double sigma;       /* extinction, of the world's unit of length */
    bool is_as_printed; /* Schlick's term as the paper prints it */
} FragmentGlass;

typedef struct FragmentView {
    Camera camera; /* perspective or parallel */
    uint32_t width, height;
    float background[4]; /* multiplied by its alpha */
    FragmentGlass glass;
} FragmentView;

/* Each method is a pair of files here, METHOD.h and METHOD.c, that appends its passes to a frame:
 *
 *   GpResult METHOD_add(const FragmentMesh *mesh, const METHODSetting *setting,
 *                       const FragmentView *view, GpSurface *color, GpSurface *depth, Frame *frame,
 *                       GpError *error);
 *       color: what is behind, multiplied by its alpha, becomes fragments + (1 - alpha) * behind;
 *       depth: D32F of what is opaque, which hides fragments and is left as it is; NULL: nothing is
 *
 * Fragments are blended front to back by depth, those of one depth in the order of triangles. */

#endif
