/* Convex pieces kept in a file, so that they are made once for a mesh.
 *
 * The file is one block, little-endian: a head, of each face its piece, of each piece whether it is
 * turned over, and what others have made of the pieces. The head says which version wrote it, of
 * what (a key), how much there is, and the hash of all.
 *
 * source ours; XXH3 for the hashes */
#ifndef APPS_FRAGMENTS_PIECES_PIECES_CACHE_H
#define APPS_FRAGMENTS_PIECES_PIECES_CACHE_H

#include "apps/fragments/pieces/pieces.h"

/* Of what pieces are made: a mesh, and how. */
uint64_t pieces_key(const float (*positions)[3], uint32_t vertex_count, const uint32_t *indices,
                    uint32_t face_count, const PiecesSetting *setting);

/* Bytes that others keep with pieces, so that they are made once too. */
typedef struct PiecesBlock {
    void *bytes; /* NULL: none */
    size_t size;
} PiecesBlock;

/* Reads pieces that were written for the same key.
 * out    pieces: free with pieces_free; block: free its bytes with gp_free; both untouched on
 *        failure
 * errors GP_ERROR_IO (no such file), GP_ERROR_MEMORY, GP_ERROR_FORMAT: they are to be made anew,
 *        and the message says why: "FILE: not a cache of convex pieces", "... of another version",
 *        "... of another mesh or other settings", "... damaged ..." */
GpResult pieces_read(const char *path, uint64_t key, Pieces *pieces, PiecesBlock *block,
                     GpError *error);

/* Writes them, beside their place and renamed. errors GP_ERROR_IO, GP_ERROR_MEMORY */
GpResult pieces_write(const char *path, uint64_t key, const Pieces *pieces,
                      const PiecesBlock *block, GpError *error);

#endif
