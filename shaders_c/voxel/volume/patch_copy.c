/* A rectangle of a texture over the viewport. */
#include "shaders_c/common/cover_shared.h"
#include "shaders_c/voxel/volume/patch_copy.h"

vertex_shader(patch_copy_vs, PatchCopyUniforms, CoverVertex, CoverVarying)
{
    *position = cover(in, out);
    out->place = mad(out->place, u2(c->extent), u2(c->origin));
}

pixel_shader(patch_copy_ps, PatchCopyUniforms, CoverVarying)
{
    return texld(0, in->place);
}

program(patch_copy_program, patch_copy_vs, patch_copy_ps, MODEL_2_0, COVER_DECLARATIONS,
        .samplers = 1 << 0)
