/* Texels of a worksheet on their way into another: as they are, or inverted. Constructive solid
 * geometry on volumes is then a choice of the blend operation.
 * source Dong, Chen, Bao, Zhang and Peng, Pacific Graphics 2004: blending of worksheets */
#include "pipeline/shader.h"
#include "shaders_c/voxel_combine.h"

typedef struct NoUniforms {
} NoUniforms; /* a draw's may be NULL */

typedef struct Vertex {
    float3 position;
} Vertex;

typedef struct Nothing {
} Nothing;

vertex_shader(voxel_sheet_vs, NoUniforms, Vertex, Nothing)
{
    *position = rgba(in->position, 1);
}

pixel_shader(voxel_copy_ps, NoUniforms, Nothing)
{
    return gp_load_local(0);
}

/* A byte b is read as b / 255: what is left to 1 is stored as 255 - b, which is ~b. */
pixel_shader(voxel_complement_ps, NoUniforms, Nothing)
{
    return sub(sp4(bcast(1)), gp_load_local(0));
}

/* clang-format off */
#define SHEET_DECLARATIONS                                                                         \
    .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0,                                       \
    .inputs = { { GP_POSITION, 3 } }, .local_reads = 1 << 0

program(voxel_copy_program, voxel_sheet_vs, voxel_copy_ps, SHEET_DECLARATIONS)
program(voxel_complement_program, voxel_sheet_vs, voxel_complement_ps, SHEET_DECLARATIONS)
