/* What the reference executor keeps for the draw it is in, and how it reports to a trace. */
#ifndef GP_REFERENCE_DRAW_H
#define GP_REFERENCE_DRAW_H

#include "pipeline/list/needs.h"
#include "pipeline/reference/reference.h"
#include "pipeline/reference/waiting.h"
#include "pipeline/units/clip.h"
#include "pipeline/units/depth_stencil.h"
#include "pipeline/units/interpolate.h"
#include "pipeline/units/pixel_stage.h"
#include "pipeline/units/setup.h"
#include "pipeline/units/vertex_stage.h"
#include "pipeline/units/viewport.h"

typedef struct GpReferenceDraw {
    const GpReference *reference;
    const GpPass *pass;
    const GpDraw *draw;
    uint32_t pass_number, draw_number;
    uint32_t width, height; /* of the targets */

    GpNeeds needs;
    GpVaryingModes modes;
    GpViewport viewport; /* resolved */
    GpRect rect;         /* pixels that viewport and targets allow */
    GpGuardBand band;
    GpVertexStage vertex_stage;
    GpPixelStage pixel_stage;
    GpDepthStencil depth_stencil;

    GpVertex *vertices; /* shaded, vertex number first_vertex first */
    uint32_t first_vertex;

    /* the primitive on its way; polygon and corner stay NULL for points */
    uint32_t primitive, stepped; /* stepped: 1 + the one whose vertices' steps were told last */
    uint32_t corner_numbers[3];
    const GpClipPolygon *polygon;
    const GpScreenVertex *corner;
    int part; /* of the polygon's fan */
    GpSetupResult setup_result;
    const GpTriangle *triangle; /* that was set up; NULL: none was */
    GpWaiting *waiting;         /* fragments of the pass, where they are sorted */
    const GpQuad *quad;         /* in the pixel shader; NULL in the vertex shader */
    bool untold;                /* steps of a shader, for want of memory */
} GpReferenceDraw;

/* Whether events of a kind are sent of the draw (GpTrace.without). */
bool gp_trace_sends(const GpReferenceDraw *d, GpTraceKind kind);

/* Whether a quad has a pixel that is told of. */
bool gp_trace_wants_quad(const GpReferenceDraw *d, const GpQuad *quad);

/* One call a unit; each looks at the filter by itself. Where one pixel is watched, the events of
 * vertices, clipping and set-up wait until a quad of the primitive covers it, and then come
 * first. */
void gp_trace_clear(const GpReference *reference, const GpPass *pass, uint32_t pass_number);
void gp_trace_clip(const GpReferenceDraw *d); /* the vertices, then the clipping */
void gp_trace_setup(const GpReferenceDraw *d);
void gp_trace_raster(const GpReferenceDraw *d, const GpQuad *quad);
void gp_trace_interpolate(const GpReferenceDraw *d, const GpQuad *quad);
void gp_trace_texture(const GpReferenceDraw *d, const GpTextureRead *read,
                      const GpSampleReport reports[4]);

/* After the pixel shader ran, and before its quad goes on: runs it again, step by step.
 * in   shaded: as it came out of the shader; before: as it went in */
void gp_trace_steps(GpReferenceDraw *d, const GpQuad *before, const GpQuad *shaded);
void gp_trace_pixel(const GpReferenceDraw *d, const GpQuad *quad, unsigned mask);

/* The same of the vertex shader, for the primitive's corners; once, after the first of its pixels
 * that is wanted was told of. in: quad: NULL: a pixel that the primitive missed was */
void gp_trace_vertex_steps(GpReferenceDraw *d, const GpQuad *quad);

/* Reports one of the tests that only shrink the mask, after it ran: "scissor", "clip plane",
 * "alpha test". */
void gp_trace_test(const GpReferenceDraw *d, const GpQuad *quad, const char *unit,
                   unsigned mask_before);
void gp_trace_sort(const GpReferenceDraw *d, const GpQuad *quad, uint32_t key, uint32_t place,
                   uint32_t count);
void gp_trace_depth_stencil(const GpReferenceDraw *d, const GpQuad *quad, unsigned mask_before);

/* After the store: reads back what is there now; quad->color has what was blended.
 * in   source: [channel][pixel], before blending */
void gp_trace_output(const GpReferenceDraw *d, const GpQuad *quad, int target, float source[4][4]);

/* Where a triangle would have been: its part that was culled, and what near or far plane alone cut
 * away of all of it. For who asks (GpTrace.missed). */
void gp_trace_missed_part(GpReferenceDraw *d);
void gp_trace_missed_clip(GpReferenceDraw *d);

/* What the files of traces share. */
bool gp_trace_wants(const GpReferenceDraw *d, int32_t x, int32_t y);
void gp_trace_send_steps(const GpReferenceDraw *d, int32_t x, int32_t y, const GpTraceSteps *steps);
void gp_trace_send_missed(const GpReferenceDraw *d, int32_t x, int32_t y,
                          const GpTraceMissed *missed);

#endif
