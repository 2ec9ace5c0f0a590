#include "apps/bench/operations.h"

#include "pipeline/list/needs.h"
#include "pipeline/shader/counts.h"
#include "pipeline/shader/steps.h"

/* --- shaders ---------------------------------------------------------------------------------- */

enum { QUAD = 4 };

/* Operations of one component of a result, least of all that would do; of dot products, of all of
 * it. */
static double operations_of(const GpShaderStep *step)
{
    switch (step->code) {
    case GP_STEP_MAD:
    case GP_STEP_SLT: /* a comparison and a selection */
    case GP_STEP_SGE:
    case GP_STEP_CMP:
    case GP_STEP_SAT:
    case GP_STEP_FRC:
        return 2 * step->width;
    case GP_STEP_LRP:
    case GP_STEP_CRS:
        return 3 * step->width;
    case GP_STEP_DP2:
        return 3;
    case GP_STEP_DP2ADD:
        return 4;
    case GP_STEP_DP3:
        return 5;
    case GP_STEP_DP4:
    case GP_STEP_ROW:
        return 7;
    case GP_STEP_RSQ:
        return 2;
    case GP_STEP_NRM: /* a dot product, a root, a division, products */
        return 5 + 2 + step->width;
    case GP_STEP_EXP: /* a polynomial of binary32, at the least */
    case GP_STEP_LOG:
    case GP_STEP_SIN:
    case GP_STEP_COS:
        return 10 * step->width;
    case GP_STEP_POW:
    case GP_STEP_SINCOS:
        return 20 * step->width;
    case GP_STEP_LOOP:
        return 1;
    case GP_STEP_LOCAL:
        return 0;
    default:
        return step->width;
    }
}

static void add_step(void *user, const GpShaderStep *step)
{
    *(double *)user += operations_of(step);
}

static void take_output(void *user, const GpStepOutput *output)
{
    (void)user;
    (void)output;
}

static void read_nothing(const GpShaderCall *call, const GpTextureRead *read)
{
    (void)call;
    for (int i = 0; i < 4 * QUAD; i++)
        read->texel[i] = 0.5f;
}

static void read_no_pixel(const GpShaderCall *call, int slot, int packet, int lanes, float *texel)
{
    (void)call, (void)slot, (void)packet;
    for (int i = 0; i < 4 * lanes; i++)
        texel[i] = 0.5f;
}

/* What shaders read and write, of one quad; inputs are the numbers 1/2. */
typedef struct Quad {
    _Alignas(64) float in[GP_MAX_VARYINGS * QUAD];
    _Alignas(64) float position[4 * QUAD], varying[GP_MAX_VARYINGS * QUAD], size[QUAD];
    _Alignas(64) float pixel[2 * QUAD], face[QUAD], color[GP_MAX_TARGETS * 4 * QUAD], depth[QUAD];
    _Alignas(64) int32_t killed[QUAD];
} Quad;

static double shader_operations(const GpDraw *draw, bool vertex)
{
    double sum = 0;
    Quad quad = { .face = { 1, 1, 1, 1 } };
    for (size_t i = 0; i < GP_COUNT(quad.in); i++)
        quad.in[i] = 0.5f;
    const GpShaderCall call = { .uniforms = draw->uniforms,
                                .packets = 1,
                                .in = quad.in,
                                .textures = draw->textures,
                                .read_texture = read_nothing,
                                .read_local = read_no_pixel,
                                .position = quad.position,
                                .varying = quad.varying,
                                .point_size = quad.size,
                                .pixel = quad.pixel,
                                .face = quad.face,
                                .color = quad.color,
                                .depth = quad.depth,
                                .killed = quad.killed };
    gp_program_steps(draw->program, vertex, &call,
                     &(GpStepListener){ .step = add_step, .output = take_output, .user = &sum });
    return sum;
}

/* --- fixed units ------------------------------------------------------------------------------ */

enum {
    WEIGHTS = 9,        /* two edges, their shares of the area, one division */
    PERSPECTIVE = 4,    /* 1/w, and a product each */
    COMPONENT = 4,      /* v0 + (s1 d1 + s2 d2) (R16) */
    DEPTH_AND_TEST = 6, /* the same in binary64, a comparison, a selection */
    TEXEL = 8,          /* two addresses, of the nearest texel */
};

static double interpolation(const GpDraw *draw, const GpNeeds *needs)
{
    double sum = 0;
    bool perspective = false;
    int first = 0;
    for (size_t i = 0; i < GP_COUNT(draw->program->varyings); i++) {
        const GpVaryingDecl *varying = &draw->program->varyings[i];
        const uint64_t all = ((uint64_t)1 << varying->components) - 1;
        const int read = __builtin_popcountll(needs->varyings >> first & all);
        first += varying->components;
        if (varying->mode == GP_FLAT || !read)
            continue;
        sum += COMPONENT * read;
        perspective |= varying->mode == GP_PERSPECTIVE;
    }
    return sum > 0 ? WEIGHTS + (perspective ? PERSPECTIVE : 0) + sum : 0;
}

/* What multiplying by a factor takes. */
static double factor(GpBlendFactor name)
{
    const bool inverse = name == GP_INV_SRC_COLOR || name == GP_INV_SRC_ALPHA ||
                         name == GP_INV_DEST_COLOR || name == GP_INV_DEST_ALPHA;
    return name == GP_ONE || name == GP_ZERO ? 0 : inverse ? 2 : 1;
}

/* Blending, and the rounding to what is stored and back. */
static double output(const GpPass *pass, const GpDraw *draw)
{
    double sum = 0;
    for (int t = 0; t < gp_program_targets(draw->program) && pass->color[t].surface; t++) {
        const GpBlend *blend = &draw->state.blend[t];
        const GpFormatInfo *format = gp_format_info(pass->color[t].surface->format);
        const double store = format->is_unorm8 ? 3 : 1; /* clamp, scale, round */
        const double weigh = factor(blend->src) + factor(blend->dst) + 1;
        const bool reads = blend->op != GP_BLEND_OFF;
        sum += format->channels * (store + (reads ? weigh + 1 : 0));
    }
    return sum;
}

DrawOperations draw_operations(const GpPass *pass, const GpDraw *draw)
{
    const GpNeeds needs = gp_draw_needs(pass, draw, gp_pixel_facts(draw->program).varyings_read);
    DrawOperations operations = { .vertex = shader_operations(draw, true) };
    if (!needs.pixel_shader)
        return operations;
    operations.fragment = shader_operations(draw, false) + interpolation(draw, &needs);
    if (needs.depth)
        operations.fragment += DEPTH_AND_TEST;
    if (needs.textures)
        operations.fragment += TEXEL * __builtin_popcount(draw->program->samplers);
    if (needs.color)
        operations.fragment += output(pass, draw);
    return operations;
}
