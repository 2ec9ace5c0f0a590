/* Planar depth images of height maps: pictures whose brightness is a height over a plane. */
#ifndef APPS_DEPTH_IMAGES_MAKING_HEIGHT_MAP_H
#define APPS_DEPTH_IMAGES_MAKING_HEIGHT_MAP_H

#include "apps/depth_images/depth_image.h"

/* Reads a colour picture and a map. The image stands upright about the origin and faces +z: it is
 * `width` wide, in proportion as high, heights of 0 lie at z = 0, those of 1 at z = relief. It is
 * seen along -z from the plane z = relief. A map of four channels has the normal in the first
 * three, n = 2 c - 1, y up in the picture, and the height in the fourth, as relief textures have
 * them; of any other map heights are its first channel, and normals are found from them. The map's
 * size is the image's; colours are averaged to it or repeated.
 * in     color_path: NULL: white; width, relief: above 0
 * out    image: planar, parallel, one layer; untouched on failure
 * errors those of picture_read; GP_ERROR_MEMORY; owns: the caller, until depth_pixels_free of its
 *        front */
GpResult height_map_read(const char *color_path, const char *map_path, double width, double relief,
                         DepthImage *image, GpError *error);

#endif
