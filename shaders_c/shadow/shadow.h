/* The second pass of shadow mapping: a surface lit by one light, as far as its map lets it.
 *
 * Texture 0 is the surface's colour (the programs without `textured` have none), texture 1 the
 * light's map. Alpha is the visibility of the light, which is what the truth speaks of.
 */
#ifndef SHADERS_SHADOW_H
#define SHADERS_SHADOW_H

#include "pipeline/shader/program.h"

typedef struct ShadowUniforms {
    float mvp[4][4]; /* world to clip */
    float map[4][4]; /* world to the map: u w, v w, depth w, w; the plain forms: to clip space */
    float eye[3];    /* world */
    float light[4];  /* world; w 0: the direction towards it, unit length */
    /* of its cone: direction out of the light, and the cosine to the edge; without a cone that is
     * below -1 */
    float axis[4];
    float color[3];               /* the light's */
    float ambient[3], diffuse[3]; /* the surface's, linear */
    float specular, shininess;
    float half_texel;    /* of the map, in texture coordinates: Direct3D 9's offset */
    float epsilon;       /* taken from the depth before it is compared */
    float map_size;      /* texels a side */
    float offset;        /* along the normal, in texels, for a surface that light grazes */
    float texel;         /* a texel's side in the world, at w = 1 */
    float least_w;       /* what has no more w is behind the light, and lit */
    float face_depth[2]; /* cube: a depth is a - b / (distance along the face's view) */
    /* soft only */
    float distance[4]; /* (a + b z) / (c + d z) is the way from the light to a stored depth z */
    float nearest;     /* distance at which things may begin to block */
    float light_size;  /* side of the light, in texture coordinates of the map at distance 1 */
    /* (0, 1) where the map's rays part from a point, (1, 0) where they are parallel */
    float spread[2];
} ShadowUniforms;

/* How the map is asked: plain, depths in a colour target, compared in the shader (thesis, section
 * 4.2) once or four times; hardware, a depth surface behind a sampler that compares (section 4.3);
 * soft, as plain but in an area as wide as the penumbra; cube, hardware from a map of all that is
 * around a light. What is turned away from the light is dark: smooth by its normals, flat by its
 * triangles. */
#define SHADOW_PROGRAMS(form)                                                                      \
    extern const GpProgram shadow_##form##_smooth_program,                                         \
        shadow_##form##_smooth_textured_program, shadow_##form##_flat_program,                     \
        shadow_##form##_flat_textured_program

SHADOW_PROGRAMS(plain_nearest);
SHADOW_PROGRAMS(plain_bilinear);
SHADOW_PROGRAMS(hardware);
SHADOW_PROGRAMS(soft);
SHADOW_PROGRAMS(cube);

#endif
