/* What a shader costs and uses, as its counting build finds it. */
#ifndef GP_COUNTS_H
#define GP_COUNTS_H

#include "pipeline/shader/program.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Costs as in CONVENTIONS.md, "Profiles". */
struct GpShaderCounts {
    int slots; /* instruction slots: arithmetic + texture */
    int arithmetic_slots;
    int texture_slots;
    /* four-component registers live at once: an estimate, described with all other figures in
     * pipeline/shader/graph_counts.c */
    int temporaries;
    int constants; /* float4 constants: uniforms read plus literals */
    int inputs;    /* declared inputs or interpolants read */
    int outputs;   /* interpolants (vertex) or colour targets (pixel) written */
    int samplers;  /* distinct texture slots read */
    /* longest chain of texture reads, 0 = no read depends on another or on computed coordinates */
    int dependent_reads;
    uint64_t inputs_read;     /* bit i: component i of the input struct is used */
    uint64_t outputs_written; /* bit i: component i of the varyings or of the targets is written */
    uint16_t sampler_slots;   /* bit i: slot i is read by texld and its kin */
    uint16_t local_slots;     /* bit i: slot i is read by gp_load_local */
    /* 1 + the slot whose texel, read in place, is all that the pixel shader gives, as it is; 0: it
     * does something else */
    int copied_slot;
    /* 1 + the first component of the vertex struct's member that is called as the semantic; 0: none
     * is */
    uint8_t named_inputs[GP_SEMANTICS];
    bool gradients;    /* dsx, dsy or texldd appear */
    bool needs_quads;  /* dsx or dsy */
    bool implicit_lod; /* texld, texldp or texldb appear */
    bool explicit_lod; /* texldl appears */
    bool loops;        /* loop_while appears */
    bool discards, writes_depth, writes_point_size, reads_pixel, reads_face;
};

/* The bit of a slot in them; 0: there is no such slot. */
static inline uint16_t gp_slot_bit(int slot)
{
    return (uint16_t)(slot >= 0 && slot < GP_MAX_SAMPLERS ? 1u << slot : 0);
}

/* What counting a pixel shader tells of it. */
typedef struct GpPixelFacts {
    /* bit i: component i; all where the counting build is not there, or had no memory */
    uint64_t varyings_read;
    int copied_slot; /* GpShaderCounts.copied_slot */
} GpPixelFacts;

/* Takes some microseconds: to be asked once for a program. */
GpPixelFacts gp_pixel_facts(const GpProgram *program);

#ifdef __cplusplus
}
#endif

#endif
