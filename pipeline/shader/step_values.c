/* Each case is the instruction itself: nothing is computed in another way than by shaders. */
#ifndef GP_STEP_VALUE
#define GP_STEP_VALUE gp_step_value
#endif
#include "pipeline/shader/step_values.h"

#include "pipeline/shader/instructions.h"
#include "pipeline/shader/pixels.h"

#include <string.h>

typedef union Lanes {
    flt each[4];
    float2 two;
    float3 three;
    float4 four;
} Lanes;

static Lanes lanes_of(const float operand[4][4])
{
    Lanes lanes;
    for (int c = 0; c < 4; c++)
        memcpy(&lanes.each[c], operand[c], sizeof lanes.each[c]);
    return lanes;
}

/* Component by component. */
static flt of_each(GpStepCode code, flt a, flt b, flt c)
{
    switch (code) {
    case GP_STEP_ADD:
        return add(a, b);
    case GP_STEP_SUB:
        return sub(a, b);
    case GP_STEP_MUL:
        return mul(a, b);
    case GP_STEP_DIV:
        return a / b;
    case GP_STEP_MIN:
        return min(a, b);
    case GP_STEP_MAX:
        return max(a, b);
    case GP_STEP_SLT:
        return slt(a, b);
    case GP_STEP_SGE:
        return sge(a, b);
    case GP_STEP_MAD:
        return mad(a, b, c);
    case GP_STEP_LRP:
        return lrp(a, b, c);
    case GP_STEP_CMP:
        return cmp(a, b, c);
    case GP_STEP_SEL:
        return sel((msk)a, b, c);
    case GP_STEP_ABS:
        return abs_(a);
    case GP_STEP_FRC:
        return frc(a);
    case GP_STEP_FLOOR:
        return floor_(a);
    case GP_STEP_SAT:
        return sat(a);
    case GP_STEP_DSX:
        return gp_dsx1(a);
    case GP_STEP_DSY:
        return gp_dsy1(a);
    default:
        return flt_set(0);
    }
}

/* Of one component to one component. */
static flt of_one(GpStepCode code, flt a, flt b)
{
    switch (code) {
    case GP_STEP_RCP:
        return rcp(a);
    case GP_STEP_RSQ:
        return rsq(a);
    case GP_STEP_SQRT:
        return sqrt_(a);
    case GP_STEP_EXP:
        return exp_(a);
    case GP_STEP_LOG:
        return log_(a);
    case GP_STEP_POW:
        return pow_(a, b);
    case GP_STEP_SIN:
        return sin_(a);
    case GP_STEP_COS:
        return cos_(a);
    case GP_STEP_SGN:
        return sgn(a);
    default:
        return flt_set(0);
    }
}

static msk of_mask(GpStepCode code, flt a, flt b)
{
    switch (code) {
    case GP_STEP_LESS:
        return a < b;
    case GP_STEP_LESS_EQUAL:
        return a <= b;
    case GP_STEP_GREATER:
        return a > b;
    case GP_STEP_GREATER_EQUAL:
        return a >= b;
    case GP_STEP_EQUAL:
        return a == b;
    case GP_STEP_NOT_EQUAL:
        return a != b;
    case GP_STEP_AND:
        return (msk)a & (msk)b;
    case GP_STEP_OR:
        return (msk)a | (msk)b;
    case GP_STEP_XOR:
        return (msk)a ^ (msk)b;
    default:
        return ~(msk)a;
    }
}

/* A row of a matrix; width: of the vector. */
static flt of_row(int width, const Lanes *v, const float row[4][4])
{
    const float of_all[4] = { row[0][0], row[1][0], row[2][0], row[3][0] };
    return width == 3 ? gp_row3(v->three, of_all) : gp_row4(v->four, of_all);
}

static Lanes of_vectors(GpStepCode code, int width, const Lanes *a, const Lanes *b, const Lanes *c)
{
    Lanes result = { .four = sp4(flt_set(0)) };
    if (code == GP_STEP_DP2)
        result.each[0] = dp2(a->two, b->two);
    else if (code == GP_STEP_DP2ADD)
        result.each[0] = dp2add(a->two, b->two, c->each[0]);
    else if (code == GP_STEP_DP3)
        result.each[0] = dp3(a->three, b->three);
    else if (code == GP_STEP_DP4)
        result.each[0] = dp4(a->four, b->four);
    else if (code == GP_STEP_CRS)
        result.three = crs(a->three, b->three);
    else if (code == GP_STEP_SINCOS)
        result.two = sincos_(a->each[0]);
    else if (code == GP_STEP_LIT)
        result.four = lit(a->each[0], b->each[0], c->each[0]);
    else if (code == GP_STEP_DST)
        result.four = dst(a->four, b->four);
    else if (width == 2)
        result.two = nrm(a->two);
    else if (width == 3)
        result.three = nrm(a->three);
    else
        result.four = nrm(a->four);
    return result;
}

static bool is_each(GpStepCode code)
{
    return code <= GP_STEP_SAT || code == GP_STEP_DSX || code == GP_STEP_DSY;
}

static bool is_vector(GpStepCode code)
{
    return (code >= GP_STEP_DP2 && code <= GP_STEP_CRS) || code == GP_STEP_SINCOS ||
           (code >= GP_STEP_NRM && code <= GP_STEP_DST);
}

void GP_STEP_VALUE(GpStepCode code, int width, const float operand[GP_STEP_OPERANDS][4][4],
                   float value[4][4])
{
    const Lanes a = lanes_of(operand[0]), b = lanes_of(operand[1]), c = lanes_of(operand[2]);
    Lanes result = { .four = sp4(flt_set(0)) };
    if (is_each(code))
        for (int i = 0; i < width; i++)
            result.each[i] = of_each(code, a.each[i], b.each[i], c.each[i]);
    else if (code == GP_STEP_ROW)
        result.each[0] = of_row(width, &a, operand[1]);
    else if (is_vector(code))
        result = of_vectors(code, width, &a, &b, &c);
    else if (code >= GP_STEP_LESS && code <= GP_STEP_NOT)
        result.each[0] = (flt)of_mask(code, a.each[0], b.each[0]);
    else
        result.each[0] = of_one(code, a.each[0], b.each[0]);
    for (int i = 0; i < 4; i++)
        memcpy(value[i], &result.each[i], sizeof value[i]);
}
