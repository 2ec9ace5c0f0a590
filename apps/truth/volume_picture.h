/* What the two truths of volumes have in common: which picture is asked for, its rays, and its
 * memory. */
#ifndef APPS_TRUTH_VOLUME_PICTURE_H
#define APPS_TRUTH_VOLUME_PICTURE_H

#include "apps/base/camera.h"
#include "pipeline/base/pool.h"

enum { VOLUME_VALUES = 256 };

/* Colour, not multiplied by opacity, and opacity of a slab 1 thick at a value. */
typedef struct VolumeStop {
    double value, rgba[4];
} VolumeStop;

typedef struct VolumeScene {
    uint32_t size[3];        /* samples along x, y, z */
    double scale[3];         /* their distances, in the space of the camera */
    const uint8_t *value;    /* [z][y][x] */
    const VolumeStop *stops; /* by rising value; straight between, level beyond */
    uint32_t stop_count;     /* at least 1 */
    /* sample (0, 0, 0) is at the origin; nothing nearer than near or farther than far is seen */
    Camera camera;
    uint32_t width, height;
    /* [height][width]: of opaque things, as a depth buffer of the camera has it, 0 near, 1 far:
     * what lies behind is hidden. NULL: there are none */
    const float *depth;
} VolumeScene;

typedef struct VolumePicture {
    uint32_t width, height;
    double *rgba; /* [height][width][4]: colour multiplied by alpha, and alpha */
} VolumePicture;

/* Part of a line through the volume, in samples: begin + t * way for t in low..high, where t is a
 * length
 * in the camera's space. Empty where low >= high. */
typedef struct VolumeRay {
    double begin[3], way[3], low, high;
} VolumeRay;

/* The directions of all rays of a scene, found once. */
typedef struct VolumeEye {
    const VolumeScene *scene;
    CameraAxes axes;
} VolumeEye;

/* Colour and opacity of a value. */
void volume_classify(const VolumeScene *scene, double value, double rgba[4]);

/* -ln(1 - opacity), which stays finite: opacities beyond 1 - 2^-24 count as that. */
double volume_extinction(double opacity);

VolumeEye volume_eye(const VolumeScene *scene);

/* The ray through a place of the picture, pixels from its upper left corner, as far as it is in the
 * box that is `margin` samples larger than the samples' own. */
VolumeRay volume_ray(const VolumeEye *eye, double x, double y, double margin);

/* errors GP_ERROR_MEMORY; owns: the caller, until volume_picture_free */
GpResult volume_picture_create(uint32_t width, uint32_t height, VolumePicture *picture);

void volume_picture_free(VolumePicture *picture); /* zeroes it; a zeroed one is fine */

#endif
