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

enum { LINE = 64, HUGE_PAGE = 2 << 20 };

/* The first place in a block of malloc's that is aligned, with room before it for where the block
 * begins. */
static void *align(char *block, size_t alignment)
{
    const uintptr_t behind = (uintptr_t)(block + sizeof block);
    char *memory = block + sizeof block + (-behind & (alignment - 1));
    memcpy(memory - sizeof block, &block, sizeof block);
    return memory;
}

/* Bytes at the start of a block that ask for huge pages. Rows of a large surface lie pages apart,
 * and blocks of many pages are read at random: there are more pages than processors keep addresses
 * of; and each is fetched from the system when it is touched first (the last half of a huge page
 * counts as one: whole commands take 16 to 20 % less where the system is a guest that traps
 * them). */
static size_t huge_bytes(size_t bytes)
{
#ifdef __SANITIZE_ADDRESS__ /* sees what is beyond a block only where nothing follows it */
    (void)bytes;
    return 0;
#else
    return (bytes + HUGE_PAGE / 2) / HUGE_PAGE * HUGE_PAGE;
#endif
}

/* Zeros are calloc's, which knows what the system has cleared: so pages are touched where they are
 * used first, by all threads, and others never. */
static void *alloc(size_t bytes, bool zeros)
{
    if (bytes > SIZE_MAX / 2)
        return NULL;
    const size_t huge = huge_bytes(bytes), alignment = huge ? HUGE_PAGE : LINE;
    const size_t room = alignment + (huge > bytes ? huge : bytes);
    char *block = zeros ? calloc(1, room) : malloc(room);
    if (!block)
        return NULL;
    void *memory = align(block, alignment);
#ifdef MADV_HUGEPAGE
    if (huge)
        madvise(memory, huge, MADV_HUGEPAGE); /* a wish that is not met loses nothing */
#endif
    return memory;
}

void *gp_alloc_unset(size_t bytes)
{
    return alloc(bytes, false);
}

void *gp_alloc(size_t count, size_t size)
{
    size_t bytes;
    return __builtin_mul_overflow(count, size, &bytes) ? NULL : alloc(bytes, true);
}

void gp_free(void *memory)
{
    char *block;
    if (!memory)
        return;
    memcpy(&block, (char *)memory - sizeof block, sizeof block);
    free(block);
}

static GpEndFn called_without_memory;

void gp_call_without_memory(GpEndFn end)
{
    called_without_memory = end;
}

GpEndFn gp_called_without_memory(void)
{
    return called_without_memory;
}
