/* How the faces of a mesh hang together: which stand at each place, and which lies across each
 * edge.
 *
 * Vertices at one place are one. A link is an edge of exactly two faces that run along it in
 * opposite ways; across other edges nobody can say which face goes on, and so there is none. Faces
 * that have not three different corners have no edges. */
#ifndef APPS_FRAGMENTS_PIECES_LINKS_H
#define APPS_FRAGMENTS_PIECES_LINKS_H

#include "pipeline/base/base.h"

enum { NO_FACE = UINT32_MAX };

/* Owns all; a zeroed one is empty. */
typedef struct FaceLinks {
    uint32_t face_count, place_count;
    uint32_t *places; /* [3 * face_count] of the corners */
    uint32_t *across; /* [3 * face_count] face across the edge from corner c to c + 1, or NO_FACE */
    uint32_t *first;  /* [place_count + 1] of each place in faces */
    uint32_t *faces;  /* [3 * face_count] that stand at each place */
    uint32_t boundary_edges;     /* of one face */
    uint32_t non_manifold_edges; /* of three or more */
    uint32_t turned_edges;       /* of two that run along it the same way */
} FaceLinks;

/* in     indices: [3 * face_count], all < vertex_count
 * errors GP_ERROR_MEMORY */
GpResult links_make(const float (*positions)[3], uint32_t vertex_count, const uint32_t *indices,
                    uint32_t face_count, FaceLinks *links, GpError *error);
void links_free(FaceLinks *links);

#endif
