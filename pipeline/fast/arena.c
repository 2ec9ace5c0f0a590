#include "pipeline/fast/arena.h"

enum { HEADER = 64, SMALLEST = 1 << 16 };

typedef struct FastArenaBlock {
    struct FastArenaBlock *next;
    size_t size; /* bytes after the header */
} FastArenaBlock;

static bool add_block(FastArena *arena, size_t size)
{
    FastArenaBlock *block = gp_alloc_unset(HEADER + size);
    if (!block)
        return false;
    *block = (FastArenaBlock){ arena->blocks, size };
    arena->blocks = block;
    arena->used = 0;
    arena->size = size;
    return true;
}

void *fast_arena_take(FastArena *arena, size_t bytes)
{
    if (bytes > SIZE_MAX / 4)
        return NULL;
    size_t rounded = (bytes + 63) & ~(size_t)63;
    if (arena->size - arena->used < rounded) {
        size_t size = 2 * arena->size;
        size = size < SMALLEST ? SMALLEST : size;
        if (!add_block(arena, size < rounded ? rounded : size))
            return NULL;
    }
    char *memory = (char *)arena->blocks + HEADER + arena->used;
    arena->used += rounded;
    arena->taken += rounded;
    return memory;
}

void fast_arena_free(FastArena *arena)
{
    while (arena->blocks) {
        FastArenaBlock *next = arena->blocks->next;
        gp_free(arena->blocks);
        arena->blocks = next;
    }
    *arena = (FastArena){ 0 };
}

void fast_arena_reset(FastArena *arena)
{
    arena->used = arena->taken = 0;
    if (!arena->blocks || !arena->blocks->next)
        return;
    size_t total = 0;
    for (FastArenaBlock *block = arena->blocks; block; block = block->next)
        total += block->size;
    fast_arena_free(arena);
    add_block(arena, total); /* where this fails, the next take tries again */
}
