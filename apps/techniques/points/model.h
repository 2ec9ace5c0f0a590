/* A point model that has been opened, and how it is seen. */
#ifndef APPS_TECHNIQUES_POINTS_MODEL_H
#define APPS_TECHNIQUES_POINTS_MODEL_H

#include "apps/points/cache.h"
#include "apps/points/hierarchy.h"
#include "apps/points/open.h"
#include "apps/points/patches.h"
#include "apps/points/drawing/splats.h"
#include "apps/techniques/points/options.h"
#include "apps/techniques/points/truths.h"
#include "apps/techniques/technique.h"
#include "pipeline/io/mesh/mesh.h"

typedef struct PointsModel {
    char path[4096];
    uint32_t point_count;
    Bounds bounds;     /* of the points */
    Surfels surfels;   /* empty where they were freed, or lie in patches from the cache */
    float mean_radius; /* of them */
    double step;       /* to which floats round their farthest coordinates */
    PointsFacts facts; /* where a report is asked for */
    Patches patches;   /* empty until a setting needs them, or the cache had them */
    Compressed compressed[COMPRESS_FORMS]; /* the same */
    /* what it was opened for: of another form than POINTS_PLAIN it keeps that alone, once it is
     * built, and frees what it was made of */
    PointsCompress keeps;
    GpFile file;       /* what a model from the cache lies in */
    Sequence sequence; /* empty until a setting needs it */
    const char *cache; /* where they go once they are built; NULL: nowhere, or they are there */
    uint64_t cache_key;
    GpError cache_fault; /* why the cache was of no use, or could not be written; else empty */
    PointsListener listener;
    PointsSource source;
    GpMesh mesh;     /* whose surface they are; empty until it is needed */
    bool is_surface; /* it is as the points are of it (points_surface) */
    SplatView view;
    const uint8_t *color; /* of all points; NULL: each has its own */
    MeshPicture truth;    /* empty until it is found */
} PointsModel;

/* As a technique's open and close. */
GpResult points_model_open(const TechniqueInput *input, void **model, GpError *error);
void points_model_close(void *model);

/* Builds the patches, and compresses them, once.
 * errors those of patches_build; GP_ERROR_INVALID: the model keeps another form alone */
GpResult points_model_structure(PointsModel *model, PointsCompress form, int threads,
                                GpError *error);

/* Puts the patches' nodes into a sequence, once. errors GP_ERROR_MEMORY */
GpResult points_model_sequence(PointsModel *model, GpError *error);

/* Finds the truth, once. errors GP_ERROR_INVALID: the surface is not known; GP_ERROR_MEMORY */
GpResult points_model_truth(PointsModel *model, int threads, GpError *error);

/* Points that a frame draws, and the bytes that what a setting draws takes in memory: surfels, or
 * patches with all their levels. */
uint64_t points_model_splats(const Frame *frame);
double points_model_bytes(const PointsModel *model, const PointsOptions *options);

#endif
