#include "apps/fragments/pieces/pieces_cache.h"

#include "apps/base/content.h"
#include "pipeline/io/file.h"

#include <string.h>

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "caches are little-endian");

enum { VERSION = 1 /* one more whenever other pieces are made, or they are kept otherwise */ };

static const char magic[8] = { 'g', 'p', 'p', 'i', 'e', 'c', 'e', 's' };

typedef struct Head {
    char magic[8];
    uint64_t version;
    uint64_t key;
    uint64_t hash; /* of the head with 0 here, then of all behind it */
    uint32_t face_count, count, alone;
    uint32_t boundary_edges, non_manifold_edges, turned_edges;
} Head;

uint64_t pieces_key(const float (*positions)[3], uint32_t vertex_count, const uint32_t *indices,
                    uint32_t face_count, const PiecesSetting *setting)
{
    const double settings[3] = { setting->tolerance, setting->outward, setting->merge };
    uint64_t key = content_hash_bytes(settings, sizeof settings, 0);
    key = content_hash_bytes(positions, vertex_count * sizeof *positions, key);
    return content_hash_bytes(indices, 3 * sizeof *indices * face_count, key);
}

static size_t size_of(const Head *head)
{
    return sizeof *head + (size_t)head->face_count * sizeof(uint32_t) + head->count;
}

static uint64_t hash_all(const Head *head, const char *file)
{
    Head zeroed = *head;
    zeroed.hash = 0;
    return content_hash_bytes(file + sizeof zeroed, size_of(head) - sizeof zeroed,
                              content_hash_bytes(&zeroed, sizeof zeroed, 0));
}

/* What the head says, before anything behind it is believed. */
static GpResult check_head(const char *path, const GpFile *file, uint64_t key, Head *head,
                           GpError *error)
{
    if (file->size < sizeof *head || memcmp(file->data, magic, sizeof magic) != 0)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: not a cache of convex pieces", path);
    memcpy(head, file->data, sizeof *head);
    if (head->version != VERSION)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: a cache of another version", path);
    if (head->key != key)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: a cache of another mesh or of other settings",
                       path);
    if (file->size != size_of(head) || hash_all(head, file->data) != head->hash)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: damaged: its content does not have the hash that it says", path);
    return GP_OK;
}

GpResult pieces_read(const char *path, uint64_t key, Pieces *pieces, GpError *error)
{
    GpFile file = { NULL, 0 };
    Head head;
    GpResult result = gp_file_read(path, &file, error);
    if (!result)
        result = check_head(path, &file, key, &head, error);
    if (!result) {
        const char *of = file.data + sizeof head;
        Pieces read = { .count = head.count,
                        .face_count = head.face_count,
                        .alone = head.alone,
                        .boundary_edges = head.boundary_edges,
                        .non_manifold_edges = head.non_manifold_edges,
                        .turned_edges = head.turned_edges };
        result = pieces_fill(&read, (const uint32_t *)(const void *)of,
                             (const uint8_t *)of + (size_t)head.face_count * sizeof(uint32_t));
        if (result == GP_ERROR_MEMORY)
            gp_fail(error, result, "out of memory");
        else if (result)
            gp_fail(error, result, "%s: damaged: its parts do not fit together", path);
        else
            *pieces = read;
    }
    gp_file_free(&file);
    return result;
}

GpResult pieces_write(const char *path, uint64_t key, const Pieces *pieces, GpError *error)
{
    Head head = { .version = VERSION,
                  .key = key,
                  .face_count = pieces->face_count,
                  .count = pieces->count,
                  .alone = pieces->alone,
                  .boundary_edges = pieces->boundary_edges,
                  .non_manifold_edges = pieces->non_manifold_edges,
                  .turned_edges = pieces->turned_edges };
    memcpy(head.magic, magic, sizeof magic);
    const size_t faces = (size_t)pieces->face_count * sizeof(uint32_t);
    char *file = gp_alloc(size_of(&head), 1);
    if (!file)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for %zu bytes", path, size_of(&head));
    memcpy(file + sizeof head, pieces->piece_of, faces);
    memcpy(file + sizeof head + faces, pieces->inward, pieces->count);
    head.hash = hash_all(&head, file);
    memcpy(file, &head, sizeof head);
    const GpResult result = gp_file_write(path, file, size_of(&head), error);
    gp_free(file);
    return result;
}
