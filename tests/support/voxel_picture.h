/* Volumes and pictures of them, for tests. */
#ifndef TESTS_VOXEL_PICTURE_H
#define TESTS_VOXEL_PICTURE_H

#include "apps/voxel_view.h"

enum { VOXEL_PICTURE_SIDE = 64 }; /* pixels */

/* An empty work with room for a picture. */
void voxel_picture_begin(Work *work);

/* Voxels of worksheets of one bit. */
void voxel_picture_put(const Worksheet *sheet, uint32_t x, uint32_t y, uint32_t z);
bool voxel_picture_get(const Worksheet *sheet, const uint32_t voxel[3]);

/* One voxel in so many. */
Worksheet voxel_picture_random(Work *work, uint32_t size, int32_t rarity, uint64_t seed);

/* Looks at the middle of a volume from a direction, `distance` sizes away; fovy 0: parallel rays. */
Camera voxel_picture_camera(uint32_t size, double x, double y, double z, double distance,
                            double fovy);

/* Builds a picture, and draws all of the work's list. */
void voxel_picture_draw(Work *work, const Worksheet *sheet, const VoxelView *view);

/* A pixel of the target of a pass. */
void voxel_picture_pixel(const Work *work, const char *pass, int x, int y, float rgba[4]);

#endif
