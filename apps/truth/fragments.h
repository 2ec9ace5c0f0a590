/* Every fragment of a mesh under the centres of a picture's pixels, by brute force in double, put
 * together front to back. */
#ifndef APPS_TRUTH_FRAGMENTS_H
#define APPS_TRUTH_FRAGMENTS_H

#include "apps/base/camera.h"
#include "pipeline/base/pool.h"

/* What is seen: world space, both sides of triangles. Nothing nearer than near or farther than far
 * is. */
typedef struct FragmentTruthScene {
    const float (*positions)[3];
    const uint32_t *indices; /* three a triangle */
    uint32_t triangle_count;
    const float (*colors)[4]; /* of triangles, not multiplied by alpha */
    Camera camera;
    uint32_t width, height;
    /* A body (FragmentGlass of apps/fragments/drawing/view.h says what these mean); false: each
     * fragment hides alpha of what is behind it. */
    bool is_glass;
    double sigma, reflected, begin;
} FragmentTruthScene;

typedef struct FragmentTruth {
    uint32_t width, height;
    double *rgba; /* [height][width][4]: colour multiplied by alpha, and alpha */
    /* [height][width]: an edge of a triangle, or where the near or the far plane cuts it, is within
     * 1/256 pixel of the centre, so that a machine that rounds corners to that may see other
     * triangles. */
    uint8_t *is_edge;
    /* [height][width]: triangles come so close at the centre that rounding their corners may change
     * which of them is in front: they cut each other there, or lie in one plane. */
    uint8_t *is_crossing;
    uint64_t fragments;
    uint32_t layers; /* fragments of the pixel that has most */
} FragmentTruth;

/* Fragments go by exact depth, those of one depth by the order of triangles. Of triangles that
 * share an edge on which a centre lies exactly, one has it. Takes time as the fragments are many.
 * errors GP_ERROR_MEMORY; owns: the caller, until fragment_truth_free */
GpResult fragment_truth_make(const FragmentTruthScene *scene, GpPool *pool, FragmentTruth *truth);

void fragment_truth_free(FragmentTruth *truth); /* zeroes it; a zeroed one is fine */

#endif
