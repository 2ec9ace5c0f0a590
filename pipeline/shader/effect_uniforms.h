/* The uniforms of <glasspipe/effect.h>. */
#ifndef GP_EFFECT_UNIFORMS_H
#define GP_EFFECT_UNIFORMS_H

/* The uniforms of a shader that is drawn without a project. */
typedef struct EffectUniforms {
    float view_projection[4][4]; /* world to clip: m4x4(in->position, c->view_projection) */
    float eye[3];                /* world */
    float light[3];      /* towards the light, world, unit length: over the right shoulder */
    float time;          /* --time, seconds */
    float resolution[2]; /* width and height of the picture */
    float values[8];     /* --values 0.5,2: what the shader makes of them */
} EffectUniforms;

#endif
