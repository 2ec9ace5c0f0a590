/* Faces that lie on one convex body: none has a corner in front of another's plane.
 *
 * Any line crosses such faces at most twice, once going in and once coming out. The body need not
 * be closed, and its faces need not hang together. Faces may all be turned over: then the body is
 * the other side of a dent. */
#ifndef APPS_FRAGMENTS_PIECES_CONVEX_SET_H
#define APPS_FRAGMENTS_PIECES_CONVEX_SET_H

#include "apps/fragments/pieces/links.h"

/* What is the same for all sets of a mesh. Borrowed. */
typedef struct ConvexMesh {
    const float (*positions)[3];
    const uint32_t *indices;
    const FaceLinks *links;
    double extent;    /* the largest coordinate's absolute value */
    double tolerance; /* distance by which a corner may be in front of a plane; 0: exactly none */
} ConvexMesh;

typedef struct ConvexSet ConvexSet;

/* An empty set. NULL: out of memory. */
ConvexSet *convex_set_create(const ConvexMesh *mesh);
void convex_set_destroy(ConvexSet *set); /* NULL-safe */

/* Empties it; inward: faces count as turned over. */
void convex_set_begin(ConvexSet *set, bool inward);

/* Adds a face if the set stays convex with it. Faces without area never do.
 * order  the answer depends on which faces are there, not on their order
 * source exact with tolerance 0 (side.h); faces in one plane must not lie on each other either */
bool convex_set_add(ConvexSet *set, uint32_t face);

/* Leaves out the faces that were added after the first `count`. */
void convex_set_cut(ConvexSet *set, uint32_t count);

uint32_t convex_set_count(const ConvexSet *set);
const uint32_t *convex_set_faces(const ConvexSet *set);

#endif
