/* Surfels in 8 bytes, in the printed form and in a better one: shaders_c/points/compressed_shared.h
 * has the bits, and takes them apart in the vertex shader.
 *
 * A surfel is off from what it was by at most (of a patch's box with sides a, b, c and radii from r
 * to R; all of it but for roundings of floats):
 *
 *             printed                                   ours
 *   place     a/4096, b/4096, c/2048 along the world's  a/4094, b/4094, c/2046 along the box's
 *             axes: the box is the world's              own axes: c is the thickness of the piece
 *                                                       of surface
 *   normal    0.787 degrees                             0.32 degrees
 *   radius    half the way to the next of 256 clusters  a factor of (R/r)^(1/254)
 *   share     1/30 of the span in the patch             1/254
 *
 * A model keeps 8 bytes for each of its surfels and at most a third more for parents, and about 300
 * for each patch: less than 11 bytes a point in patches of 2048; with colours 3 bytes more for each
 * surfel, 4 a point.
 */
#ifndef APPS_POINTS_COMPRESS_H
#define APPS_POINTS_COMPRESS_H

#include "apps/points/patches.h"
#include "shaders_c/points/compressed.h"

typedef enum CompressForm { COMPRESS_OURS = 0, COMPRESS_PRINTED, COMPRESS_FORMS } CompressForm;

enum { COMPRESSED_BYTES = 8 };

typedef struct Compressed {
    CompressForm form;
    uint32_t surfel_count;
    uint8_t *words;                /* [surfel_count][8], as shaders take them */
    uint8_t *colors;               /* [surfel_count][3]; NULL: all are white */
    CompressedFrame *frames;       /* one a patch */
    float radii[COMPRESSED_RADII]; /* of the printed form, rising */
} Compressed;

/* Compresses all surfels of patches.
 * out    compressed; free with compressed_free
 * order  the same bits for any number of threads
 * errors GP_ERROR_MEMORY */
GpResult patches_compress(const Patches *patches, CompressForm form, GpPool *pool,
                          Compressed *compressed);

void compressed_free(Compressed *compressed); /* zeroes; a zeroed one is fine */

/* Surfel `number`, of patch `patch`, as shaders have it, but for float roundings. */
Surfel compressed_surfel(const Compressed *compressed, uint32_t patch, uint32_t number);

/* Which of the printed forms of a tangent is the longest for a normal. */
int tangent_form(const float normal[3]);

/* Bytes that a model takes so: patches without surfels, words, colours, frames and table. */
size_t compressed_bytes(const Patches *patches, const Compressed *compressed);

#endif
