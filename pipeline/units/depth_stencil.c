/* Depth and stencil test: stored codes are compared, then written.
 * in: depths of a quad, its facing, the state and the surface; out: the quad's mask, and the
 * surface. Rules R18, R21, R38, R39. */
#include "pipeline/units/depth_stencil.h"

#include "pipeline/resources/compare.h"

uint8_t gp_stencil_apply(GpStencilOp op, uint8_t stored, uint8_t reference)
{
    switch (op) {
    case GP_STENCIL_ZERO:
        return 0;
    case GP_STENCIL_REPLACE:
        return reference;
    case GP_STENCIL_INCR_SAT:
        return stored == 255 ? 255 : (uint8_t)(stored + 1);
    case GP_STENCIL_DECR_SAT:
        return stored == 0 ? 0 : (uint8_t)(stored - 1);
    case GP_STENCIL_INVERT:
        return (uint8_t)~stored;
    case GP_STENCIL_INCR:
        return (uint8_t)(stored + 1);
    case GP_STENCIL_DECR:
        return (uint8_t)(stored - 1);
    default:
        return stored;
    }
}

uint32_t gp_depth_put_back(GpFormat format, uint32_t code, float epsilon)
{
    if (format != GP_D32F)
        return code + gp_depth_code(format, epsilon);
    return gp_float_bits(gp_canonical(gp_bits_float(code) + epsilon));
}

/* What the depth test says of a pixel. */
typedef struct Verdict {
    bool passed, replaced;
    uint32_t written; /* the code that is stored where it passes */
} Verdict;

static Verdict test_depth(const GpDepthStencil *unit, uint32_t incoming, uint32_t stored)
{
    const GpFormat format = unit->surface->format;
    const GpDepthState *depth = &unit->depth;
    if (!depth->ternary)
        return (Verdict){ .passed = gp_compare_codes(depth->test, incoming, stored),
                          .written = incoming };
    return (Verdict){ .passed = incoming <= gp_depth_put_back(format, stored, depth->epsilon),
                      .replaced = gp_depth_put_back(format, incoming, depth->epsilon) < stored,
                      .written = incoming < stored ? incoming : stored };
}

static void test_pixel(const GpDepthStencil *unit, const GpStencilFace *face, GpQuad *quad,
                       int pixel)
{
    const GpSurface *surface = unit->surface;
    uint8_t *texel =
        gp_surface_texel(&surface->level[0], gp_format_info(surface->format)->bytes,
                         (uint32_t)(quad->x + pixel % 2), (uint32_t)(quad->y + pixel / 2));
    uint32_t stored_depth;
    uint8_t stored_stencil;
    gp_depth_load(surface->format, texel, &stored_depth, &stored_stencil);

    float depth = quad->depth[pixel];
    depth = depth < unit->min_depth   ? unit->min_depth
            : depth > unit->max_depth ? unit->max_depth
                                      : depth;
    uint32_t incoming = gp_depth_code(surface->format, depth);

    uint8_t seen = (uint8_t)~unit->stencil.ignore;
    bool stencil_passed = !face || gp_compare_codes(face->test, unit->stencil.reference & seen,
                                                    stored_stencil & seen);
    const Verdict verdict = test_depth(unit, incoming, stored_depth);

    uint8_t stencil = stored_stencil;
    if (face) {
        GpStencilOp op = !stencil_passed   ? face->fail
                         : !verdict.passed ? face->depth_fail
                                           : face->pass;
        uint8_t result = gp_stencil_apply(op, stored_stencil, unit->stencil.reference);
        uint8_t keep = unit->stencil.keep;
        stencil = (uint8_t)((stored_stencil & keep) | (result & ~keep));
    }
    bool passed = stencil_passed && verdict.passed;
    gp_depth_store(surface->format, texel,
                   passed && unit->depth.write ? verdict.written : stored_depth, stencil);

    quad->depth_incoming[pixel] = incoming;
    quad->depth_stored[pixel] = stored_depth;
    quad->stencil_before[pixel] = stored_stencil;
    quad->stencil_after[pixel] = stencil;
    quad->stencil_passed |= (unsigned)stencil_passed << pixel;
    quad->depth_passed |= (unsigned)verdict.passed << pixel;
    quad->replaced |= (unsigned)(passed && verdict.replaced) << pixel;
    if (!passed)
        quad->mask &= ~(1u << pixel);
}

void gp_depth_stencil(const GpDepthStencil *unit, GpQuad *quad)
{
    const GpStencilState *stencil = &unit->stencil;
    const GpStencilFace *face = !stencil->enable                     ? NULL
                                : stencil->two_sided && !quad->front ? &stencil->back
                                                                     : &stencil->front;
    quad->stencil_passed = quad->depth_passed = quad->replaced = 0;
    for (int pixel = 0; unit->surface && pixel < 4; pixel++)
        if (quad->mask >> pixel & 1)
            test_pixel(unit, face, quad, pixel);
}
