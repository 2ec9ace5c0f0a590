/* The conversions of pipeline/base/lanes as functions of arrays, so that a check can call every
 * lane width's. */
#ifndef TESTS_KERNEL_CHANNELS_H
#define TESTS_KERNEL_CHANNELS_H

#include <stdint.h>

/* `lanes` values a call. */
typedef struct ChannelsCode {
    int lanes;
    const char *isa;
    void (*unorm8_code)(const float *v, uint8_t *code);  /* of 0 to 1 */
    void (*pack_unorm8)(const float *v, uint32_t *word); /* the same v in all four bytes */
    void (*unpack_unorm8)(const uint32_t *word, int byte, float *v);
    void (*through_unorm8)(const float *v, float *result); /* of 0 to 1 */
    void (*through_half)(const float *v, float *result);
} ChannelsCode;

/* Absent where a width was not compiled. */
extern const ChannelsCode channels_code4 __attribute__((weak));
extern const ChannelsCode channels_code8 __attribute__((weak));
extern const ChannelsCode channels_code16 __attribute__((weak));

#endif
