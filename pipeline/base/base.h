/* Results, error messages, assertions and memory: what every layer may use.
 *
 * Convention: a function that can fail returns GpResult and leaves its outputs untouched on
 * failure; where a reason helps, it takes a GpError that receives one readable line. Misuse by the
 * caller (a NULL that the contract forbids) is a bug and stops the program through GP_ASSERT,
 * in release builds too.
 */
#ifndef GP_BASE_H
#define GP_BASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a function came to. */
typedef enum GpResult {
    GP_OK = 0,
    GP_ERROR_INVALID = -1,     /* a description that contradicts itself or a limit */
    GP_ERROR_MEMORY = -2,      /* allocation failed */
    GP_ERROR_UNSUPPORTED = -3, /* valid, but not on this device or build */
    GP_ERROR_IO = -4,          /* a file could not be read or written */
    GP_ERROR_FORMAT = -5,      /* a file's content is not what its format promises */
} GpResult;

/* One line of text for a person; empty when nothing went wrong. */
typedef struct GpError {
    char text[512];
} GpError;

/* Writes a formatted message to *error (NULL: dropped) and returns result. */
GpResult gp_fail(GpError *error, GpResult result, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Name of a result, e.g. "invalid". Never NULL. */
const char *gp_result_name(GpResult result);

/* Says where a condition failed, and stops the program. */
__attribute__((noreturn)) void gp_assert_failed(const char *condition, const char *file, int line);

/* Stops the program where its own code, or the caller, broke a contract. */
#define GP_ASSERT(condition)                                                                       \
    ((condition) ? (void)0 : gp_assert_failed(#condition, __FILE__, __LINE__))

/* Elements of an array. */
#define GP_COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* Zeroed array of count elements of size bytes, aligned to 64 bytes; count or size 0 gives a valid
 * pointer to nothing. NULL when memory is short or the product overflows. Free with gp_free. */
void *gp_alloc(size_t count, size_t size);
void *gp_alloc_unset(size_t bytes); /* the same, but with whatever was there */
void gp_free(void *memory);

typedef void (*GpEndFn)(void);

/* Has `end` called, in whatever thread, where memory ends and who asked would not hear of it: what
 * counts shaders goes on without its figures, and libraries of C++ throw what cannot be caught
 * while they are loaded. It does not return. NULL, as at first: they go on. */
void gp_call_without_memory(GpEndFn end);
GpEndFn gp_called_without_memory(void);

/* The bits of a float. (Vectors of lanes are cast, which keeps their bits.) */
static inline uint32_t gp_float_bits(float value)
{
    union {
        float f;
        uint32_t u;
    } pun = { value };
    return pun.u;
}

/* The float that has these bits. */
static inline float gp_bits_float(uint32_t bits)
{
    union {
        uint32_t u;
        float f;
    } pun = { bits };
    return pun.f;
}

#ifdef __cplusplus
}
#endif

#endif
