/* Texels on their way into another surface: as they are, or inverted. Constructive solid geometry
 * on flat textures is then a choice of the blend operation.
 * source Dong, Chen, Bao, Zhang and Peng, Pacific Graphics 2004: blending of flat textures */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/common/texel_copy.h"

clip_vertex_shader(texel_copy_vs, NoUniforms);

pixel_shader(texel_copy_ps, NoUniforms, NoVarying)
{
    return gp_load_local(0);
}

/* A byte b is read as b / 255: what is left to 1 is stored as 255 - b, which is ~b. */
pixel_shader(texel_complement_ps, NoUniforms, NoVarying)
{
    return sub(sp4(bcast(1)), gp_load_local(0));
}

pixel_shader(texel_depth_ps, NoUniforms, NoVarying)
{
    odepth(gp_load_local(0).x);
    return sp4(bcast(1));
}

/* clang-format off */
#define TEXEL_DECLARATIONS MODEL_2_0, .inputs = { { GP_POSITION, 3 } }, .local_reads = 1 << 0
/* clang-format on */

program(texel_copy_program, texel_copy_vs, texel_copy_ps, TEXEL_DECLARATIONS)
program(texel_complement_program, texel_copy_vs, texel_complement_ps, TEXEL_DECLARATIONS)
program(texel_depth_program, texel_copy_vs, texel_depth_ps, TEXEL_DECLARATIONS,
        .writes_depth = true)
