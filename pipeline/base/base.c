/* Results, assertions, memory. */
#include "pipeline/base/base.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

GpResult gp_fail(GpError *error, GpResult result, const char *format, ...)
{
    if (error) {
        va_list args;
        va_start(args, format);
        vsnprintf(error->text, sizeof error->text, format, args);
        va_end(args);
    }
    return result;
}

const char *gp_result_name(GpResult result)
{
    switch (result) {
    case GP_OK:
        return "ok";
    case GP_ERROR_INVALID:
        return "invalid";
    case GP_ERROR_MEMORY:
        return "out of memory";
    case GP_ERROR_UNSUPPORTED:
        return "unsupported";
    case GP_ERROR_IO:
        return "input/output";
    case GP_ERROR_FORMAT:
        return "bad format";
    }
    return "unknown";
}

void gp_assert_failed(const char *condition, const char *file, int line)
{
    fprintf(stderr, "glasspipe: %s:%d: violated: %s\n", file, line, condition);
    abort();
}

enum { HUGE_PAGE = 2 << 20 };

/* Rows of a large surface lie pages apart, and blocks of many pages are read at random: there are more
 * pages than processors keep addresses of. Asks for large ones, where a wish that is not met loses
 * nothing. */
static void *alloc_huge(size_t bytes)
{
    void *memory;
    if (posix_memalign(&memory, HUGE_PAGE, bytes))
        return NULL;
#ifdef MADV_HUGEPAGE
    madvise(memory, bytes / HUGE_PAGE * HUGE_PAGE, MADV_HUGEPAGE);
#endif
    return memory;
}

void *gp_alloc_unset(size_t bytes)
{
    if (bytes > SIZE_MAX - 64)
        return NULL;
    bytes = bytes ? (bytes + 63) & ~(size_t)63 : 64;
    return bytes < HUGE_PAGE ? aligned_alloc(64, bytes) : alloc_huge(bytes);
}

void *gp_alloc(size_t count, size_t size)
{
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes))
        return NULL;
    void *memory = gp_alloc_unset(bytes);
    if (memory)
        memset(memory, 0, bytes);
    return memory;
}

void gp_free(void *memory)
{
    free(memory);
}
