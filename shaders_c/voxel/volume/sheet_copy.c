/* A rectangle of a texture over the viewport. */
#include "pipeline/shader.h"
#include "shaders_c/common/cover_shared.h"
#include "shaders_c/voxel/volume/sheet_copy.h"

vertex_shader(sheet_copy_vs, SheetCopyUniforms, CoverVertex, CoverVarying)
{
    *position = cover_position(in->corner);
    out->place = mad(cover_place(in->corner), u2(c->extent), u2(c->origin));
}

pixel_shader(sheet_copy_ps, SheetCopyUniforms, CoverVarying)
{
    return texld(0, in->place);
}

program(sheet_copy_program, sheet_copy_vs, sheet_copy_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, COVER_DECLARATIONS, .samplers = 1 << 0)
