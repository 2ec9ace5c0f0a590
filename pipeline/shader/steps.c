/* What a step computes: the instructions of the shader language, called by their numbers. */
#include "pipeline/shader/steps.h"

#include "pipeline/shader/step_values.h"

const char *const gp_step_names[GP_STEP_CODES] = {
    [GP_STEP_ADD] = "add",
    [GP_STEP_SUB] = "sub",
    [GP_STEP_MUL] = "mul",
    [GP_STEP_DIV] = "div",
    [GP_STEP_MIN] = "min",
    [GP_STEP_MAX] = "max",
    [GP_STEP_SLT] = "slt",
    [GP_STEP_SGE] = "sge",
    [GP_STEP_MAD] = "mad",
    [GP_STEP_LRP] = "lrp",
    [GP_STEP_CMP] = "cmp",
    [GP_STEP_SEL] = "sel",
    [GP_STEP_ABS] = "abs",
    [GP_STEP_FRC] = "frc",
    [GP_STEP_FLOOR] = "floor",
    [GP_STEP_SAT] = "sat",
    [GP_STEP_DP2] = "dp2",
    [GP_STEP_DP2ADD] = "dp2add",
    [GP_STEP_DP3] = "dp3",
    [GP_STEP_DP4] = "dp4",
    [GP_STEP_CRS] = "crs",
    [GP_STEP_ROW] = "row",
    [GP_STEP_RCP] = "rcp",
    [GP_STEP_RSQ] = "rsq",
    [GP_STEP_SQRT] = "sqrt",
    [GP_STEP_EXP] = "exp",
    [GP_STEP_LOG] = "log",
    [GP_STEP_POW] = "pow",
    [GP_STEP_SIN] = "sin",
    [GP_STEP_COS] = "cos",
    [GP_STEP_SINCOS] = "sincos",
    [GP_STEP_SGN] = "sgn",
    [GP_STEP_NRM] = "nrm",
    [GP_STEP_LIT] = "lit",
    [GP_STEP_DST] = "dst",
    [GP_STEP_DSX] = "dsx",
    [GP_STEP_DSY] = "dsy",
    [GP_STEP_LESS] = "<",
    [GP_STEP_LESS_EQUAL] = "<=",
    [GP_STEP_GREATER] = ">",
    [GP_STEP_GREATER_EQUAL] = ">=",
    [GP_STEP_EQUAL] = "==",
    [GP_STEP_NOT_EQUAL] = "!=",
    [GP_STEP_AND] = "and",
    [GP_STEP_OR] = "or",
    [GP_STEP_XOR] = "xor",
    [GP_STEP_NOT] = "not",
    [GP_STEP_LOOP] = "loop_while",
    [GP_STEP_DISCARD] = "discard",
    [GP_STEP_TEXKILL] = "texkill",
    [GP_STEP_TEXLD] = "texld",
    [GP_STEP_TEXLDP] = "texldp",
    [GP_STEP_TEXLDB] = "texldb",
    [GP_STEP_TEXLDL] = "texldl",
    [GP_STEP_TEXLDD] = "texldd",
    [GP_STEP_LOCAL] = "gp_load_local",
};

static void evaluate(GpStepCode code, bool software, int width,
                     const float operand[GP_STEP_OPERANDS][4][4], float value[4][4])
{
    if (software)
        gp_step_value_software(code, width, operand, value);
    else
        gp_step_value(code, width, operand, value);
}

bool gp_program_steps(const GpProgram *program, bool vertex, const GpShaderCall *call,
                      const GpStepListener *listener)
{
    if (!program->step)
        return false;
    const GpStepRun run = { call, evaluate, listener };
    program->step(program, vertex, &run);
    return true;
}
