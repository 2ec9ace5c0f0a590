/* Sheets: passes into which splats are added up, and passes that put them under each other. */
#ifndef APPS_VOLUMES_DRAWING_SPLAT_SHEETS_H
#define APPS_VOLUMES_DRAWING_SPLAT_SHEETS_H

#include "apps/volumes/drawing/splat.h"
#include "apps/volumes/drawing/splat_cover.h"
#include "shaders_c/volume/sheet.h"

/* Passes of a frame that draw one volume. All that they refer to is the frame's. */
typedef struct Sheets {
    const VolumeSplats *splats;
    const VolumeView *view;
    const VolumeSplatSetting *setting;
    VoxelEye eye;
    const VoxelOrder *order;       /* along the axis nearest to the view */
    const VoxelUniforms *uniforms; /* NULL without memory */
    GpSurface *look; /* of the 256 values: colour, and extinction, or opacity as printed */
    /* the target, and what hides: its depth, or that and what is opaque; or NULL */
    GpSurface *color;
    GpSurface *depth;
    GpFormat format;
    GpSurface *sheet[SHEETS_AT_ONCE], *sum;
    uint16_t shown[FIELD_VALUES + 1]; /* values shown below each */
    Frame *frame;

    /* private */
    SplatCover cover;
    uint32_t filled; /* sheets that wait to be put under the sum, */
    uint32_t sheets; /* and all */
    uint32_t marked; /* of these when opaque pixels were marked last */
    bool begun;      /* the sum has some */
} Sheets;

Sheets sheets_make(const VolumeSplats *splats, const VolumeView *view,
                   const VolumeSplatSetting *setting, const VolumeTarget *target, Frame *frame);

/* Slices from the front: number i of them. */
uint32_t sheets_slice(const Sheets *sheets, uint32_t i);

/* Extinction of a slab one unit thick that has this opacity. */
float sheets_extinction(double opacity);

/* Begins the next sheet, front to back: draws then go to it. The other: in a surface of the
 * caller's choice, which puts it under the sum. */
void sheets_begin(Sheets *sheets);
void sheets_begin_in(Sheets *sheets, uint32_t surface);

/* Says where splats of the present sheet are: those of a slice, or in these cells. */
void sheets_cover_slice(Sheets *sheets, uint32_t slice);
void sheets_cover(Sheets *sheets, const SplatCover *cover);

/* A draw that adds to a sheet, and is hidden by what hides. */
void sheets_set_state(const Sheets *sheets, GpDraw *draw);

/* Puts what a program makes of sheets under the sum, where they cover the picture; then marks what
 * is opaque, where that is due. */
void sheets_under(Sheets *sheets, const GpProgram *program, const void *uniforms,
                  const GpTexture *textures, uint32_t texture_count);

/* Ends a sheet, and the last one: puts the sum over the target. */
void sheets_end(Sheets *sheets);
void sheets_finish(Sheets *sheets);

#endif
