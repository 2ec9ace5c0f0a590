#include "apps/fragments/pieces/near.h"

#include "apps/base/bounds.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct Place {
    uint64_t key;
    uint32_t piece;
    uint8_t inward;
} Place;

static int compare_places(const void *a, const void *b)
{
    const Place *p = a, *q = b;
    if (p->key != q->key)
        return p->key < q->key ? -1 : 1;
    return (p->piece > q->piece) - (p->piece < q->piece);
}

/* Bits of three numbers below 2^16, in turn. */
static uint64_t mix_bits(const uint32_t number[3])
{
    uint64_t mixed = 0;
    for (int bit = 0; bit < 16; bit++)
        for (int k = 0; k < 3; k++)
            mixed |= (uint64_t)(number[k] >> bit & 1) << (3 * bit + k);
    return mixed;
}

static uint64_t key_of(const Bounds *box, const Bounds *all)
{
    const double side = bounds_longest(all);
    uint32_t at[3];
    for (int k = 0; k < 3; k++) {
        const double middle = (box->low[k] + box->high[k]) / 2 - all->low[k];
        at[k] = side > 0 ? (uint32_t)fmin(fmax(middle / side * 65535, 0), 65535) : 0;
    }
    return mix_bits(at);
}

GpResult pieces_put_near(const ConvexMesh *mesh, uint32_t *piece_of, uint8_t *inward,
                         uint32_t count)
{
    const uint32_t faces = mesh->links->face_count;
    Bounds *boxes = gp_alloc(count, sizeof *boxes), all = bounds_of_nothing;
    Place *places = gp_alloc(count, sizeof *places);
    uint32_t *number = gp_alloc(count, sizeof *number);
    const bool done = boxes && places && number;
    for (uint32_t p = 0; p < count && done; p++)
        boxes[p] = bounds_of_nothing;
    for (uint32_t i = 0; i < 3 * faces && done; i++) {
        const float *at = mesh->positions[mesh->indices[i]];
        bounds_add(&boxes[piece_of[i / 3]],
                   (double[3]){ (double)at[0], (double)at[1], (double)at[2] });
    }
    for (uint32_t p = 0; p < count && done; p++)
        bounds_join(&all, &boxes[p]);
    for (uint32_t p = 0; p < count && done; p++)
        places[p] = (Place){ key_of(&boxes[p], &all), p, inward[p] };
    if (done)
        qsort(places, count, sizeof *places, compare_places);
    for (uint32_t p = 0; p < count && done; p++) {
        number[places[p].piece] = p;
        inward[p] = places[p].inward;
    }
    for (uint32_t f = 0; f < faces && done; f++)
        piece_of[f] = number[piece_of[f]];
    gp_free(boxes);
    gp_free(places);
    gp_free(number);
    return done ? GP_OK : GP_ERROR_MEMORY;
}
