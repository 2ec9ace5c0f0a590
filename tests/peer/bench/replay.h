/* Lists of glasspipe, drawn by OpenGL ES: the same triangles, textures, targets and state, and the
 * same arithmetic in shaders that are written twice (programs.c). What a benchmark case is, is said
 * once, where it is built for glasspipe.
 *
 * Everything that does not change from frame to frame is prepared once, and only what changes from
 * draw to draw is set, as a program written for OpenGL would do it.
 */
#ifndef PEER_BENCH_REPLAY_H
#define PEER_BENCH_REPLAY_H

#include <glasspipe/glasspipe.h>
#include "tests/peer/gl.h"

enum {
    REPLAY_UNITS = 2,
    REPLAY_SURFACES = 16,
    REPLAY_PROGRAMS = 8,
    REPLAY_UNIFORMS = 12,
};

/* --- programs.c: shaders in GLSL -------------------------------------------------------------- */

typedef enum UniformKind {
    UNIFORM_FLOAT,
    UNIFORM_VEC3,
    UNIFORM_VEC4,
    UNIFORM_MATRIX,
    UNIFORM_CLIP, /* a matrix to clip space: becomes OpenGL's, with -w <= z */
} UniformKind;

/* A member of a program's uniforms. */
typedef struct Uniform {
    const char *name; /* NULL: the end */
    UniformKind kind;
    size_t offset;
} Uniform;

/* Attribute 0 is the position, attribute 1 what the geometry has beside it. */
typedef struct Translation {
    const GpProgram *program;
    const char *vertex, *pixel;
    Uniform uniforms[REPLAY_UNIFORMS + 1];
} Translation;

extern const char glsl_head[];         /* goes before each shader */
extern const char *const glsl_units[]; /* names of samplers: of unit 0, 1 */
extern const char glsl_screen[], glsl_show[];

/* The translation of a program, or NULL. */
const Translation *translation_find(const GpProgram *program);

/* --- replay.c --------------------------------------------------------------------------------- */

typedef struct Replay Replay;

/* Prepares a list of passes for a driver.
 * in   gl, list: borrowed until replay_destroy; the list is one that gp_list_check accepts
 * errors GP_ERROR_UNSUPPORTED: the list uses what is not translated, or OpenGL refused it;
 *        GP_ERROR_MEMORY
 * owns the caller, until replay_destroy; objects of OpenGL go with its context */
GpResult replay_create(const Gl *gl, const GpList *list, Replay **replay, GpError *error);
void replay_destroy(Replay **replay); /* NULL-safe; sets NULL */

/* Draws one frame, and waits until the driver has finished it. */
void replay_frame(Replay *replay);

/* What became of the frames so far. Errors: GP_ERROR_UNSUPPORTED (an OpenGL error). */
GpResult replay_check(const Replay *replay, GpError *error);

/* Copies an eight-bit target of the last frame into the list's surface. */
void replay_fetch(Replay *replay, GpSurface *surface);

/* The last frame as bench_show gives it: colour clamped to eight bits, or without a colour 6 times
 * the distance from the far plane as grey; alpha is 255, or 0 where the depth buffer stayed clear.
 * in   color, depth: targets of the list; either may be NULL
 * out  rgba: rows from the top */
GpResult replay_show(Replay *replay, const GpSurface *color, const GpSurface *depth, uint8_t *rgba,
                     GpError *error);

#endif
