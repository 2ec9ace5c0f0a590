/* Volumes by rays: passes of the program shaders_c/volume/raycast.h. */
#ifndef APPS_VOLUMES_DRAWING_RAYCAST_H
#define APPS_VOLUMES_DRAWING_RAYCAST_H

#include "apps/frame/atlas.h"
#include "apps/volumes/bricks.h"
#include "apps/volumes/drawing/view.h"

/* All zero: as they are meant. */
typedef struct RaycastSetting {
    double step;      /* length of a step, in the field's space; 0: 1 */
    double least;     /* share of light at which a ray ends; 0: 1/256 */
    const char *name; /* of the pass, borrowed; NULL: "raycast" */
} RaycastSetting;

/* A field, and a transfer function, as rays read them. A zeroed one is empty. Owned by whoever made it,
 * until raycast_close; what frames refer to stays while they are run. */
typedef struct RaycastVolume {
    const Field *field; /* borrowed */
    Transfer transfer;
    Bricks bricks;
    uint8_t *shown; /* of the bricks */
    VolumeAtlas atlas;
    GpSurface *runs;
    uint32_t columns; /* of patches in its rows */
    unsigned known;   /* bit i: runs of way i are there */
} RaycastVolume;

/* Makes what stays the same from frame to frame. The transfer function is yet to come.
 * errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: more samples than a flat texture has room for, some 200
 *        million */
GpResult raycast_open(const Field *field, RaycastVolume *volume, GpError *error);
void raycast_close(RaycastVolume *volume);

/* Takes a transfer function, the first or another. Frames that were made before are to be made anew. */
void raycast_classify(RaycastVolume *volume, const Transfer *transfer);

/* Appends a pass that draws the volume over what the target holds.
 * in   volume: classified; what the frame's ways ask for is added to it
 * errors GP_ERROR_MEMORY */
GpResult raycast_add(RaycastVolume *volume, const VolumeView *view, const RaycastSetting *setting,
                     const VolumeTarget *target, Frame *frame, GpError *error);

#endif
