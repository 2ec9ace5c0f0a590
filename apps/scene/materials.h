/* Materials from JSON: which program, and what stands in its uniforms. */
#ifndef APPS_SCENE_MATERIALS_H
#define APPS_SCENE_MATERIALS_H

#include "apps/scene/loader.h"

/* What a program is called in a material. */
const char *scene_program_name(const GpProgram *program);

/* Direction towards the first light, world, unit length, as seen from where the camera looks at. */
void scene_light_direction(const SceneView *view, float direction[3]);

/* "material": program, uniforms, textures.
 * in   program: the one where none is named; draw: textures that it has are what programs read */
void scene_read_material(Loader *loader, Node node, const SceneView *view, const char *program,
                         GpDraw *draw);

#endif
