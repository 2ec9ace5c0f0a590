/* The types of the shader language, and operands of one width made those of another. */
#ifndef GP_SHADER_TYPES_H
#define GP_SHADER_TYPES_H

#include "pipeline/base/lanes.h"
#include "pipeline/shader/program.h"

/* Two components in lanes. */
typedef struct float2 {
    flt x, y;
} float2;

/* Three components in lanes. */
typedef struct float3 {
    flt x, y, z;
} float3;

/* Four components in lanes. */
typedef struct float4 {
    flt x, y, z, w;
} float4;

/* One packet of one call: what the vocabulary needs beside its operands. */
typedef struct GpInvocation {
    const GpShaderCall *call;
    int packet;
    uint32_t used; /* GpShaderUse */
    msk killed;
    flt depth;
} GpInvocation;

/* --- constants into lanes --------------------------------------------------------------------- */

/* A number in all lanes. */
GP_INLINE flt bcast(float value)
{
    return flt_set(value);
}

/* A vector of uniforms, the same in all lanes. */
GP_INLINE float2 u2(const float *value)
{
    return (float2){ flt_set(value[0]), flt_set(value[1]) };
}

/* A vector of uniforms, the same in all lanes. */
GP_INLINE float3 u3(const float *value)
{
    return (float3){ flt_set(value[0]), flt_set(value[1]), flt_set(value[2]) };
}

/* A vector of uniforms, the same in all lanes. */
GP_INLINE float4 u4(const float *value)
{
    return (float4){ flt_set(value[0]), flt_set(value[1]), flt_set(value[2]), flt_set(value[3]) };
}

/* --- widening: `gp_as(a, b)` is b with the type of a ------------------------------------------ */

/* One value in all components. */
GP_INLINE float2 sp2(flt a)
{
    return (float2){ a, a };
}

/* One value in all components. */
GP_INLINE float3 sp3(flt a)
{
    return (float3){ a, a, a };
}

/* One value in all components. */
GP_INLINE float4 sp4(flt a)
{
    return (float4){ a, a, a, a };
}

GP_INLINE flt gp_same1(flt a)
{
    return a;
}
GP_INLINE float2 gp_same2(float2 a)
{
    return a;
}
GP_INLINE float3 gp_same3(float3 a)
{
    return a;
}
GP_INLINE float4 gp_same4(float4 a)
{
    return a;
}
GP_INLINE float2 gp_number2(float a)
{
    return sp2(flt_set(a));
}
GP_INLINE float3 gp_number3(float a)
{
    return sp3(flt_set(a));
}
GP_INLINE float4 gp_number4(float a)
{
    return sp4(flt_set(a));
}

/* Components of an operand: 1 to 4, 5 of a mask, 0 of a number and of all that is none. */
#define GP_WIDTH(a)   _Generic((a), flt : 1, float2 : 2, float3 : 3, float4 : 4, msk : 5, default : 0)
#define GP_PAIR(a, b) (6 * GP_WIDTH(a) + GP_WIDTH(b))

/* A mistake is answered with a sentence, before the compiler speaks of what stands behind a word of
 * the vocabulary. Bit GP_PAIR(a, b) of the number: b can be widened to a. */
#define GP_SAY(condition, text) ((void)__extension__({ _Static_assert(condition, text); }))
#define GP_WANT(form, a)        GP_SAY(GP_WIDTH(a) % 5 != 0, form ": a must be a flt or a vector")
#define GP_WANT2(form, a, b)                                                                       \
    GP_SAY(0x132c70c0 >> GP_PAIR(a, b) & 1, form                                                   \
           ": a must be a flt or a vector, and what goes with it as wide as a, or a flt, or a "    \
           "number")

/* clang-format off */
#define gp_as(a, b)                                                                                \
    _Generic((char(*)[1 + GP_PAIR(a, b)])0,                                                        \
             char(*)[8] : gp_same1,                                                                \
             char(*)[13] : gp_number2, char(*)[14] : sp2, char(*)[15] : gp_same2,                  \
             char(*)[19] : gp_number3, char(*)[20] : sp3, char(*)[22] : gp_same3,                  \
             char(*)[25] : gp_number4, char(*)[26] : sp4, char(*)[29] : gp_same4,                  \
             default : bcast)(b)

#define GP_BY_WIDTH(name, a)                                                                       \
    _Generic((a), flt : name##1, float2 : name##2, float3 : name##3, default : name##4)
/* clang-format on */

/* Defines name1..name4 from a function of one, two or three flt, component by component. */
#define GP_MAP1(name, f)                                                                           \
    GP_INLINE flt name##1(flt a)                                                                   \
    {                                                                                              \
        return f(a);                                                                               \
    }                                                                                              \
    GP_INLINE float2 name##2(float2 a)                                                             \
    {                                                                                              \
        return (float2){ f(a.x), f(a.y) };                                                         \
    }                                                                                              \
    GP_INLINE float3 name##3(float3 a)                                                             \
    {                                                                                              \
        return (float3){ f(a.x), f(a.y), f(a.z) };                                                 \
    }                                                                                              \
    GP_INLINE float4 name##4(float4 a)                                                             \
    {                                                                                              \
        return (float4){ f(a.x), f(a.y), f(a.z), f(a.w) };                                         \
    }

#define GP_MAP2(name, f)                                                                           \
    GP_INLINE flt name##1(flt a, flt b)                                                            \
    {                                                                                              \
        return f(a, b);                                                                            \
    }                                                                                              \
    GP_INLINE float2 name##2(float2 a, float2 b)                                                   \
    {                                                                                              \
        return (float2){ f(a.x, b.x), f(a.y, b.y) };                                               \
    }                                                                                              \
    GP_INLINE float3 name##3(float3 a, float3 b)                                                   \
    {                                                                                              \
        return (float3){ f(a.x, b.x), f(a.y, b.y), f(a.z, b.z) };                                  \
    }                                                                                              \
    GP_INLINE float4 name##4(float4 a, float4 b)                                                   \
    {                                                                                              \
        return (float4){ f(a.x, b.x), f(a.y, b.y), f(a.z, b.z), f(a.w, b.w) };                     \
    }

#define GP_MAP3(name, f)                                                                           \
    GP_INLINE flt name##1(flt a, flt b, flt c)                                                     \
    {                                                                                              \
        return f(a, b, c);                                                                         \
    }                                                                                              \
    GP_INLINE float2 name##2(float2 a, float2 b, float2 c)                                         \
    {                                                                                              \
        return (float2){ f(a.x, b.x, c.x), f(a.y, b.y, c.y) };                                     \
    }                                                                                              \
    GP_INLINE float3 name##3(float3 a, float3 b, float3 c)                                         \
    {                                                                                              \
        return (float3){ f(a.x, b.x, c.x), f(a.y, b.y, c.y), f(a.z, b.z, c.z) };                   \
    }                                                                                              \
    GP_INLINE float4 name##4(float4 a, float4 b, float4 c)                                         \
    {                                                                                              \
        return (float4){ f(a.x, b.x, c.x), f(a.y, b.y, c.y), f(a.z, b.z, c.z), f(a.w, b.w, c.w) }; \
    }

#endif
