/* The printed solid: rows scanned along three axes, and the majority of what they say. */
#include "apps/techniques/voxel/methods/solid_rows.h"

#include "apps/techniques/voxel/methods/synthesis.h"
#include "shaders_c/common/texel_copy.h"
#include "shaders_c/voxel/methods/rows.h"

/* Eight voxels of a row at once (shaders_c/voxel/methods/rows.h). */
static const GpSurface *make_table(Frame *frame)
{
    uint8_t codes[2][256][2];
    for (int outset = 0; outset < 2; outset++)
        for (int byte = 0; byte < 256; byte++) {
            int state = outset, filled = 0;
            for (int k = 0; k < 8; k++) {
                int crossing = byte >> k & 1;
                filled |= (state | crossing) << k;
                state ^= crossing;
            }
            codes[outset][byte][0] = (uint8_t)filled;
            codes[outset][byte][1] = state ? 255 : 0;
        }
    return voxel_table(frame, 256, 2, 2, codes[0][0]);
}

/* What the scan of all rows needs. */
typedef struct Scan {
    const GpSurface *table;
    GpSurface *ends;
} Scan;

static void draw_scan(Frame *frame, const GpProgram *program, const Scan *scan,
                      const VoxelRowsUniforms *uniforms, const FlatTexture *crossings)
{
    GpDraw *draw = frame_draw(frame, program, uniforms, &flat_texture_cover);
    draw->textures[0] = voxel_texels(crossings->texels);
    draw->textures[1] = voxel_texels(scan->table);
    if (program == &voxel_rows_program)
        draw->textures[2] = voxel_texels(scan->ends);
}

static void scan_rows(Frame *frame, const Scan *scan, const FlatTexture *crossings,
                      const FlatTexture *inside)
{
    const float width = (float)crossings->texels->width, height = (float)crossings->texels->height;
    VoxelRowsUniforms rows = { .flat = flat_texture_layout(crossings) };
    for (uint32_t slab = 0; slab < crossings->slabs; slab++) {
        const GpViewport patch = flat_texture_patch(crossings, slab);
        rows.origin[slab][0] = patch.x / width;
        rows.origin[slab][1] = patch.y / height;
    }
    const VoxelRowsUniforms *uniforms = frame_copy(frame, &rows, sizeof rows);
    frame_pass(frame, "row ends", scan->ends, NULL, (const float[4]){ 0, 0, 0, 0 });
    draw_scan(frame, &voxel_row_ends_program, scan, uniforms, crossings);
    flat_texture_pass(frame, "rows", inside);
    draw_scan(frame, &voxel_rows_program, scan, uniforms, crossings);
}

VoxelDirections voxel_row_scan(const VoxelSetting *setting, Frame *frame,
                               const VoxelDirections *crossings, const FlatTexture *solid)
{
    const uint32_t width = solid->texels->width, height = solid->texels->height;
    const Scan scan = { make_table(frame), frame_surface(frame, GP_R8, width, height, 1) };
    const FlatTexture *x = &crossings->along[0], *y = &crossings->along[1];
    const FlatTexture *both = &crossings->along[2]; /* x and y, once z is scanned */
    if (setting->axes == 1) {
        scan_rows(frame, &scan, both, solid);
        return (VoxelDirections){ .along = { [2] = *solid } };
    }
    const VoxelTables tables = voxel_tables_make(frame, solid);
    for (int axis = 0; axis < 2; axis++) {
        const FlatTexture *along = &crossings->along[axis];
        scan_rows(frame, &scan, along, solid); /* which is not yet in the volume's places */
        voxel_turn(axis, solid, &tables, along, &(GpBlend){ .op = GP_BLEND_OFF }, frame);
    }
    const FlatTexture z = flat_texture_make(frame, setting->size, setting->bits);
    scan_rows(frame, &scan, both, &z);

    flat_texture_pass(frame, "both", both);
    flat_texture_blend(frame, &texel_copy_program, x->texels, GP_BLEND_OFF);
    flat_texture_blend(frame, &texel_copy_program, y->texels, GP_BLEND_LOGIC_AND);
    flat_texture_pass(frame, "majority", solid); /* ((x | y) & z) | (x & y) */
    flat_texture_blend(frame, &texel_copy_program, x->texels, GP_BLEND_OFF);
    flat_texture_blend(frame, &texel_copy_program, y->texels, GP_BLEND_LOGIC_OR);
    flat_texture_blend(frame, &texel_copy_program, z.texels, GP_BLEND_LOGIC_AND);
    flat_texture_blend(frame, &texel_copy_program, both->texels, GP_BLEND_LOGIC_OR);
    return (VoxelDirections){ .along = { *x, *y, z } };
}
