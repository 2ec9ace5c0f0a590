/* Volumes by rays: passes of the programs shaders_c/volume/raycast.h, and what is seen through
 * them. */
#ifndef APPS_VOLUMES_DRAWING_RAYCAST_H
#define APPS_VOLUMES_DRAWING_RAYCAST_H

#include "apps/volumes/drawing/raycast_volume.h"
#include "apps/volumes/drawing/view.h"

/* All zero: as they are meant. */
typedef struct RaycastSetting {
    double step;      /* length of a step, in the field's space; 0: 1 */
    double least;     /* share of light at which a ray ends; 0: 1/256 */
    const char *name; /* of the pass, borrowed; NULL: "raycast" */
} RaycastSetting;

/* Appends a pass that draws the volume over what the target holds.
 * in   volume: classified; what the frame's ways ask for is added to it
 * errors GP_ERROR_MEMORY */
GpResult raycast_add(RaycastVolume *volume, const VolumeView *view, const RaycastSetting *setting,
                     const VolumeTarget *target, Frame *frame, GpError *error);

/* Whether the volume is before any of a body, on the same pixels. in: the body's corners, in the
 * field's space */
bool raycast_is_before(const RaycastVolume *volume, const VolumeView *view, double body[8][3]);

/* Makes a draw of phong_program one of what is seen through the volume, which the target holds
 * already (shaders_c/volume/through.h).
 * in   to_field: row i takes the world to axis i of the field's space
 * errors GP_ERROR_MEMORY */
GpResult raycast_see_through(RaycastVolume *volume, const VolumeView *view,
                             const RaycastSetting *setting, double to_field[3][4], GpDraw *draw,
                             Frame *frame, GpError *error);

#endif
