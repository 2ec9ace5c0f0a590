#include "tests/kernel/channels.h"

#include "pipeline/base/lanes.h"

#include <string.h>

static void unorm8_code(const float *v, uint8_t *code)
{
    itg codes = itg_unorm8(flt_load(v));
    for (int lane = 0; lane < GP_LANES; lane++)
        code[lane] = (uint8_t)codes[lane];
}

static void pack_unorm8(const float *v, uint32_t *word)
{
    flt all = flt_load(v);
    itg words = itg_pack_unorm8((flt[4]){ all, all, all, all });
    memcpy(word, &words, sizeof words);
}

static void unpack_unorm8(const uint32_t *word, int byte, float *v)
{
    itg words;
    memcpy(&words, word, sizeof words);
    flt_store(v, byte == 0   ? flt_unpack_unorm8(words, 0)
                 : byte == 1 ? flt_unpack_unorm8(words, 1)
                 : byte == 2 ? flt_unpack_unorm8(words, 2)
                             : flt_unpack_unorm8(words, 3));
}

static void through_unorm8(const float *v, float *result)
{
    flt_store(result, flt_quantize_unorm8(flt_load(v)));
}

static void through_half(const float *v, float *result)
{
    flt_store(result, flt_quantize_half(flt_load(v)));
}

#define CODE_PASTE_(lanes) channels_code##lanes
#define CODE_PASTE(lanes)  CODE_PASTE_(lanes)

const ChannelsCode CODE_PASTE(GP_LANES) = { GP_LANES,      GP_ISA_NAME,    unorm8_code, pack_unorm8,
                                            unpack_unorm8, through_unorm8, through_half };
