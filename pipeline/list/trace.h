/* Traces: what every unit of the reference executor saw and decided.
 *
 * The executor calls back once per unit and object that the filter lets through, in pipeline order.
 * All pointers in an event are valid during the call only.
 */
#ifndef GP_TRACE_H
#define GP_TRACE_H

#include "pipeline/list/list.h"
#include "pipeline/resources/sample_report.h"
#include "pipeline/shader/steps.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which unit tells, or of what. */
typedef enum GpTraceKind {
    GP_TRACE_CLEAR,       /* a target's pixel was cleared */
    GP_TRACE_VERTEX,      /* one vertex was shaded */
    GP_TRACE_CLIP,        /* one triangle met the clip volume */
    GP_TRACE_SETUP,       /* one triangle (after clipping) was set up or culled */
    GP_TRACE_RASTER,      /* a pixel was covered */
    GP_TRACE_INTERPOLATE, /* its depth and interpolants */
    GP_TRACE_TEXTURE,     /* one texture read of its shader */
    /* every instruction of its shader; where GpTrace.steps is set. Those of the vertex shader come
     * after the first pixel of a primitive, one event a corner */
    GP_TRACE_STEPS,
    GP_TRACE_PIXEL, /* what its shader returned */
    /* its turn among the pixel's, in a pass with an order; of a pass's fragments these come last,
     * each with what follows of its own */
    GP_TRACE_SORT,
    /* scissor, alpha test, stencil, depth: one event each, in that order; clip planes before
     * GP_TRACE_INTERPOLATE */
    GP_TRACE_TEST,
    GP_TRACE_OUTPUT, /* blending and the stored value, one event per target */
    /* a triangle that was culled or clipped would have covered the pixel; where GpTrace.missed is
     * set. Its vertices, clipping and set-up follow where one pixel is watched */
    GP_TRACE_MISSED,
    GP_TRACE_KINDS
} GpTraceKind;

/* By value: "raster". */
extern const char *const gp_trace_kind_names[GP_TRACE_KINDS];

/* A pass clears its targets. */
typedef struct GpTraceClear {
    const GpPass *pass; /* its targets say what was cleared, and to which values */
} GpTraceClear;

/* What the vertex shader was given and gave. */
typedef struct GpTraceVertex {
    uint32_t vertex;
    int input_components, varying_components;
    const float *inputs, *varyings;
    float clip[4]; /* clip-space position */
} GpTraceVertex;

enum { GP_TRACE_CORNERS = 9 }; /* at most, of what is left of a clipped triangle */

/* How a triangle lies in the clip volume, and what is left of it. */
typedef struct GpTraceClip {
    float clip[3][4];
    /* bit i: some vertex is outside plane i: left right bottom top (guard band) near far */
    unsigned planes;
    int corners; /* of the polygon that is left; 0: nothing; 3: untouched or cut to a triangle */
    float corner[GP_TRACE_CORNERS][4]; /* these, in clip space */
    float band[4]; /* left right bottom top of the guard band: limits of x/w and y/w */
} GpTraceClip;

/* A triangle on the screen, or why it is not there. */
typedef struct GpTraceSetup {
    int part;           /* of the fan that clipping left, from 0 */
    float place[3][2];  /* x, y in pixels, before they are snapped */
    int32_t x[3], y[3]; /* 24.8 fixed point */
    float z[3], rw[3];  /* depth, 1/w */
    int64_t area2;      /* twice the signed area in 1/65536 pixels; > 0 is clockwise, y down */
    bool culled;
    const char *reason; /* NULL, or why it draws nothing: "facing", "zero area", ... */

    /* unless culled: E_i = a x + b y + c in sub-pixels, opposite corner i, positive inside; and
     * whether a centre on it is inside, since it is a top or a left edge (R5) */
    int64_t a[3], b[3], c[3];
    bool accepts_zero[3]; /* of each edge */
} GpTraceSetup;

/* How a covered pixel lies in its triangle. */
typedef struct GpTraceRaster {
    /* edge functions opposite the three vertices, in the order in which they were submitted; at the
     * centre, in 1/65536 pixels; their sum is |area2| */
    int64_t edge[3];
    bool front; /* clockwise */
} GpTraceRaster;

/* What a pixel gets of its triangle's corners. */
typedef struct GpTraceInterpolate {
    float barycentric[3]; /* perspective-correct shares of the vertices, in submitted order */
    float depth;
    int components;
    const float *varyings;

    /* the same, had it been linear on the screen */
    float screen[3];
    const float *screen_varyings;

    /* the quad that the pixel is in, whose differences are derivatives */
    unsigned mask; /* bit i: pixel i (0 left top, 1 right top, 2, 3 below) is alive; others help */
    const float *quad; /* [component][pixel] */
} GpTraceInterpolate;

/* A texture read, and the texels that went into it. */
typedef struct GpTraceTexture {
    int slot;
    const GpSurface *surface;
    float coord[4];
    GpSampleReport report;
    float texel[4];
} GpTraceTexture;

/* Every instruction of a shader, as it was run again for a quad, or a primitive's vertices. */
typedef struct GpTraceSteps {
    bool of_vertex;
    int lane; /* of the values: the pixel of the quad, or the corner */
    const GpShaderStep *step;
    int steps;
    const GpStepOutput *output;
    int outputs;
    const GpStepWatch *watch;
    int watches;
    bool agrees; /* what the steps give has the bits that were drawn with */
} GpTraceSteps;

/* What the pixel shader gave. */
typedef struct GpTracePixel {
    int targets;
    float color[GP_MAX_TARGETS][4];
    float depth; /* not yet clamped to the viewport (R18) */
    bool killed;
} GpTracePixel;

/* A fragment's turn in a pass with an order. */
typedef struct GpTraceSort {
    GpOrder order;
    uint32_t place, count; /* of the pixel's fragments, from 0 */
    float depth;           /* by which it was sorted: clamped to the viewport's */
} GpTraceSort;

/* One test of a fragment. */
typedef struct GpTraceTest {
    const char *unit; /* "scissor", "clip plane", "alpha test", "stencil", "depth" */
    GpCompare compare;
    double incoming, stored;             /* the two operands */
    uint32_t incoming_code, stored_code; /* depth only: the codes that are compared (R21) */
    bool passed;
    bool ternary, replaced;                /* depth only: what passes replaces, or else is added */
    double epsilon;                        /* of the ternary test */
    int32_t stencil_before, stencil_after; /* -1 without stencil */
} GpTraceTest;

/* What the ternary test says: "replaced", "added" or "dropped". */
const char *gp_trace_ternary(const GpTraceTest *test);

/* How a fragment met what the target held. */
typedef struct GpTraceOutput {
    int target;
    const GpSurface *surface;
    GpBlend blend;
    float source[4], destination[4]; /* as blended */
    float factor[2][4];              /* of source and destination; 0 where the operation has none */
    float blended[4];                /* before it is rounded to the format */
    float result[4];                 /* as read back after the store */
} GpTraceOutput;

/* Why a triangle is not at a pixel. */
typedef struct GpTraceMissed {
    const char *reason; /* "facing"; "near plane", "far plane" where only that cut it away */
    bool front;         /* clockwise */
    bool has_depth;
    float depth; /* that it would have had */
} GpTraceMissed;

/* One thing that a unit did; `kind` says which member of the union holds. */
typedef struct GpTraceEvent {
    GpTraceKind kind;
    uint32_t pass, draw, primitive;
    const char *pass_name, *draw_name, *program_name;
    int32_t x, y; /* the pixel; -1 where the event is not about one */
    union {
        GpTraceClear clear;
        GpTraceVertex vertex;
        GpTraceClip clip;
        GpTraceSetup setup;
        GpTraceRaster raster;
        GpTraceInterpolate interpolate;
        GpTraceTexture texture;
        GpTracePixel pixel;
        GpTraceSort sort;
        GpTraceTest test;
        GpTraceOutput output;
        GpTraceSteps steps;
        GpTraceMissed missed;
    };
} GpTraceEvent;

/* A filter and where to report. The zero filter reports nothing; set the `any_` flags or numbers.
 * owns nothing; event must not run the device */
typedef struct GpTrace {
    void (*event)(void *user, const GpTraceEvent *event);
    void *user;
    /* only the pixel x, y; vertex, clip and setup events then come for triangles that cover it */
    bool one_pixel;
    int32_t x, y;
    bool one_pass, one_draw, one_primitive;
    uint32_t pass, draw, primitive;
    bool steps, missed; /* GP_TRACE_STEPS and GP_TRACE_MISSED are sent too */
    /* Of which pixels events are sent; those of vertices, clipping and set-up come all the same.
     * NULL: of all */
    bool (*wants)(void *user, int32_t x, int32_t y);
    bool (*wants_steps)(void *user); /* whether steps are, from now on; NULL: always */
    uint32_t without;                /* kinds that are not sent, 1 << GP_TRACE_VERTEX and so on */
    /* On a device of the fast executor, which wants it there: the units draw only quads of 2x2
     * pixels that have one which is told of, and the executor everything. The same events as of the
     * reference executor, much sooner where pixels are few */
    bool only_wanted;
} GpTrace;

#ifdef __cplusplus
}
#endif

#endif
