/* Opening llvmpipe through surfaceless EGL 1.5. */
#include "tests/peer/gl.h"

#include <dlfcn.h>
#include <stdio.h>
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
/* clang-format on */

typedef struct Egl {
#define EGL_MEMBER(type, name, arguments) type(*name) arguments;
    EGL_CALLS(EGL_MEMBER)
#undef EGL_MEMBER
} Egl;

static bool load_egl(void *library, Egl *egl)
{
    bool complete = true;
#define LOAD(type, name, arguments)                                                                \
    egl->name = (type(*) arguments)dlsym(library, "egl" #name);                                    \
    complete = complete && egl->name;
    EGL_CALLS(LOAD)
#undef LOAD
    return complete;
}

static bool load_gl(const Egl *egl, Gl *gl)
{
    bool complete = true;
#define LOAD(type, name, arguments)                                                                \
    gl->name = (type(*) arguments)egl->GetProcAddress("gl" #name);                                 \
    complete = complete && gl->name;
    GL_CALLS(LOAD)
#undef LOAD
    return complete;
}

static bool make_context(const Egl *egl, int minor, Gl *gl)
{
    static const int config_wish[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                       EGL_OPENGL_ES3_BIT, EGL_NONE };
    const int context_wish[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, minor,
                                 EGL_NONE };
    void *config;
    int count = 0;
    gl->display = egl->GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL);
    if (!gl->display || !egl->Initialize(gl->display, NULL, NULL) ||
        !egl->BindAPI(EGL_OPENGL_ES_API) ||
        !egl->ChooseConfig(gl->display, config_wish, &config, 1, &count) || count < 1)
        return false;
    gl->context = egl->CreateContext(gl->display, config, NULL, context_wish);
    return gl->context && egl->MakeCurrent(gl->display, NULL, NULL, gl->context);
}

GpResult gl_open(int minor, int threads, Gl *gl, GpError *error)
{
    Egl egl;
    char number[16];
    *gl = (Gl){ .library = NULL };
    snprintf(number, sizeof number, "%d", threads);
    if (threads > 0)
        setenv("LP_NUM_THREADS", number, 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1); /* so that the first frame shows compiling */
    gl->library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!gl->library || !load_egl(gl->library, &egl))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "no EGL (libEGL.so.1 of EGL 1.5 not found)");
    if (!make_context(&egl, minor, gl))
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "no EGL context for OpenGL ES 3.%d without a window system", minor);
    if (!load_gl(&egl, gl))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "no EGL: functions of OpenGL ES are missing");
    const char *renderer = (const char *)gl->GetString(GL_RENDERER);
    if (!renderer || !strstr(renderer, "llvmpipe"))
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "no EGL with llvmpipe: the driver is %s",
                       renderer ? renderer : "without a name");
    return GP_OK;
}

void gl_close(Gl *gl)
{
    Egl egl;
    if (gl->context) {
        load_egl(gl->library, &egl);
        egl.MakeCurrent(gl->display, NULL, NULL, NULL);
        egl.DestroyContext(gl->display, gl->context);
        egl.Terminate(gl->display);
    }
    *gl = (Gl){ .library = NULL };
}

/* --- programs --------------------------------------------------------------------------------- */

static unsigned compile(const Gl *gl, unsigned kind, const char *head, const char *source,
                        GpError *error)
{
    const char *text[2] = { head, source };
    unsigned shader = gl->CreateShader(kind);
    int compiled = 0;
    gl->ShaderSource(shader, 2, text, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[400] = "";
        gl->GetShaderInfoLog(shader, sizeof log, NULL, log);
        gp_fail(error, GP_ERROR_UNSUPPORTED, "OpenGL ES refused a shader: %s", log);
    }
    return shader;
}

GpResult gl_link(const Gl *gl, const char *head, const char *vertex, const char *pixel,
                 unsigned *program, GpError *error)
{
    GpError reason = { "" };
    unsigned name = gl->CreateProgram();
    const unsigned shaders[2] = { compile(gl, GL_VERTEX_SHADER, head, vertex, &reason),
                                  compile(gl, GL_FRAGMENT_SHADER, head, pixel, &reason) };
    int linked = 0;
    for (int i = 0; i < 2; i++) {
        gl->AttachShader(name, shaders[i]);
        gl->DeleteShader(shaders[i]); /* when the program goes */
    }
    gl->LinkProgram(name);
    gl->GetProgramiv(name, GL_LINK_STATUS, &linked);
    if (!linked)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "shaders do not link; %s", reason.text);
    *program = name;
    return GP_OK;
}
