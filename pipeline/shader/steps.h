/* Shaders run one instruction at a time: the counting build of a shader, which records every
 * instruction, computes its values too, with the instructions' own code at four lanes. So the very
 * source that draws tells its steps, and what it gives has the bits of the code that draws.
 */
#ifndef GP_STEPS_H
#define GP_STEPS_H

#include "pipeline/shader/program.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The instructions, by their names in the shader language; infix operators are those that they
 * mean. */
typedef enum GpStepCode {
    GP_STEP_ADD,
    GP_STEP_SUB,
    GP_STEP_MUL,
    GP_STEP_DIV,
    GP_STEP_MIN,
    GP_STEP_MAX,
    GP_STEP_SLT,
    GP_STEP_SGE,
    GP_STEP_MAD,
    GP_STEP_LRP,
    GP_STEP_CMP,
    GP_STEP_SEL,
    GP_STEP_ABS,
    GP_STEP_FRC,
    GP_STEP_FLOOR,
    GP_STEP_SAT,
    GP_STEP_DP2,
    GP_STEP_DP2ADD,
    GP_STEP_DP3,
    GP_STEP_DP4,
    GP_STEP_CRS,
    GP_STEP_ROW, /* a row of m4x4, m4x3: the w of three components is 1 */
    GP_STEP_RCP,
    GP_STEP_RSQ,
    GP_STEP_SQRT,
    GP_STEP_EXP,
    GP_STEP_LOG,
    GP_STEP_POW,
    GP_STEP_SIN,
    GP_STEP_COS,
    GP_STEP_SINCOS,
    GP_STEP_SGN,
    GP_STEP_NRM,
    GP_STEP_LIT,
    GP_STEP_DST,
    GP_STEP_DSX,
    GP_STEP_DSY,
    GP_STEP_LESS, /* comparisons and masks: all bits of a lane set, or none */
    GP_STEP_LESS_EQUAL,
    GP_STEP_GREATER,
    GP_STEP_GREATER_EQUAL,
    GP_STEP_EQUAL,
    GP_STEP_NOT_EQUAL,
    GP_STEP_AND,
    GP_STEP_OR,
    GP_STEP_XOR,
    GP_STEP_NOT,
    GP_STEP_LOOP, /* what follows runs once more where the mask is true in any lane */
    GP_STEP_DISCARD,
    GP_STEP_TEXKILL,
    GP_STEP_TEXLD,
    GP_STEP_TEXLDP,
    GP_STEP_TEXLDB,
    GP_STEP_TEXLDL,
    GP_STEP_TEXLDD,
    GP_STEP_LOCAL,
    GP_STEP_CODES
} GpStepCode;

/* By value: "mad". */
extern const char *const gp_step_names[GP_STEP_CODES];

/* Where a component of an operand comes from. */
typedef enum GpStepSource {
    GP_STEP_RESULT,  /* an earlier step */
    GP_STEP_INPUT,   /* a component of the vertex or varying struct */
    GP_STEP_UNIFORM, /* a word of the uniforms */
    GP_STEP_NUMBER,  /* a number of the source, or one that C computed of uniforms */
    GP_STEP_PIXEL,   /* vpos: x, y */
    GP_STEP_FACE,    /* vface */
    GP_STEP_UNSET,   /* nothing was written */
    GP_STEP_SOURCES
} GpStepSource;

/* One component of an operand, or of a result of the shader. */
typedef struct GpStepPart {
    GpStepSource source;
    int index;     /* of the step, input, word or component; 0 where there is one only */
    int component; /* of the step's result */
    bool negated;
    float value[4]; /* of the lanes, negated where it is */
} GpStepPart;

/* An operand of one to four components. */
typedef struct GpStepOperand {
    int width;
    GpStepPart part[4];
} GpStepOperand;

enum { GP_STEP_OPERANDS = 3 };

/* One instruction as it was run for the four pixels of a quad, or for four vertices. */
typedef struct GpShaderStep {
    int number; /* from 0; operands come from lower ones */
    GpStepCode code;
    int slots;        /* of the instruction in the program's model (CONVENTIONS.md, "Profiles") */
    int slot;         /* texture slot of reads; else -1 */
    const char *file; /* of the shader's text, as the compiler was given it */
    int line;
    int operands, width;
    GpStepOperand operand[GP_STEP_OPERANDS];
    float value[4][4]; /* [component of the result][lane] */
} GpShaderStep;

/* What a shader gives: which step, or leaf, each of its outputs is. Outputs of a vertex shader are
 * the four components of the position, the varyings, the point size; of a pixel shader those of the
 * targets, then its depth. */
typedef struct GpStepOutput {
    int number;
    GpStepPart part;
} GpStepOutput;

/* The most of either shader. */
enum { GP_STEP_OUTPUTS = 4 * GP_MAX_TARGETS + GP_MAX_VARYINGS + 5 };

/* A value that the shader names, watch("opacity", alpha). Its parts have values, and are of steps
 * that are told where anything needs them, else of step -1. */
typedef struct GpStepWatch {
    const char *name;
    GpStepOperand value;
} GpStepWatch;

/* Who is told. Steps come in an order that follows from the shader alone: discards and loops first,
 * as they were met, then outputs, each after what it needs; what nothing needs is left out. Then
 * the outputs are told, and what the shader watches, as it was met; watched: NULL, nobody asks. */
typedef struct GpStepListener {
    void (*step)(void *user, const GpShaderStep *step);
    void (*output)(void *user, const GpStepOutput *output);
    void (*watched)(void *user, const GpStepWatch *watch);
    void *user;
} GpStepListener;

/* One run of a shader's counting build: GpProgram.step. */
typedef struct GpStepRun {
    /* one packet of four lanes; its outputs are written as a shader does */
    const GpShaderCall *call;
    const GpStepListener *listener;
} GpStepRun;

/* Runs a vertex or pixel shader step by step.
 * in   call: one packet of four lanes
 * out  what the call asks for
 * returns false where the program has no counting build, or memory ran out */
bool gp_program_steps(const GpProgram *program, bool vertex, const GpShaderCall *call,
                      const GpStepListener *listener);

#ifdef __cplusplus
}
#endif

#endif
