/* Which pixels of a planar depth image lie side by side on one surface, and which only in the
 * picture.
 *
 * Flat depths: depth itself where rays are parallel, and 1 / depth where they meet in an eye. Of a
 * plane they are a linear function of the place in the picture, and stay so wherever the plane is
 * seen from; so it is they that are interpolated, compared and continued.
 */
#ifndef APPS_DEPTH_IMAGES_DRAWING_EDGES_H
#define APPS_DEPTH_IMAGES_DRAWING_EDGES_H

#include "apps/depth_images/depth_image.h"

typedef enum EdgeRule {
    EDGES_SLOPES = 0, /* steps steeper than the surfaces on both sides of them are cut */
    EDGES_RELATIVE,   /* steps of more than a share of the depth are cut */
    EDGES_NONE        /* nothing is cut: rubber sheets hang between near and far */
} EdgeRule;

/* All zero: as they are meant. */
typedef struct EdgeSetting {
    EdgeRule rule;
    double share;  /* of the depth, EDGES_RELATIVE; 0: 0.02, as peers have it */
    double spread; /* EDGES_SLOPES: times the steeper of both sides that a step may be; 0: 1.2 */
    double texels; /* EDGES_SLOPES: pixel widths that it may be beside; 0: 4 */
    /* EDGES_SLOPES, of images with normals: cosine to the normals on both sides that the way of a
     * step may have which is more than `texels`; 0: normals are not asked */
    double along;
} EdgeSetting;

/* Vertices of a grid over the picture, every step-th pixel and the last, and which are one
 * surface. */
typedef struct DepthLattice {
    uint32_t width, height; /* vertices */
    uint32_t image[2];      /* pixels across and down */
    uint32_t step;
    bool is_parallel;
    double texel;       /* width of a pixel at depth 1, of parallel rays anywhere */
    double level;       /* to which depths were rounded, as far as neighbours tell */
    float *flat;        /* [height][width] flat depths; NaN: nothing */
    uint8_t *neighbour; /* [height][width]: bits of EdgeNeighbour */
    /* [height][width]: 1: by its normal, its back is what the image's eye sees of it */
    uint8_t *away;
} DepthLattice;

typedef enum EdgeNeighbour {
    EDGE_RIGHT = 1, /* one surface with the vertex to the right, */
    EDGE_DOWN = 2   /* with the one below */
} EdgeNeighbour;

/* The least step between neighbours in a row that is not 0: of depths that were stored in few bits,
 * what they were rounded to, so that steps of it are no edges. 0: there is none, or fewer than 16
 * of it from the nearest to the farthest. */
double depth_level(const DepthPixels *pixels);

/* Says that an image's depths are in steps wider than its pixels, a sentence; NULL: they are
 * not. */
const char *depth_level_warning(const DepthPlane *plane, const DepthPixels *pixels);

/* Finds where surfaces end: every pixel is a vertex. A pixel at the eye itself, of perspective
 * images, is nothing.
 * in     pixels: at least one
 * errors GP_ERROR_MEMORY; *lattice is then empty
 * owns   the caller, until depth_lattice_free
 * source ours */
GpResult depth_lattice_make(const DepthPlane *plane, const DepthPixels *pixels,
                            const EdgeSetting *setting, DepthLattice *lattice);

/* Every step-th vertex; two are one surface where all pixels from one to the other are.
 * in   pixels: of step 1. errors and owns: as above */
GpResult depth_lattice_thin(const DepthLattice *pixels, uint32_t step, DepthLattice *lattice);
void depth_lattice_free(DepthLattice *lattice); /* a zeroed one is fine */

/* Whether a cell, by its upper left vertex, is there and one surface along all four sides. */
bool depth_lattice_is_whole(const DepthLattice *lattice, int64_t x, int64_t y);

/* Where a place between vertices is across (axis 0) or down the picture, in pixels from its upper
 * left corner: vertices stand in the middles of their pixels, and beyond the first and the last is
 * the picture's side. */
double depth_lattice_place(const DepthLattice *lattice, int axis, double at);

/* Depth of a flat depth, and the other way. */
static inline double depth_flat(bool is_parallel, double depth)
{
    return is_parallel ? depth : 1 / depth;
}

/* A difference of flat depths at a flat depth, in widths of the pixels there: so far it would be
 * seen aside, in pixels, from an eye that looks at 45 degrees. */
static inline double depth_lattice_texels(const DepthLattice *lattice, double flat,
                                          double difference)
{
    return lattice->is_parallel ? fabs(difference) / lattice->texel
                                : fabs(difference) / (fabs(flat) * lattice->texel);
}

#endif
