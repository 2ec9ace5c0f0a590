#include "apps/fragments/order/parting.h"

#include "apps/base/mesh_places.h"
#include "apps/fragments/order/part_two.h"
#include "pipeline/base/grow.h"

#include <stdlib.h>
#include <string.h>

/* Whether the boxes of two pieces are apart along an axis. */
static bool boxes_apart(const PieceSpan *one, const PieceSpan *other)
{
    for (int k = 0; k < 3; k++) /* the first axes of spans are x, y, z */
        if (one->high[k] <= other->low[k] || other->high[k] <= one->low[k])
            return true;
    return false;
}

/* --- pairs ------------------------------------------------------------------------------------ */

typedef struct Place {
    double low;
    uint32_t piece;
} Place;

typedef struct Work {
    PartWork two;
    Partings made;
    size_t room;      /* of made */
    Place *order;     /* pieces along x */
    uint32_t *active; /* those of which the sweep is in the box */
} Work;

static int compare_places(const void *a, const void *b)
{
    const Place *p = a, *q = b;
    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    return (p->piece > q->piece) - (p->piece < q->piece);
}

static bool add_parting(Work *work, const Parting *parting)
{
    Partings *made = &work->made;
    Parting *list = gp_grown(made->list, made->count, &work->room, sizeof *list, NULL);
    if (!list)
        return false;
    made->list = list;
    made->list[made->count++] = *parting;
    return true;
}

/* Faces that reach beyond a slab's planes leave to it; their number. */
static uint32_t leave_to_slab(Work *work, const Parting *parting, const Slab *slab)
{
    const OrderMesh *mesh = work->two.mesh;
    uint32_t count = 0;
    for (int side = 0; side < 2; side++) {
        const uint32_t piece = side ? parting->high : parting->low;
        for (uint32_t i = mesh->pieces->first[piece]; i < mesh->pieces->first[piece + 1]; i++) {
            const uint32_t face = mesh->pieces->faces[i];
            bool reaches = false;
            for (uint32_t c = 0; c < 3; c++) {
                const float *at = mesh->mesh->positions[mesh->mesh->indices[3 * (size_t)face + c]];
                const double along = slab->normal[0] * (double)at[0] +
                                     slab->normal[1] * (double)at[1] +
                                     slab->normal[2] * (double)at[2];
                reaches |=
                    side ? along < slab->high - mesh->doubt : along > slab->low + mesh->doubt;
            }
            if (reaches && work->made.slab_of[face] == NO_SLAB) {
                work->made.slab_of[face] = work->made.slab_count;
                count++;
            }
        }
    }
    return count;
}

static bool part_pair(Work *work, uint32_t a, uint32_t b)
{
    Parting parting;
    Slab slab;
    if (boxes_apart(&work->two.mesh->spans[a], &work->two.mesh->spans[b]))
        return true;
    part_two(&work->two, a < b ? a : b, a < b ? b : a, &parting, &slab);
    if (parting.kind == PARTING_SLAB && leave_to_slab(work, &parting, &slab) > 0)
        parting.slab = work->made.slab_count++;
    return add_parting(work, &parting);
}

/* Goes along x, with all pieces whose boxes are there. */
static GpResult part_all(Work *work, PiecesProgress progress, void *context)
{
    const OrderMesh *mesh = work->two.mesh;
    const uint32_t count = mesh->pieces->count;
    uint32_t active = 0;
    for (uint32_t p = 0; p < count; p++)
        work->order[p] = (Place){ mesh->spans[p].low[0], p };
    if (count > 0)
        qsort(work->order, count, sizeof *work->order, compare_places);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t piece = work->order[i].piece;
        uint32_t left = 0;
        for (uint32_t k = 0; k < active; k++) {
            const uint32_t other = work->active[k];
            if (mesh->spans[other].high[0] <= work->order[i].low)
                continue;
            work->active[left++] = other;
            if (!part_pair(work, piece, other))
                return GP_ERROR_MEMORY;
        }
        active = left;
        work->active[active++] = piece;
        if (i % 64 == 0 && progress && !progress(context, (double)i / count))
            return GP_ERROR_INVALID;
    }
    return GP_OK;
}

/* --- the table -------------------------------------------------------------------------------- */

static uint32_t lesser(const Parting *parting)
{
    return parting->low < parting->high ? parting->low : parting->high;
}

static uint32_t greater(const Parting *parting)
{
    return parting->low < parting->high ? parting->high : parting->low;
}

static int compare_partings(const void *a, const void *b)
{
    const Parting *p = a, *q = b;
    if (lesser(p) != lesser(q))
        return lesser(p) < lesser(q) ? -1 : 1;
    return (greater(p) > greater(q)) - (greater(p) < greater(q));
}

static bool fits(const Partings *partings)
{
    uint32_t slabs = 0;
    for (uint32_t i = 0; i < partings->count; i++) {
        const Parting *parting = &partings->list[i];
        if (parting->low == parting->high || parting->low >= partings->piece_count ||
            parting->high >= partings->piece_count || parting->kind > PARTING_NESTED ||
            (parting->slab != NO_SLAB && parting->slab >= partings->slab_count))
            return false;
        slabs += parting->slab != NO_SLAB;
    }
    if (slabs != partings->slab_count)
        return false;
    for (uint32_t f = 0; f < partings->face_count; f++)
        if (partings->slab_of[f] != NO_SLAB && partings->slab_of[f] >= partings->slab_count)
            return false;
    return true;
}

/* Makes the rest of what list, slab_of and the numbers say; frees all where that is nothing. */
static GpResult index_all(Partings *partings)
{
    const size_t pieces = partings->piece_count;
    GpResult result = GP_ERROR_FORMAT;
    if (fits(partings)) {
        partings->first = gp_alloc(pieces + 2, sizeof *partings->first);
        partings->slab_first = gp_alloc(pieces + 2, sizeof *partings->slab_first);
        partings->slabs = gp_alloc(2 * (size_t)partings->slab_count, sizeof *partings->slabs);
        result =
            partings->first && partings->slab_first && partings->slabs ? GP_OK : GP_ERROR_MEMORY;
    }
    if (result) {
        partings_free(partings);
        return result;
    }
    if (partings->count > 0)
        qsort(partings->list, partings->count, sizeof *partings->list, compare_partings);
    uint32_t *next = partings->slab_first + 1; /* counts, then where one goes, then ends */
    for (uint32_t i = 0; i < partings->count; i++) {
        const Parting *parting = &partings->list[i];
        partings->first[lesser(parting) + 1]++;
        next[parting->low + 1] += parting->slab != NO_SLAB;
        next[parting->high + 1] += parting->slab != NO_SLAB;
    }
    for (uint32_t p = 0; p < pieces; p++) {
        partings->first[p + 1] += partings->first[p];
        next[p + 1] += next[p];
    }
    for (uint32_t i = 0; i < partings->count; i++)
        if (partings->list[i].slab != NO_SLAB) {
            partings->slabs[next[partings->list[i].low]++] = i;
            partings->slabs[next[partings->list[i].high]++] = i;
        }
    return GP_OK;
}

const Parting *parting_of(const Partings *partings, uint32_t one, uint32_t other)
{
    const uint32_t least = one < other ? one : other, most = one < other ? other : one;
    uint32_t low = partings->first[least], high = partings->first[least + 1];
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        if (greater(&partings->list[middle]) < most)
            low = middle + 1;
        else
            high = middle;
    }
    return low < partings->first[least + 1] && greater(&partings->list[low]) == most
               ? &partings->list[low]
               : NULL;
}

/* --- the whole -------------------------------------------------------------------------------- */

GpResult partings_make(const OrderMesh *mesh, PiecesProgress progress, void *context,
                       Partings *partings, GpError *error)
{
    const FragmentMesh *drawn = mesh->mesh;
    uint32_t *place_of = gp_alloc(drawn->vertex_count, sizeof *place_of);
    Work work = { .two = { .mesh = mesh,
                           .place_of = place_of,
                           .mark = gp_alloc(drawn->vertex_count, sizeof *work.two.mark) },
                  .made = { .piece_count = mesh->pieces->count,
                            .face_count = drawn->triangle_count,
                            .slab_of = gp_alloc(drawn->triangle_count, sizeof(uint32_t)) },
                  .order = gp_alloc(mesh->pieces->count, sizeof *work.order),
                  .active = gp_alloc(mesh->pieces->count, sizeof *work.active) };
    GpResult result = GP_ERROR_MEMORY;
    if (place_of && work.two.mark && work.made.slab_of && work.order && work.active &&
        !mesh_places(&drawn->positions[0][0], drawn->vertex_count, place_of)) {
        for (uint32_t f = 0; f < drawn->triangle_count; f++)
            work.made.slab_of[f] = NO_SLAB;
        result = part_all(&work, progress, context);
    }
    gp_free(place_of);
    gp_free(work.two.mark);
    gp_free(work.order);
    gp_free(work.active);
    if (result)
        partings_free(&work.made);
    else
        result = index_all(&work.made);
    if (result)
        return gp_fail(error, result, "%s",
                       result == GP_ERROR_INVALID ? "stopped" : "out of memory");
    *partings = work.made;
    return GP_OK;
}

typedef struct Packed {
    uint32_t count, slab_count, piece_count, face_count;
} Packed;

GpResult partings_pack(const Partings *partings, PiecesBlock *block)
{
    const Packed packed = { partings->count, partings->slab_count, partings->piece_count,
                            partings->face_count };
    const size_t list = packed.count * sizeof(Parting),
                 slabs = packed.face_count * sizeof(uint32_t);
    char *bytes = gp_alloc_unset(sizeof packed + list + slabs);
    if (!bytes)
        return GP_ERROR_MEMORY;
    memcpy(bytes, &packed, sizeof packed);
    if (list > 0)
        memcpy(bytes + sizeof packed, partings->list, list);
    memcpy(bytes + sizeof packed + list, partings->slab_of, slabs);
    *block = (PiecesBlock){ bytes, sizeof packed + list + slabs };
    return GP_OK;
}

GpResult partings_unpack(const PiecesBlock *block, const Pieces *pieces, Partings *partings)
{
    const char *bytes = block->bytes;
    Packed packed;
    if (block->size < sizeof packed)
        return GP_ERROR_FORMAT;
    memcpy(&packed, bytes, sizeof packed);
    const size_t list = packed.count * sizeof(Parting),
                 slabs = packed.face_count * sizeof(uint32_t);
    if (packed.piece_count != pieces->count || packed.face_count != pieces->face_count ||
        block->size != sizeof packed + list + slabs)
        return GP_ERROR_FORMAT;
    Partings made = { .list = gp_alloc_unset(list),
                      .count = packed.count,
                      .slab_count = packed.slab_count,
                      .piece_count = packed.piece_count,
                      .face_count = packed.face_count,
                      .slab_of = gp_alloc_unset(slabs) };
    if (!made.list || !made.slab_of) {
        partings_free(&made);
        return GP_ERROR_MEMORY;
    }
    memcpy(made.list, bytes + sizeof packed, list);
    memcpy(made.slab_of, bytes + sizeof packed + list, slabs);
    const GpResult result = index_all(&made);
    if (!result)
        *partings = made;
    return result;
}

void partings_free(Partings *partings)
{
    gp_free(partings->list);
    gp_free(partings->first);
    gp_free(partings->slab_of);
    gp_free(partings->slab_first);
    gp_free(partings->slabs);
    *partings = (Partings){ .count = 0 };
}
