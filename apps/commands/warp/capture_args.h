/* What `glasspipe warp capture` is asked for, and how that becomes depth images. */
#ifndef APPS_COMMANDS_CAPTURE_ARGS_H
#define APPS_COMMANDS_CAPTURE_ARGS_H

#include "apps/commands/options.h"
#include "apps/depth_images/making/capture_cylinder.h"
#include "apps/techniques/warp/options.h"

typedef struct CaptureArgs {
    Options options; /* first: see options.h */
    const char *input, *output;
    WarpOptions warp;  /* of meshes: kind, source, color */
    uint32_t layers;   /* 1 or 2; 0: of meshes 2, of scenes 1 */
    CaptureRays rays;  /* of cylinders */
    const char *depth; /* picture of depths beside a colour picture; NULL: there is none */
    const char *camera, *frame;
    double unit; /* 0: the camera's */
    const char *height;
    double relief, width; /* of height maps; relief 0: it is none; width 0: 1 */
    const char *write_camera;
} CaptureArgs;

/* What an input is, by its name and the options. */
typedef enum CaptureInput {
    CAPTURE_INPUT_MESH,
    CAPTURE_INPUT_SCENE,
    CAPTURE_INPUT_RGBD,
    CAPTURE_INPUT_HEIGHTS
} CaptureInput;

CaptureInput capture_input(const CaptureArgs *args);

/* Makes the images.
 * in   device: to draw with
 * out  model: untouched on failure; owned by the caller until depth_model_free
 * errors those of what is read and captured, with the file; GP_ERROR_INVALID: no pixel shows
 *      anything */
GpResult capture_model(const CaptureArgs *args, GpDevice *device, DepthModel *model,
                       GpError *error);

/* The camera of a planar image, whose range is twice about its depths.
 * errors GP_ERROR_INVALID: it is no plane about its own middle */
GpResult capture_camera(const DepthModel *model, Camera *camera, GpError *error);

#endif
