/* A mesh as convex pieces: sets of faces that any line crosses at most twice.
 *
 * source paper 002 (Xie and Wang, "Rendering with multiple fragments on GPU by reading data once"),
 *        section 3.1: from a seed face grow over neighbours, leave out what lies in front of a
 *        member's plane, until every face has a piece
 * DEVIATES: the seed grows outward and, turned over, inward, and the larger piece is kept: dents
 *        are convex from behind, and become one piece instead of one for each of their faces. As
 *        printed with `outward`. */
#ifndef APPS_FRAGMENTS_PIECES_PIECES_H
#define APPS_FRAGMENTS_PIECES_PIECES_H

#include "pipeline/base/base.h"

/* All zero: exact, both ways, not merged. */
typedef struct PiecesSetting {
    /* by how much of the longest side of the mesh's box a corner may be in front of a plane. Above
     * 0 pieces may be concave, and pictures wrong */
    double tolerance;
    bool outward; /* as printed: no piece is turned over */
    bool merge;   /* pieces that touch are joined where they are convex together */
} PiecesSetting;

/* Owns all; a zeroed one is empty. Faces of a piece are [first[p], first[p + 1]) of faces. */
typedef struct Pieces {
    uint32_t count, face_count;
    uint32_t *piece_of; /* [face_count] */
    uint32_t *first;    /* [count + 1] */
    uint32_t *faces;    /* [face_count], pieces that are near each other near each other */
    uint8_t *inward;    /* [count]: faces are turned over */
    uint32_t alone;     /* faces without area, each a piece of its own */
    uint32_t boundary_edges, non_manifold_edges, turned_edges; /* over which no piece goes on */
} Pieces;

/* Tells how far the work is, 0..1; false: stop it. */
typedef bool (*PiecesProgress)(void *context, double share);

/* Splits a mesh. The same pieces on every machine.
 * in     positions: finite; indices: [3 * face_count]; progress: NULL: nobody asks
 * errors GP_ERROR_MEMORY; GP_ERROR_INVALID: stopped */
GpResult pieces_make(const float (*positions)[3], uint32_t vertex_count, const uint32_t *indices,
                     uint32_t face_count, const PiecesSetting *setting, PiecesProgress progress,
                     void *context, Pieces *pieces, GpError *error);
void pieces_free(Pieces *pieces);

/* Makes pieces of what is known of each face and piece, copied; counts are set already.
 * in     piece_of: [face_count]; inward: [count]
 * errors GP_ERROR_MEMORY; GP_ERROR_FORMAT: a face of no piece, a piece of no face. Untouched
 *        then */
GpResult pieces_fill(Pieces *pieces, const uint32_t *piece_of, const uint8_t *inward);

/* The fewest words that say what a mesh kept pieces from: "12 boundary edges, 3 faces without
 * area"; "" of a clean one. */
void pieces_faults(const Pieces *pieces, char *text, size_t size);

#endif
