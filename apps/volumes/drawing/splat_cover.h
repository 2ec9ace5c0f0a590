/* Which parts of a picture a volume's sheets cover: composited is only where something is. */
#ifndef APPS_VOLUMES_DRAWING_SPLAT_COVER_H
#define APPS_VOLUMES_DRAWING_SPLAT_COVER_H

#include "apps/frame/frame.h"
#include "apps/volumes/drawing/splat_eye.h"
#include "apps/volumes/voxels.h"

enum { COVER_CELL = 32 }; /* pixels */

/* Cells of a picture. A zeroed one is empty. */
typedef struct SplatCover {
    uint32_t width, height; /* in cells */
    uint8_t *covered;       /* [height][width]: 1; 2 while it is drawn */
} SplatCover;

/* Belongs to the frame; without memory, all is covered. */
SplatCover splat_cover_make(const VolumeView *view, Frame *frame);

/* Adds what the footprints of a slice reach, of those cells that have values which are shown.
 * in  shown: number of values shown below each, FIELD_VALUES + 1 of them */
void splat_cover_slice(const VoxelEye *eye, const VoxelOrder *order, uint32_t slice,
                       const uint16_t shown[FIELD_VALUES + 1], const Field *field,
                       SplatCover *cover);

/* Adds what the footprints of a rectangle of a slice reach, by its corners in samples. */
void splat_cover_rectangle(const VoxelEye *eye, const VoxelOrder *order, const double low[3],
                           const double high[3], SplatCover *cover);

/* Adds what a footprint reaches. in pixel, reach: as voxel_eye_pixel gives them */
void splat_cover_pixel(const double pixel[2], double reach, SplatCover *cover);

/* Adds what another one covers, of the same picture. */
void splat_cover_add(const SplatCover *more, SplatCover *cover);

/* Draws a triangle over all that is covered, a draw for each rectangle of cells. */
void splat_cover_draw(const SplatCover *cover, const VolumeView *view, const GpProgram *program,
                      const void *uniforms, const GpTexture *textures, uint32_t texture_count,
                      const GpState *state, Frame *frame);

void splat_cover_clear(SplatCover *cover);

#endif
