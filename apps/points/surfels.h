/* Surfels: the points of a surface, each a small disc of it.
 *
 * source Pfister, Zwicker, van Baar and Gross, "Surfels: surface elements as rendering primitives",
 *        SIGGRAPH 2000; Zwicker et al., "Surface splatting", SIGGRAPH 2001.
 */
#ifndef APPS_POINTS_SURFELS_H
#define APPS_POINTS_SURFELS_H

#include "apps/base/bounds.h"
#include "pipeline/base/base.h"
#include "shaders_c/points/splat.h"

#include <math.h>

/* As vertex streams take it, position and radius as one: 32 bytes. */
typedef struct Surfel {
    float position[3]; /* of the model, finite */
    /* of the disc, in the model's unit, > 0: discs leave no hole where the sampling is watertight,
     * but for those of parents (patches.h) */
    float radius;
    float normal[3];  /* unit length, outwards */
    uint8_t color[3]; /* red, green, blue, as stored in files; white where there is none */
    /* (share / 255)^2 is how much of the area 2 pi radius^2 this surfel stands for, at least 1:
     * sums of Gaussians times that are 1 on a flat surface, however dense its points are */
    uint8_t share;
} Surfel;

/* Where a surfel on a crease ends: its part of its disc is bounded by lines through its centre. As
 * vertex streams take it: 32 bytes. */
typedef struct SurfelClip {
    /* x y z: unit directions of the model, in the surfel's plane and square to a line each, to
     * where the surfel is. w of the first: 1 where it is inwards of both, -1 where of either; of
     * the second: its share counts by that factor */
    float inward[2][4];
} SurfelClip;

typedef struct Surfels {
    Surfel *surfels; /* [count] */
    uint32_t count;
    SurfelClip *clips;   /* [clip_count] of the last surfels; NULL: none were looked for */
    uint32_t clip_count; /* others end at no line */
    bool had_normals, had_radii, had_colors; /* the file stored them; what it did not was made */
} Surfels;

/* What a surfel's Gaussian is as wide as, in units of the splats' spread: its radius, or less where
 * its disc is wider than its area needs. */
static inline float surfel_width(const Surfel *surfel)
{
    const float share = SPLAT_PER_SHARE / 255 * (float)surfel->share;
    return surfel->radius * (share < 1 ? share : 1);
}

/* The area that a surfel stands for, from its radius and share; and the share of an area. */
static inline double surfel_area(const Surfel *surfel)
{
    const double side = (double)surfel->share / 255 * (double)surfel->radius;
    return 6.283185307179586 * side * side;
}

static inline uint8_t surfel_share(double area, double radius)
{
    const double share = sqrt(area / 6.283185307179586) / radius * 255 + 0.5;
    return !(share > 1) ? 1 : share > 255 ? 255 : (uint8_t)share;
}

/* Of their places. */
static inline Bounds surfels_bounds(const Surfels *surfels)
{
    return bounds_of(surfels->surfels->position, sizeof(Surfel), NULL, surfels->count);
}

/* Of at least one. */
float surfels_mean_radius(const Surfels *surfels);

/* errors GP_ERROR_MEMORY; owns: the caller, until surfels_free */
GpResult surfels_alloc(Surfels *surfels, uint32_t count);

/* Frees and zeroes; a zeroed one is fine. */
void surfels_free(Surfels *surfels);

#endif
