/* What is in front of what, from one view. */
#ifndef APPS_FRAGMENTS_ORDER_RELATIONS_H
#define APPS_FRAGMENTS_ORDER_RELATIONS_H

#include "apps/fragments/order/graph.h"
#include "apps/fragments/order/order_mesh.h"
#include "apps/fragments/order/screen.h"

/* Owns all. */
typedef struct Relations {
    Pairs faces;  /* of two that share pixels: the one in front, the one behind */
    Pairs pieces; /* large ones: nothing of the second is in front of anything of the first */
} Relations;

/* Finds them among faces that meet on the screen; of those of one piece, near before far. Those
 * within a large piece are left out: its near faces are in front of its far ones in any case.
 * errors GP_ERROR_MEMORY */
GpResult relations_find(const OrderMesh *mesh, const Camera *camera, const Screen *screen,
                        Relations *relations, GpError *error);
void relations_free(Relations *relations);

/* Whether a face is on the far side of its piece. */
static inline bool relations_is_far(const Pieces *pieces, const Screen *screen, uint32_t face)
{
    return screen->faces[face].is_turned != (pieces->inward[pieces->piece_of[face]] != 0);
}

#endif
