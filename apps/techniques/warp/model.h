/* What is warped, once it has been opened: a mesh and what was captured of it, or an image from a
 * file; how it is seen, and what methods have made of it. */
#ifndef APPS_TECHNIQUES_WARP_MODEL_H
#define APPS_TECHNIQUES_WARP_MODEL_H

#include "apps/base/bounds.h"
#include "apps/depth_images/drawing/polygons.h"
#include "apps/techniques/technique.h"
#include "apps/techniques/warp/heights.h"
#include "apps/techniques/warp/options.h"
#include "apps/techniques/warp/truths.h"
#include "pipeline/io/mesh/mesh.h"

/* What a method keeps of all images of a model, as some settings have it: methods.c */
typedef struct WarpMade WarpMade;

/* Images that frames are made of, and what methods keep of them. */
typedef struct WarpImages {
    struct WarpImages *next;
    WarpKind kind;
    uint32_t size[2]; /* as asked for */
    DepthModel model;
    WarpMade *made; /* a list */
} WarpImages;

/* A truth, of a view. */
typedef struct WarpTruth {
    struct WarpTruth *next;
    double turn;
    RayPicture picture;
} WarpTruth;

typedef struct WarpModel {
    bool is_image;     /* from a file; else a mesh */
    GpMesh mesh;       /* with colours */
    Polygons polygons; /* that mesh */
    Bounds bounds;     /* of what is seen */
    OrbitUp up;        /* the axis of cylinders about the mesh */
    Camera source;     /* by which a planar image of the mesh is captured */
    Camera about;      /* what the view is turned from */
    WarpImages *images;
    WarpHeights heights;     /* on all of them */
    const char *color;       /* as the options have it */
    const char *truth_path;  /* a file; NULL: the mesh */
    DepthModel truth_images; /* of that file, where it is one */
    Camera fixed;            /* the view, */
    bool is_fixed;           /* where it was given */
    uint32_t width, height;
    bool lit;
    WarpTruth *truths;
} WarpModel;

/* As a technique's open; and its close, for what no method has made. */
GpResult warp_model_open(const TechniqueInput *input, void **model, GpError *error);
void warp_model_close(void *model);

/* How a setting looks at the model. in light: room, borrowed by the view */
WarpView warp_model_view(const WarpModel *model, const WarpOptions *options, WarpLight *light);

/* The images that a setting draws, captured once.
 * in     device: to capture with
 * errors those of the captures; GP_ERROR_INVALID: the file's image is of another kind */
GpResult warp_model_images(WarpModel *model, const WarpOptions *options, GpDevice *device,
                           WarpImages **images, GpError *error);

/* The truth of a setting's view, found once.
 * errors GP_ERROR_INVALID: there is none, with the reason; GP_ERROR_MEMORY; those of the truth's
 *      file */
GpResult warp_model_truth(WarpModel *model, const WarpOptions *options, int threads,
                          const RayPicture **truth, GpError *error);

/* How far off a frame is that has been drawn. errors those of warp_model_truth */
GpResult warp_model_error(WarpModel *model, const Frame *frame, int threads, WarpError *off,
                          GpError *error);

#endif
