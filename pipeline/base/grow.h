/* Lists that grow by one. */
#ifndef GP_GROW_H
#define GP_GROW_H

#include "pipeline/base/base.h"

#include <string.h>

/* A list of gp_alloc, whose large blocks are of huge pages, with room for one more element, which
 * may have moved.
 * in   list: NULL where room is 0
 * out  failed: true where there is no memory, else as it was; may be NULL
 * returns NULL where there is no memory: the list stays as it is */
static inline void *gp_grown(void *list, size_t count, size_t *room, size_t size, bool *failed)
{
    if (count < *room)
        return list;
    const size_t more = *room ? 2 * *room : 64;
    void *larger = gp_alloc_unset(more * size);
    if (larger) {
        if (count)
            memcpy(larger, list, count * size);
        gp_free(list);
        *room = more;
    } else if (failed)
        *failed = true;
    return larger;
}

#endif
