#include "shaders_c/volume/sheet.h"

#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/volume/sheet_shared.h"

clip_vertex_shader(sheet_vs, NoUniforms);

GP_INLINE float4 sheet_of_alphas(float4 sheet)
{
    return rgba(min(xyz(sheet), 1), min(sheet.w, 1));
}

GP_INLINE float4 put_under(float4 front, float4 behind)
{
    return mad(behind, 1.0f - front.w, front);
}

pixel_shader(sheets_ps, NoUniforms, NoVarying)
{
    float4 front = sheet_of_light(gp_load_local(0));
    front = put_under(front, sheet_of_light(gp_load_local(1)));
    return put_under(front, sheet_of_light(gp_load_local(2)));
}

pixel_shader(sheets_of_alphas_ps, NoUniforms, NoVarying)
{
    float4 front = sheet_of_alphas(gp_load_local(0));
    front = put_under(front, sheet_of_alphas(gp_load_local(1)));
    return put_under(front, sheet_of_alphas(gp_load_local(2)));
}

pixel_shader(sheets_over_ps, NoUniforms, NoVarying)
{
    return gp_load_local(0);
}

/* Less than half of a step of 8 bits is seen behind it. */
#define OPAQUE (1 - 1.0f / 512)

pixel_shader(sheets_opaque_ps, NoUniforms, NoVarying)
{
    discard(gp_load_local(0).w < OPAQUE);
    return sp4(bcast(1));
}

/* clang-format off */
#define SHEET_DECLARATIONS MODEL_2_0, .inputs = { { GP_POSITION, 3 } }
/* clang-format on */

program(sheets_program, sheet_vs, sheets_ps, SHEET_DECLARATIONS, .local_reads = 7)
program(sheets_of_alphas_program, sheet_vs, sheets_of_alphas_ps, SHEET_DECLARATIONS,
        .local_reads = 7)
program(sheets_over_program, sheet_vs, sheets_over_ps, SHEET_DECLARATIONS, .local_reads = 1)
program(sheets_opaque_program, sheet_vs, sheets_opaque_ps, SHEET_DECLARATIONS, .local_reads = 1,
        .may_discard = true)
