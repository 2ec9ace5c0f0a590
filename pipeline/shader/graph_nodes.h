/* The instruction graph itself (internal): nodes in the order in which they came, so that operands
 * stand before what reads them. */
#ifndef GP_GRAPH_NODES_H
#define GP_GRAPH_NODES_H

#include "pipeline/shader/graph.h"

typedef struct GpNode {
    GpOp op;   /* of leaves the kind alone */
    int index; /* bits of a number, word of a uniform, component, texture slot */
    GpOperand operand[GP_STEP_OPERANDS];
    int operands;
    GpStepCode code;
    GpPlace at;
    int32_t next_leaf;   /* of the same hash; -1: none */
    int order;           /* the highest order of the texture reads that went into it */
    unsigned live;       /* bit i: component i reaches an output */
    int readers;         /* live instructions, and output registers, that read it */
    int32_t reader;      /* the last that was counted, from 1 on */
    int place, last_use; /* in the schedule; -1: none */
    float value[4][4];   /* of instructions that were stepped: [component][lane] */
} GpNode;

/* An output register: up to four components of the output struct from `first` on. */
typedef struct GpGraphRegister {
    GpPart part[4];
    int parts;
    int first; /* -1: not part of the struct (position, point size, depth) */
} GpGraphRegister;

typedef struct GpGraphWatch {
    const char *name;
    GpOperand value;
} GpGraphWatch;

enum { GP_GRAPH_HASHES = 64 };

typedef struct GpGraph {
    const GpProgram *program;
    bool is_vertex, no_memory;
    /* of steps: computes a node that was just added; NULL: nothing is computed */
    void (*compute)(struct GpGraph *graph, GpNode *node);
    const GpStepRun *run;
    bool software; /* GP_SHADER_SW */
    bool killed[4];
    void *tagged; /* uniforms that tell which they are; owned */
    size_t uniform_bytes;
    GpNode *node;
    int nodes;
    size_t node_room;
    int32_t leaf[GP_GRAPH_HASHES]; /* the newest of each hash; -1: none */
    int32_t *schedule;             /* nodes of live instructions, each after its operands */
    int scheduled;
    GpGraphRegister output[GP_STEP_OUTPUTS];
    int outputs;
    GpGraphWatch *watch;
    int watches;
    size_t watch_room;
    uint8_t named_inputs[GP_SEMANTICS]; /* GpShaderCounts.named_inputs */
} GpGraph;

static inline bool gp_node_is_instruction(const GpNode *node)
{
    return node->op.kind >= GP_NODE_ARITHMETIC;
}

static inline void gp_raise(int *most, int value)
{
    *most = value > *most ? value : *most;
}

bool gp_graph_has_model2(const GpGraph *graph);

enum { GP_GRAPH_INPUTS = 16 }; /* registers that a program can declare for either shader to read */

/* Components of declared register i < GP_GRAPH_INPUTS that the shader reads; 0: it is not
 * declared. */
int gp_graph_input_components(const GpGraph *graph, int i);

/* Adds a node; node 0 without memory. */
int32_t gp_graph_add_node(GpGraph *graph, const GpNode *node);

/* The one node of a leaf. */
GpPart gp_graph_find_leaf(GpGraph *graph, GpNodeKind kind, int index);

/* The operand components that the live components of a node read, one after the other; NULL after
 * the last. at: where the last was found; zero before the first */
typedef struct GpReads {
    int operand, component;
} GpReads;
const GpPart *gp_node_next_read(const GpNode *node, GpReads *at);

/* Marks what reaches an output, or runs in any case. */
void gp_graph_mark_live(GpGraph *graph);

/* Puts live instructions in an order that depends on the graph alone: kills and loops first, then
 * outputs, each after its operands from left to right.
 * returns false without memory */
bool gp_graph_arrange(GpGraph *graph);

/* The values of a component in four lanes, negated where it is, of a graph that is stepped. */
void gp_graph_values(const GpGraph *graph, GpPart part, float value[4]);

/* Records a shader into *graph, of which program, is_vertex and what steps need are set (graph.c).
 * returns false without memory
 * owns   *graph what it holds, to gp_graph_free */
bool gp_graph_record(GpGraph *graph, void (*shader)(void));
void gp_graph_free(GpGraph *graph);

/* Memory ended: ends the program, where that is asked for (gp_call_without_memory); false
 * otherwise. */
bool gp_graph_missed(void);

#endif
