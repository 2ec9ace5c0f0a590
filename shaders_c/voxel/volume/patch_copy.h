/* A rectangle of a texture over the viewport: a patch of a flat texture to another, or all of
 * it. */
#ifndef SHADERS_VOXEL_VOLUME_PATCH_COPY_H
#define SHADERS_VOXEL_VOLUME_PATCH_COPY_H

#include "pipeline/shader/program.h"

typedef struct PatchCopyUniforms {
    float origin[2], extent[2]; /* of the rectangle, in texture space */
} PatchCopyUniforms;

/* Drawn with flat_texture_cover. Slot 0: the texture. */
extern const GpProgram patch_copy_program;

#endif
