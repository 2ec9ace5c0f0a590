#include "apps/fragments/pieces/pieces_cache.h"

#include "apps/base/content.h"
#include "pipeline/io/file.h"

#include <string.h>

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "caches are little-endian");

enum { VERSION = 2 /* one more whenever other pieces are made, or they are kept otherwise */ };

static const char magic[8] = { 'g', 'p', 'p', 'i', 'e', 'c', 'e', 's' };

typedef struct Head {
    char magic[8];
    uint64_t version;
    uint64_t key;
    uint64_t hash; /* of the head with 0 here, then of all behind it */
    uint32_t face_count, count, alone;
    uint32_t boundary_edges, non_manifold_edges, turned_edges;
    uint64_t block_size;
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
    return sizeof *head + (size_t)head->face_count * sizeof(uint32_t) + head->count +
           (size_t)head->block_size;
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
    if (head->block_size > file->size || file->size != size_of(head) ||
        hash_all(head, file->data) != head->hash)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%s: damaged: its content does not have the hash that it says", path);
    return GP_OK;
}

/* Those behind a head that is right. */
static GpResult read_parts(const char *path, const GpFile *file, const Head *of_file,
                           Pieces *pieces, PiecesBlock *block, GpError *error)
{
    const Head head = *of_file;
    const char *of = file->data + sizeof head, *end = file->data + file->size;
    PiecesBlock kept = { NULL, (size_t)head.block_size };
    Pieces read = { .count = head.count,
                    .face_count = head.face_count,
                    .alone = head.alone,
                    .boundary_edges = head.boundary_edges,
                    .non_manifold_edges = head.non_manifold_edges,
                    .turned_edges = head.turned_edges };
    kept.bytes = kept.size ? gp_alloc_unset(kept.size) : NULL;
    if (kept.size && !kept.bytes)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    if (kept.size)
        memcpy(kept.bytes, end - kept.size, kept.size);
    const GpResult result =
        pieces_fill(&read, (const uint32_t *)(const void *)of,
                    (const uint8_t *)of + (size_t)head.face_count * sizeof(uint32_t));
    if (result) {
        gp_free(kept.bytes);
        return result == GP_ERROR_MEMORY
                   ? gp_fail(error, result, "out of memory")
                   : gp_fail(error, result, "%s: damaged: its parts do not fit together", path);
    }
    *pieces = read;
    *block = kept;
    return GP_OK;
}

GpResult pieces_read(const char *path, uint64_t key, Pieces *pieces, PiecesBlock *block,
                     GpError *error)
{
    GpFile file = { NULL, 0 };
    Head head;
    GpResult result = gp_file_read(path, &file, error);
    if (!result)
        result = check_head(path, &file, key, &head, error);
    if (!result)
        result = read_parts(path, &file, &head, pieces, block, error);
    gp_file_free(&file);
    return result;
}
GpResult pieces_write(const char *path, uint64_t key, const Pieces *pieces,
                      const PiecesBlock *block, GpError *error)
{
    Head head = { .version = VERSION,
                  .key = key,
                  .face_count = pieces->face_count,
                  .count = pieces->count,
                  .alone = pieces->alone,
                  .boundary_edges = pieces->boundary_edges,
                  .non_manifold_edges = pieces->non_manifold_edges,
                  .turned_edges = pieces->turned_edges,
                  .block_size = block ? block->size : 0 };
    memcpy(head.magic, magic, sizeof magic);
    const size_t faces = (size_t)pieces->face_count * sizeof(uint32_t);
    char *file = gp_alloc(size_of(&head), 1);
    if (!file)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for %zu bytes", path, size_of(&head));
    memcpy(file + sizeof head, pieces->piece_of, faces);
    memcpy(file + sizeof head + faces, pieces->inward, pieces->count);
    if (head.block_size)
        memcpy(file + size_of(&head) - head.block_size, block->bytes, block->size);
    head.hash = hash_all(&head, file);
    memcpy(file, &head, sizeof head);
    const GpResult result = gp_file_write(path, file, size_of(&head), error);
    gp_free(file);
    return result;
}
