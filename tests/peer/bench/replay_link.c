/* Programs in GLSL, and their uniforms. */
#include "tests/peer/bench/replay_parts.h"

#include <string.h>

GpResult replay_link(const Gl *gl, const char *vertex, const char *pixel, unsigned *program,
                     GpError *error)
{
    unsigned name;
    GpResult result = gl_link(gl, glsl_head, vertex, pixel, &name, error);
    if (result)
        return result;
    gl->UseProgram(name);
    for (int i = 0; i < REPLAY_UNITS; i++)
        gl->Uniform1i(gl->GetUniformLocation(name, glsl_units[i]), i);
    *program = name;
    return GP_OK;
}

GpResult replay_make_program(Replay *r, const GpProgram *program, Linked **linked, GpError *error)
{
    const Translation *translation = translation_find(program);
    if (!translation)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "no GLSL for %s", program->name);
    for (int i = 0; i < r->program_count; i++)
        if (r->programs[i].translation == translation) {
            *linked = &r->programs[i];
            return GP_OK;
        }
    GP_ASSERT(r->program_count < REPLAY_PROGRAMS);
    Linked *made = &r->programs[r->program_count++];
    made->translation = translation;
    *linked = made;
    GpResult result =
        replay_link(r->gl, translation->vertex, translation->pixel, &made->name, error);
    for (int i = 0; !result && translation->uniforms[i].name; i++)
        made->locations[i] = r->gl->GetUniformLocation(made->name, translation->uniforms[i].name);
    return result;
}

/* OpenGL's clip space: z' = 2 z - w. */
static void to_gl_clip(const float from[16], float to[16])
{
    memcpy(to, from, 16 * sizeof *to);
    for (int i = 8; i < 12; i++)
        to[i] = (float)(2 * (double)from[i] - (double)from[i + 4]);
}

static size_t uniform_size(UniformKind kind)
{
    static const uint8_t floats[] = {
        [UNIFORM_FLOAT] = 1,   [UNIFORM_VEC3] = 3,  [UNIFORM_VEC4] = 4,
        [UNIFORM_MATRIX] = 16, [UNIFORM_CLIP] = 16,
    };
    return floats[kind] * sizeof(float);
}

void replay_set_uniforms(const Gl *gl, Linked *linked, const void *uniforms)
{
    const char *before = linked->uniforms, *values = uniforms;
    if (before == values)
        return;
    const Uniform *u = linked->translation->uniforms;
    for (int i = 0; u[i].name; i++) {
        int location = linked->locations[i];
        float value[16], clip[16];
        if (before && !memcmp(before + u[i].offset, values + u[i].offset, uniform_size(u[i].kind)))
            continue;
        memcpy(value, values + u[i].offset, uniform_size(u[i].kind));
        switch (u[i].kind) {
        case UNIFORM_FLOAT:
            gl->Uniform1f(location, value[0]);
            break;
        case UNIFORM_VEC3:
            gl->Uniform3fv(location, 1, value);
            break;
        case UNIFORM_VEC4:
            gl->Uniform4fv(location, 1, value);
            break;
        case UNIFORM_MATRIX:
            gl->UniformMatrix4fv(location, 1, 1, value);
            break;
        case UNIFORM_CLIP:
            to_gl_clip(value, clip);
            gl->UniformMatrix4fv(location, 1, 1, clip);
            break;
        }
    }
    linked->uniforms = uniforms;
}
