/* Channels of texels in lanes, at every lane width, against pipeline/resources/format.h: every one
 * of the 2^32 floats to a code of eight bits and back, and through a half, every code back to a
 * float.
 *
 * One line a width with the first difference, if any, then the count of passed and failed widths.
 * An argument N looks at every Nth float only. Exit status 1 on a failure.
 */
#include "tests/kernel/channels.h"

#include "pipeline/resources/format.h"
#include "pipeline/list/isa.h"

#include <stdio.h>
#include <stdlib.h>

enum { WIDEST = 16 };

static bool is_nan(float v)
{
    return v != v;
}

static bool same_bits(float a, float b)
{
    return gp_float_bits(a) == gp_float_bits(b);
}

/* What a half leaves; of a NaN, its upper bits, quiet. */
static float half_of(float v)
{
    if (is_nan(v))
        return gp_bits_float((gp_float_bits(v) | 0x00400000u) & 0xffffe000u);
    return gp_float_from_half(gp_half_from_float(v));
}

static bool check_codes(const ChannelsCode *code)
{
    for (uint32_t c = 0; c < 256; c++)
        for (int byte = 0; byte < 4; byte++) {
            uint32_t word[WIDEST];
            float v[WIDEST];
            for (int lane = 0; lane < code->lanes; lane++)
                word[lane] = (c << 8 * byte) | (~c * 0x01010101u & ~(255u << 8 * byte));
            code->unpack_unorm8(word, byte, v);
            for (int lane = 0; lane < code->lanes; lane++)
                if (!same_bits(v[lane], gp_float_from_unorm(c, 8))) {
                    printf("FAILED %s: code %u in byte %d gives %a\n", code->isa, c, byte,
                           (double)v[lane]);
                    return false;
                }
        }
    return true;
}

static bool check_float(const ChannelsCode *code, float v, uint8_t clamped, uint32_t word,
                        float unorm, float half)
{
    uint32_t expected = gp_unorm_from_float(v, 8);
    bool packs = is_nan(v) || v <= 2; /* no more is promised */
    if (clamped == expected && (!packs || word == expected * 0x01010101u) &&
        same_bits(unorm, gp_float_from_unorm(expected, 8)) && same_bits(half, half_of(v)))
        return true;
    printf("FAILED %s: %a gives code %u, word %08x, back %a, half %a\n", code->isa, (double)v,
           clamped, word, (double)unorm, (double)half);
    return false;
}

static bool check_width(const ChannelsCode *code, uint64_t step)
{
    if (!check_codes(code))
        return false;
    for (uint64_t bits = 0; bits < UINT64_C(1) << 32; bits += step * (uint64_t)code->lanes) {
        float v[WIDEST], clamped[WIDEST], unorm[WIDEST], half[WIDEST];
        uint8_t unorm8[WIDEST];
        uint32_t word[WIDEST];
        for (int lane = 0; lane < code->lanes; lane++) {
            v[lane] = gp_bits_float((uint32_t)(bits + step * (uint64_t)lane));
            clamped[lane] = v[lane] > 0 ? (v[lane] < 1 ? v[lane] : 1) : 0;
        }
        code->unorm8_code(clamped, unorm8);
        code->pack_unorm8(v, word);
        code->through_unorm8(clamped, unorm);
        code->through_half(v, half);
        for (int lane = 0; lane < code->lanes; lane++)
            if (!check_float(code, v[lane], unorm8[lane], word[lane], unorm[lane], half[lane]))
                return false;
    }
    printf("ok     %s\n", code->isa);
    return true;
}

int main(int count, char **arguments)
{
    const ChannelsCode *codes[] = { &channels_code4, &channels_code8, &channels_code16 };
    const uint64_t step = count > 1 ? strtoull(arguments[1], NULL, 10) : 1;
    int passed = 0, failed = 0;
    for (size_t i = 0; i < GP_COUNT(codes); i++) {
        if (!codes[i] || !gp_isa_runs(codes[i]->isa))
            continue;
        if (check_width(codes[i], step ? step : 1))
            passed++;
        else
            failed++;
    }
    printf("%d passed, %d failed\n", passed, failed);
    return failed != 0;
}
