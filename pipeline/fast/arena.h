/* Memory that is taken piece by piece and given back all at once, and kept for the next frame. */
#ifndef GP_FAST_ARENA_H
#define GP_FAST_ARENA_H

#include "pipeline/base/base.h"

typedef struct FastArena {
    struct FastArenaBlock *blocks; /* the newest first; only that one has room */
    size_t used, size;             /* of the newest, in bytes */
    size_t taken;                  /* in all since the last reset */
} FastArena;

/* `bytes` of memory, aligned to 64, with whatever it held before; NULL when memory is short. */
void *fast_arena_take(FastArena *arena, size_t bytes);

/* Makes all of it free again, as one block, so that the next frame takes the same path with one
 * allocation at most. */
void fast_arena_reset(FastArena *arena);
void fast_arena_free(FastArena *arena);

#endif
