/* The truth of a splatted picture, and how far off it is. */
#ifndef APPS_TECHNIQUES_POINTS_TRUTHS_H
#define APPS_TECHNIQUES_POINTS_TRUTHS_H

#include "apps/points/drawing/view.h"
#include "apps/truth/mesh_picture.h"
#include "pipeline/io/mesh/mesh.h"

typedef struct PointsError {
    double interior_psnr; /* dB, over pixels that the mesh covers wholly, with their neighbours */
    double area_error;    /* of the sum of alpha, as a share of the truth's: above 0 too large */
    double rmse;          /* over the interior, of 1 */
    double largest;       /* the 99.9th percentile of absolute errors there, rounded up to 1/255 */
    double holes;         /* interior pixels in which nothing was drawn */
    double covered;       /* pixels, parts of such counted as parts */
} PointsError;

/* The mesh itself, with the light of the view, 8 x 8 samples a pixel.
 * in     mesh: with normals; color: of all of it; NULL: its vertices' own
 * errors GP_ERROR_MEMORY; owns: the caller, until mesh_picture_free */
GpResult points_truth_find(const GpMesh *mesh, const uint8_t *color, const SplatView *view,
                           GpPool *pool, MeshPicture *truth);

/* in   picture: A8R8G8B8, of the truth's size */
PointsError points_error(const MeshPicture *truth, const GpSurface *picture);

/* How much brighter than the truth each pixel of the interior is, as the mean of its channels; 0
 * elsewhere. out off: [height][width] */
void points_difference(const MeshPicture *truth, const GpSurface *picture, float *off);

#endif
