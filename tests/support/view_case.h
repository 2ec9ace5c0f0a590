/* Pictures of volumes drawn for tests: voxels put by hand, a camera, pixels. */
#ifndef TESTS_VIEW_CASE_H
#define TESTS_VIEW_CASE_H

#include "apps/techniques/voxel/pictures/view.h"

enum { VIEW_CASE_SIDE = 64 }; /* pixels */

/* An empty frame with room for a picture. */
void view_case_begin(Frame *frame);

/* Voxels of flat textures of one bit. */
void view_case_put(const FlatTexture *flat, uint32_t x, uint32_t y, uint32_t z);
bool view_case_get(const FlatTexture *flat, const uint32_t voxel[3]);

/* One voxel in so many. */
FlatTexture view_case_random(Frame *frame, uint32_t size, int32_t rarity, uint64_t seed);

/* Looks at the centre of a volume from a direction, `distance` sizes away; fovy 0: parallel
 * rays. */
Camera view_case_camera(uint32_t size, double x, double y, double z, double distance, double fovy);

/* Builds a picture, and draws all of the frame's list. */
void view_case_draw(Frame *frame, const FlatTexture *flat, const VoxelView *view);

/* A pixel of the target of a pass. */
void view_case_pixel(const Frame *frame, const char *pass, int x, int y, float rgba[4]);

#endif
