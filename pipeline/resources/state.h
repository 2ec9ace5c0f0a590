/* Fixed-function state of a draw: plain data, all zero = a sensible default.
 *
 * Names and meanings are Direct3D 9's (CONVENTIONS.md, "Pixels"); the value 0 of each enumeration
 * is the unit switched off, so that a draw says only what it uses.
 */
#ifndef GP_STATE_H
#define GP_STATE_H

#include "pipeline/resources/surface.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    GP_MAX_TARGETS = 4,
    GP_MAX_SAMPLERS = 16,
    GP_MAX_CLIP_PLANES = 6,
    GP_MAX_VARYINGS = 40, /* floats: ten interpolants of four */
    GP_MAX_INPUTS = 64,   /* floats: sixteen vertex inputs of four */
};

/* How a new value, on the left, is compared with what is there. The first passes always. */
typedef enum GpCompare {
    GP_ALWAYS = 0,
    GP_NEVER,
    GP_LESS,
    GP_EQUAL,
    GP_LESS_EQUAL,
    GP_GREATER,
    GP_NOT_EQUAL,
    GP_GREATER_EQUAL,
    GP_COMPARES
} GpCompare;

/* Which triangles are left out. */
typedef enum GpCull {
    GP_CULL_NONE = 0,
    GP_CULL_CW,  /* triangles that turn clockwise on the screen, y down: Direct3D's front faces */
    GP_CULL_CCW, /* the others: what Direct3D culls by default */
    GP_CULLS
} GpCull;

/* Which pixels a primitive covers, and its depth. */
typedef struct GpRasterState {
    GpCull cull;
    bool scissor; /* keep only pixels inside [x0, x1) x [y0, y1) */
    int32_t scissor_x0, scissor_y0, scissor_x1, scissor_y1;
    float depth_bias;       /* added to depth, in depth units (Direct3D 9's form, R22) */
    float slope_depth_bias; /* times max(|dz/dx|, |dz/dy|) per pixel; triangles only */
    uint8_t clip_planes;    /* bit i: clip_plane[i] . clip position >= 0 is drawn (R11) */
    float clip_plane[GP_MAX_CLIP_PLANES][4];
} GpRasterState;

/* X = (x + 1) * width * 0.5 + x0 and so on (R17). All zero: the whole target, depth 0 to 1.
 * d3d9_centers puts the centre of pixel (i, j) at (i, j) instead of (i+1/2, j+1/2) (R1). */
typedef struct GpViewport {
    float x, y, width, height;
    float min_depth, max_depth; /* both 0 means 0 and 1, unless has_depth_range */
    bool d3d9_centers;
    bool has_depth_range; /* min_depth and max_depth hold as they are: to say 0 and 0 */
} GpViewport;

/* The depth test. All zero: none, and depth is not written.
 *
 * The ternary test is an extension (CONVENTIONS.md): a fragment in front of the stored depth by
 * more than epsilon replaces what the pixel's targets hold, one within epsilon is blended with it,
 * one behind by more is dropped. It asks for GP_LESS_EQUAL and for write, which stores the nearer
 * depth. */
typedef struct GpDepthState {
    GpCompare test; /* incoming TEST stored */
    bool write;     /* store the depth of fragments that pass; works with GP_ALWAYS too */
    bool ternary;
    float epsilon; /* of the ternary test, in depth units, from 0 on */
} GpDepthState;

/* What becomes of a stencil value. */
typedef enum GpStencilOp {
    GP_STENCIL_KEEP = 0,
    GP_STENCIL_ZERO,
    GP_STENCIL_REPLACE,
    GP_STENCIL_INCR_SAT,
    GP_STENCIL_DECR_SAT,
    GP_STENCIL_INVERT,
    GP_STENCIL_INCR,
    GP_STENCIL_DECR,
    GP_STENCIL_OPS
} GpStencilOp;

/* The stencil test of one facing. */
typedef struct GpStencilFace {
    GpCompare test; /* (ref & ~ignore) TEST (stored & ~ignore) */
    GpStencilOp fail, depth_fail, pass;
} GpStencilFace;

/* The stencil test of both facings. All zero: off. */
typedef struct GpStencilState {
    bool enable;
    bool two_sided;      /* false: `front` serves all; true: `back` serves counter-clockwise ones */
    GpStencilFace front; /* clockwise triangles, and points */
    GpStencilFace back;
    uint8_t reference;
    uint8_t ignore; /* bits that the test does not see (Direct3D's mask, inverted) */
    uint8_t keep;   /* bits that are never written (Direct3D's write mask, inverted) */
} GpStencilState;

/* Alpha of target 0 against a reference; fragments that fail are gone. */
typedef struct GpAlphaTest {
    GpCompare test;    /* alpha of target 0 TEST reference/255; failing kills all targets */
    uint8_t reference; /* 0..255 */
} GpAlphaTest;

/* How the shader's colour and the target's become one. */
typedef enum GpBlendOp {
    GP_BLEND_OFF = 0, /* the shader's colour replaces */
    GP_BLEND_ADD,
    GP_BLEND_SUBTRACT,     /* source - destination */
    GP_BLEND_REV_SUBTRACT, /* destination - source */
    GP_BLEND_MIN,          /* factors ignored */
    GP_BLEND_MAX,
    GP_BLEND_LOGIC_AND, /* OpenGL's logical operations on the stored bits: an extension, since */
    GP_BLEND_LOGIC_OR,  /* Direct3D 9 had none; unorm targets only, colour and alpha alike */
    GP_BLEND_LOGIC_XOR,
    GP_BLEND_OPS
} GpBlendOp;

/* Whether an operation is one of bits. */
static inline bool gp_blend_is_logic(GpBlendOp op)
{
    return op >= GP_BLEND_LOGIC_AND && op <= GP_BLEND_LOGIC_XOR;
}

/* What a side of blending is multiplied with. */
typedef enum GpBlendFactor {
    GP_ZERO = 0,
    GP_ONE,
    GP_SRC_COLOR,
    GP_INV_SRC_COLOR,
    GP_SRC_ALPHA,
    GP_INV_SRC_ALPHA,
    GP_DEST_ALPHA,
    GP_INV_DEST_ALPHA,
    GP_DEST_COLOR,
    GP_INV_DEST_COLOR,
    GP_SRC_ALPHA_SAT, /* (f, f, f, 1), f = min(As, 1 - Ad); source factor only */
    GP_BLEND_CONSTANT,
    GP_INV_BLEND_CONSTANT,
    GP_BLEND_FACTORS
} GpBlendFactor;

/* Blending of one target. All zero: off, and all channels are written. */
typedef struct GpBlend {
    GpBlendOp op; /* colour; and alpha too unless alpha_op says otherwise */
    GpBlendFactor src, dst;
    GpBlendOp alpha_op; /* GP_BLEND_OFF: alpha blends as colour does */
    GpBlendFactor alpha_src, alpha_dst;
    uint8_t keep; /* bit c: channel c (0 red .. 3 alpha) keeps its bits (R37) */
} GpBlend;

/* In which order the fragments of a pixel, of all draws of a pass, come to stencil, depth and
 * blending (an extension: CONVENTIONS.md, Sorted fragments). Equal depths keep the order of
 * submission. */
typedef enum GpOrder {
    GP_ORDER_SUBMITTED = 0, /* draws, and their primitives, one after the other (R35) */
    GP_ORDER_DEPTH,         /* the farthest first: what "over" asks for */
    GP_ORDER_DEPTH_NEAR_FIRST,
    GP_ORDERS
} GpOrder;

/* The fixed functions of a draw. All zero: fragments go straight to the targets. */
typedef struct GpState {
    GpRasterState raster;
    GpDepthState depth;
    GpStencilState stencil;
    GpAlphaTest alpha_test;
    GpBlend blend[GP_MAX_TARGETS];
    float blend_constant[4];
} GpState;

/* --- sampling --------------------------------------------------------------------------------- */

/* How texels of one level are chosen or mixed. */
typedef enum GpFilter { GP_POINT = 0, GP_LINEAR, GP_FILTERS } GpFilter;

/* How levels are chosen or mixed. */
typedef enum GpMipFilter {
    GP_MIP_NONE = 0,
    GP_MIP_POINT,
    GP_MIP_LINEAR,
    GP_MIP_FILTERS
} GpMipFilter;

/* What a coordinate outside [0, 1] reads. */
typedef enum GpAddress {
    GP_WRAP = 0,
    GP_MIRROR,
    GP_CLAMP,
    GP_BORDER,
    GP_MIRROR_ONCE,
    GP_ADDRESSES
} GpAddress;

/* How a texture is read. All zero: the nearest texel of level 0, repeated. */
typedef struct GpSampler {
    GpFilter min, mag;
    GpMipFilter mip;
    GpAddress address_u, address_v;
    float border[4]; /* border[0] is the depth where a depth surface is compared */
    float lod_bias;
    float min_lod;    /* clamp of the level of detail; the finest level allowed */
    float max_lod;    /* 0 means no upper clamp, unless has_max_lod */
    bool compare;     /* depth-compare sampling (R49): returns how much of r <= stored holds */
    bool has_max_lod; /* max_lod holds as it is: to say 0 */
} GpSampler;

/* The upper clamp of the level of detail; infinite where there is none. */
static inline float gp_sampler_max_lod(const GpSampler *sampler)
{
    return sampler->has_max_lod || sampler->max_lod != 0 ? sampler->max_lod : __builtin_inff();
}

/* One texture slot of a draw. Borrowed until the list has run. */
typedef struct GpTexture {
    const GpSurface *surface; /* NULL: unbound */
    GpSampler sampler;
} GpTexture;

/* --- names, for scene files and messages: tables in state.c ----------------------------------- */

/* By value, as scene files have them: "less-equal". */
extern const char *const gp_compare_names[GP_COMPARES];
extern const char *const gp_cull_names[GP_CULLS];
extern const char *const gp_stencil_op_names[GP_STENCIL_OPS];
extern const char *const gp_blend_op_names[GP_BLEND_OPS];
extern const char *const gp_blend_factor_names[GP_BLEND_FACTORS];
extern const char *const gp_order_names[GP_ORDERS];
extern const char *const gp_filter_names[GP_FILTERS];
extern const char *const gp_mip_filter_names[GP_MIP_FILTERS];
extern const char *const gp_address_names[GP_ADDRESSES];

#ifdef __cplusplus
}
#endif

#endif
