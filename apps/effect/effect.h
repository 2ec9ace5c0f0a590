/* A frame of one model, drawn by a program that takes <glasspipe/effect.h>'s uniforms. */
#ifndef APPS_EFFECT_EFFECT_H
#define APPS_EFFECT_EFFECT_H

#include "apps/base/orbit.h"
#include "apps/frame/frame.h"

typedef struct EffectInput {
    const GpProgram *program;
    const char *model; /* a mesh's name, as model_shape takes it */
    /* a picture, or builtin:NAME; bound to every slot that the program reads */
    const char *texture;
    Orbit orbit;
    uint32_t width, height;
    double time;
    float values[8];
} EffectInput;

/* Builds the frame, into a zeroed one.
 * out    frame->color: A8R8G8B8 on dark grey; frame->depth: D24S8
 * errors GP_ERROR_INVALID: the program has other uniforms, or inputs that a model has not; those of
 *        model_shape and of reading a picture; GP_ERROR_MEMORY */
GpResult effect_build(const EffectInput *input, Frame *frame, GpError *error);

#endif
