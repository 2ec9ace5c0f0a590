/* Lists over the public interface: a random list (tests/support/random_list.h) in which any fields
 * hold any values. It is refused, or drawn to the same bits by both executors. */
#include "tests/fuzz/targets.h"
#include "tests/support/random_list.h"

#include <string.h>

/* What a field's bits are taken for. */
typedef enum Kind { REAL, NAME, FLAG, BYTE, NUMBER } Kind;

typedef struct Field {
    size_t offset;
    Kind kind;
} Field;

#define STATE(member, kind)                                                                        \
    {                                                                                              \
        offsetof(GpDraw, state.member), kind                                                       \
    }
#define VIEWPORT(member, kind)                                                                     \
    {                                                                                              \
        offsetof(GpDraw, viewport.member), kind                                                    \
    }
#define SAMPLER(member, kind)                                                                      \
    {                                                                                              \
        offsetof(GpDraw, textures[0].sampler.member), kind                                         \
    }

static const Field draw_fields[] = {
    STATE(raster.cull, NAME),
    STATE(raster.scissor, FLAG),
    STATE(raster.scissor_x0, NUMBER),
    STATE(raster.scissor_y0, NUMBER),
    STATE(raster.scissor_x1, NUMBER),
    STATE(raster.scissor_y1, NUMBER),
    STATE(raster.depth_bias, REAL),
    STATE(raster.slope_depth_bias, REAL),
    STATE(raster.clip_planes, BYTE),
    STATE(raster.clip_plane[0][0], REAL),
    STATE(raster.clip_plane[0][3], REAL),
    STATE(raster.clip_plane[5][1], REAL),
    STATE(depth.test, NAME),
    STATE(depth.write, FLAG),
    STATE(depth.ternary, FLAG),
    STATE(depth.epsilon, REAL),
    STATE(stencil.enable, FLAG),
    STATE(stencil.two_sided, FLAG),
    STATE(stencil.front.test, NAME),
    STATE(stencil.front.pass, NAME),
    STATE(stencil.back.fail, NAME),
    STATE(stencil.back.depth_fail, NAME),
    STATE(stencil.reference, BYTE),
    STATE(stencil.ignore, BYTE),
    STATE(stencil.keep, BYTE),
    STATE(alpha_test.test, NAME),
    STATE(alpha_test.reference, BYTE),
    STATE(blend[0].op, NAME),
    STATE(blend[0].src, NAME),
    STATE(blend[0].dst, NAME),
    STATE(blend[0].alpha_op, NAME),
    STATE(blend[0].alpha_src, NAME),
    STATE(blend[0].alpha_dst, NAME),
    STATE(blend[0].keep, BYTE),
    STATE(blend[1].op, NAME),
    STATE(blend_constant[0], REAL),
    STATE(blend_constant[3], REAL),
    VIEWPORT(x, REAL),
    VIEWPORT(y, REAL),
    VIEWPORT(width, REAL),
    VIEWPORT(height, REAL),
    VIEWPORT(min_depth, REAL),
    VIEWPORT(max_depth, REAL),
    VIEWPORT(d3d9_centers, FLAG),
    VIEWPORT(has_depth_range, FLAG),
    SAMPLER(min, NAME),
    SAMPLER(mag, NAME),
    SAMPLER(mip, NAME),
    SAMPLER(address_u, NAME),
    SAMPLER(address_v, NAME),
    SAMPLER(border[0], REAL),
    SAMPLER(lod_bias, REAL),
    SAMPLER(min_lod, REAL),
    SAMPLER(max_lod, REAL),
    SAMPLER(compare, FLAG),
    SAMPLER(has_max_lod, FLAG),
    { offsetof(GpDraw, geometry.primitive), NAME },
};

static const Field pass_fields[] = {
    { offsetof(GpPass, order), NAME },
    { offsetof(GpPass, color[0].clear), FLAG },
    { offsetof(GpPass, color[0].clear_color[0]), REAL },
    { offsetof(GpPass, color[0].clear_color[3]), REAL },
    { offsetof(GpPass, depth.clear_depth), FLAG },
    { offsetof(GpPass, depth.clear_stencil), FLAG },
    { offsetof(GpPass, depth.depth_value), REAL },
    { offsetof(GpPass, depth.stencil_value), BYTE },
};

static void set_field(void *object, const Field *field, uint32_t bits)
{
    uint8_t *at = (uint8_t *)object + field->offset;
    const bool flag = bits & 1;
    const uint32_t name = bits % 16;
    if (field->kind == FLAG)
        memcpy(at, &flag, sizeof flag);
    else if (field->kind == BYTE)
        memcpy(at, &bits, 1);
    else
        memcpy(at, field->kind == NAME ? &name : &bits, sizeof bits);
}

/* Eight bytes for a seed, then changes of eight bytes: which field of which draw or pass, and its
 * bits; or which number of a draw's uniforms, or of its vertices. */
enum { CHANGE = 8, MOST_CHANGES = 24 };

static void change(RandomList *random, const uint8_t *bytes)
{
    uint32_t bits;
    memcpy(&bits, bytes + 4, sizeof bits);
    const uint32_t p = bytes[0] % random->list.pass_count;
    GpPass *pass = &random->passes[p];
    if (bytes[1] % 8 == 0 || pass->draw_count == 0) {
        set_field(pass, &pass_fields[bytes[2] % GP_COUNT(pass_fields)], bits);
        return;
    }
    const uint32_t d = bytes[3] % pass->draw_count;
    if (bytes[1] % 8 == 1)
        memcpy((uint8_t *)&random->uniforms[p][d] + bytes[2] % (sizeof(ExerciseUniforms) / 4) * 4,
               &bits, sizeof bits);
    else if (bytes[1] % 8 == 2 && random->vertices[p][d])
        memcpy(&random->vertices[p][d][bytes[2] % 3], &bits, sizeof bits);
    else
        set_field(&random->draws[p][d], &draw_fields[bytes[2] % GP_COUNT(draw_fields)], bits);
}

static GpResult draw(const uint8_t *data, size_t size, GpExecutor executor, uint64_t *before,
                     uint64_t *after)
{
    static RandomList random;
    GpError error = { "" };
    uint64_t seed;
    memcpy(&seed, data, sizeof seed);
    fuzz_claim(random_list_create(seed, 24, &random), "there is memory");
    for (size_t at = 8; at + CHANGE <= size && at < 8 + MOST_CHANGES * CHANGE; at += CHANGE)
        change(&random, data + at);
    *before = random_list_hash(&random);
    const GpResult result = gp_device_run(fuzz_device(executor), &random.list, &error);
    fuzz_accepted(result, &error);
    *after = random_list_hash(&random);
    random_list_destroy(&random);
    return result;
}

static bool run_list(const uint8_t *data, size_t size)
{
    uint64_t before[2], after[2];
    if (size < 8)
        return false;
    const GpResult result = draw(data, size, GP_EXECUTOR_REFERENCE, &before[0], &after[0]);
    fuzz_claim(draw(data, size, GP_EXECUTOR_FAST, &before[1], &after[1]) == result,
               "executors agree");
    fuzz_claim(before[0] == before[1], "the same list is made twice");
    fuzz_claim(after[0] == after[1], "executors draw the same bits");
    fuzz_claim(!result || before[0] == after[0], "what is refused changes no texel");
    return result == GP_OK;
}

static void seeds_list(const FuzzSeeds *to)
{
    for (uint64_t seed = 1; seed < 40; seed++) {
        char name[3] = { (char)('0' + seed / 10), (char)('0' + seed % 10), '\0' };
        to->take(to->user, name, &seed, sizeof seed);
    }
}

const FuzzTarget fuzz_list = { "list", 8 + MOST_CHANGES *CHANGE, run_list, seeds_list, NULL };
