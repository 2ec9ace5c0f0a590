/* What may be set of points: how they are drawn, of what, and how they are looked at. */
#ifndef APPS_TECHNIQUES_POINTS_OPTIONS_H
#define APPS_TECHNIQUES_POINTS_OPTIONS_H

#include "apps/base/orbit.h"
#include "apps/points/drawing/splats.h"
#include "apps/techniques/settings.h"

/* What points are kept as. */
typedef enum PointsCompress { POINTS_PLAIN, POINTS_OURS, POINTS_PRINTED } PointsCompress;

/* The setting of the technique. */
typedef struct PointsOptions {
    SplatSetting splats;
    double detail;   /* largest standard deviation of a splat on the picture; 0: all points */
    uint32_t budget; /* splats at most; 0: any number */
    PointsCompress compress;

    /* aside of the key */
    uint32_t subdivide, sample; /* of a mesh: midpoints, points spread over it; 0: its vertices */
    double sharp;               /* of a mesh: the angle of creases; 0: none are looked for */
    bool one_radius;            /* for all vertices of a mesh */
    const char *color;  /* "file", "waves:K", or a name; NULL: the file's, where it has any */
    const char *camera; /* a file; NULL: the orbit */
    Orbit orbit;
    bool unlit;
    const char *cache; /* a file for what is built of the points; NULL: none */
    bool measures, reports;
} PointsOptions;

extern const SettingField points_settings[];
extern const PointsOptions points_option_defaults;

/* As a technique's check. */
GpResult points_options_check(const void *options, uint32_t given, const char *extension,
                              GpError *error);

/* What a setting draws with: its own method, but ewa instead of adaptive where splats are to end at
 * creases (sharp). */
SplatMethod points_method(const PointsOptions *options);

/* Whether a setting asks for patches: for levels, for filters that differ from patch to patch, or
 * since they are what is compressed and cached. */
bool points_needs_patches(const PointsOptions *options);

#endif
