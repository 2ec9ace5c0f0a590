/* Planar depth images of what depth cameras take: a colour picture and one of depths, of one size,
 * and the camera that took both.
 */
#ifndef APPS_DEPTH_IMAGES_MAKING_RGBD_H
#define APPS_DEPTH_IMAGES_MAKING_RGBD_H

#include "apps/depth_images/depth_image.h"

/* A camera by its lens: the pixel in column i and row j (whole numbers, of pixel centres) sees
 * along ((i - cx) / fx, (j - cy) / fy, 1) of its own axes: x right, y down, z forward. */
typedef struct RgbdCamera {
    double fx, fy, cx, cy; /* pixels; fx, fy above 0 */
    double unit;           /* what one step of a depth picture is in the world */
    double right[3], up[3], forward[3], eye[3]; /* world; unit vectors, square to each other */
} RgbdCamera;

/* Reads a camera's file: "intrinsics" with fx, fy, cx and cy; "depth_unit_m", 0.001 where it is not
 * there; "camera_axes", of which "x right, y down, z forward" alone is known; and "frames", each by
 * a name with its "camera_to_world", four rows of four numbers, of which the upper left three by
 * three turn, to 1e-3.
 * in     frame: its name; NULL: the only one
 * errors those of reader_open; GP_ERROR_FORMAT with file, line and member; camera is then
 *        untouched */
GpResult rgbd_camera_read(const char *path, const char *frame, RgbdCamera *camera, GpError *error);

/* The plane of such a camera's pictures. */
DepthPlane rgbd_plane(const RgbdCamera *camera, uint32_t width, uint32_t height);

/* Reads both pictures. A depth is the code of 8 or 16 bits, or a float, times the camera's unit; 0,
 * and floats that are not finite, are nothing. Normals are found from depths beside each other that
 * are one surface.
 * out    image: planar, one layer; untouched on failure
 * errors those of gp_image_read; GP_ERROR_FORMAT: sizes that differ, depths of several channels,
 *        depths below 0; GP_ERROR_MEMORY; owns: the caller, until depth_pixels_free of its front */
GpResult rgbd_read(const char *color_path, const char *depth_path, const RgbdCamera *camera,
                   DepthImage *image, GpError *error);

#endif
