/* What the files of a replay share: the objects of a list in OpenGL. */
#ifndef PEER_BENCH_REPLAY_PARTS_H
#define PEER_BENCH_REPLAY_PARTS_H

#include "tests/peer/bench/replay.h"

typedef struct Texture {
    const GpSurface *surface;
    unsigned name;
} Texture;

typedef struct Linked {
    const Translation *translation;
    unsigned name;
    int locations[REPLAY_UNIFORMS];
    const void *uniforms; /* those set last; NULL: none yet */
} Linked;

/* What a draw needs beside what it says itself. */
typedef struct Step {
    const GpGeometry *geometry;
    unsigned array; /* of vertices */
    Linked *linked;
} Step;

struct Replay {
    const Gl *gl;
    const GpList *list;
    Texture textures[REPLAY_SURFACES];
    Linked programs[REPLAY_PROGRAMS];
    int texture_count, program_count;
    unsigned *framebuffers; /* one a pass; passes of the same targets share theirs */
    Step *steps;            /* one a draw */

    /* what is set at present, so as not to set it again */
    const GpState *state;
    const GpSurface *unit[REPLAY_UNITS];
    Step now;
};

/* --- replay_objects.c: textures, framebuffers, arrays of vertices ----------------------------- */

/* The texture of a surface; 0: not made yet, or no surface. */
unsigned replay_find_texture(const Replay *r, const GpSurface *surface);

/* Makes it, if it is not there, with the content of eight-bit surfaces.
 * errors GP_ERROR_UNSUPPORTED (format), GP_ERROR_MEMORY */
GpResult replay_make_texture(Replay *r, const GpSurface *surface, GpError *error);

/* Sets how a texture is sampled. Errors: GP_ERROR_UNSUPPORTED. */
GpResult replay_set_sampler(const Replay *r, const GpTexture *texture, GpError *error);

/* Makes the framebuffer of a pass; those before it, and its textures, are there. Errors:
 * GP_ERROR_UNSUPPORTED. */
GpResult replay_make_framebuffer(Replay *r, uint32_t pass, GpError *error);

/* Interleaved floats in one buffer, indices in another. Errors: GP_ERROR_MEMORY. */
GpResult replay_make_array(const Gl *gl, const GpGeometry *geometry, unsigned *array,
                           GpError *error);

/* To A8R8G8B8, which is blue, green, red, alpha in memory, and back; in place too. */
void replay_swap_red_and_blue(const uint8_t *from, size_t texels, uint8_t *to);

/* --- replay_link.c: programs and uniforms ----------------------------------------------------- */

/* Links two shaders and leaves them in use. Errors: GP_ERROR_UNSUPPORTED, with OpenGL's reason. */
GpResult replay_link(const Gl *gl, const char *vertex, const char *pixel, unsigned *program,
                     GpError *error);

/* The translation of a program, linked. Errors: GP_ERROR_UNSUPPORTED. */
GpResult replay_make_program(Replay *r, const GpProgram *program, Linked **linked, GpError *error);

/* Sets those that differ from what the program, which is in use, has already. */
void replay_set_uniforms(const Gl *gl, Linked *linked, const void *uniforms);

#endif
