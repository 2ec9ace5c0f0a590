/* OpenGL ES 3 on Mesa's llvmpipe, without a window and without headers or libraries to build with:
 * libEGL is opened while running, and the prototypes and constants are the Khronos registry's.
 */
#ifndef PEER_GL_H
#define PEER_GL_H

#include "pipeline/base/base.h"

enum {
    GL_POINTS = 0,
    GL_ONE = 1,
    GL_TRIANGLES = 4,
    GL_NEVER = 0x0200,
    GL_LESS = 0x0201,
    GL_EQUAL = 0x0202,
    GL_LEQUAL = 0x0203,
    GL_GREATER = 0x0204,
    GL_NOTEQUAL = 0x0205,
    GL_GEQUAL = 0x0206,
    GL_ALWAYS = 0x0207,
    GL_SRC_ALPHA = 0x0302,
    GL_ONE_MINUS_SRC_ALPHA = 0x0303,
    GL_DST_ALPHA = 0x0304,
    GL_ONE_MINUS_DST_ALPHA = 0x0305,
    GL_CULL_FACE = 0x0b44,
    GL_DEPTH_TEST = 0x0b71,
    GL_DITHER = 0x0bd0,
    GL_BLEND = 0x0be2,
    GL_TEXTURE_2D = 0x0de1,
    GL_UNSIGNED_BYTE = 0x1401,
    GL_UNSIGNED_INT = 0x1405,
    GL_FLOAT = 0x1406,
    GL_COLOR = 0x1800,
    GL_DEPTH = 0x1801,
    GL_RGBA = 0x1908,
    GL_RENDERER = 0x1f01,
    GL_VERSION = 0x1f02,
    GL_NEAREST = 0x2600,
    GL_LINEAR = 0x2601,
    GL_NEAREST_MIPMAP_NEAREST = 0x2700,
    GL_TEXTURE_MAG_FILTER = 0x2800,
    GL_TEXTURE_MIN_FILTER = 0x2801,
    GL_TEXTURE_WRAP_S = 0x2802,
    GL_TEXTURE_WRAP_T = 0x2803,
    GL_REPEAT = 0x2901,
    GL_RGBA8 = 0x8058,
    GL_CLAMP_TO_EDGE = 0x812f,
    GL_RG32UI = 0x823c,
    GL_MIRRORED_REPEAT = 0x8370,
    GL_TEXTURE0 = 0x84c0,
    GL_RGBA32F = 0x8814,
    GL_RGBA16F = 0x881a,
    GL_TEXTURE_COMPARE_MODE = 0x884c,
    GL_TEXTURE_COMPARE_FUNC = 0x884d,
    GL_COMPARE_REF_TO_TEXTURE = 0x884e,
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

/* clang-format off */
#define GL_CALLS(X)                                                                                \
    X(const unsigned char *, GetString, (unsigned))                                                \
    X(unsigned, GetError, (void))                                                                  \
    X(void, Finish, (void))                                                                        \
    X(void, Enable, (unsigned))                                                                    \
    X(void, Disable, (unsigned))                                                                   \
    X(void, DepthFunc, (unsigned))                                                                 \
    X(void, DepthMask, (unsigned char))                                                            \
    X(void, BlendFunc, (unsigned, unsigned))                                                       \
    X(void, Viewport, (int, int, int, int))                                                        \
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
    X(int, GetUniformLocation, (unsigned, const char *))                                           \
    X(void, Uniform1i, (int, int))                                                                 \
    X(void, Uniform1f, (int, float))                                                               \
    X(void, Uniform3fv, (int, int, const float *))                                                 \
    X(void, Uniform4fv, (int, int, const float *))                                                 \
    X(void, UniformMatrix4fv, (int, int, unsigned char, const float *))                            \
    X(void, ActiveTexture, (unsigned))                                                             \
    X(void, GenTextures, (int, unsigned *))                                                        \
    X(void, BindTexture, (unsigned, unsigned))                                                     \
    X(void, TexStorage2D, (unsigned, int, unsigned, int, int))                                     \
    X(void, TexParameteri, (unsigned, unsigned, int))                                              \
    X(void, TexSubImage2D, (unsigned, int, int, int, int, int, unsigned, unsigned, const void *))  \
    X(void, GenFramebuffers, (int, unsigned *))                                                    \
    X(void, BindFramebuffer, (unsigned, unsigned))                                                 \
    X(void, FramebufferTexture2D, (unsigned, unsigned, unsigned, unsigned, int))                   \
    X(unsigned, CheckFramebufferStatus, (unsigned))                                                \
    X(void, DrawBuffers, (int, const unsigned *))                                                  \
    X(void, ClearBufferfv, (unsigned, int, const float *))                                         \
    X(void, ReadBuffer, (unsigned))                                                                \
    X(void, ReadPixels, (int, int, int, int, unsigned, unsigned, void *))                          \
    X(void, GenVertexArrays, (int, unsigned *))                                                    \
    X(void, BindVertexArray, (unsigned))                                                           \
    X(void, GenBuffers, (int, unsigned *))                                                         \
    X(void, BindBuffer, (unsigned, unsigned))                                                      \
    X(void, BufferData, (unsigned, intptr_t, const void *, unsigned))                              \
    X(void, VertexAttribPointer, (unsigned, int, unsigned, unsigned char, int, const void *))      \
    X(void, EnableVertexAttribArray, (unsigned))                                                   \
    X(void, DrawArrays, (unsigned, int, int))                                                      \
    X(void, DrawElements, (unsigned, int, unsigned, const void *))                                 \
    X(void, DeleteProgram, (unsigned))                                                             \
    X(void, GenRenderbuffers, (int, unsigned *))                                                   \
    X(void, BindRenderbuffer, (unsigned, unsigned))                                                \
    X(void, RenderbufferStorage, (unsigned, unsigned, int, int))                                   \
    X(void, DeleteRenderbuffers, (int, const unsigned *))                                          \
    X(void, FramebufferRenderbuffer, (unsigned, unsigned, unsigned, unsigned))                     \
    X(void, DeleteFramebuffers, (int, const unsigned *))                                           \
    X(void, ClearBufferuiv, (unsigned, int, const unsigned *))                                     \
    X(void, DeleteVertexArrays, (int, const unsigned *))                                           \
    X(void, DeleteBuffers, (int, const unsigned *))
/* clang-format on */

/* OpenGL's functions, without the "gl" of their names, and the context they work on. */
typedef struct Gl {
#define GL_MEMBER(type, name, arguments) type(*name) arguments;
    GL_CALLS(GL_MEMBER)
#undef GL_MEMBER
    void *library, *display, *context;
} Gl;

/* Opens llvmpipe and makes a fresh context current in this thread.
 * in   minor: of OpenGL ES 3.x, at least; threads: llvmpipe's rasterizer threads, whose vertex
 *      stage runs in the caller's beside them; 0: as many as it likes
 * out  *gl: to be closed, even after an error
 * errors GP_ERROR_UNSUPPORTED: no library, no such platform, or another driver; says which */
GpResult gl_open(int minor, int threads, Gl *gl, GpError *error);

/* Frees the context and all that was made in it. The library itself stays loaded: Mesa's worker
 * threads and exit handlers live in it. */
void gl_close(Gl *gl);

/* Links two shaders, before each of which `head` goes. Errors: GP_ERROR_UNSUPPORTED, with OpenGL's
 * reason. */
GpResult gl_link(const Gl *gl, const char *head, const char *vertex, const char *pixel,
                 unsigned *program, GpError *error);

#endif
