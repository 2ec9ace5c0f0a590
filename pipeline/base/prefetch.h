/* Asking memory for what is wanted soon. */
#ifndef GP_PREFETCH_H
#define GP_PREFETCH_H

#include <stddef.h>
#include <stdint.h>

/* For functions that do nothing else: gcc takes calls of them for calls of what does nothing. */
#define GP_PREFETCHES static inline __attribute__((always_inline))

/* All lines of some bytes, which need not exist. */
GP_PREFETCHES void gp_prefetch(const void *from, size_t bytes)
{
    enum { LINE = 64 };
    const uintptr_t first = (uintptr_t)from & -(uintptr_t)LINE;
    for (uintptr_t line = first; line < (uintptr_t)from + bytes; line += LINE)
        __builtin_prefetch((const void *)line);
}

#endif
