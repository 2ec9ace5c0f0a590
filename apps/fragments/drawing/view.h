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
    const GpGeometry *drawn;     /* the same for draws: drawing/geometry.h */
    const GpGeometry *backwards; /* the same, the last triangle first */
} FragmentMesh;

/* Light on its way through what is between two surfaces, so that a mesh is a body.
 *
 * At a surface a share t of the light goes through, t = (1 - r) (1 - (1 - cos)^5), Schlick's, of
 * the angle between the line of sight and the triangle's normal; r = 0.04, or 0 as printed. So a
 * fragment hides h = 1 - (1 - alpha) t, and adds h times its colour. Of the way d to a fragment
 * along the line of sight, from the plane `begin` on, what lies between a triangle that faces the
 * eye (its corners turn counter-clockwise) and one that does not is inside and takes light, by Beer
 * and Lambert's exp(-sigma length). Said of each fragment by itself, which is the same where bodies
 * are closed and apart, so that whoever sorts may blend them as any others: one that faces the eye
 * lets (1 - h) exp(sigma d) through; one that does not, (1 - h) exp(-sigma d), and its own light is
 * times exp(-sigma d) too. */
typedef struct FragmentGlass {
    bool is_on;         /* false: each fragment hides alpha of what is behind it, and that is all */
    double sigma;       /* extinction, of the world's unit of length */
    bool is_as_printed; /* Schlick's term as the paper prints it */
    /* distance of a plane along the view, before which is no surface, and no body; the nearer the
     * mesh, the smaller the exponents. 0: the near plane */
    double begin;
} FragmentGlass;

#define FRAGMENT_REFLECTED 0.04 /* r: of glass, head on */

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
