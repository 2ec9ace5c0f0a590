/* Voxels of 8 and 16 bits: normals and colours, as whole numbers in one or two bytes.
 * source Dong et al., Pacific Graphics 2004, name what voxels may carry; the codes are ours */
#include "pipeline/shader.h"
#include "shaders_c/voxel/methods/sheets_shared.h"

typedef struct Vertex {
    float3 position, value;
} Vertex;

typedef struct Varying {
    flt depth;
    float3 value;
} Varying;

/* --- normals ---------------------------------------------------------------------------------- */

vertex_shader(voxel_normals_vs, VoxelSheetsUniforms, Vertex, Varying)
{
    *position = place_on_patch(c, in->position, &out->depth);
    out->value = m3x3(in->value, c->to_volume);
}

GP_INLINE flt fold(flt a, flt b)
{
    return sel(a >= 0.0f, 1.0f - abs_(b), abs_(b) - 1.0f);
}

/* The octahedron |x| + |y| + |z| = 1 laid flat: its lower half is folded out over the corners.
 * source Meyer, Suessmuth, Sussner, Stamminger and Greiner, "On floating-point normal vectors",
 *        EGSR 2010 */
pixel_shader_targets(voxel_normals_ps, VoxelSheetsUniforms, Varying, Targets)
{
    float3 n = in->value;
    n = mul(n, rcp(abs_(n.x) + abs_(n.y) + abs_(n.z)));
    flt a = sel(n.z < 0.0f, fold(n.x, n.y), n.x), b = sel(n.z < 0.0f, fold(n.y, n.x), n.y);
    flt first = floor_(sat(a * 0.5f + 0.5f) * c->levels[0] + 0.5f);
    flt second = floor_(sat(b * 0.5f + 0.5f) * c->levels[1] + 0.5f);
    put_value(c, in->depth, first * c->weights[0] + second * c->weights[1] + c->offset, out);
}

program(voxel_normals_program, voxel_normals_vs, voxel_normals_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_B, .inputs = { { GP_POSITION, 3 }, { GP_NORMAL, 3 } },
        .varyings = { { "depth", 1, GP_PERSPECTIVE }, { "value", 3, GP_PERSPECTIVE } })

/* --- colours ---------------------------------------------------------------------------------- */

vertex_shader(voxel_colors_vs, VoxelSheetsUniforms, Vertex, Varying)
{
    *position = place_on_patch(c, in->position, &out->depth);
    out->value = in->value;
}

/* Black is nearly so: 0 says that nothing is there. */
pixel_shader_targets(voxel_colors_ps, VoxelSheetsUniforms, Varying, Targets)
{
    float3 whole = floor_(add(mul(sat(in->value), u3(c->levels)), 0.5f));
    flt code = dp3(whole, u3(c->weights));
    put_value(c, in->depth, max(code, 1), out);
}

program(voxel_colors_program, voxel_colors_vs, voxel_colors_ps, .vertex_profile = GP_VS_2_0,
        .pixel_profile = GP_PS_2_0, .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 3 } },
        .varyings = { { "depth", 1, GP_PERSPECTIVE }, { "value", 3, GP_PERSPECTIVE } })
