/* What a draw needs: which hardware units have work, so that nothing else runs. */
#ifndef GP_NEEDS_H
#define GP_NEEDS_H

#include "pipeline/list/list.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The units that a draw needs; all false: none. */
typedef struct GpNeeds {
    bool pixel_shader; /* a colour is written, or the shader may discard or write depth */
    bool color;        /* some colour target keeps some channel written */
    bool interpolate;  /* the pixel shader reads an interpolant */
    /* bit i: component i of the varyings is read by the pixel shader; all of them where the program
     * was not counted */
    uint64_t varyings;
    bool quads; /* whole 2x2 quads with helper pixels: derivatives or mip levels */
    bool depth; /* interpolated depth is needed at all */
    bool depth_test, ternary, depth_write, stencil, alpha_test, discard, shader_depth;
    bool blend; /* some target is read before it is written */
    bool scissor, cull, depth_bias;
    uint8_t clip_planes; /* user planes in use */
    bool vertex_textures, textures, local_reads;
    bool late_depth; /* depth and stencil must wait for the pixel shader */
    bool sorted;     /* fragments wait for all others of their pixel (GpPass.order) */
} GpNeeds;

/* The needs of a draw in its pass; both already checked.
 * in   varyings_read: of the draw's program, as gp_pixel_facts (pipeline/shader/counts.h) has
 *      them */
GpNeeds gp_draw_needs(const GpPass *pass, const GpDraw *draw, uint64_t varyings_read);

/* What becomes of one unit. The texts are constants. */
typedef struct GpUnitNeed {
    const char *unit; /* "blending" */
    bool runs;
    const char *why; /* it runs, or not: "no target is read" */
} GpUnitNeed;

enum { GP_UNIT_NEEDS = 19 };

/* The needs in words, a row for each unit, in the order of the pipeline. */
void gp_needs_explain(const GpNeeds *needs, GpUnitNeed rows[GP_UNIT_NEEDS]);

#ifdef __cplusplus
}
#endif

#endif
