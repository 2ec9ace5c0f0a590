/* Voxels of functions: the sign at centres, or at the eight corners of each voxel, which the blend
 * unit puts together: a voxel is of the surface where some corner is inside, and not all of them
 * are. */
#include "apps/techniques/voxel/inputs/implicit.h"

#include "apps/scene/shapes.h"
#include "shaders_c/common/texel_copy.h"
#include "shaders_c/voxel/inputs/field.h"
#include "shaders_c/voxel/inputs/implicit.h"

#include <math.h>
#include <string.h>

_Static_assert((int)VOXEL_FUNCTION_DEGREE == (int)POLYNOMIAL_DEGREE, "one degree");

enum { CORNERS = 8 };

GpResult voxel_function_parse(const char *text, VoxelFunction *function, GpError *error)
{
    static const char quartic[] = "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8 = 0";
    Polynomial polynomial;
    GpResult result =
        polynomial_parse(strcmp(text, "quartic") == 0 ? quartic : text, &polynomial, error);
    if (result == GP_OK)
        *function = (VoxelFunction){ .polynomial = polynomial };
    return result;
}

VoxelBox voxel_box_of_cube(double reach, uint32_t size)
{
    return (VoxelBox){ .size = size,
                       .scale = size / (2 * reach),
                       .offset = { size / 2.0, size / 2.0, size / 2.0 } };
}

/* --- samples ---------------------------------------------------------------------------------- */

/* What the draws of one kind of function need. */
typedef struct Sampling {
    const VoxelFunction *function;
    const VoxelBox *box;
    Frame *frame;
    const FlatTexture *flat;
    GpSurface *field;   /* of a callback */
    FlatTexture layout; /* the field's patches */
} Sampling;

/* Bounds below which samples of a slab are inside; none is past the end. */
static void bound_samples(const FlatTexture *flat, uint32_t slab, float inside[])
{
    for (uint32_t k = 0; k < flat->per_texel; k++)
        inside[k] = slab * flat->per_texel + k < flat->size ? 0 : -INFINITY;
}

/* Draws the samples of a slab at a place in its voxels. */
static GpDraw *draw_polynomial(Sampling *s, uint32_t slab, bool corner, const float place[3])
{
    const double scale = 1 / s->box->scale;
    VoxelImplicitUniforms u = {
        .size = (float)s->flat->size,
        .first = { place[0], place[1], (float)(slab * s->flat->per_texel) + place[2] },
        .scale = (float)scale,
    };
    for (int k = 0; k < 3; k++)
        u.offset[k] = (float)(-s->box->offset[k] * scale);
    bound_samples(s->flat, slab, u.inside);
    for (int i = 0; i < POLYNOMIAL_SIDE; i++)
        for (int j = 0; j < POLYNOMIAL_SIDE; j++)
            for (int k = 0; k < POLYNOMIAL_SIDE; k++)
                u.coefficient[k][j][i] = (float)s->function->polynomial.c[i][j][k];
    return flat_texture_draw(s->frame,
                             corner ? &voxel_implicit_corner_program : &voxel_implicit_program, &u,
                             s->flat, slab);
}

static GpDraw *draw_field(Sampling *s, uint32_t slab, bool corner, const float place[3])
{
    VoxelFieldUniforms u = { .size = (float)s->flat->size,
                             .texel = { 1.0f / (float)s->field->width,
                                        1.0f / (float)s->field->height },
                             .next = corner ? place[2] : 0 };
    bound_samples(s->flat, slab, u.inside);
    for (uint32_t i = 0; i < VOXEL_FIELD_PATCHES; i++) {
        const uint32_t last = s->layout.slabs - 1;
        const uint32_t patch = slab * (s->flat->per_texel / s->layout.per_texel) + i;
        const GpViewport v = flat_texture_patch(&s->layout, patch < last ? patch : last);
        u.origin[i][0] = v.x + (corner ? place[0] : 0);
        u.origin[i][1] = v.y + (corner ? place[1] : 0);
    }
    GpDraw *draw = flat_texture_draw(
        s->frame, corner ? &voxel_field_corner_program : &voxel_field_program, &u, s->flat, slab);
    draw->textures[0].surface = s->field;
    return draw;
}

static GpDraw *draw_samples(Sampling *s, uint32_t slab, bool corner, const float place[3])
{
    return (s->function->evaluate ? draw_field : draw_polynomial)(s, slab, corner, place);
}

/* --- callbacks -------------------------------------------------------------------------------- */

enum { PER_TEXEL = 4 };

/* Patches of a field: as a flat texture's, four samples a texel. */
static GpResult plan_field(uint32_t samples, FlatTexture *layout, GpError *error)
{
    const uint32_t slabs = (samples + PER_TEXEL - 1) / PER_TEXEL, columns = GP_MAX_SIZE / samples;
    const uint32_t rows = (slabs + columns - 1) / columns;
    if (rows * samples > GP_MAX_SIZE)
        return gp_fail(
            error, GP_ERROR_INVALID,
            "%u samples a side of a function: more than a texture of %d x %d texels holds", samples,
            GP_MAX_SIZE, GP_MAX_SIZE);
    *layout = (FlatTexture){ .size = samples,
                             .per_texel = PER_TEXEL,
                             .slabs = slabs,
                             .columns = columns < slabs ? columns : slabs };
    return GP_OK;
}

/* Evaluates one layer of samples, which is one component of a patch.
 * in   place: of the samples in their voxels */
static void fill_layer(const Sampling *s, uint32_t z, float place)
{
    const size_t bytes = PER_TEXEL * sizeof(float);
    const GpViewport patch = flat_texture_patch(&s->layout, z / PER_TEXEL);
    for (uint32_t y = 0; y < s->layout.size; y++) {
        float *texels = (float *)(void *)gp_surface_texel(&s->field->level[0], bytes,
                                                          (uint32_t)patch.x, (uint32_t)patch.y + y);
        for (uint32_t x = 0; x < s->layout.size; x++) {
            const uint32_t voxel[3] = { x, y, z };
            double at[3];
            for (int k = 0; k < 3; k++)
                at[k] = (voxel[k] + (double)place - s->box->offset[k]) / s->box->scale;
            texels[PER_TEXEL * x + z % PER_TEXEL] =
                (float)s->function->evaluate(s->function->user, at);
        }
    }
}

static void fill_field(Sampling *s, float place)
{
    const FlatTexture *layout = &s->layout;
    const uint32_t rows = (layout->slabs + layout->columns - 1) / layout->columns;
    s->field = frame_surface(s->frame, GP_A32B32G32R32F, layout->columns * layout->size,
                             rows * layout->size, 1);
    for (uint32_t z = 0; s->field->level[0].texels && z < layout->size; z++)
        fill_layer(s, z, place);
}

/* --- volumes ---------------------------------------------------------------------------------- */

static void draw_solid(Sampling *s)
{
    static const float centre[3] = { 0.5f, 0.5f, 0.5f };
    flat_texture_pass(s->frame, "inside", s->flat);
    for (uint32_t slab = 0; slab < s->flat->slabs; slab++)
        draw_samples(s, slab, false, centre);
}

static void draw_surface(Sampling *s)
{
    const GpSurface *flat = s->flat->texels;
    GpSurface *all = frame_surface(s->frame, flat->format, flat->width, flat->height, 1);
    GpPass *pass = flat_texture_pass(s->frame, "corners", s->flat);
    pass->color[1] =
        (GpColorTarget){ .surface = all, .clear = true, .clear_color = { 1, 1, 1, 1 } };
    for (uint32_t slab = 0; slab < s->flat->slabs; slab++)
        for (int i = 0; i < CORNERS; i++) {
            const float corner[3] = { (float)(i & 1), (float)(i >> 1 & 1), (float)(i >> 2) };
            GpDraw *draw = draw_samples(s, slab, true, corner);
            draw->state.blend[0].op = GP_BLEND_LOGIC_OR;
            draw->state.blend[1].op = GP_BLEND_LOGIC_AND;
        }
    flat_texture_pass(s->frame, "not all corners", s->flat)->color[0].clear = false;
    for (uint32_t slab = 0; slab < s->flat->slabs; slab++) {
        GpDraw *draw = flat_texture_blend(s->frame, &texel_copy_program, all, GP_BLEND_LOGIC_XOR);
        draw->viewport = flat_texture_patch(s->flat, slab);
    }
}

GpResult voxel_implicit(const VoxelFunction *function, const VoxelBox *box, VoxelKind kind,
                        Frame *frame, const FlatTexture *flat, GpError *error)
{
    GP_ASSERT(flat->bits == 1);
    const bool solid = kind == VOXEL_SOLID;
    Sampling s = { .function = function, .box = box, .frame = frame, .flat = flat };
    if (function->evaluate) {
        GpResult result = plan_field(flat->size + !solid, &s.layout, error);
        if (result)
            return result;
        fill_field(&s, solid ? 0.5f : 0);
    }
    (solid ? draw_solid : draw_surface)(&s);
    return frame_result(frame, error);
}
