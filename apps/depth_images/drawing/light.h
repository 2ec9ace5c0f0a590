/* The light of a view, as programs take it. */
#ifndef APPS_DEPTH_IMAGES_DRAWING_LIGHT_H
#define APPS_DEPTH_IMAGES_DRAWING_LIGHT_H

#include "apps/depth_images/drawing/view.h"
#include "shaders_c/warp/light.h"

/* How bright highlights are, and how small. */
#define WARP_SPECULAR  0.25
#define WARP_SHININESS 32.0

/* in   view: lit */
WarpLightUniforms warp_light_uniforms(const WarpView *view);

/* A white light without end that stands to the left of a camera's eye and above it. */
WarpLight warp_light_beside(const Camera *camera);

#endif
