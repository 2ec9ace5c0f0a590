/* C leaves the order of arguments and of initialisers open, so every number is drawn in a statement
 * of its own: otherwise a seed would mean other scenes to other compilers. */
#include "tests/support/random_list.h"

#include "tests/support/random.h"
#include "tests/support/random_geometry.h"

#include <string.h>

/* --- surfaces --------------------------------------------------------------------------------- */

static const GpFormat color_formats[] = { GP_A8R8G8B8,      GP_R8,   GP_G16R16F,
                                          GP_A16B16G16R16F, GP_R32F, GP_A32B32G32R32F };
static const GpFormat depth_formats[] = { GP_D16, GP_D24S8, GP_D32F };

static GpSurface *add_surface(RandomList *random, GpFormat format, uint32_t width, uint32_t height,
                              uint32_t levels)
{
    GpSurface *surface = NULL;
    GpSurfaceDesc desc = { .format = format, .width = width, .height = height, .levels = levels };
    if (gp_surface_create(&desc, &surface, NULL))
        return NULL;
    random->surfaces[random->surface_count++] = surface;
    return surface;
}

static GpSurface *add_texture(RandomList *random, Random *r)
{
    static const GpFormat formats[] = { GP_A8R8G8B8, GP_A8R8G8B8_SRGB, GP_R8, GP_A16B16G16R16F,
                                        GP_R32F };
    GpFormat format = formats[random_int(r, 0, GP_COUNT(formats) - 1)];
    uint32_t width = (uint32_t)random_int(r, 1, 40);
    uint32_t height = (uint32_t)random_int(r, 1, 40);
    uint32_t levels = random_chance(r, 60) ? GP_MAX_LEVELS : 1;
    GpSurface *s = add_surface(random, format, width, height, levels);
    for (uint32_t y = 0; s && y < s->height; y++)
        for (uint32_t x = 0; x < s->width; x++) {
            float rgba[4];
            for (int c = 0; c < 4; c++)
                rgba[c] = random_float(r, 0, 1);
            GpFormat store = format == GP_A8R8G8B8_SRGB ? GP_A8R8G8B8 : format;
            gp_texel_store(store,
                           gp_surface_texel(&s->level[0], gp_format_info(format)->bytes, x, y),
                           rgba, 0);
        }
    if (s)
        gp_surface_build_mips(s);
    return s;
}

/* --- state ------------------------------------------------------------------------------------ */

/* What techniques use, and executors may have short ways for. */
static GpBlend usual_blend(Random *r)
{
    static const GpBlend usual[] = {
        { .op = GP_BLEND_OFF },
        { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE },
        { .op = GP_BLEND_ADD, .src = GP_SRC_ALPHA, .dst = GP_INV_SRC_ALPHA },
        { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_INV_SRC_ALPHA },
        { .op = GP_BLEND_ADD, .src = GP_INV_DEST_ALPHA, .dst = GP_ONE },
        { .op = GP_BLEND_ADD, .src = GP_DEST_COLOR, .dst = GP_ZERO },
        { .op = GP_BLEND_MAX, .src = GP_ONE, .dst = GP_ONE },
        { .op = GP_BLEND_MIN, .src = GP_ONE, .dst = GP_ONE },
    };
    return usual[random_int(r, 0, GP_COUNT(usual) - 1)];
}

static GpBlend random_blend(Random *r, bool logic_allowed)
{
    if (random_chance(r, 40))
        return usual_blend(r);
    GpBlend blend = { .keep = random_chance(r, 20) ? (uint8_t)random_int(r, 0, 15) : 0 };
    if (random_chance(r, 50))
        return blend;
    blend.op =
        (GpBlendOp)random_int(r, GP_BLEND_ADD, logic_allowed ? GP_BLEND_LOGIC_XOR : GP_BLEND_MAX);
    blend.src = (GpBlendFactor)random_int(r, 0, GP_BLEND_FACTORS - 1);
    do
        blend.dst = (GpBlendFactor)random_int(r, 0, GP_BLEND_FACTORS - 1);
    while (blend.dst == GP_SRC_ALPHA_SAT);
    if (blend.op <= GP_BLEND_MAX && random_chance(r, 30)) {
        blend.alpha_op = (GpBlendOp)random_int(r, GP_BLEND_ADD, GP_BLEND_MAX);
        blend.alpha_src = (GpBlendFactor)random_int(r, 0, GP_BLEND_FACTORS - 1);
        blend.alpha_dst = blend.dst;
    }
    return blend;
}

static GpStencilOp random_stencil_op(Random *r)
{
    return (GpStencilOp)random_int(r, 0, GP_STENCIL_OPS - 1);
}

static GpCompare random_compare(Random *r)
{
    return (GpCompare)random_int(r, 0, GP_COMPARES - 1);
}

static GpStencilFace random_face(Random *r)
{
    GpStencilFace face;
    face.test = random_compare(r);
    face.fail = random_stencil_op(r);
    face.depth_fail = random_stencil_op(r);
    face.pass = random_stencil_op(r);
    return face;
}

static void random_stencil(Random *r, GpStencilState *stencil)
{
    stencil->enable = true;
    stencil->two_sided = random_chance(r, 50);
    stencil->front = random_face(r);
    stencil->back = random_face(r);
    stencil->reference = (uint8_t)random_int(r, 0, 255);
    stencil->ignore = (uint8_t)random_int(r, 0, 255);
    stencil->keep = (uint8_t)random_int(r, 0, 255);
}

static void random_viewport(Random *r, uint32_t width, uint32_t height, GpViewport *viewport)
{
    viewport->x = random_float(r, -20, 20);
    viewport->y = random_float(r, -20, 20);
    viewport->width = random_float(r, 1, (float)width * 2);
    viewport->height = random_float(r, 1, (float)height * 2);
    viewport->min_depth = random_float(r, 0, 0.4f);
    viewport->max_depth = random_float(r, 0.5f, 1);
    viewport->d3d9_centers = random_chance(r, 30);
}

static void random_raster(Random *r, GpRasterState *raster, int32_t width, int32_t height)
{
    raster->cull = (GpCull)random_int(r, 0, 2);
    if (random_chance(r, 20)) {
        raster->scissor = true;
        raster->scissor_x0 = random_int(r, -5, width);
        raster->scissor_y0 = random_int(r, -5, height);
        raster->scissor_x1 = raster->scissor_x0 + random_int(r, 0, width);
        raster->scissor_y1 = raster->scissor_y0 + random_int(r, 0, height);
    }
    if (random_chance(r, 20)) {
        raster->depth_bias = random_float(r, -0.1f, 0.1f);
        raster->slope_depth_bias = random_chance(r, 50) ? random_float(r, -2, 2) : 0;
    }
    if (random_chance(r, 20)) {
        raster->clip_planes = (uint8_t)random_int(r, 1, 63);
        for (int i = 0; i < GP_MAX_CLIP_PLANES; i++)
            for (int c = 0; c < 4; c++)
                raster->clip_plane[i][c] = random_float(r, -1, c == 3 ? 3 : 1);
    }
}

static void random_state(Random *r, const GpPass *pass, GpDraw *draw)
{
    uint32_t width, height;
    gp_pass_size(pass, &width, &height);
    GpState *state = &draw->state;
    random_raster(r, &state->raster, (int32_t)width, (int32_t)height);
    if (pass->depth.surface) {
        state->depth.test = random_chance(r, 40) ? GP_LESS_EQUAL : random_compare(r);
        state->depth.write = random_chance(r, 60);
    }
    if (pass->depth.surface && pass->depth.surface->format == GP_D24S8 && random_chance(r, 50))
        random_stencil(r, &state->stencil);
    if (random_chance(r, 20)) {
        state->alpha_test.test = random_compare(r);
        state->alpha_test.reference = (uint8_t)random_int(r, 0, 255);
    }
    for (int i = 0; i < GP_MAX_TARGETS; i++) {
        const GpSurface *target = pass->color[i].surface;
        state->blend[i] = random_blend(r, target && !gp_format_info(target->format)->is_float);
        state->blend_constant[i] = random_float(r, -0.5f, 1.5f);
    }
    if (random_chance(r, 30))
        random_viewport(r, width, height, &draw->viewport);
}

static GpSampler random_sampler(Random *r)
{
    GpSampler s = { 0 };
    s.min = (GpFilter)random_int(r, 0, GP_FILTERS - 1);
    s.mag = (GpFilter)random_int(r, 0, GP_FILTERS - 1);
    s.mip = (GpMipFilter)random_int(r, 0, GP_MIP_FILTERS - 1);
    s.address_u = (GpAddress)random_int(r, 0, GP_ADDRESSES - 1);
    s.address_v = (GpAddress)random_int(r, 0, GP_ADDRESSES - 1);
    s.lod_bias = random_chance(r, 30) ? random_float(r, -2, 2) : 0;
    s.max_lod = random_chance(r, 20) ? random_float(r, 0, 4) : 0;
    for (int c = 0; c < 4; c++)
        s.border[c] = random_float(r, 0, 1);
    return s;
}

/* --- draws and passes ------------------------------------------------------------------------- */

/* A program that the pass can run: by the number of its targets, and reading in place only where an
 * earlier pass of the same size is there to be read. */
static const GpProgram *random_program(Random *r, int targets, bool local)
{
    static const GpProgram *const one[] = {
        &exercise_color,       &exercise_texture,  &exercise_dependent, &exercise_discard,
        &exercise_depth,       &exercise_math,     &exercise_point,     &exercise_vertex_texture,
        &exercise_derivatives, &exercise_position,
    };
    if (targets == 0)
        return random_chance(r, 50) ? &exercise_depth_only : &exercise_discard;
    if (local && random_chance(r, 40))
        return &exercise_local;
    if (targets == 2 && random_chance(r, 60))
        return &exercise_targets2;
    if (targets == 4 && random_chance(r, 60))
        return &exercise_targets4;
    return one[random_int(r, 0, GP_COUNT(one) - 1)];
}

static bool add_draw(RandomList *random, Random *r, uint32_t pass, uint32_t number,
                     GpSurface *const textures[3], GpSurface *in_place)
{
    GpPass *p = &random->passes[pass];
    GpDraw *draw = &random->draws[pass][number];
    ExerciseUniforms *u = &random->uniforms[pass][number];
    int targets = 0;
    while (targets < GP_MAX_TARGETS && p->color[targets].surface)
        targets++;
    draw->program = random_program(r, targets, in_place != NULL);
    draw->uniforms = u;
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++)
            u->matrix[row][column] = row == column;
        u->color[row] = random_float(r, 0, 1);
        u->scale[row] = random_float(r, 0, row < 2 ? 6.0f : 1.0f);
    }
    if (draw->program == &exercise_point)
        u->scale[3] = random_float(r, 0, 30);
    for (int i = 0; i < 3; i++)
        draw->textures[i] = (GpTexture){ textures[i], random_sampler(r) };
    draw->textures[3].surface = in_place;
    random_state(r, p, draw);
    bool points = draw->program == &exercise_point || random_chance(r, 5);
    return random_geometry(r, points, &draw->geometry, &random->vertices[pass][number],
                           &random->indices[pass][number]);
}

static bool writes(const GpPass *pass, const GpSurface *surface)
{
    for (int i = 0; i < GP_MAX_TARGETS; i++)
        if (pass->color[i].surface == surface)
            return true;
    return false;
}

/* A colour target of any earlier pass of a size, or NULL. */
static GpSurface *earlier_target(const RandomList *random, Random *r, uint32_t passes,
                                 uint32_t width, uint32_t height)
{
    if (passes == 0)
        return NULL;
    int pass = random_int(r, 0, (int32_t)passes - 1);
    int target = random_int(r, 0, GP_MAX_TARGETS - 1);
    GpSurface *surface = random->passes[pass].color[target].surface;
    return surface && surface->width == width && surface->height == height ? surface : NULL;
}

/* An earlier target is drawn into again now and then, unless a texture of this pass. */
static GpSurface *random_target(RandomList *random, Random *r, uint32_t pass, uint32_t width,
                                uint32_t height, GpSurface *const textures[3])
{
    GpFormat format = color_formats[random_int(r, 0, GP_COUNT(color_formats) - 1)];
    GpSurface *again = random_chance(r, 40) ? earlier_target(random, r, pass, width, height) : NULL;
    for (int i = 0; i < 3; i++)
        if (again == textures[i])
            again = NULL;
    if (again && !writes(&random->passes[pass], again))
        return again;
    return add_surface(random, format, width, height, 1);
}

static bool add_depth(RandomList *random, Random *r, uint32_t number, uint32_t width,
                      uint32_t height)
{
    GpDepthTarget *depth = &random->passes[number].depth;
    GpFormat format = depth_formats[random_int(r, 0, 2)];
    const GpSurface *before = number ? random->passes[number - 1].depth.surface : NULL;
    bool again = before && before->width == width && before->height == height;
    if (again && random_chance(r, 40))
        depth->surface = random->passes[number - 1].depth.surface;
    else
        depth->surface = add_surface(random, format, width, height, 1);
    if (!depth->surface)
        return false;
    depth->clear_depth = random_chance(r, 80);
    depth->clear_stencil = depth->surface->format == GP_D24S8 && random_chance(r, 80);
    depth->depth_value = random_chance(r, 80) ? 1 : random_float(r, 0, 1);
    depth->stencil_value = (uint8_t)random_int(r, 0, 255);
    return true;
}

static bool add_targets(RandomList *random, Random *r, uint32_t number, uint32_t width,
                        uint32_t height, GpSurface *const textures[3])
{
    GpPass *pass = &random->passes[number];
    int targets = random_int(r, 0, GP_MAX_TARGETS);
    for (int i = 0; i < targets; i++) {
        pass->color[i].surface = random_target(random, r, number, width, height, textures);
        pass->color[i].clear = random_chance(r, 80);
        for (int c = 0; c < 4; c++)
            pass->color[i].clear_color[c] = random_float(r, -0.2f, 1.2f);
        if (!pass->color[i].surface)
            return false;
    }
    if (targets > 0 && random_chance(r, 30))
        return true;
    return add_depth(random, r, number, width, height);
}

bool random_list_create(uint64_t seed, uint32_t largest, RandomList *random)
{
    memset(random, 0, sizeof *random);
    Random r = { seed * 0x9e3779b97f4a7c15u + 1 };
    GpSurface *textures[3];
    for (int i = 0; i < 3; i++)
        if (!(textures[i] = add_texture(random, &r)))
            return false;
    random->list = (GpList){ random->passes, (uint32_t)random_int(&r, 1, RANDOM_PASSES) };
    uint32_t width = 0, height = 0;
    for (uint32_t p = 0; p < random->list.pass_count; p++) {
        GpPass *pass = &random->passes[p];
        if (p == 0 ||
            random_chance(&r, 30)) { /* a new size: earlier passes cannot be read in place */
            width = (uint32_t)random_int(&r, 1, (int32_t)largest);
            height = (uint32_t)random_int(&r, 1, (int32_t)largest);
        }
        if (!add_targets(random, &r, p, width, height, textures))
            return false;
        GpSurface *in_place = earlier_target(random, &r, p, width, height);
        if (in_place && writes(pass, in_place))
            in_place = NULL;
        pass->name = "random";
        pass->draws = random->draws[p];
        pass->draw_count = (uint32_t)random_int(&r, 0, RANDOM_DRAWS);
        for (uint32_t i = 0; i < pass->draw_count; i++)
            if (!add_draw(random, &r, p, i, textures, in_place))
                return false;
        if (pass->color[0].surface && random_chance(&r, 25)) /* later passes may read it anywhere */
            textures[random_int(&r, 0, 2)] = pass->color[0].surface;
    }
    return true;
}

void random_list_destroy(RandomList *random)
{
    for (int i = 0; i < random->surface_count; i++)
        gp_surface_destroy(&random->surfaces[i]);
    for (int i = 0; i < RANDOM_SURFACES; i++)
        gp_free(random->kept_memory[i]);
    for (int p = 0; p < RANDOM_PASSES; p++)
        for (int i = 0; i < RANDOM_DRAWS; i++) {
            gp_free(random->vertices[p][i]);
            gp_free(random->indices[p][i]);
            for (int k = 0; k < 4; k++)
                gp_free(random->kept_geometry[p][i][k]);
        }
    memset(random, 0, sizeof *random);
}

uint64_t random_list_hash(const RandomList *random)
{
    uint64_t hash = 0;
    for (int i = 0; i < random->surface_count; i++) /* order matters: a rotation between terms */
        hash =
            (hash << 7 | hash >> 57) * 0x9e3779b97f4a7c15u ^ gp_surface_hash(random->surfaces[i]);
    return hash;
}
