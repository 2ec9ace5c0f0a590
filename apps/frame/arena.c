#include "apps/frame/arena.h"

enum { CHUNK_BYTES = 1 << 16, ALIGNMENT = 64 };

typedef struct ArenaChunk {
    struct ArenaChunk *next;
    size_t used, size; /* with this header */
} ArenaChunk;

/* What was made elsewhere. */
typedef struct ArenaOwned {
    struct ArenaOwned *next;
    void *thing;
} ArenaOwned;

static void *fail(Arena *arena, GpResult result, const char *reason)
{
    if (!arena->result)
        arena->result = gp_fail(&arena->error, result, "%s", reason);
    return NULL;
}

void arena_fail(Arena *arena)
{
    fail(arena, GP_ERROR_MEMORY, "out of memory");
}

/* Large blocks are chunks of their own, behind the one that small blocks are cut from. */
static ArenaChunk *add_chunk(Arena *arena, size_t bytes)
{
    const size_t size = ALIGNMENT + (bytes < CHUNK_BYTES ? CHUNK_BYTES : bytes);
    ArenaChunk *chunk = gp_alloc(1, size);
    if (!chunk)
        return fail(arena, GP_ERROR_MEMORY, "out of memory");
    ArenaChunk **link =
        arena->chunks && bytes >= CHUNK_BYTES ? &arena->chunks->next : &arena->chunks;
    *chunk = (ArenaChunk){ *link, ALIGNMENT, size };
    *link = chunk;
    return chunk;
}

void *arena_alloc(Arena *arena, size_t count, size_t size)
{
    const bool too_many = size > 0 && count > SIZE_MAX / 2 / size;
    if (too_many || ++arena->calls == arena->fails)
        return fail(arena, GP_ERROR_MEMORY, "out of memory");
    if (arena->result)
        return NULL;
    const size_t bytes = (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    ArenaChunk *chunk = arena->chunks;
    if (!chunk || chunk->size - chunk->used < bytes)
        chunk = add_chunk(arena, bytes);
    if (!chunk)
        return NULL;
    chunk->used += bytes;
    return (char *)chunk + chunk->used - bytes;
}

static bool own(Arena *arena, void *thing, ArenaOwned **list)
{
    ArenaOwned *owned = arena_alloc(arena, 1, sizeof *owned);
    if (!owned)
        return false;
    *owned = (ArenaOwned){ *list, thing };
    *list = owned;
    return true;
}

void *arena_own(Arena *arena, void *memory)
{
    if (!memory || own(arena, memory, &arena->blocks))
        return memory;
    gp_free(memory);
    return NULL;
}

GpSurface *arena_own_surface(Arena *arena, GpSurface *surface)
{
    if (!own(arena, surface, &arena->surfaces))
        gp_surface_destroy(&surface);
    return surface;
}

GpSurface *arena_surface(Arena *arena, const GpSurfaceDesc *desc)
{
    GpSurface *surface;
    GpError error = { "" };
    GpResult result = arena->result ? arena->result : gp_surface_create(desc, &surface, &error);
    return result ? fail(arena, result, error.text) : arena_own_surface(arena, surface);
}

GpResult arena_result(const Arena *arena, GpError *error)
{
    return arena->result ? gp_fail(error, arena->result, "%s", arena->error.text) : GP_OK;
}

void arena_free(Arena *arena)
{
    for (ArenaOwned *owned = arena->surfaces; owned; owned = owned->next)
        gp_surface_destroy(&(GpSurface *){ owned->thing });
    for (ArenaOwned *owned = arena->blocks; owned; owned = owned->next)
        gp_free(owned->thing);
    while (arena->chunks) {
        ArenaChunk *chunk = arena->chunks;
        arena->chunks = chunk->next;
        gp_free(chunk);
    }
    *arena = (Arena){ .result = GP_OK };
}
