/* Volumes as rays read them: flat textures of samples and of bricks. */
#ifndef APPS_VOLUMES_DRAWING_RAYCAST_VOLUME_H
#define APPS_VOLUMES_DRAWING_RAYCAST_VOLUME_H

#include "apps/frame/atlas.h"
#include "apps/volumes/bricks.h"
#include "apps/volumes/transfer.h"

/* A field, and a transfer function, as rays read them. A zeroed one is empty. Owned by whoever made
 * it, until raycast_close; what frames refer to stays while they are run. */
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
 * errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED: more samples than a flat texture has room for, some
 *        200 million */
GpResult raycast_open(const Field *field, RaycastVolume *volume, GpError *error);
void raycast_close(RaycastVolume *volume);

/* Takes a transfer function, the first or another. Frames that were made before are to be made
 * anew. */
void raycast_classify(RaycastVolume *volume, const Transfer *transfer);

/* Fills in runs that are not there yet, of the ways that bits stand for. errors GP_ERROR_MEMORY */
GpResult raycast_find_runs(RaycastVolume *volume, unsigned ways, GpError *error);

#endif
