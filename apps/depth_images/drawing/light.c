#include "apps/depth_images/drawing/light.h"

#include <string.h>

WarpLightUniforms warp_light_uniforms(const WarpView *view)
{
    const Camera *camera = &view->camera;
    const WarpLight *light = view->light;
    const bool is_parallel = !(camera->fovy > 0);
    WarpLightUniforms uniforms = { .specular = (float)WARP_SPECULAR,
                                   .shininess = (float)WARP_SHININESS };
    double towards[3];
    vector_subtract(camera->eye, camera->at, towards);
    vector_normalize(towards);
    for (int k = 0; k < 3; k++) {
        uniforms.eye[k] = (float)(is_parallel ? towards[k] : camera->eye[k]);
        uniforms.source[k] = (float)light->position[k];
    }
    uniforms.eye[3] = is_parallel ? 0 : 1;
    uniforms.source[3] = light->directional ? 0 : 1;
    memcpy(uniforms.color, light->color, sizeof uniforms.color);
    memcpy(uniforms.ambient, light->ambient, sizeof uniforms.ambient);
    return uniforms;
}

WarpLight warp_light_beside(const Camera *camera)
{
    const CameraAxes axes = camera_axes(camera, 1);
    WarpLight light = { .directional = true,
                        .color = { 0.85f, 0.85f, 0.85f },
                        .ambient = { 0.15f, 0.15f, 0.15f } };
    for (int k = 0; k < 3; k++)
        light.position[k] = -0.4 * axes.right[k] + 0.5 * axes.up[k] - axes.forward[k];
    vector_normalize(light.position);
    return light;
}
