/* The instruction graph that the counting build of a shader records.
 *
 * Every operation of the vocabulary (counting_instructions.hpp) adds one node: an instruction with
 * its operands, or a leaf: a number, a uniform, an input. Nothing is computed, unless the shader is
 * run step by step (graph_steps.c); graph_counts.c reads the figures off it.
 *
 * This is what the counting build calls; one shader at a time runs in a thread, and the calls are
 * about that. Where memory ends, nodes go missing, the shader runs on, and who asked for it is told
 * at the end.
 */
#ifndef GP_GRAPH_H
#define GP_GRAPH_H

#include "pipeline/shader/counts.h"
#include "pipeline/shader/steps.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum GpNodeKind {
    GP_NODE_NUMBER,
    GP_NODE_UNWRITTEN,
    GP_NODE_UNIFORM,
    GP_NODE_INPUT,
    GP_NODE_PIXEL,
    GP_NODE_FACE,
    GP_NODE_ARITHMETIC, /* instructions, from here on */
    GP_NODE_TEXTURE,
    GP_NODE_KILL, /* and from here on what runs though no output needs it */
    GP_NODE_LOOP
} GpNodeKind;

/* One component of a node: the flt of counting lanes. All zero it is the number 0, as `float3 sum =
 * { 0 }` is in C. */
typedef struct GpPart {
    int32_t node;
    uint8_t component;
    bool negated;
} GpPart;

/* A value of one to four components. */
typedef struct GpOperand {
    int width;
    GpPart part[4];
} GpOperand;

/* What an instruction is: its slots in shader models 2 and 3, and whether component i of the result
 * needs component i of each operand or all of them. */
typedef struct GpOp {
    int slots2, slots3;
    bool reads_all;
    GpNodeKind kind;
    bool gradient; /* dsx, dsy, texldd */
    GpLodMode mode;
} GpOp;

/* Where an instruction stands in the shader's text. */
typedef struct GpPlace {
    const char *file;
    int line;
} GpPlace;

/* --- of the vocabulary ------------------------------------------------------------------------ */

/* Adds an instruction.
 * in   operand: at most GP_STEP_OPERANDS, of reads the coordinate first; index: texture slot of
 *      reads
 * returns its node */
int32_t gp_graph_add(const GpOp *op, GpStepCode code, GpPlace at, const GpOperand *operand,
                     int operands, int index);

/* The one node of a leaf: component, or 0 where there is one only. */
GpPart gp_graph_leaf(GpNodeKind kind, int index);

/* A C number, or a member of the uniforms, which is known by its value or by where it stands. */
GpPart gp_graph_number(const float *value);

GpNodeKind gp_graph_kind(GpPart part);

/* Whether a mask is true in any lane: known of steps, else it may be. */
bool gp_graph_may_hold(GpPart mask);

/* The shader names a value. */
void gp_graph_watch(const char *name, const GpOperand *value);

/* What is recorded: a vertex shader; of a program of model 2; with values. */
bool gp_graph_is_vertex(void);
bool gp_graph_is_model2(void);
bool gp_graph_is_stepping(void);

/* --- of a shader's body ----------------------------------------------------------------------- */

/* What a shader reads and writes, at its own places. */
typedef struct GpGraphBody {
    size_t uniform_bytes;
    GpPart *in, *out; /* components of its structs */
    int ins, outs;
    GpPart *position; /* four, of a vertex shader; else NULL */
    GpPart *single;   /* point size or depth */
} GpGraphBody;

/* Before the body: in receives its leaves, and all outputs are unwritten.
 * returns the uniforms; NULL: there was no memory, and the body is not to be run */
const void *gp_graph_begin(const GpGraphBody *body);

/* A member of the vertex struct, of component `first`, is called as the semantic. */
void gp_graph_name_input(GpSemantic semantic, int first);

/* After it: what the outputs hold. */
void gp_graph_end(const GpGraphBody *body);

/* --- of a program ----------------------------------------------------------------------------- */

/* The shaders of a program as recorded: each begins, runs its body and ends. pixel: NULL, there is
 * none. */
typedef struct GpGraphShaders {
    void (*vertex)(void), (*pixel)(void);
    bool software; /* GP_SHADER_SW */
} GpGraphShaders;

/* GpCountFn and GpStepFn of a program. */
bool gp_graph_count(const GpProgram *program, const GpGraphShaders *shaders, GpShaderCounts *vertex,
                    GpShaderCounts *pixel);
bool gp_graph_step(const GpProgram *program, const GpGraphShaders *shaders, bool vertex,
                   const GpStepRun *run);

#ifdef __cplusplus
}
#endif

#endif
