/* Surfels as a picture: the passes that draw them.
 *
 * Three passes (paper 004, section 3): visibility leaves the surface's depth, pushed back by epsilon;
 * splats that lie before it add their weighted attributes; the sums are divided by the weights, and
 * lit. Rivals without filters take one.
 */
#ifndef APPS_POINTS_SPLATS_H
#define APPS_POINTS_SPLATS_H

#include "apps/base/camera.h"
#include "apps/frame/frame.h"
#include "apps/points/surfels.h"

typedef enum SplatMethod {
    SPLAT_ADAPTIVE,       /* the cheapest filter whose error has a bound: filter.h */
    SPLAT_EWA,            /* both filters */
    SPLAT_RECONSTRUCTION, /* the surfel's own Gaussian alone */
    SPLAT_LOW_PASS,       /* the pixel's filter alone */
    SPLAT_AREA,           /* adaptive as the thesis prints it: by the ratio of areas */
    SPLAT_DISTANCE,       /* adaptive as paper 003 prints it: by distances */
    SPLAT_ROUND,          /* discs that face the eye, without filters */
    SPLAT_PIXELS,         /* a pixel a point */
    SPLAT_METHODS
} SplatMethod;

/* What sums are kept in. */
typedef enum SplatSums { SPLAT_HALVES, SPLAT_FLOATS, SPLAT_BYTES } SplatSums;

typedef struct SplatSetting {
    SplatMethod method;
    double tolerance; /* of the adaptive method: by how much a colour of 0 to 1 may be off */
    SplatSums sums;
    double low_pass; /* standard deviation of the pixel's filter, in pixels */
    double spread;   /* of a surfel's Gaussian, in its radii */
    double cut;      /* splats end at so many standard deviations */
    double epsilon;  /* footprints that visibility lies behind the surface */
    bool two_sided;  /* surfels that face away from the eye are drawn too */
} SplatSetting;

extern const SplatSetting splat_defaults;

/* How surfels are seen. */
typedef struct SplatView {
    Camera camera; /* perspective */
    uint32_t width, height;
    double waves; /* above 0: colours 0.5 + 0.5 sin(waves * position) instead of the surfels' */
    bool lit;     /* by a light beside the eye, once a pixel */
    float background[4]; /* multiplied by its alpha */
} SplatView;

/* The light of a view that is lit, which stands to the left of the eye and above it, without end. */
typedef struct SplatLight {
    double towards[3]; /* world, unit length */
    double ambient, specular, shininess;
} SplatLight;

SplatLight splat_light(const SplatView *view);

/* Consecutive surfels that are drawn with one filter. */
typedef struct SplatRun {
    SplatMethod filter; /* of splats: SPLAT_EWA, SPLAT_RECONSTRUCTION or SPLAT_LOW_PASS */
    uint32_t first, count;
} SplatRun;

/* What is drawn: runs of a vertex array. Borrowed until the frame has run. */
typedef struct SplatSource {
    const Surfel *surfels;
    const SplatRun *runs;
    uint32_t run_count;
} SplatSource;

/* Appends the passes; frame->color is the picture, frame->depth its depth, where surfels are lit.
 * errors GP_ERROR_INVALID: rays are parallel; GP_ERROR_MEMORY is the frame's own */
GpResult splats_build(const SplatSource *source, const SplatView *view, const SplatSetting *setting,
                      Frame *frame, GpError *error);

#endif
