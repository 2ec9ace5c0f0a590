/* Pixel stage: runs the pixel shader on a quad. */
#ifndef GP_PIXEL_STAGE_H
#define GP_PIXEL_STAGE_H

#include "pipeline/resources/packet.h"
#include "pipeline/shader/steps.h"

typedef struct GpPixelStage {
    const GpProgram *program;
    const GpProgramCode *code;
    const void *uniforms;
    const GpTexture *textures;
    GpTextureFn read_texture;
    GpLocalFn read_local;
    void *executor; /* for read_texture */
} GpPixelStage;

/* Shades all four pixels of a quad, helpers too.
 * in   quad: x, y, front, varying
 * out  quad->color of the targets that the program writes; quad->depth where it writes depth;
 *      quad->killed. The mask is left to the caller.
 * note on code wider than four lanes the quad is repeated to fill them: same bits, more work */
void gp_shade_quad(const GpPixelStage *stage, GpQuad *quad);

/* The same step by step, for who listens (gp_program_steps).
 * returns false, and leaves the quad alone, where the program has no counting build, or memory is
 *      short */
bool gp_step_quad(const GpPixelStage *stage, const GpStepListener *listener, GpQuad *quad);

#endif
