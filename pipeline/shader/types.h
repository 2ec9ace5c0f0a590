/* The types of the shader language, and operands of one width made those of another. */
#ifndef GP_SHADER_TYPES_H
#define GP_SHADER_TYPES_H

#include "pipeline/base/lanes.h"
#include "pipeline/shader/program.h"

typedef struct float2 {
    flt x, y;
} float2;
typedef struct float3 {
    flt x, y, z;
} float3;
typedef struct float4 {
    flt x, y, z, w;
} float4;

/* One packet of one call: what the vocabulary needs beside its operands. */
typedef struct GpInvocation {
    const GpShaderCall *call;
    int packet;
    msk killed;
    flt depth;
} GpInvocation;

/* --- constants into lanes --------------------------------------------------------------------- */

GP_INLINE flt bcast(float value)
{
    return flt_set(value);
}

GP_INLINE float2 u2(const float *value)
{
    return (float2){ flt_set(value[0]), flt_set(value[1]) };
}

GP_INLINE float3 u3(const float *value)
{
    return (float3){ flt_set(value[0]), flt_set(value[1]), flt_set(value[2]) };
}

GP_INLINE float4 u4(const float *value)
{
    return (float4){ flt_set(value[0]), flt_set(value[1]), flt_set(value[2]), flt_set(value[3]) };
}

/* --- widening: `gp_as(a, b)` is b with the type of a ------------------------------------------ */

GP_INLINE float2 sp2(flt a)
{
    return (float2){ a, a };
}

GP_INLINE float3 sp3(flt a)
{
    return (float3){ a, a, a };
}

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

#define gp_as(a, b)                                                                                \
    _Generic((a), flt                                                                              \
             : _Generic((b), flt                                                                   \
                        : gp_same1, default                                                        \
                        : bcast),                                                                  \
               float2                                                                              \
             : _Generic((b), float2                                                                \
                        : gp_same2, flt                                                            \
                        : sp2, default                                                             \
                        : gp_number2),                                                             \
               float3                                                                              \
             : _Generic((b), float3                                                                \
                        : gp_same3, flt                                                            \
                        : sp3, default                                                             \
                        : gp_number3),                                                             \
               float4                                                                              \
             : _Generic((b), float4                                                                \
                        : gp_same4, flt                                                            \
                        : sp4, default                                                             \
                        : gp_number4))(b)

#define GP_BY_WIDTH(name, a)                                                                       \
    _Generic((a), flt : name##1, float2 : name##2, float3 : name##3, float4 : name##4)

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
