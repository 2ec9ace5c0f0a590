/* Numbering pieces so that those near each other have near numbers. */
#ifndef APPS_FRAGMENTS_PIECES_NEAR_H
#define APPS_FRAGMENTS_PIECES_NEAR_H

#include "apps/fragments/pieces/convex_set.h"

/* Renumbers pieces along a space-filling curve through their boxes' middles.
 * in/out piece_of: [faces of the mesh]; inward: [count]
 * errors GP_ERROR_MEMORY
 * source Morton, "A computer oriented geodetic data base", 1966 */
GpResult pieces_put_near(const ConvexMesh *mesh, uint32_t *piece_of, uint8_t *inward,
                         uint32_t count);

#endif
