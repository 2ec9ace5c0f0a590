/* The shaders of the benchmark cases in GLSL ES 3.00: the arithmetic is that of glasspipe's
 * shaders, expression by expression. Left out of the uniforms: what a shader knows as a
 * constant. */
#include "tests/peer/bench/replay.h"

#include "shaders_c/bench/arithmetic.h"
#include "shaders_c/common/blit.h"
#include "shaders_c/common/depth_only.h"
#include "shaders_c/bench/peeling.h"
#include "shaders_c/bench/lookup.h"
#include "shaders_c/bench/mandelbrot.h"
#include "shaders_c/bench/placed.h"
#include "shaders_c/bench/scaled_color.h"
#include "shaders_c/bench/slab_bits.h"
#include "shaders_c/bench/soft_sprite.h"
#include "shaders_c/bench/surface_maps.h"
#include "shaders_c/common/texel_copy.h"
#include "shaders_c/bench/two_sided.h"

const char glsl_head[] = "#version 300 es\n"
                         "precision highp float;\n"
                         "precision highp int;\n"
                         "precision highp sampler2D;\n"
                         "precision highp sampler2DShadow;\n";

const char *const glsl_units[REPLAY_UNITS] = { "image", "table" };

/* --- vertices --------------------------------------------------------------------------------- */

/* Quads come in Direct3D's clip space, 0 <= z <= 1. */
#define GLSL_QUAD                                                                                  \
    "layout(location = 0) in vec3 corner;\n"                                                       \
    "vec4 clip() { return vec4(corner.xy, corner.z * 2.0 - 1.0, 1.0); }\n"

const char glsl_screen[] = GLSL_QUAD "void main() { gl_Position = clip(); }\n";

static const char vertex_color[] = GLSL_QUAD "layout(location = 1) in vec4 tint;\n"
                                             "out vec4 color;\n"
                                             "void main() {\n"
                                             "    color = tint;\n"
                                             "    gl_Position = clip();\n"
                                             "}\n";

static const char vertex_quad[] = GLSL_QUAD "layout(location = 1) in vec2 place;\n"
                                            "out vec2 uv;\n"
                                            "void main() {\n"
                                            "    uv = place;\n"
                                            "    gl_Position = clip();\n"
                                            "}\n";

static const char vertex_depth[] = "layout(location = 0) in vec3 position;\n"
                                   "uniform mat4 mvp;\n"
                                   "void main() { gl_Position = mvp * vec4(position, 1.0); }\n";

static const char vertex_mesh[] = "layout(location = 0) in vec3 position;\n"
                                  "layout(location = 1) in vec3 normal;\n"
                                  "uniform mat4 mvp, model;\n"
                                  "out vec3 world, n;\n"
                                  "void main() {\n"
                                  "    world = (model * vec4(position, 1.0)).xyz;\n"
                                  "    n = mat3(model) * normal;\n"
                                  "    gl_Position = mvp * vec4(position, 1.0);\n"
                                  "}\n";

static const char vertex_world[] = "layout(location = 0) in vec3 position;\n"
                                   "layout(location = 1) in vec3 normal;\n"
                                   "uniform mat4 mvp;\n"
                                   "out vec3 world, n;\n"
                                   "void main() {\n"
                                   "    world = position;\n"
                                   "    n = normal;\n"
                                   "    gl_Position = mvp * vec4(position, 1.0);\n"
                                   "}\n";

static const char vertex_shadow[] = "layout(location = 0) in vec3 position;\n"
                                    "layout(location = 1) in vec3 normal;\n"
                                    "uniform mat4 mvp, light_clip;\n"
                                    "out vec3 world, n;\n"
                                    "out vec4 seen;\n"
                                    "void main() {\n"
                                    "    world = position;\n"
                                    "    n = normal;\n"
                                    "    seen = light_clip * vec4(position, 1.0);\n"
                                    "    gl_Position = mvp * vec4(position, 1.0);\n"
                                    "}\n";

static const char vertex_points[] =
    "layout(location = 0) in vec3 position;\n"
    "uniform mat4 mvp;\n"
    "uniform vec3 light, color;\n"
    "uniform float ambient, size;\n"
    "out vec3 lit;\n"
    "void main() {\n"
    "    lit = color * (ambient + (1.0 - ambient) * max(dot(position, light), 0.0));\n"
    "    gl_PointSize = size;\n"
    "    gl_Position = mvp * vec4(position, 1.0);\n"
    "}\n";

static const char vertex_sheet[] = "layout(location = 0) in vec3 point;\n"
                                   "uniform float size;\n"
                                   "out float value;\n"
                                   "void main() {\n"
                                   "    value = point.z;\n"
                                   "    gl_PointSize = size;\n"
                                   "    gl_Position = vec4(point.xy, 0.0, 1.0);\n"
                                   "}\n";

static const char vertex_small[] =
    "layout(location = 0) in vec3 position;\n"
    "layout(location = 1) in vec3 normal;\n"
    "uniform mat4 mvp;\n"
    "uniform vec4 place;\n"
    "out vec3 n;\n"
    "void main() {\n"
    "    n = normal;\n"
    "    gl_Position = mvp * vec4(position * place.w + place.xyz, 1.0);\n"
    "}\n";

static const char vertex_voxels[] = "layout(location = 0) in vec3 position;\n"
                                    "uniform mat4 mvp;\n"
                                    "out float z;\n"
                                    "void main() {\n"
                                    "    vec4 clip = mvp * vec4(position, 1.0);\n"
                                    "    z = clip.z * 0.5 + 0.5;\n"
                                    "    gl_Position = clip;\n"
                                    "}\n";

/* --- full-screen quads ------------------------------------------------------------------------ */

static const char pixel_color[] = "in vec4 color;\n"
                                  "uniform float scale;\n"
                                  "out vec4 result;\n"
                                  "void main() { result = color * scale; }\n";

static const char pixel_texture[] = "in vec2 uv;\n"
                                    "uniform sampler2D image;\n"
                                    "out vec4 result;\n"
                                    "void main() { result = texture(image, uv); }\n";

static const char pixel_dependent[] =
    "in vec2 uv;\n"
    "uniform sampler2D image, table;\n"
    "out vec4 result;\n"
    "void main() { result = texture(table, texture(image, uv).xy); }\n";

static const char pixel_discard[] = "in vec2 uv;\n"
                                    "uniform sampler2D image;\n"
                                    "out vec4 result;\n"
                                    "void main() {\n"
                                    "    vec4 c = texture(image, uv);\n"
                                    "    if (c.a < 0.5)\n"
                                    "        discard;\n"
                                    "    result = c;\n"
                                    "}\n";

#define GLSL_MAD                                                                                   \
    "v0 = v0 * factor + addend; v1 = v1 * factor + addend;\n"                                      \
    "v2 = v2 * factor + addend; v3 = v3 * factor + addend;\n"
#define GLSL_MAD_MAIN(steps)                                                                       \
    "in vec2 uv;\n"                                                                                \
    "uniform vec4 factor, addend;\n"                                                               \
    "out vec4 result;\n"                                                                           \
    "void main() {\n"                                                                              \
    "    vec4 v0 = vec4(uv, 1.0 - uv), v1 = v0 * 0.5, v2 = v0 + 0.25, v3 = v0 * v0;\n" steps       \
    "    result = (v0 + v1 + v2 + v3) * 0.25;\n"                                                   \
    "}\n"
#define GLSL_4(text)  text text text text
#define GLSL_64(text) GLSL_4(GLSL_4(GLSL_4(text)))

static const char pixel_mad[] = GLSL_MAD_MAIN("for (int i = 0; i < 64; i++) {\n" GLSL_MAD "}\n");
static const char pixel_mad_flat[] = GLSL_MAD_MAIN(GLSL_64(GLSL_MAD));

static const char pixel_mandel[] =
    "in vec2 uv;\n"
    "out vec4 result;\n"
    "void main() {\n"
    "    vec2 c = uv * 2.6 - vec2(1.9, 1.3), z = vec2(0.0);\n"
    "    int n = 0;\n"
    "    for (; n < 64; n++) {\n"
    "        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;\n"
    "        if (dot(z, z) > 4.0)\n"
    "            break;\n"
    "    }\n"
    "    result = vec4(float(n) / 64.0 * vec3(1.0, 0.7, 0.4), 1.0);\n"
    "}\n";

/* One layer, premultiplied, on its way under those in front of it. */
static const char pixel_premultiply[] =
    "uniform sampler2D image;\n"
    "out vec4 result;\n"
    "void main() {\n"
    "    vec4 c = texelFetch(image, ivec2(gl_FragCoord.xy), 0);\n"
    "    result = vec4(c.rgb * c.a, c.a);\n"
    "}\n";

static const char pixel_resolve[] = "uniform sampler2D image;\n"
                                    "uniform vec3 background;\n"
                                    "out vec4 result;\n"
                                    "void main() {\n"
                                    "    vec4 c = texelFetch(image, ivec2(gl_FragCoord.xy), 0);\n"
                                    "    result = vec4(c.rgb + (1.0 - c.a) * background, 1.0);\n"
                                    "}\n";

static const char pixel_copy[] =
    "uniform sampler2D image;\n"
    "out vec4 result;\n"
    "void main() { result = texelFetch(image, ivec2(gl_FragCoord.xy), 0); }\n";

/* What is hashed: the colour, or without a colour target the depth; alpha tells where the depth
 * buffer stayed clear. A texture that is not there reads as (0, 0, 0, 1), a depth of 0. */
const char glsl_show[] =
    "uniform sampler2D image, table;\n"
    "uniform bool only_depth;\n"
    "out vec4 result;\n"
    "void main() {\n"
    "    ivec2 at = ivec2(gl_FragCoord.xy);\n"
    "    float d = texelFetch(table, at, 0).r;\n"
    "    vec3 grey = vec3(d < 1.0 ? (1.0 - d) * 6.0 : 0.0);\n"
    "    result = vec4(only_depth ? grey : texelFetch(image, at, 0).rgb, d < 1.0 ? 1.0 : 0.0);\n"
    "}\n";

/* --- meshes ----------------------------------------------------------------------------------- */

static const char pixel_nothing[] = "void main() {}\n";

#define GLSL_PHONG                                                                                 \
    "in vec3 world, n;\n"                                                                          \
    "uniform vec3 eye, light, albedo;\n"                                                           \
    "uniform float ambient, specular, shininess;\n"                                                \
    "out vec4 result;\n"                                                                           \
    "vec4 phong(float lit) {\n"                                                                    \
    "    vec3 N = normalize(n), V = normalize(eye - world);\n"                                     \
    "    if (dot(N, V) < 0.0)\n"                                                                   \
    "        N = -N;\n"                                                                            \
    "    vec3 H = normalize(light + V);\n"                                                         \
    "    float highlight = pow(max(dot(N, H), 0.0), shininess);\n"                                 \
    "    vec3 diffuse = albedo * (ambient + lit * max(dot(N, light), 0.0));\n"                     \
    "    return vec4(diffuse + lit * specular * highlight, 1.0);\n"                                \
    "}\n"

static const char pixel_phong[] = GLSL_PHONG "void main() { result = phong(1.0); }\n";

static const char pixel_targets[] = "in vec3 world, n;\n"
                                    "uniform vec3 light, albedo;\n"
                                    "layout(location = 0) out vec4 result0;\n"
                                    "layout(location = 1) out vec4 result1;\n"
                                    "layout(location = 2) out vec4 result2;\n"
                                    "layout(location = 3) out vec4 result3;\n"
                                    "void main() {\n"
                                    "    vec3 N = normalize(n);\n"
                                    "    result0 = vec4(world, 1.0);\n"
                                    "    result1 = vec4(N, 1.0);\n"
                                    "    result2 = vec4(albedo, 1.0);\n"
                                    "    result3 = vec4(gl_FragCoord.z, dot(N, light), 0.0, 1.0);\n"
                                    "}\n";

#define GLSL_SHADOW                                                                                \
    GLSL_PHONG                                                                                     \
    "in vec4 seen;\n"                                                                              \
    "uniform float bias;\n"                                                                        \
    "float lit(vec3 at);\n"                                                                        \
    "void main() {\n"                                                                              \
    "    vec3 at = seen.xyz / seen.w * 0.5 + 0.5;\n"                                               \
    "    result = phong(lit(vec3(at.xy, at.z - bias)));\n"                                         \
    "}\n"

static const char pixel_shadow_compare[] =
    GLSL_SHADOW "uniform sampler2DShadow image;\n"
                "float lit(vec3 at) { return texture(image, at); }\n";

static const char pixel_shadow_nearest[] =
    GLSL_SHADOW "uniform sampler2D image;\n"
                "float lit(vec3 at) { return at.z <= texture(image, at.xy).r ? 1.0 : 0.0; }\n";

static const char pixel_shadow_four[] =
    GLSL_SHADOW "uniform sampler2D image;\n"
                "const int size = 1024;\n"
                "float tap(ivec2 i, float z) {\n"
                "    ivec2 inside = clamp(i, ivec2(0), ivec2(size - 1));\n"
                "    return z <= texelFetch(image, inside, 0).r ? 1.0 : 0.0;\n"
                "}\n"
                "float lit(vec3 at) {\n"
                "    vec2 t = at.xy * float(size) - 0.5, base = floor(t), f = t - base;\n"
                "    ivec2 i = ivec2(base);\n"
                "    return mix(mix(tap(i, at.z), tap(i + ivec2(1, 0), at.z), f.x),\n"
                "               mix(tap(i + ivec2(0, 1), at.z), tap(i + ivec2(1, 1), at.z), f.x),\n"
                "               f.y);\n"
                "}\n";

#define GLSL_PEEL(test)                                                                            \
    "in vec3 world, n;\n"                                                                          \
    "uniform vec3 light;\n"                                                                        \
    "uniform vec4 color;\n"                                                                        \
    "uniform sampler2D image;\n"                                                                   \
    "out vec4 result;\n"                                                                           \
    "void main() {\n" test "    float lambert = abs(dot(normalize(n), light));\n"                  \
    "    result = vec4(color.rgb * (0.25 + 0.75 * lambert), color.a);\n"                           \
    "}\n"

static const char pixel_peel_first[] = GLSL_PEEL("");
static const char pixel_peel[] =
    GLSL_PEEL("    if (gl_FragCoord.z <= texelFetch(image, ivec2(gl_FragCoord.xy), 0).r)\n"
              "        discard;\n");

static const char pixel_small[] =
    "in vec3 n;\n"
    "uniform vec3 light, albedo;\n"
    "uniform float ambient;\n"
    "out vec4 result;\n"
    "void main() {\n"
    "    result = vec4(albedo * (ambient + abs(dot(normalize(n), light))), 1.0);\n"
    "}\n";

/* Sets one bit of 128: four targets of 32, four channels of 8. */
static const char pixel_voxels[] =
    "in float z;\n"
    "uniform float first_slab;\n"
    "layout(location = 0) out vec4 result0;\n"
    "layout(location = 1) out vec4 result1;\n"
    "layout(location = 2) out vec4 result2;\n"
    "layout(location = 3) out vec4 result3;\n"
    "void main() {\n"
    "    int voxel = int(floor(z * 256.0)), slab = (voxel >> 5) - int(first_slab), bit = voxel & "
    "31;\n"
    "    if (slab < 0 || slab > 3)\n"
    "        discard;\n"
    "    float x = float(1 << (bit & 7)) / 255.0;\n"
    "    int c = bit >> 3;\n"
    "    vec4 v = vec4(c == 0 ? x : 0.0, c == 1 ? x : 0.0, c == 2 ? x : 0.0, c == 3 ? x : 0.0);\n"
    "    result0 = slab == 0 ? v : vec4(0.0);\n"
    "    result1 = slab == 1 ? v : vec4(0.0);\n"
    "    result2 = slab == 2 ? v : vec4(0.0);\n"
    "    result3 = slab == 3 ? v : vec4(0.0);\n"
    "}\n";

/* --- points ----------------------------------------------------------------------------------- */

static const char pixel_points[] = "in vec3 lit;\n"
                                   "uniform float opacity;\n"
                                   "out vec4 result;\n"
                                   "void main() {\n"
                                   "    vec2 d = (gl_PointCoord - 0.5) * 2.0;\n"
                                   "    float r2 = dot(d, d);\n"
                                   "    if (r2 > 1.0)\n"
                                   "        discard;\n"
                                   "    float a = exp(-4.0 * r2) * opacity;\n"
                                   "    result = vec4(lit * a, a);\n"
                                   "}\n";

static const char pixel_sheet[] = "in float value;\n"
                                  "uniform float opacity;\n"
                                  "out vec4 result;\n"
                                  "void main() {\n"
                                  "    vec2 d = (gl_PointCoord - 0.5) * 2.0;\n"
                                  "    float a = opacity * exp(-3.0 * dot(d, d));\n"
                                  "    result = vec4(vec3(value, 0.6, 1.0 - value) * a, a);\n"
                                  "}\n";

/* --- the table -------------------------------------------------------------------------------- */

/* clang-format off */
#define AT(type, kind, member) { #member, kind, offsetof(type, member) }

#define LIT_UNIFORMS                                                                               \
    AT(TwoSidedUniforms, UNIFORM_CLIP, mvp), AT(TwoSidedUniforms, UNIFORM_VEC3, eye),              \
    AT(TwoSidedUniforms, UNIFORM_VEC3, light), AT(TwoSidedUniforms, UNIFORM_VEC3, albedo),         \
    AT(TwoSidedUniforms, UNIFORM_FLOAT, ambient), AT(TwoSidedUniforms, UNIFORM_FLOAT, specular),   \
    AT(TwoSidedUniforms, UNIFORM_FLOAT, shininess)

#define SHADOW_UNIFORMS                                                                            \
    LIT_UNIFORMS, AT(TwoSidedUniforms, UNIFORM_CLIP, light_clip),                                  \
    AT(TwoSidedUniforms, UNIFORM_FLOAT, bias)

#define PEEL_UNIFORMS                                                                              \
    AT(PeelUniforms, UNIFORM_CLIP, mvp), AT(PeelUniforms, UNIFORM_MATRIX, model),                  \
    AT(PeelUniforms, UNIFORM_VEC3, light), AT(PeelUniforms, UNIFORM_VEC4, color)

#define CHAIN_UNIFORMS                                                                             \
    AT(ArithmeticUniforms, UNIFORM_VEC4, factor), AT(ArithmeticUniforms, UNIFORM_VEC4, addend)

static const Translation translations[] = {
    { &scaled_color_program, vertex_color, pixel_color,
      { AT(ScaledColorUniforms, UNIFORM_FLOAT, scale) } },
    { &blit_program, vertex_quad, pixel_texture, { { .name = NULL } } },
    { &lookup_program, vertex_quad, pixel_dependent, { { .name = NULL } } },
    { &cut_out_program, vertex_quad, pixel_discard, { { .name = NULL } } },
    { &mad_loop_program, vertex_quad, pixel_mad, { CHAIN_UNIFORMS } },
    { &mad_flat_program, vertex_quad, pixel_mad_flat, { CHAIN_UNIFORMS } },
    { &mandelbrot_program, vertex_quad, pixel_mandel, { { .name = NULL } } },

    { &depth_only_program, vertex_depth, pixel_nothing,
      { AT(DepthOnlyUniforms, UNIFORM_CLIP, mvp) } },
    { &two_sided_program, vertex_mesh, pixel_phong,
      { LIT_UNIFORMS, AT(TwoSidedUniforms, UNIFORM_MATRIX, model) } },
    { &two_sided_compare_program, vertex_shadow, pixel_shadow_compare, { SHADOW_UNIFORMS } },
    { &two_sided_nearest_program, vertex_shadow, pixel_shadow_nearest, { SHADOW_UNIFORMS } },
    { &two_sided_pcf_program, vertex_shadow, pixel_shadow_four, { SHADOW_UNIFORMS } },
    { &surface_maps_program, vertex_world, pixel_targets,
      { AT(SurfaceMapsUniforms, UNIFORM_CLIP, mvp), AT(SurfaceMapsUniforms, UNIFORM_VEC3, light),
        AT(SurfaceMapsUniforms, UNIFORM_VEC3, albedo) } },
    { &placed_program, vertex_small, pixel_small,
      { AT(PlacedUniforms, UNIFORM_CLIP, mvp), AT(PlacedUniforms, UNIFORM_VEC4, place),
        AT(PlacedUniforms, UNIFORM_VEC3, light), AT(PlacedUniforms, UNIFORM_VEC3, albedo),
        AT(PlacedUniforms, UNIFORM_FLOAT, ambient) } },
    { &slab_bits_program, vertex_voxels, pixel_voxels,
      { AT(SlabBitsUniforms, UNIFORM_CLIP, mvp),
        AT(SlabBitsUniforms, UNIFORM_FLOAT, first_slab) } },

    { &peel_first_program, vertex_mesh, pixel_peel_first, { PEEL_UNIFORMS } },
    { &peel_next_program, vertex_mesh, pixel_peel, { PEEL_UNIFORMS } },
    { &texel_copy_program, glsl_screen, pixel_copy, { { .name = NULL } } },
    { &layer_premultiply_program, glsl_screen, pixel_premultiply, { { .name = NULL } } },
    { &layer_background_program, glsl_screen, pixel_resolve,
      { AT(LayerUniforms, UNIFORM_VEC3, background) } },

    { &soft_sprite_program, vertex_points, pixel_points,
      { AT(SoftSpriteUniforms, UNIFORM_CLIP, mvp), AT(SoftSpriteUniforms, UNIFORM_VEC3, light),
        AT(SoftSpriteUniforms, UNIFORM_VEC3, color), AT(SoftSpriteUniforms, UNIFORM_FLOAT, ambient),
        AT(SoftSpriteUniforms, UNIFORM_FLOAT, size),
        AT(SoftSpriteUniforms, UNIFORM_FLOAT, opacity) } },
    { &sheet_sprite_program, vertex_sheet, pixel_sheet,
      { AT(SheetSpriteUniforms, UNIFORM_FLOAT, size),
        AT(SheetSpriteUniforms, UNIFORM_FLOAT, opacity) } },
};
/* clang-format on */

const Translation *translation_find(const GpProgram *program)
{
    for (size_t i = 0; i < GP_COUNT(translations); i++)
        if (translations[i].program == program)
            return &translations[i];
    return NULL;
}
