/* Programs: a vertex and a pixel shader, compiled for lanes, with what they declare.
 *
 * A shader source (written with <glasspipe/shader.h>) is compiled once for each lane width; each
 * time it yields a GpProgramCode, and the narrowest also yields the GpProgram that users name. The
 * wider ones and the counting one are weak references, so a program that was compiled once, with no
 * special flags, runs too. Executors call code through the two function types below, a block of
 * packets at a time; a packet is `lanes` vertices, or pixels of lanes/4 whole 2x2 quads.
 */
#ifndef GP_PROGRAM_H
#define GP_PROGRAM_H

#include "pipeline/resources/geometry.h"
#include "pipeline/resources/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a shader may be: the shader models of the time, and those without limits of number. */
typedef enum GpProfile {
    GP_PROFILE_NONE = 0, /* nothing declared: treated as the _sw profile */
    GP_VS_2_0,
    GP_VS_3_0,
    GP_VS_2_SW,
    GP_VS_3_SW,
    GP_PS_2_0,
    GP_PS_2_A,
    GP_PS_2_B,
    GP_PS_3_0,
    GP_PS_2_SW,
    GP_PS_3_SW,
    GP_PROFILES
} GpProfile;

/* How a varying goes from corners to pixels. */
typedef enum GpInterpolation {
    GP_PERSPECTIVE = 0, /* a/w linear, divided by 1/w (R16) */
    GP_LINEAR_SCREEN,   /* linear on the screen */
    GP_FLAT,            /* the value of the triangle's first vertex */
    /* of points: 0..1 over the square, x and y, whatever the vertex shader wrote; of triangles as
     * GP_PERSPECTIVE. One varying of two components (R12) */
    GP_SPRITE_COORD,
    GP_INTERPOLATIONS
} GpInterpolation;

/* One input of the vertex struct. */
typedef struct GpInputDecl {
    GpSemantic semantic;
    uint8_t components; /* 1..4 */
} GpInputDecl;

/* One varying of the varying struct. */
typedef struct GpVaryingDecl {
    const char *name;
    uint8_t components; /* 1..4; 0 ends the list */
    GpInterpolation mode;
} GpVaryingDecl;

/* --- the calls -------------------------------------------------------------------------------- */

/* How a texture read chooses its level of detail. */
typedef enum GpLodMode {
    GP_LOD_IMPLICIT, /* texld, texldp: from the differences inside each quad */
    GP_LOD_BIAS,     /* texldb: the same plus coordinate w */
    GP_LOD_EXPLICIT, /* texldl: coordinate w */
    GP_LOD_GRADIENT, /* texldd: from the given derivatives */
} GpLodMode;

/* Texture reads of one packet.
 * in   coord: [4][lanes], u v r w; gradient: [4][lanes] du/dx dv/dx du/dy dv/dy in texture space,
 *      only for GP_LOD_GRADIENT
 * out  texel: [4][lanes], r g b a */
typedef struct GpTextureRead {
    int slot, lanes;
    GpLodMode mode;
    const float *coord, *gradient;
    float *texel;
} GpTextureRead;

struct GpShaderCall;

/* Serves the texture reads of one packet. */
typedef void (*GpTextureFn)(const struct GpShaderCall *call, const GpTextureRead *read);

/* Reads of the pixel's own position in a surface bound to `slot` (gp_load_local), for one packet:
 * texel[4][lanes]. */
typedef void (*GpLocalFn)(const struct GpShaderCall *call, int slot, int packet, int lanes,
                          float *texel);

/* What a shader did, as it tells who asks. */
typedef enum GpShaderUse {
    GP_USED_DISCARD = 1 << 0,     /* discard or texkill */
    GP_USED_DEPTH = 1 << 1,       /* odepth */
    GP_USED_PIXEL = 1 << 2,       /* vpos */
    GP_USED_FACE = 1 << 3,        /* vface */
    GP_USED_DERIVATIVES = 1 << 4, /* dsx or dsy */
    GP_USED_FUSED = 1 << 5, /* its code rounds a * b + c once: compiled with contraction (R50) */
} GpShaderUse;

/* The varyings of one triangle, for pixel shaders that interpolate them packet by packet:
 * value[c][0] + (weight[0][p] value[c][1] + weight[1][p] value[c][2]), as CONVENTIONS.md has it. */
typedef struct GpInterpolants {
    const float *value; /* [component][3][lanes]: at the first corner, and how the others differ */
    const float *weight[2]; /* [packet][lanes]: of the other corners */
} GpInterpolants;

/* Pixel shaders of so few components of varyings can be called with interpolants. */
enum { GP_FEW_COMPONENTS = 4 };

/* One call: `packets` packets in a row. Arrays are [packet][component][lanes] floats, aligned to
 * a lane vector; the components are those of the shader's own structs, in order.
 * owns everything belongs to the caller; the shader reads and writes, and keeps nothing */
typedef struct GpShaderCall {
    const void *uniforms;
    int packets;
    const float *in;           /* vertex inputs or varyings */
    const GpTexture *textures; /* GP_MAX_SAMPLERS slots */
    GpTextureFn read_texture;
    GpLocalFn read_local; /* pixel shaders only */
    void *executor;       /* for read_texture */
    void *local;          /* for read_local */

    /* vertex shader: out */
    float *position;   /* [packet][4][lanes], clip space */
    float *varying;    /* NULL: positions and sizes only */
    float *point_size; /* [packet][lanes], pixels; NULL unless the program writes it */

    /* pixel shader: in */
    const GpInterpolants *interpolants; /* of each layer, in place of `in`; or NULL */
    int layers; /* with interpolants: parts of the packets, of equal length, on the same pixels */
    const float *pixel; /* [packet][2][lanes], x y of the pixel (vPos); NULL unless used */
    const float *face;  /* [packet][lanes], +1 clockwise (front), -1; NULL unless used */
    /* pixel shader: out */
    float *color;    /* [packet][target][4][lanes] */
    float *depth;    /* [packet][lanes]; NULL unless the program writes depth */
    int32_t *killed; /* [packet][lanes], -1 killed; NULL unless the program may discard */

    uint32_t *used; /* out: bits of GpShaderUse are added; NULL: nobody asks */
} GpShaderCall;

/* A shader: runs one call. */
typedef void (*GpShaderFn)(const GpShaderCall *call);

/* A program's shaders, compiled for one width of lanes. */
typedef struct GpProgramCode {
    int lanes;
    const char *isa; /* "sse2", "avx2", "avx512", "neon", "generic" */
    GpShaderFn vertex, pixel;
} GpProgramCode;

/* What the counting build of a shader reports: pipeline/shader/counts.h. */
typedef struct GpShaderCounts GpShaderCounts;

typedef struct GpProgram GpProgram;

/* Runs the counting build of a program once, by its profiles, inputs and varyings; vertex and pixel
 * may be NULL.
 * returns false where memory ran out */
typedef bool (*GpCountFn)(const GpProgram *program, GpShaderCounts *vertex, GpShaderCounts *pixel);

struct GpStepRun;

/* Runs a shader of the counting build step by step: gp_program_steps (pipeline/shader/steps.h)
 * calls it.
 * returns false where memory ran out */
typedef bool (*GpStepFn)(const GpProgram *program, bool vertex, const struct GpStepRun *run);

enum { GP_CODE_WIDTHS = 3 }; /* lanes 4, 8, 16 */

/* What a program declares, and its code. All that the shaders use must be declared: what is not
 * is refused before the first pixel, with the field's name. */
struct GpProgram {
    const char *name;
    GpProfile vertex_profile, pixel_profile;
    GpInputDecl inputs[16];     /* in the order of the vertex struct; components 0 ends */
    GpVaryingDecl varyings[10]; /* in the order of the varying struct; components 0 ends */
    uint16_t samplers;          /* bit i: slot i is read by texld and its kin */
    uint16_t vertex_samplers;   /* bit i: slot i is read by the vertex shader */
    uint16_t local_reads;       /* bit i: slot i is read by load_local only */
    bool may_discard;           /* texkill or discard appears */
    bool writes_depth;          /* oDepth is written */
    bool writes_point_size;     /* oPts is written */
    bool uses_pixel;            /* vPos is read */
    bool uses_face;             /* vFace is read */
    /* dsx or dsy: the shader needs whole 2x2 quads (levels of detail ask for them where a texture
     * has levels) */
    bool uses_derivatives;

    /* filled in by the program() macro */
    size_t uniform_bytes;
    uint8_t input_components, varying_components, pixel_input_components, color_components;
    const GpProgramCode *code[GP_CODE_WIDTHS]; /* by width 4, 8, 16; NULL where not compiled */
    GpCountFn count;                           /* NULL where the counting build is absent */
    GpStepFn step;                             /* likewise */
};

/* Colour targets that a program writes. */
static inline int gp_program_targets(const GpProgram *program)
{
    return program->color_components / 4;
}

/* Place of a width (4, 8 or 16 lanes) in arrays of GP_CODE_WIDTHS. */
static inline int gp_code_width(int lanes)
{
    return lanes == 4 ? 0 : lanes == 8 ? 1 : 2;
}

/* The code of a width, or NULL. lanes: 4, 8 or 16. */
static inline const GpProgramCode *gp_program_code(const GpProgram *program, int lanes)
{
    return program->code[gp_code_width(lanes)];
}

/* Checks a program against itself and, where it was counted, its shaders against what it declares
 * and against their profiles: names, component sums, undeclared texture slots, discards
 * and the like, varyings read but never written; slots, temporaries, constants, samplers, dependent
 * reads, features. A profile that is not declared sets no limits.
 * errors GP_ERROR_MEMORY; GP_ERROR_INVALID, "program lava_program, ps_2_0: 101 slots, at most 96;
 *        ps_2_sw has no such limit" */
GpResult gp_program_check(const GpProgram *program, GpError *error);

/* Checks the code of one width against what the program declares, by running it: a few packets of
 * made-up vertices and pixels tell what it reads and writes, since shaders do not branch on what a
 * lane holds. So a program that was never counted is held to its declarations too. Takes some
 * microseconds: to be asked once for a program.
 * in   program: passed gp_program_check; code: one of its own, which this processor runs; uniforms:
 *      of a draw that is to be run
 * errors GP_ERROR_INVALID, "program lava_program: slot 3 is read, but not declared in samplers" */
GpResult gp_program_try(const GpProgram *program, const GpProgramCode *code, const void *uniforms,
                        GpError *error);

/* Name of a profile as Direct3D writes it ("ps_2_0"). */
const char *gp_profile_name(GpProfile profile);

#ifdef __cplusplus
}
#endif

#endif
