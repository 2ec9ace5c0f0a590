/* The scenes through OpenGL ES 3.2 on Mesa's llvmpipe. */
#include "tests/peer/gl.h"
#include "tests/peer/peer.h"

#include <stdio.h>
#include <string.h>

struct PeerGl {
    Gl gl;
    char name[256];
};

/* --- shaders ---------------------------------------------------------------------------------- */

static const char glsl_head[] = "#version 320 es\nprecision highp float;\nprecision highp int;\n";

#define GLSL_INPUTS                                                                                \
    "layout(location = 0) in vec3 position;\n"                                                     \
    "layout(location = 1) in vec3 normal;\n"                                                       \
    "layout(location = 2) in vec4 clip;\n"                                                         \
    "out vec3 n, world;\n"                                                                         \
    "uniform mat4 mvp;\n"

static const char own_vertices[] = GLSL_INPUTS
    "void main() { n = normal; world = position; gl_Position = mvp * vec4(position, 1.0); }\n";

static const char same_vertices[] =
    GLSL_INPUTS "void main() { n = normal; world = position; gl_Position = clip; }\n";

/* shaders_c/materials/phong_shared.h in GLSL; beside the colour, who drew the pixel and at what
 * depth. */
static const char phong_pixel[] =
    "in vec3 n, world;\n"
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

GpResult peer_gl_open(PeerGl **gl, GpError *error)
{
    PeerGl *g = gp_alloc(1, sizeof *g);
    if (!g)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for an OpenGL context");
    GpResult result = gl_open(2, 0, &g->gl, error);
    if (result) {
        peer_gl_close(&g);
        return result;
    }
    snprintf(g->name, sizeof g->name, "%.120s, %.120s", g->gl.GetString(GL_RENDERER),
             g->gl.GetString(GL_VERSION));
    *gl = g;
    return GP_OK;
}

void peer_gl_close(PeerGl **gl)
{
    if (*gl)
        gl_close(&(*gl)->gl);
    gp_free(*gl);
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
    unsigned program;
    GpResult result =
        gl_link(gl, glsl_head, vertices == PEER_OWN_VERTICES ? own_vertices : same_vertices,
                phong_pixel, &program, error);
    if (result) {
        gp_free(clip);
        return result;
    }
    Objects o = { 0 };
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
