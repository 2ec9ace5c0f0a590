/* How surfels may be drawn, of what, and how they are looked at. */
#ifndef APPS_POINTS_DRAWING_SETTING_H
#define APPS_POINTS_DRAWING_SETTING_H

#include "apps/points/compress.h"
#include "apps/points/hierarchy.h"

typedef enum SplatMethod {
    SPLAT_ADAPTIVE,       /* the cheapest filter whose error has a bound */
    SPLAT_EWA,            /* both filters */
    SPLAT_RECONSTRUCTION, /* the surfel's own Gaussian alone */
    SPLAT_LOW_PASS,       /* the pixel's filter alone */
    SPLAT_AREA,           /* adaptive as the thesis prints it: by the ratio of areas */
    SPLAT_DISTANCE,       /* adaptive as paper 003 prints it: by distances */
    SPLAT_TERNARY,        /* both filters in one pass, by the ternary depth test */
    SPLAT_PERSPECTIVE,    /* both filters, by the ray of each pixel against the surfel's plane */
    SPLAT_QUADS,          /* both filters, as quads in the surfels' planes */
    SPLAT_ROUND,          /* discs that face the eye, without filters */
    SPLAT_PIXELS,         /* a pixel a point */
    SPLAT_QSPLAT,         /* squares, as many as a walk down the hierarchy finds */
    SPLAT_SEQUENCE,       /* squares, by a sequential point tree */
    SPLAT_METHODS
} SplatMethod;

/* Whether a method draws compressed surfels: those that know filters by runs. */
static inline bool splat_takes_compressed(SplatMethod method)
{
    return method < SPLAT_TERNARY;
}

/* Whether splats on creases can end at their clip lines: where all are drawn, by affine EWA. */
static inline bool splat_has_clips(SplatMethod method)
{
    return method == SPLAT_EWA || method == SPLAT_RECONSTRUCTION || method == SPLAT_LOW_PASS;
}

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

#define SPLAT_DEFAULTS                                                                             \
    {                                                                                              \
        .low_pass = 0.4, .spread = 0.8, .tolerance = 0.05, .cut = 2, .epsilon = 4                  \
    }

/* How surfels are seen. */
typedef struct SplatView {
    Camera camera; /* perspective */
    uint32_t width, height;
    double waves; /* above 0: colours 0.5 + 0.5 sin(waves * position) instead of the surfels' */
    bool lit;     /* by a light beside the eye, once a pixel */
    float background[4]; /* multiplied by its alpha */
} SplatView;

/* Consecutive surfels that are drawn with one filter. */
typedef struct SplatRun {
    SplatMethod filter; /* of splats: SPLAT_EWA, SPLAT_RECONSTRUCTION or SPLAT_LOW_PASS */
    uint32_t first, count;
    float radius;   /* mean of the surfels' */
    uint32_t patch; /* whose surfels they are; of compressed ones only */
    bool merged;    /* some stand for several leaves */
} SplatRun;

/* How much narrower splats of merged surfels are. There are so many as pixels, whose filter closes
 * the surface between them; and what they are wider than leaves is what merging blurs. */
#define SPLAT_MERGED_SPREAD 0.65

/* What is drawn: runs of a vertex array, of surfels as they are or of compressed ones
 * (splat_takes_compressed). Borrowed until the frame has run. */
typedef struct SplatSource {
    const Surfel *surfels;
    const Compressed *compressed; /* instead of surfels; NULL: these */
    GpSurface *radii;             /* of them, in a vertex texture: compressed_radii */
    const uint8_t *color;         /* of all compressed surfels, where they have none; NULL: white */
    const SplatRun *runs;
    uint32_t run_count;
    const SplatRun *hiders; /* what leaves visibility; NULL: the runs themselves */
    uint32_t hider_count;

    const struct SplatSource *clipped; /* of surfels with clips, drawn beside these; NULL: none */
    const SurfelClip *clips;           /* of such a source, one a surfel */

    const SequenceNode *nodes; /* of SPLAT_SEQUENCE, instead of surfels and runs */
    uint32_t node_count;
    double per_radius; /* depth at which a radius of 1 is small enough */
} SplatSource;

#endif
