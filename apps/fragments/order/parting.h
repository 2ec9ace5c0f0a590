/* What parts two convex pieces whose boxes reach into each other, whatever the view: made once for
 * a mesh.
 *
 * A plane parts them, or the one is nested in the other: then the order of all of them follows from
 * the side that the eye is on. Where neither is so, a slab does: two parallel planes, between which
 * faces of both leave their pieces, so that what is left is parted. A slab has two convex pieces'
 * faces, and so no more than 4 layers.
 *
 * source paper 002, sections 3.2.1 and 3.2.2
 * DEVIATES: faces that reach into a slab leave whole; cut at its planes their corners would be
 *        rounded anew, and gaps be seen. A face leaves its piece once, to the first slab that it
 *        reaches into */
#ifndef APPS_FRAGMENTS_ORDER_PARTING_H
#define APPS_FRAGMENTS_ORDER_PARTING_H

#include "apps/fragments/order/order_mesh.h"
#include "apps/fragments/pieces/pieces_cache.h"

enum { NO_SLAB = UINT32_MAX };

typedef enum PartingKind { PARTING_PLANE, PARTING_SLAB, PARTING_NESTED } PartingKind;

typedef struct Parting {
    /* pieces: behind the plane, and in front of it; of nested ones the outer, the inner */
    uint32_t low, high;
    uint32_t kind;
    uint32_t slab;   /* its number, or NO_SLAB */
    double plane[4]; /* normal, unit length, and distance; of a slab that in its middle */
} Parting;

/* Owns all; a zeroed one is empty. */
typedef struct Partings {
    Parting *list; /* by the lesser of their pieces, then by the greater */
    uint32_t count, slab_count, piece_count, face_count;
    uint32_t *first;      /* [piece_count + 1] of each lesser piece in list */
    uint32_t *slab_of;    /* [face_count] the slab that a face has left to, or NO_SLAB */
    uint32_t *slab_first; /* [piece_count + 1] of each piece in slabs */
    uint32_t *slabs;      /* places in list of the slabs of each piece */
} Partings;

/* in     progress: NULL: nobody asks. errors GP_ERROR_MEMORY; GP_ERROR_INVALID: stopped */
GpResult partings_make(const OrderMesh *mesh, PiecesProgress progress, void *context,
                       Partings *partings, GpError *error);
void partings_free(Partings *partings);

/* All of them as bytes, to be kept with their pieces, and back.
 * errors GP_ERROR_MEMORY; unpack also GP_ERROR_FORMAT: they are not of such pieces */
GpResult partings_pack(const Partings *partings, PiecesBlock *block);
GpResult partings_unpack(const PiecesBlock *block, const Pieces *pieces, Partings *partings);

/* That of two pieces; NULL: their boxes are apart. */
const Parting *parting_of(const Partings *partings, uint32_t one, uint32_t other);

#endif
