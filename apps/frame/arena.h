/* Memory and surfaces that are made one after the other and freed together.
 *
 * There is no limit but memory. Where that runs short the failure is kept: the call that met it and
 * all later ones give NULL, and whoever made the arena asks once, at the end (arena_result).
 */
#ifndef APPS_FRAME_ARENA_H
#define APPS_FRAME_ARENA_H

#include "pipeline/resources/surface.h"

/* A zeroed one is empty. Owned by whoever made it, until arena_free. */
typedef struct Arena {
    GpResult result; /* of the first failure */
    GpError error;   /* its reason */
    uint32_t fails;  /* for tests: the call that finds no memory, counted from 1; 0: none */

    /* private */
    uint32_t calls;
    struct ArenaChunk *chunks;
    struct ArenaOwned *blocks, *surfaces;
} Arena;

/* Zeroed memory, aligned to 64 bytes. */
void *arena_alloc(Arena *arena, size_t count, size_t size);

/* Takes over memory of gp_alloc, which is freed at once where that fails; NULL is fine.
 * returns it, or NULL */
void *arena_own(Arena *arena, void *memory);

/* Makes a surface; takes one over, which is destroyed at once where that fails. */
GpSurface *arena_surface(Arena *arena, const GpSurfaceDesc *desc);
GpSurface *arena_own_surface(Arena *arena, GpSurface *surface);

/* Other memory was missing for what it was to hold: a failure as its own. */
void arena_fail(Arena *arena);

/* The first failure, or GP_OK. */
GpResult arena_result(const Arena *arena, GpError *error);

/* Frees all and zeroes it; a zeroed one is fine. */
void arena_free(Arena *arena);

#endif
