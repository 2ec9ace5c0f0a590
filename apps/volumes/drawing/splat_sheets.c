#include "apps/volumes/drawing/splat_sheets.h"

#include "apps/base/stable_math.h"
#include "apps/volumes/drawing/splat_filter.h"
#include "shaders_c/common/texel_copy.h"

#include <math.h>
#include <string.h>

static const GpBlend add = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
static const GpBlend under = { .op = GP_BLEND_ADD, .src = GP_INV_DEST_ALPHA, .dst = GP_ONE };
static const GpBlend over = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_INV_SRC_ALPHA };
static const float nothing[4] = { 0 };

/* --- beginning -------------------------------------------------------------------------------- */

/* Opaque is what lets 2^-16 through. */
float sheets_extinction(double opacity)
{
    return (float)-stable_log(fmax(1 - opacity, 0x1p-16));
}

static GpSurface *make_look(const VolumeSplats *splats, const VolumeSplatSetting *setting,
                            Frame *frame)
{
    GpSurface *look = frame_surface(frame, GP_A32B32G32R32F, FIELD_VALUES, 1, 1);
    float *texel = (float *)(void *)look->level[0].texels;
    for (int v = 0; v < FIELD_VALUES && texel; v++, texel += 4) {
        memcpy(texel, splats->table[v], 4 * sizeof *texel);
        if (!setting->alphas)
            texel[3] = sheets_extinction((double)texel[3]);
    }
    return look;
}

/* Opaque pixels are marked in a depth buffer of the frame's own: that of the target stays as it
 * is. */
static void copy_depth(Sheets *sheets)
{
    static const float corners[] = { -1, -1, 1, -1, 3, 1, 3, -1, 1 };
    const GpGeometry whole = {
        .vertex_count = 3, .streams = { [GP_POSITION] = { .data = corners, .components = 3 } }
    };
    GpSurface *given = sheets->depth;
    sheets->depth =
        frame_surface(sheets->frame, GP_D32F, sheets->view->width, sheets->view->height, 1);
    frame_pass(sheets->frame, "depth", NULL, sheets->depth, nothing);
    if (!given)
        return;
    GpDraw *draw = frame_draw(sheets->frame, &texel_depth_program, NULL, &whole);
    draw->textures[0].surface = given;
    draw->state.depth = (GpDepthState){ .test = GP_ALWAYS, .write = true };
}

Sheets sheets_make(const VolumeSplats *splats, const VolumeView *view,
                   const VolumeSplatSetting *setting, const VolumeTarget *target, Frame *frame)
{
    static const GpFormat formats[] = { [VOXEL_HALVES] = GP_A16B16G16R16F,
                                        [VOXEL_FLOATS] = GP_A32B32G32R32F,
                                        [VOXEL_BYTES] = GP_A8R8G8B8 };
    Sheets sheets = { .splats = splats,
                      .view = view,
                      .setting = setting,
                      .color = target->color,
                      .depth = target->depth,
                      .eye = voxel_eye(splats->field, view, setting),
                      .look = make_look(splats, setting, frame),
                      .cover = splat_cover_make(view, frame),
                      .frame = frame };
    const VoxelUniforms uniforms = voxel_uniforms(&sheets.eye, splats->field, view, setting);
    sheets.uniforms = frame_copy(frame, &uniforms, sizeof uniforms);
    sheets.order = &splats->voxels.along[sheets.eye.along];
    sheets.format = formats[splat_sums(&sheets.eye, splats->field, setting)];
    for (int i = 0; i < SHEETS_AT_ONCE; i++)
        sheets.sheet[i] = frame_surface(frame, sheets.format, view->width, view->height, 1);
    sheets.sum = frame_surface(frame, sheets.format, view->width, view->height, 1);
    for (int v = 0; v < FIELD_VALUES; v++)
        sheets.shown[v + 1] = (uint16_t)(sheets.shown[v] + splats->shown[v]);
    if (setting->cull)
        copy_depth(&sheets);
    return sheets;
}

uint32_t sheets_slice(const Sheets *sheets, uint32_t i)
{
    return sheets->eye.falling ? sheets->order->slices - 1 - i : i;
}

/* --- a sheet ---------------------------------------------------------------------------------- */

void sheets_begin_in(Sheets *sheets, uint32_t surface)
{
    frame_pass(sheets->frame, "sheet", sheets->sheet[surface], sheets->depth, nothing)
        ->depth.clear_depth = false;
    sheets->sheets++;
}

void sheets_begin(Sheets *sheets)
{
    sheets_begin_in(sheets, sheets->filled++);
}

void sheets_set_state(const Sheets *sheets, GpDraw *draw)
{
    draw->state.blend[0] = add;
    if (sheets->depth)
        draw->state.depth.test = GP_LESS;
}

void sheets_cover_slice(Sheets *sheets, uint32_t slice)
{
    splat_cover_slice(&sheets->eye, sheets->order, slice, sheets->shown, sheets->splats->field,
                      &sheets->cover);
}

void sheets_cover(Sheets *sheets, const SplatCover *cover)
{
    splat_cover_add(cover, &sheets->cover);
}

/* Where the sum is opaque, the depth buffer hides all that comes. */
static void mark_opaque(Sheets *sheets)
{
    const GpTexture sum = { .surface = sheets->sum };
    frame_pass(sheets->frame, "opaque", NULL, sheets->depth, nothing)->depth.clear_depth = false;
    splat_cover_draw(&sheets->cover, sheets->view, &sheets_opaque_program, NULL, &sum, 1,
                     &(GpState){ .depth = { .test = GP_ALWAYS, .write = true } }, sheets->frame);
    sheets->marked = sheets->sheets;
}

void sheets_under(Sheets *sheets, const GpProgram *program, const void *uniforms,
                  const GpTexture *textures, uint32_t texture_count)
{
    frame_pass(sheets->frame, "under", sheets->sum, NULL, nothing)->color[0].clear = !sheets->begun;
    splat_cover_draw(&sheets->cover, sheets->view, program, uniforms, textures, texture_count,
                     &(GpState){ .blend = { under } }, sheets->frame);
    sheets->begun = true;
    if (sheets->setting->cull && sheets->sheets - sheets->marked >= sheets->setting->cull)
        mark_opaque(sheets);
    splat_cover_clear(&sheets->cover);
}

/* Those that are filled, and empty ones for the rest. */
static void put_under(Sheets *sheets)
{
    GpTexture textures[SHEETS_AT_ONCE] = { { 0 } };
    if (!sheets->filled)
        return;
    for (uint32_t i = 0; i < SHEETS_AT_ONCE; i++)
        textures[i].surface = sheets->sheet[i];
    for (; sheets->filled < SHEETS_AT_ONCE; sheets->filled++)
        frame_pass(sheets->frame, "no sheet", sheets->sheet[sheets->filled], NULL, nothing);
    sheets_under(sheets, sheets->setting->alphas ? &sheets_of_alphas_program : &sheets_program,
                 NULL, textures, SHEETS_AT_ONCE);
    sheets->filled = 0;
}

void sheets_end(Sheets *sheets)
{
    if (sheets->filled == SHEETS_AT_ONCE)
        put_under(sheets);
}

void sheets_finish(Sheets *sheets)
{
    static const float corners[] = { -1, -1, 0, -1, 3, 0, 3, -1, 0 };
    const GpGeometry whole = {
        .vertex_count = 3, .streams = { [GP_POSITION] = { .data = corners, .components = 3 } }
    };
    put_under(sheets);
    if (!sheets->begun)
        return;
    frame_pass(sheets->frame, "over", sheets->color, NULL, nothing)->color[0].clear = false;
    GpDraw *draw = frame_draw(sheets->frame, &sheets_over_program, NULL, &whole);
    draw->textures[0].surface = sheets->sum;
    draw->state.blend[0] = over;
}
