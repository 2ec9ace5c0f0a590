#include "pipeline/base/detmath.h"

float gp_exp2(float x)
{
    return math_exp2(flt_set(x))[0];
}

float gp_log2(float x)
{
    return math_log2(flt_set(x))[0];
}

float gp_pow(float x, float y)
{
    return math_pow(flt_set(x), flt_set(y))[0];
}

float gp_sin(float x)
{
    return math_sin(flt_set(x))[0];
}

float gp_cos(float x)
{
    return math_cos(flt_set(x))[0];
}
