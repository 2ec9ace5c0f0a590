/* Asking memory for what is wanted soon. */
#ifndef GP_PREFETCH_H
#define GP_PREFETCH_H

#include <stddef.h>
#include <stdint.h>

/* All lines of some bytes, which need not exist. */
static inline void gp_prefetch(const void *from, size_t bytes)
{
    enum { LINE = 64 };
    const uintptr_t first = (uintptr_t)from & -(uintptr_t)LINE;
    for (uintptr_t line = first; line < (uintptr_t)from + bytes; line += LINE)
        __builtin_prefetch((const void *)line);
}

#endif
