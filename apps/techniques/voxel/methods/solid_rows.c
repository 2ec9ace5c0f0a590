/* The printed solid: rows scanned along three axes, and the majority of what they say. */
#include "apps/techniques/voxel/methods/sheets.h"
#include "shaders_c/voxel/sheet_copy.h"
#include "shaders_c/voxel/voxel_rows.h"

/* Eight voxels of a row at once (shaders_c/voxel/voxel_rows.h). */
static const GpSurface *make_table(Work *work)
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
    return voxel_table(work, 256, 2, 2, codes[0][0]);
}

/* What the scan of all rows needs. */
typedef struct Scan {
    const GpSurface *table;
    GpSurface *ends;
} Scan;

static void draw_scan(Work *work, const GpProgram *program, const Scan *scan,
                      const VoxelRowsUniforms *uniforms, const Worksheet *crossings)
{
    GpDraw *draw = work_draw(work, program, uniforms, &worksheet_cover);
    draw->textures[0] = voxel_texels(crossings->texels);
    draw->textures[1] = voxel_texels(scan->table);
    if (program == &voxel_rows_program)
        draw->textures[2] = voxel_texels(scan->ends);
}

static void scan_rows(Work *work, const Scan *scan, const Worksheet *crossings,
                      const Worksheet *inside)
{
    const float width = (float)crossings->texels->width, height = (float)crossings->texels->height;
    VoxelRowsUniforms *uniforms = work_alloc(work, 1, sizeof *uniforms);
    uniforms->sheet = worksheet_layout(crossings);
    for (uint32_t slab = 0; slab < crossings->slabs; slab++) {
        const GpViewport patch = worksheet_patch(crossings, slab);
        uniforms->origin[slab][0] = patch.x / width;
        uniforms->origin[slab][1] = patch.y / height;
    }
    work_pass(work, "row ends", scan->ends, NULL, (const float[4]){ 0, 0, 0, 0 });
    draw_scan(work, &voxel_row_ends_program, scan, uniforms, crossings);
    worksheet_pass(work, "rows", inside);
    draw_scan(work, &voxel_rows_program, scan, uniforms, crossings);
}

/* A whole sheet onto another. */
static void draw_sheet(Work *work, const Worksheet *from, GpBlendOp op)
{
    static const SheetCopyUniforms all = { .extent = { 1, 1 } };
    GpDraw *draw = work_draw(work, &sheet_copy_program, &all, &worksheet_cover);
    draw->textures[0] = voxel_texels(from->texels);
    draw->state.blend[0].op = op;
}

VoxelDirections voxel_row_scan(const VoxelSetting *setting, Work *work,
                               const VoxelDirections *crossings, const Worksheet *solid)
{
    const uint32_t width = solid->texels->width, height = solid->texels->height;
    const Scan scan = { make_table(work), work_surface(work, GP_R8, width, height, 1) };
    const Worksheet *x = &crossings->along[0], *y = &crossings->along[1];
    const Worksheet *both = &crossings->along[2]; /* x and y, once z is scanned */
    if (setting->axes == 1) {
        scan_rows(work, &scan, both, solid);
        return (VoxelDirections){ .along = { [2] = *solid } };
    }
    const VoxelTables tables = voxel_tables_make(work, solid);
    for (int axis = 0; axis < 2; axis++) {
        const Worksheet *along = &crossings->along[axis];
        scan_rows(work, &scan, along, solid); /* which is not yet in the volume's places */
        voxel_turn(axis, solid, &tables, along, &(GpBlend){ .op = GP_BLEND_OFF }, work);
    }
    const Worksheet z = worksheet_make(work, setting->size, setting->bits);
    scan_rows(work, &scan, both, &z);

    worksheet_pass(work, "both", both);
    draw_sheet(work, x, GP_BLEND_OFF);
    draw_sheet(work, y, GP_BLEND_LOGIC_AND);
    worksheet_pass(work, "majority", solid); /* ((x | y) & z) | (x & y) */
    draw_sheet(work, x, GP_BLEND_OFF);
    draw_sheet(work, y, GP_BLEND_LOGIC_OR);
    draw_sheet(work, &z, GP_BLEND_LOGIC_AND);
    draw_sheet(work, both, GP_BLEND_LOGIC_OR);
    return (VoxelDirections){ .along = { *x, *y, z } };
}

VoxelDirections voxel_sheets_solid(const VoxelModel *model, const VoxelSetting *setting, Work *work,
                                   const Worksheet *solid)
{
    VoxelDirections crossings = voxel_directions_make(setting, work, NULL);
    voxel_directions_draw(model, setting, setting->axes == 1 ? VOXEL_ALONG_Z : VOXEL_ALONG_ALL,
                          work, &crossings);
    return voxel_row_scan(setting, work, &crossings, solid);
}
