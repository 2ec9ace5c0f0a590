/* Lane vectors: GP_LANES floats or integers that go through the same operation side by side.
 *
 * The same source is compiled for several widths and instruction sets; every operation here gives
 * the same bits in each lane whatever the width, compiler or machine: IEEE add, sub, mul, div and
 * sqrt, selections by masks, and integer arithmetic that wraps. Masks are integer vectors, all ones
 * for true. This is the only file that may hold intrinsics.
 */
#ifndef GP_LANES_H
#define GP_LANES_H

#include <stdint.h>

#ifndef GP_LANES
#define GP_LANES 4
#endif

#define GP_INLINE static inline __attribute__((always_inline, unused))

typedef float flt __attribute__((vector_size(4 * GP_LANES)));
typedef int32_t itg __attribute__((vector_size(4 * GP_LANES)));
typedef uint32_t utg __attribute__((vector_size(4 * GP_LANES)));
typedef itg msk; /* per lane: -1 true, 0 false; what comparisons of flt and itg give */

/* The same value in every lane. (Subtracting from zero would lose the sign of -0.) */
GP_INLINE flt flt_set(float value)
{
    flt all;
    for (int lane = 0; lane < GP_LANES; lane++)
        all[lane] = value;
    return all;
}

GP_INLINE itg itg_set(int32_t value)
{
    itg all;
    for (int lane = 0; lane < GP_LANES; lane++)
        all[lane] = value;
    return all;
}

/* Per lane: mask ? a : b. */
GP_INLINE flt flt_select(msk mask, flt a, flt b)
{
    return (flt)(((itg)a & mask) | ((itg)b & ~mask));
}

GP_INLINE itg itg_select(msk mask, itg a, itg b)
{
    return (a & mask) | (b & ~mask);
}

/* Per lane: a < b ? a : b, and a > b ? a : b. A NaN in a gives b; a NaN in b gives b too, so
 * shaders use the vocabulary's min and max, which follow rule R30. */
GP_INLINE flt flt_lesser(flt a, flt b)
{
    return flt_select(a < b, a, b);
}

GP_INLINE flt flt_greater(flt a, flt b)
{
    return flt_select(a > b, a, b);
}

GP_INLINE flt flt_abs(flt a)
{
    return (flt)((itg)a & 0x7fffffff);
}

/* Correctly rounded square root. */
GP_INLINE flt flt_sqrt(flt a)
{
    flt root;
    for (int lane = 0; lane < GP_LANES; lane++)
        root[lane] = __builtin_sqrtf(a[lane]);
    return root;
}

/* To integer, toward zero; every lane must be in range (callers clamp first). */
GP_INLINE itg itg_from_flt(flt a)
{
    return __builtin_convertvector(a, itg);
}

/* To float, to nearest even. */
GP_INLINE flt flt_from_itg(itg a)
{
    return __builtin_convertvector(a, flt);
}

/* Bit i of the result: lane i of the mask. */
GP_INLINE unsigned msk_bits(msk mask)
{
    unsigned bits = 0;
    for (int lane = 0; lane < GP_LANES; lane++)
        bits |= (unsigned)(mask[lane] & 1) << lane;
    return bits;
}

/* --- 2x2 quads: lanes 4q..4q+3 are top left, top right, bottom left, bottom right --------------- */

#if GP_LANES == 4
#define GP_QUAD_SHUFFLE(a, i0, i1, i2, i3) __builtin_shufflevector(a, a, i0, i1, i2, i3)
#elif GP_LANES == 8
#define GP_QUAD_SHUFFLE(a, i0, i1, i2, i3)                                                         \
    __builtin_shufflevector(a, a, i0, i1, i2, i3, 4 + i0, 4 + i1, 4 + i2, 4 + i3)
#elif GP_LANES == 16
#define GP_QUAD_SHUFFLE(a, i0, i1, i2, i3)                                                         \
    __builtin_shufflevector(a, a, i0, i1, i2, i3, 4 + i0, 4 + i1, 4 + i2, 4 + i3, 8 + i0, 8 + i1,  \
                            8 + i2, 8 + i3, 12 + i0, 12 + i1, 12 + i2, 12 + i3)
#else
#error "GP_LANES must be 4, 8 or 16"
#endif

/* Right minus left, the same for both pixels of a row of the quad. */
GP_INLINE flt flt_quad_dx(flt a)
{
    return GP_QUAD_SHUFFLE(a, 1, 1, 3, 3) - GP_QUAD_SHUFFLE(a, 0, 0, 2, 2);
}

/* Lower minus upper, the same for both pixels of a column of the quad. */
GP_INLINE flt flt_quad_dy(flt a)
{
    return GP_QUAD_SHUFFLE(a, 2, 3, 2, 3) - GP_QUAD_SHUFFLE(a, 0, 1, 0, 1);
}

#endif
