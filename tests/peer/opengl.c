/* The scenes through OpenGL ES 3.2 on Mesa's llvmpipe.
 *
 * libEGL is opened while running, and the few prototypes and constants needed are written here from
 * the Khronos registry: the project builds where no header and no library of OpenGL is installed.
 */
#include "tests/peer/peer.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

enum {
    EGL_SURFACE_TYPE = 0x3033,
    EGL_PBUFFER_BIT = 1,
    EGL_NONE = 0x3038,
    EGL_RENDERABLE_TYPE = 0x3040,
    EGL_OPENGL_ES3_BIT = 0x40,
    EGL_CONTEXT_MAJOR_VERSION = 0x3098,
    EGL_CONTEXT_MINOR_VERSION = 0x30fb,
    EGL_OPENGL_ES_API = 0x30a0,
    EGL_PLATFORM_SURFACELESS_MESA = 0x31dd,

    GL_TRIANGLES = 4,
    GL_LESS = 0x0201,
    GL_DEPTH_TEST = 0x0b71,
    GL_DITHER = 0x0bd0,
    GL_TEXTURE_2D = 0x0de1,
    GL_UNSIGNED_BYTE = 0x1401,
    GL_UNSIGNED_INT = 0x1405,
    GL_FLOAT = 0x1406,
    GL_COLOR = 0x1800,
    GL_DEPTH = 0x1801,
    GL_RGBA = 0x1908,
    GL_RENDERER = 0x1f01,
    GL_VERSION = 0x1f02,
    GL_RGBA8 = 0x8058,
    GL_RG32UI = 0x823c,
    GL_ARRAY_BUFFER = 0x8892,
    GL_ELEMENT_ARRAY_BUFFER = 0x8893,
    GL_STATIC_DRAW = 0x88e4,
    GL_FRAGMENT_SHADER = 0x8b30,
    GL_VERTEX_SHADER = 0x8b31,
    GL_COMPILE_STATUS = 0x8b81,
    GL_LINK_STATUS = 0x8b82,
    GL_DEPTH_COMPONENT32F = 0x8cac,
    GL_FRAMEBUFFER_COMPLETE = 0x8cd5,
    GL_COLOR_ATTACHMENT0 = 0x8ce0,
    GL_COLOR_ATTACHMENT1 = 0x8ce1,
    GL_DEPTH_ATTACHMENT = 0x8d00,
    GL_FRAMEBUFFER = 0x8d40,
    GL_RENDERBUFFER = 0x8d41,
    GL_RGBA_INTEGER = 0x8d99,
};

typedef void (*Function)(void);

/* clang-format off */
#define EGL_CALLS(X)                                                                               \
    X(Function, GetProcAddress, (const char *))                                                    \
    X(void *, GetPlatformDisplay, (unsigned, void *, const intptr_t *))                            \
    X(unsigned, Initialize, (void *, int *, int *))                                                \
    X(unsigned, Terminate, (void *))                                                               \
    X(unsigned, BindAPI, (unsigned))                                                               \
    X(unsigned, ChooseConfig, (void *, const int *, void **, int, int *))                          \
    X(void *, CreateContext, (void *, void *, void *, const int *))                                \
    X(unsigned, DestroyContext, (void *, void *))                                                  \
    X(unsigned, MakeCurrent, (void *, void *, void *, void *))

#define GL_CALLS(X)                                                                                \
    X(const unsigned char *, GetString, (unsigned))                                                \
    X(unsigned, GetError, (void))                                                                  \
    X(unsigned, CreateShader, (unsigned))                                                          \
    X(void, ShaderSource, (unsigned, int, const char *const *, const int *))                       \
    X(void, CompileShader, (unsigned))                                                             \
    X(void, GetShaderiv, (unsigned, unsigned, int *))                                              \
    X(void, GetShaderInfoLog, (unsigned, int, int *, char *))                                      \
    X(void, DeleteShader, (unsigned))                                                              \
    X(unsigned, CreateProgram, (void))                                                             \
    X(void, AttachShader, (unsigned, unsigned))                                                    \
    X(void, LinkProgram, (unsigned))                                                               \
    X(void, GetProgramiv, (unsigned, unsigned, int *))                                             \
    X(void, UseProgram, (unsigned))                                                                \
    X(void, DeleteProgram, (unsigned))                                                             \
    X(int, GetUniformLocation, (unsigned, const char *))                                           \
    X(void, Uniform1f, (int, float))                                                               \
    X(void, Uniform3fv, (int, int, const float *))                                                 \
    X(void, UniformMatrix4fv, (int, int, unsigned char, const float *))                            \
    X(void, GenRenderbuffers, (int, unsigned *))                                                   \
    X(void, BindRenderbuffer, (unsigned, unsigned))                                                \
    X(void, RenderbufferStorage, (unsigned, unsigned, int, int))                                   \
    X(void, DeleteRenderbuffers, (int, const unsigned *))                                          \
    X(void, GenFramebuffers, (int, unsigned *))                                                    \
    X(void, BindFramebuffer, (unsigned, unsigned))                                                 \
    X(void, FramebufferRenderbuffer, (unsigned, unsigned, unsigned, unsigned))                     \
    X(unsigned, CheckFramebufferStatus, (unsigned))                                                \
    X(void, DeleteFramebuffers, (int, const unsigned *))                                           \
    X(void, DrawBuffers, (int, const unsigned *))                                                  \
    X(void, ReadBuffer, (unsigned))                                                                \
    X(void, ReadPixels, (int, int, int, int, unsigned, unsigned, void *))                          \
    X(void, ClearBufferfv, (unsigned, int, const float *))                                         \
    X(void, ClearBufferuiv, (unsigned, int, const unsigned *))                                     \
    X(void, Viewport, (int, int, int, int))                                                        \
    X(void, Enable, (unsigned))                                                                    \
    X(void, Disable, (unsigned))                                                                   \
    X(void, DepthFunc, (unsigned))                                                                 \
    X(void, GenVertexArrays, (int, unsigned *))                                                    \
    X(void, BindVertexArray, (unsigned))                                                           \
    X(void, DeleteVertexArrays, (int, const unsigned *))                                           \
    X(void, GenBuffers, (int, unsigned *))                                                         \
    X(void, BindBuffer, (unsigned, unsigned))                                                      \
    X(void, BufferData, (unsigned, intptr_t, const void *, unsigned))                              \
    X(void, DeleteBuffers, (int, const unsigned *))                                                \
    X(void, VertexAttribPointer, (unsigned, int, unsigned, unsigned char, int, const void *))      \
    X(void, EnableVertexAttribArray, (unsigned))                                                   \
    X(void, DrawElements, (unsigned, int, unsigned, const void *))
/* clang-format on */

#define MEMBER(type, name, arguments) type(*name) arguments;
typedef struct Egl {
    EGL_CALLS(MEMBER)
} Egl;
typedef struct Gl {
    GL_CALLS(MEMBER)
} Gl;
#undef MEMBER

struct PeerGl {
    void *library, *display, *context;
    Egl egl;
    Gl gl;
    char name[256];
};

/* --- shaders ---------------------------------------------------------------------------------- */

#define GLSL_HEAD "#version 320 es\nprecision highp float;\nprecision highp int;\n"

#define GLSL_INPUTS                                                                                \
    "layout(location = 0) in vec3 position;\n"                                                     \
    "layout(location = 1) in vec3 normal;\n"                                                       \
    "layout(location = 2) in vec4 clip;\n"                                                         \
    "out vec3 n, world;\n"                                                                         \
    "uniform mat4 mvp;\n"

static const char own_vertices[] = GLSL_HEAD GLSL_INPUTS
    "void main() { n = normal; world = position; gl_Position = mvp * vec4(position, 1.0); }\n";

static const char same_vertices[] =
    GLSL_HEAD GLSL_INPUTS "void main() { n = normal; world = position; gl_Position = clip; }\n";

/* shaders_c/materials/phong.c in GLSL; beside the colour, who drew the pixel and at what depth. */
static const char phong_pixel[] =
    GLSL_HEAD "in vec3 n, world;\n"
              "uniform vec3 eye, light, ambient, diffuse;\n"
              "uniform float specular, shininess;\n"
              "layout(location = 0) out vec4 color;\n"
              "layout(location = 1) out uvec2 drawn;\n"
              "void main() {\n"
              "    vec3 N = normalize(n), V = normalize(eye - world), H = normalize(V + light);\n"
              "    float highlight = pow(max(dot(N, H), 0.0), shininess);\n"
              "    vec3 lit = diffuse * max(dot(N, light), 0.0) + ambient;\n"
              "    color = vec4(vec3(highlight) * specular + lit, 1.0);\n"
              "    drawn = uvec2(uint(gl_PrimitiveID), floatBitsToUint(gl_FragCoord.z));\n"
              "}\n";

static unsigned compile(const Gl *gl, unsigned kind, const char *source, GpError *error)
{
    unsigned shader = gl->CreateShader(kind);
    int compiled = 0;
    gl->ShaderSource(shader, 1, &source, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled)
        return shader;
    char log[400] = "";
    gl->GetShaderInfoLog(shader, sizeof log, NULL, log);
    gp_fail(error, GP_ERROR_UNSUPPORTED, "OpenGL ES refused a shader: %s", log);
    gl->DeleteShader(shader);
    return 0;
}

static unsigned link_program(const Gl *gl, PeerVertices vertices, GpError *error)
{
    const char *source = vertices == PEER_OWN_VERTICES ? own_vertices : same_vertices;
    unsigned vertex = compile(gl, GL_VERTEX_SHADER, source, error);
    unsigned pixel = vertex ? compile(gl, GL_FRAGMENT_SHADER, phong_pixel, error) : 0;
    if (!pixel)
        return 0;
    unsigned program = gl->CreateProgram();
    int linked = 0;
    gl->AttachShader(program, vertex);
    gl->AttachShader(program, pixel);
    gl->LinkProgram(program);
    gl->DeleteShader(vertex);
    gl->DeleteShader(pixel);
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked)
        return program;
    gp_fail(error, GP_ERROR_UNSUPPORTED, "OpenGL ES could not link the shaders");
    return 0;
}

static void set_uniforms(const Gl *gl, unsigned program, const PeerScene *scene)
{
    const PhongUniforms *u = &scene->uniforms;
    gl->UseProgram(program);
    gl->UniformMatrix4fv(gl->GetUniformLocation(program, "mvp"), 1, 1, scene->gl_mvp[0]);
    gl->Uniform3fv(gl->GetUniformLocation(program, "eye"), 1, u->eye);
    gl->Uniform3fv(gl->GetUniformLocation(program, "light"), 1, u->light);
    gl->Uniform3fv(gl->GetUniformLocation(program, "ambient"), 1, u->ambient);
    gl->Uniform3fv(gl->GetUniformLocation(program, "diffuse"), 1, u->diffuse);
    gl->Uniform1f(gl->GetUniformLocation(program, "specular"), u->specular);
    gl->Uniform1f(gl->GetUniformLocation(program, "shininess"), u->shininess);
}

/* --- opening ---------------------------------------------------------------------------------- */

static bool load_egl(PeerGl *g)
{
    bool complete = true;
#define LOAD(type, name, arguments)                                                                \
    g->egl.name = (type(*) arguments)dlsym(g->library, "egl" #name);                               \
    complete = complete && g->egl.name;
    EGL_CALLS(LOAD)
#undef LOAD
    return complete;
}

static bool load_gl(PeerGl *g)
{
    bool complete = true;
#define LOAD(type, name, arguments)                                                                \
    g->gl.name = (type(*) arguments)g->egl.GetProcAddress("gl" #name);                             \
    complete = complete && g->gl.name;
    GL_CALLS(LOAD)
#undef LOAD
    return complete;
}

static bool make_context(PeerGl *g)
{
    static const int config_wish[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                       EGL_OPENGL_ES3_BIT, EGL_NONE };
    static const int context_wish[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
                                        EGL_NONE };
    void *config;
    int count = 0;
    g->display = g->egl.GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL);
    if (!g->display || !g->egl.Initialize(g->display, NULL, NULL) ||
        !g->egl.BindAPI(EGL_OPENGL_ES_API) ||
        !g->egl.ChooseConfig(g->display, config_wish, &config, 1, &count) || count < 1)
        return false;
    g->context = g->egl.CreateContext(g->display, config, NULL, context_wish);
    return g->context && g->egl.MakeCurrent(g->display, NULL, NULL, g->context);
}

static GpResult open_into(PeerGl *g, GpError *error)
{
    g->library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!g->library || !load_egl(g))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "no EGL (libEGL.so.1 of EGL 1.5 not found)");
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1); /* leave no files behind */
    if (!make_context(g))
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "no EGL context for OpenGL ES 3.2 without a window system");
    if (!load_gl(g))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "no EGL: functions of OpenGL ES are missing");
    const char *renderer = (const char *)g->gl.GetString(GL_RENDERER);
    const char *version = (const char *)g->gl.GetString(GL_VERSION);
    strncat(g->name, renderer ? renderer : "no name", 120);
    strncat(g->name, ", ", 3);
    strncat(g->name, version ? version : "no version", 120);
    if (!strstr(g->name, "llvmpipe"))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "%s: the bounds are llvmpipe's", g->name);
    return GP_OK;
}

GpResult peer_gl_open(PeerGl **gl, GpError *error)
{
    PeerGl *g = gp_alloc(1, sizeof *g);
    if (!g)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for an OpenGL context");
    GpResult result = open_into(g, error);
    if (result)
        peer_gl_close(&g);
    else
        *gl = g;
    return result;
}

/* The library itself stays loaded: Mesa's worker threads and exit handlers live in it. */
void peer_gl_close(PeerGl **gl)
{
    PeerGl *g = *gl;
    if (g && g->context) {
        g->egl.MakeCurrent(g->display, NULL, NULL, NULL);
        g->egl.DestroyContext(g->display, g->context);
    }
    if (g && g->display)
        g->egl.Terminate(g->display);
    gp_free(g);
    *gl = NULL;
}

const char *peer_gl_name(const PeerGl *gl)
{
    return gl->name;
}

/* --- drawing ---------------------------------------------------------------------------------- */

/* Glasspipe's clip positions in OpenGL's clip space, with y down: OpenGL's row 0 becomes the top
 * row, so that viewport arithmetic and fill rule see the same numbers on both sides. */
static GpResult same_positions(const PeerScene *scene, float (**clip)[4])
{
    float(*positions)[4] = gp_alloc(scene->vertex_count, sizeof *positions);
    if (!positions)
        return GP_ERROR_MEMORY;
    peer_clip_positions(scene, positions);
    for (uint32_t i = 0; i < scene->vertex_count; i++) {
        positions[i][1] = -positions[i][1];
        positions[i][2] = 2 * positions[i][2] - positions[i][3];
    }
    *clip = positions;
    return GP_OK;
}

typedef struct Objects {
    unsigned framebuffer, storage[3], array, buffer[3];
} Objects;

static bool make_targets(const Gl *gl, Objects *o)
{
    static const unsigned format[3] = { GL_RGBA8, GL_RG32UI, GL_DEPTH_COMPONENT32F };
    static const unsigned place[3] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                       GL_DEPTH_ATTACHMENT };
    gl->GenFramebuffers(1, &o->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, o->framebuffer);
    gl->GenRenderbuffers(3, o->storage);
    for (int i = 0; i < 3; i++) {
        gl->BindRenderbuffer(GL_RENDERBUFFER, o->storage[i]);
        gl->RenderbufferStorage(GL_RENDERBUFFER, format[i], PEER_SIZE, PEER_SIZE);
        gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, place[i], GL_RENDERBUFFER, o->storage[i]);
    }
    gl->DrawBuffers(2, place);
    return gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

static void attribute(const Gl *gl, unsigned number, int components, size_t stride, size_t offset)
{
    gl->VertexAttribPointer(number, components, GL_FLOAT, 0, (int)stride, (const void *)offset);
    gl->EnableVertexAttribArray(number);
}

static void make_geometry(const Gl *gl, const PeerScene *scene, float (*clip)[4], Objects *o)
{
    gl->GenVertexArrays(1, &o->array);
    gl->BindVertexArray(o->array);
    gl->GenBuffers(3, o->buffer);
    gl->BindBuffer(GL_ARRAY_BUFFER, o->buffer[0]);
    gl->BufferData(GL_ARRAY_BUFFER, (intptr_t)(scene->vertex_count * sizeof(PeerVertex)),
                   scene->vertices, GL_STATIC_DRAW);
    attribute(gl, 0, 3, sizeof(PeerVertex), offsetof(PeerVertex, position));
    attribute(gl, 1, 3, sizeof(PeerVertex), offsetof(PeerVertex, normal));
    if (clip) {
        gl->BindBuffer(GL_ARRAY_BUFFER, o->buffer[1]);
        gl->BufferData(GL_ARRAY_BUFFER, (intptr_t)(scene->vertex_count * sizeof *clip), clip,
                       GL_STATIC_DRAW);
        attribute(gl, 2, 4, sizeof *clip, 0);
    }
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, o->buffer[2]);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (intptr_t)(scene->index_count * sizeof(uint32_t)),
                   scene->indices, GL_STATIC_DRAW);
}

static void draw(const Gl *gl, const PeerScene *scene)
{
    gl->Viewport(0, 0, PEER_SIZE, PEER_SIZE);
    gl->Disable(GL_DITHER);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_LESS);
    gl->ClearBufferfv(GL_COLOR, 0, (const float[4]){ 0.10f, 0.12f, 0.15f, 0 });
    gl->ClearBufferuiv(GL_COLOR, 1, (const unsigned[4]){ PEER_NOTHING, gp_float_bits(1), 0, 0 });
    gl->ClearBufferfv(GL_DEPTH, 0, &(const float){ 1 });
    gl->DrawElements(GL_TRIANGLES, (int)scene->index_count, GL_UNSIGNED_INT, NULL);
}

static GpResult read_back(const Gl *gl, bool y_up, PeerPicture *picture)
{
    uint32_t(*drawn)[4] = gp_alloc(PEER_PIXELS, sizeof *drawn);
    uint8_t(*rgba)[4] = gp_alloc(PEER_PIXELS, sizeof *rgba);
    if (drawn && rgba) {
        gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
        gl->ReadPixels(0, 0, PEER_SIZE, PEER_SIZE, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
        gl->ReadBuffer(GL_COLOR_ATTACHMENT1);
        gl->ReadPixels(0, 0, PEER_SIZE, PEER_SIZE, GL_RGBA_INTEGER, GL_UNSIGNED_INT, drawn);
        for (size_t i = 0; i < PEER_PIXELS; i++) {
            size_t row = i / PEER_SIZE, column = i % PEER_SIZE;
            size_t from = (y_up ? PEER_SIZE - 1 - row : row) * PEER_SIZE + column;
            memcpy(picture->rgba[i], rgba[from], 4);
            picture->triangle[i] = drawn[from][0];
            picture->depth[i] = gp_bits_float(drawn[from][1]);
        }
    }
    GpResult result = drawn && rgba ? GP_OK : GP_ERROR_MEMORY;
    gp_free(drawn);
    gp_free(rgba);
    return result;
}

GpResult peer_draw_gl(PeerGl *g, const PeerScene *scene, PeerVertices vertices,
                      PeerPicture *picture, GpError *error)
{
    const Gl *gl = &g->gl;
    float(*clip)[4] = NULL;
    if (vertices == PEER_SAME_VERTICES && same_positions(scene, &clip))
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for clip positions");
    unsigned program = link_program(gl, vertices, error);
    if (!program) {
        gp_free(clip);
        return GP_ERROR_UNSUPPORTED;
    }
    Objects o = { 0 };
    GpResult result = GP_OK;
    if (make_targets(gl, &o)) {
        set_uniforms(gl, program, scene);
        make_geometry(gl, scene, clip, &o);
        draw(gl, scene);
        if (read_back(gl, vertices == PEER_OWN_VERTICES, picture))
            result = gp_fail(error, GP_ERROR_MEMORY, "no memory to read the picture back");
    }
    unsigned problem = gl->GetError();
    if (problem)
        result = gp_fail(error, GP_ERROR_UNSUPPORTED, "OpenGL ES error 0x%04x", problem);
    gl->DeleteProgram(program);
    gl->DeleteBuffers(3, o.buffer);
    gl->DeleteVertexArrays(1, &o.array);
    gl->DeleteFramebuffers(1, &o.framebuffer);
    gl->DeleteRenderbuffers(3, o.storage);
    gp_free(clip);
    return result;
}
