/* The exact shadows of a picture: what each pixel shows, and how much of a light it sees.
 *
 * Rays through the pixels' centres find the surface; rays from there find what is in the light's
 * way. Pixel (i, j) has its centre at (i + 0.5, j + 0.5), row 0 on top, as in the pipeline.
 */
#ifndef APPS_TRUTH_SHADOW_TRUTH_H
#define APPS_TRUTH_SHADOW_TRUTH_H

#include "apps/base/camera.h"
#include "apps/truth/ray_scene.h"

typedef enum TruthLightKind {
    TRUTH_POINT, /* position: lights all around */
    TRUTH_CONE,  /* position, axis, half_angle: a point that lights a cone */
    /* frustum: a point, or a wall of parallel rays, that lights what a camera with a square picture
     * sees; near and far do not matter */
    TRUTH_FRUSTUM,
    TRUTH_DIRECTIONAL, /* towards */
    /* position, side, samples: a parallelogram that shines to both sides; with a half_angle and an
     * axis, into a cone about its centre: what is beside that is dark, and its edge sharp, as where
     * a lamp is shaded far before it */
    TRUTH_AREA
} TruthLightKind;

/* Fields that the kind does not name are ignored. */
typedef struct TruthLight {
    TruthLightKind kind;
    double position[3]; /* of an area light: its centre */
    double axis[3];     /* out of the light, any length */
    double half_angle;  /* degrees, between axis and side, below 90; 0, of an area: no cone */
    Camera frustum;
    double towards[3];    /* from the scene to the light, any length */
    double side[2][3];    /* the whole sides of the parallelogram */
    unsigned int samples; /* points on it; 0: 16; powers of two are spread best */
} TruthLight;

typedef struct ShadowView {
    Camera camera; /* near and far cut the scene; fovy 0: parallel rays */
    uint32_t width, height;
    TruthLight light;
    int threads; /* 1..1024; 0: one; the result does not depend on it */
    /* of an area light: visibility is 1 where half of it or more is seen, else 0, which is known
     * before all of its points are looked at */
    bool only_lit;
} ShadowView;

/* What is seen where the camera sees nothing. */
#define SHADOW_NOTHING (-1.0f)

/* Packed, row 0 on top. */
typedef struct ShadowTruth {
    uint32_t width, height;
    /* the share of the light that is seen, 0 to 1, or SHADOW_NOTHING; 0 where the triangle's plane
     * parts the eye from the light */
    float *visibility;
    uint32_t *triangle; /* what is seen, or TRUTH_NO_TRIANGLE */
} ShadowTruth;

/* Casts all rays of a picture.
 * errors GP_ERROR_MEMORY
 * owns   the caller frees with shadow_truth_free
 * source an area light's points are Hammersley's: the k-th of n is at (k + 0.5) / n along the first
 *        side, and along the second at the bits of k after the binary point in reverse, centred */
GpResult shadow_truth_cast(const TruthScene *scene, const ShadowView *view, ShadowTruth *truth);

void shadow_truth_free(ShadowTruth *truth); /* frees the arrays and empties *truth */

#endif
