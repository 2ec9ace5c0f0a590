/* Lists that grow by one. */
#ifndef GP_GROW_H
#define GP_GROW_H

#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>

/* A list of malloc with room for one more element, which may have moved.
 * in   list: NULL where room is 0
 * returns NULL, the list stays as it is, and `failed` is set: there is no memory */
static inline void *gp_grown(void *list, int count, int *room, size_t size, bool *failed)
{
    if (count < *room)
        return list;
    const int more = *room ? 2 * *room : 64;
    void *larger = realloc(list, (size_t)more * size);
    *failed = *failed || !larger;
    *room = larger ? more : *room;
    return larger;
}

#endif
