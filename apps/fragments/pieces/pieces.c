#include "apps/fragments/pieces/pieces.h"

#include "apps/base/bounds.h"
#include "apps/fragments/pieces/convex_set.h"
#include "apps/fragments/pieces/near.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { FREE = UINT32_MAX };

/* A mesh on its way to pieces. */
typedef struct Work {
    ConvexMesh mesh;
    FaceLinks links;
    ConvexSet *set;
    uint32_t *tried; /* by face: the last growth that asked for it */
    uint32_t growth;
    uint32_t *kept; /* faces of the outward growth, while the inward one is made */
    Pieces pieces;
    PiecesProgress progress;
    void *context;
} Work;

static bool tell(const Work *work, double share)
{
    return !work->progress || work->progress(work->context, share);
}

/* --- growing ---------------------------------------------------------------------------------- */

/* Grows a set from a seed over free faces. Members wait in the set itself for their neighbours'
 * turn. */
static void grow(Work *work, uint32_t seed, bool inward)
{
    const uint32_t growth = ++work->growth;
    convex_set_begin(work->set, inward);
    work->tried[seed] = growth;
    if (!convex_set_add(work->set, seed))
        return;
    for (uint32_t i = 0; i < convex_set_count(work->set); i++) {
        const uint32_t face = convex_set_faces(work->set)[i];
        for (int c = 0; c < 3; c++) {
            const uint32_t next = work->links.across[3 * (size_t)face + (size_t)c];
            if (next == NO_FACE || work->tried[next] == growth ||
                work->pieces.piece_of[next] != FREE)
                continue;
            work->tried[next] = growth; /* one that is in front of a plane remains so */
            convex_set_add(work->set, next);
        }
    }
}

static void keep(Work *work, const uint32_t *faces, uint32_t count, bool inward)
{
    Pieces *pieces = &work->pieces;
    for (uint32_t i = 0; i < count; i++)
        pieces->piece_of[faces[i]] = pieces->count;
    pieces->inward[pieces->count++] = inward;
}

static void make_piece(Work *work, uint32_t seed, bool outward_only)
{
    grow(work, seed, false);
    const uint32_t outward = convex_set_count(work->set);
    if (outward == 0)
        work->pieces.alone++;
    if (outward == 0 || outward_only) {
        keep(work, outward ? convex_set_faces(work->set) : &seed, outward ? outward : 1, false);
        return;
    }
    memcpy(work->kept, convex_set_faces(work->set), outward * sizeof *work->kept);
    grow(work, seed, true);
    const uint32_t inward = convex_set_count(work->set);
    if (inward > outward)
        keep(work, convex_set_faces(work->set), inward, true);
    else
        keep(work, work->kept, outward, false);
}

/* --- merging ---------------------------------------------------------------------------------- */

/* Adds all faces of a piece, or none. */
static bool add_piece(Work *work, uint32_t piece)
{
    const Pieces *pieces = &work->pieces;
    const uint32_t before = convex_set_count(work->set);
    for (uint32_t i = pieces->first[piece]; i < pieces->first[piece + 1]; i++)
        if (!convex_set_add(work->set, pieces->faces[i])) {
            convex_set_cut(work->set, before);
            return false;
        }
    return true;
}

/* A face alone is convex either way. */
static bool may_join(const Pieces *pieces, uint32_t piece, bool inward)
{
    return pieces->inward[piece] == inward || pieces->first[piece + 1] - pieces->first[piece] == 1;
}

/* Joins to a piece what stands at its corners and is convex with it.
 * in/out of: [count] the piece that each is part of now */
static void join_neighbours(Work *work, uint32_t piece, uint32_t *of, uint32_t *asked)
{
    const FaceLinks *links = &work->links;
    const Pieces *pieces = &work->pieces;
    convex_set_begin(work->set, pieces->inward[piece]);
    if (!add_piece(work, piece))
        return; /* without area */
    asked[piece] = piece;
    for (uint32_t i = 0; i < convex_set_count(work->set); i++)
        for (int c = 0; c < 3; c++) {
            const uint32_t face = convex_set_faces(work->set)[i];
            const uint32_t place = links->places[3 * (size_t)face + (size_t)c];
            for (uint32_t k = links->first[place]; k < links->first[place + 1]; k++) {
                const uint32_t other = pieces->piece_of[links->faces[k]];
                if (asked[other] == piece || of[other] != other || other < piece ||
                    !may_join(pieces, other, pieces->inward[piece]))
                    continue;
                asked[other] = piece;
                if (add_piece(work, other))
                    of[other] = piece;
            }
        }
}

/* Puts faces into the order of their pieces. */
static GpResult list_faces(Pieces *pieces)
{
    uint32_t *next = gp_alloc((size_t)pieces->count + 2, sizeof *next);
    if (!next)
        return GP_ERROR_MEMORY;
    for (uint32_t f = 0; f < pieces->face_count; f++)
        next[pieces->piece_of[f] + 1]++;
    for (uint32_t p = 0; p < pieces->count; p++)
        next[p + 1] += next[p];
    memcpy(pieces->first, next, ((size_t)pieces->count + 1) * sizeof *next);
    for (uint32_t f = 0; f < pieces->face_count; f++)
        pieces->faces[next[pieces->piece_of[f]]++] = f;
    gp_free(next);
    return GP_OK;
}

static GpResult merge(Work *work, GpError *error)
{
    Pieces *pieces = &work->pieces;
    const uint32_t count = pieces->count;
    uint32_t *of = gp_alloc(count, sizeof *of), *asked = gp_alloc(count, sizeof *asked), left = 0;
    bool done = of && asked && !list_faces(pieces);
    for (uint32_t p = 0; p < count && done; p++) {
        of[p] = p;
        asked[p] = FREE;
    }
    for (uint32_t p = 0; p < count && done; p++)
        if (of[p] == p) {
            join_neighbours(work, p, of, asked);
            done = p % 256 != 0 || tell(work, 0.5 + 0.5 * p / count);
        }
    for (uint32_t p = 0; p < count && done; p++) /* a piece has a lower number than what joins it */
        if (of[p] == p) {
            pieces->inward[left] = pieces->inward[p];
            asked[p] = left++;
        }
    for (uint32_t f = 0; f < pieces->face_count && done; f++)
        pieces->piece_of[f] = asked[of[pieces->piece_of[f]]];
    const bool stopped = of && asked && !done;
    if (done)
        pieces->count = left;
    gp_free(of);
    gp_free(asked);
    return done ? GP_OK
                : gp_fail(error, stopped ? GP_ERROR_INVALID : GP_ERROR_MEMORY, "%s",
                          stopped ? "stopped" : "out of memory");
}

/* --- the whole -------------------------------------------------------------------------------- */

static bool alloc_pieces(Pieces *pieces)
{
    const size_t faces = pieces->face_count;
    pieces->piece_of = gp_alloc(faces, sizeof *pieces->piece_of);
    pieces->first = gp_alloc(faces + 1, sizeof *pieces->first);
    pieces->faces = gp_alloc(faces, sizeof *pieces->faces);
    pieces->inward = gp_alloc(faces, sizeof *pieces->inward);
    return pieces->piece_of && pieces->first && pieces->faces && pieces->inward;
}

static bool alloc_work(Work *work, uint32_t faces)
{
    work->set = convex_set_create(&work->mesh);
    work->tried = gp_alloc(faces, sizeof *work->tried);
    work->kept = gp_alloc(faces, sizeof *work->kept);
    work->pieces.face_count = faces;
    work->pieces.boundary_edges = work->links.boundary_edges;
    work->pieces.non_manifold_edges = work->links.non_manifold_edges;
    work->pieces.turned_edges = work->links.turned_edges;
    return alloc_pieces(&work->pieces) && work->set && work->tried && work->kept;
}

static GpResult split(Work *work, const PiecesSetting *setting, GpError *error)
{
    const uint32_t faces = work->links.face_count;
    if (!alloc_work(work, faces))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (uint32_t f = 0; f < faces; f++)
        work->pieces.piece_of[f] = FREE;
    for (uint32_t f = 0; f < faces; f++) {
        if (f % 256 == 0 && !tell(work, (setting->merge ? 0.5 : 1) * f / faces))
            return gp_fail(error, GP_ERROR_INVALID, "stopped");
        if (work->pieces.piece_of[f] == FREE)
            make_piece(work, f, setting->outward);
    }
    const GpResult result = setting->merge ? merge(work, error) : GP_OK;
    if (result)
        return result;
    if (pieces_put_near(&work->mesh, work->pieces.piece_of, work->pieces.inward,
                        work->pieces.count) ||
        list_faces(&work->pieces))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    return GP_OK;
}

GpResult pieces_make(const float (*positions)[3], uint32_t vertex_count, const uint32_t *indices,
                     uint32_t face_count, const PiecesSetting *setting, PiecesProgress progress,
                     void *context, Pieces *pieces, GpError *error)
{
    Work work = { .mesh = { .positions = positions, .indices = indices },
                  .progress = progress,
                  .context = context };
    const Bounds bounds = bounds_of(&positions[0][0], 3 * sizeof(float), indices, 3 * face_count);
    for (int k = 0; k < 3; k++)
        work.mesh.extent = fmax(work.mesh.extent, fmax(fabs(bounds.low[k]), fabs(bounds.high[k])));
    work.mesh.tolerance = setting->tolerance * bounds_longest(&bounds);
    work.mesh.links = &work.links;
    GpResult result = links_make(positions, vertex_count, indices, face_count, &work.links, error);
    if (!result)
        result = split(&work, setting, error);
    convex_set_destroy(work.set);
    links_free(&work.links);
    gp_free(work.tried);
    gp_free(work.kept);
    if (result)
        pieces_free(&work.pieces);
    else
        *pieces = work.pieces;
    return result;
}

static bool is_filled(const Pieces *pieces)
{
    for (uint32_t p = 0; p < pieces->count; p++)
        if (pieces->first[p] == pieces->first[p + 1] || pieces->inward[p] > 1)
            return false;
    return true;
}

GpResult pieces_fill(Pieces *pieces, const uint32_t *piece_of, const uint8_t *inward)
{
    Pieces made = *pieces;
    bool fits = made.count <= made.face_count;
    for (uint32_t f = 0; f < made.face_count && fits; f++)
        fits = piece_of[f] < made.count;
    if (!fits)
        return GP_ERROR_FORMAT;
    GpResult result = alloc_pieces(&made) ? GP_OK : GP_ERROR_MEMORY;
    if (!result) {
        memcpy(made.piece_of, piece_of, made.face_count * sizeof *piece_of);
        memcpy(made.inward, inward, made.count);
        result = list_faces(&made);
    }
    if (!result && !is_filled(&made))
        result = GP_ERROR_FORMAT;
    if (result)
        pieces_free(&made);
    else
        *pieces = made;
    return result;
}

void pieces_free(Pieces *pieces)
{
    gp_free(pieces->piece_of);
    gp_free(pieces->first);
    gp_free(pieces->faces);
    gp_free(pieces->inward);
    *pieces = (Pieces){ .count = 0 };
}

void pieces_faults(const Pieces *pieces, char *text, size_t size)
{
    const struct {
        uint32_t count;
        const char *one, *many;
    } faults[] = {
        { pieces->boundary_edges, "boundary edge", "boundary edges" },
        { pieces->non_manifold_edges, "non-manifold edge", "non-manifold edges" },
        { pieces->turned_edges, "edge at which a face is turned over",
          "edges at which faces are turned over" },
        { pieces->alone, "face without area", "faces without area" },
    };
    size_t used = 0;
    text[0] = 0;
    for (size_t i = 0; i < GP_COUNT(faults); i++)
        if (faults[i].count > 0 && used < size)
            used += (size_t)snprintf(text + used, size - used, "%s%u %s", used ? ", " : "",
                                     faults[i].count,
                                     faults[i].count == 1 ? faults[i].one : faults[i].many);
}
