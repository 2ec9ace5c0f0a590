/* The passes of a picture: blocks, voxels that are met first, their light, and haze. */
#include "apps/techniques/voxel/pictures/view.h"

#include "apps/frame/view_slices.h"
#include "shaders_c/common/texel_copy.h"
#include "shaders_c/voxel/pictures/blocks.h"
#include "shaders_c/voxel/pictures/light.h"
#include "shaders_c/voxel/pictures/scan.h"

#include <string.h>

const VoxelView voxel_view_defaults = {
    .paint = { { 0.80f, 0.72f, 0.60f }, 0.12f },
    .second_paint = { { 0.45f, 0.62f, 0.82f }, 0.12f },
    .hit_paint = { { 0.86f, 0.10f, 0.08f }, 0.6f },
    .light = { -0.45f, 0.7f, 0.75f },
    .background = { 0.11f, 0.12f, 0.14f },
};

/* What the passes of one picture share. */
typedef struct ViewBuild {
    const FlatTexture *flat;
    const VoxelView *view;
    Frame *frame;
    uint32_t width, height;
    double aspect;
    ViewSlices slices;
    GpSurface *blocks;
    GpSurface *found, *depth; /* the voxel that each pixel shows; NULL until drawn */
} ViewBuild;

enum { RAMP = 256 }; /* texels of a transfer ramp */

static const float nothing[4] = { 0 };
/* Colours come multiplied by alpha. */
static const GpBlend over = { .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_INV_SRC_ALPHA };

/* --- blocks ----------------------------------------------------------------------------------- */

static void find_blocks(ViewBuild *build)
{
    Frame *frame = build->frame;
    const FlatTexture *flat = build->flat, *second = build->view->second;
    const uint32_t columns = (flat->size + VOXEL_BLOCK - 1) / VOXEL_BLOCK;
    const uint32_t width = columns * flat->slabs;
    GpSurface *rows = frame_surface(frame, GP_A8R8G8B8, width, flat->size, 1);
    build->blocks = frame_surface(frame, GP_A8R8G8B8, width, columns, 1);
    const VoxelBlocksUniforms uniforms = { .flat = flat_texture_layout(flat),
                                           .columns = (float)columns,
                                           .width = (float)width,
                                           .height = (float)flat->size };
    const void *own = frame_copy(frame, &uniforms, sizeof uniforms);
    frame_pass(frame, "rows of blocks", rows, NULL, nothing);
    GpDraw *draw = frame_draw(frame, &voxel_block_rows_program, own, &flat_texture_cover);
    draw->textures[0].surface = flat->texels;
    draw->textures[1].surface = second ? second->texels : flat->texels;
    frame_pass(frame, "blocks", build->blocks, NULL, nothing);
    frame_draw(frame, &voxel_blocks_program, own, &flat_texture_cover)->textures[0].surface = rows;
}

/* --- slices ----------------------------------------------------------------------------------- */

static VoxelViewUniforms slices_uniforms(const ViewBuild *build)
{
    const VoxelView *view = build->view;
    const VoxelPaint *paints[3] = { &view->paint, &view->second_paint, &view->hit_paint };
    VoxelViewUniforms uniforms = { .slices = view_slices_uniforms(&build->slices, build->aspect) };
    uniforms.flat = flat_texture_layout(build->flat);
    uniforms.block_columns = (float)build->blocks->height;
    uniforms.blocks_width = (float)build->blocks->width;
    uniforms.blocks_height = (float)build->blocks->height;
    for (int k = 0; k < 3; k++) {
        memcpy(uniforms.colors[k], paints[k]->color, sizeof paints[k]->color);
        uniforms.colors[k][3] = paints[k]->opacity;
    }
    return uniforms;
}

/* Flat textures are read by points, of slots 0 and 1. */
static GpDraw *draw_slices(const ViewBuild *build, const GpProgram *one, const GpProgram *two,
                           bool nearest_first)
{
    const VoxelViewUniforms uniforms = slices_uniforms(build);
    const GpGeometry quads = view_slices_quads(build->frame, &build->slices, nearest_first);
    GpDraw *draw =
        frame_draw_copied(build->frame, build->view->second ? two : one, &uniforms, &quads);
    draw->textures[0].surface = build->flat->texels;
    draw->textures[3].surface = build->blocks;
    if (build->view->second)
        draw->textures[1].surface = build->view->second->texels;
    return draw;
}

static void find_voxels(ViewBuild *build)
{
    build->found = frame_surface(build->frame, GP_A16B16G16R16F, build->width, build->height, 1);
    build->depth = frame_surface(build->frame, GP_D32F, build->width, build->height, 1);
    frame_pass(build->frame, "voxels", build->found, build->depth, nothing);
    GpDraw *draw = draw_slices(build, &voxel_first_program, &voxel_first_two_program, true);
    draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
}

/* --- light ------------------------------------------------------------------------------------ */

/* Smoothed density of every pattern of six voxels in a row, and its slope. */
static GpSurface *make_run_table(Frame *frame)
{
    GpSurface *table =
        frame_surface(frame, GP_A16B16G16R16F, VOXEL_RUN_PATTERNS, VOXEL_RUN_ROWS, 1);
    for (uint32_t row = 0; table->level[0].texels && row < VOXEL_RUN_ROWS; row++)
        for (uint32_t pattern = 0; pattern < VOXEL_RUN_PATTERNS; pattern++) {
            float density = 0, slope = 0;
            for (int k = 0; k < VOXEL_RUN; k++) {
                const float distance = (float)(k - 2) - (float)row / VOXEL_RUN_ROWS;
                const float rest = 1 - distance * distance / 9;
                density += pattern >> k & 1 ? rest * rest : 0;
                slope += pattern >> k & 1 ? 4 * distance * rest / 9 : 0;
            }
            gp_texel_store(table->format, gp_surface_texel(&table->level[0], 8, pattern, row),
                           (float[4]){ density, density, slope, 0 }, 0);
        }
    return table;
}

static void set_ray(const ViewBuild *build, VoxelLightUniforms *uniforms)
{
    const Camera *camera = &build->view->camera;
    const CameraAxes axes = camera_axes(camera, build->aspect);
    double light[3];
    for (int k = 0; k < 3; k++)
        light[k] = (double)build->view->light[0] * axes.right[k] +
                   (double)build->view->light[1] * axes.up[k] -
                   (double)build->view->light[2] * axes.forward[k];
    vector_normalize(light);
    for (int k = 0; k < 3; k++) {
        uniforms->eye[k] = (float)camera->eye[k];
        uniforms->at[k] = (float)axes.forward[k];
        uniforms->right[k] = (float)(axes.right[k] * axes.half_width);
        uniforms->up[k] = (float)(axes.up[k] * axes.half_height);
        uniforms->light[k] = (float)light[k];
    }
    uniforms->perspective = camera->fovy > 0 ? 1 : 0;
}

/* Lights the voxels of one kind, all of which a volume has. */
static void light_voxels(const ViewBuild *build, const FlatTexture *flat, const VoxelPaint *paint,
                         float kind, const GpSurface *table)
{
    const VoxelView *view = build->view;
    const bool smooth = view->shading == VOXEL_SMOOTH;
    const float across = 1 / (float)flat->texels->width, down = 1 / (float)flat->texels->height;
    VoxelLightUniforms uniforms = { .flat = flat_texture_layout(flat),
                                    .slabs = (float)flat->slabs,
                                    .across = { across, 0, across, 0 },
                                    .down = { 0, down, 0, down },
                                    .kind = kind };
    set_ray(build, &uniforms);
    memcpy(uniforms.color, paint->color, sizeof uniforms.color);
    GpDraw *draw = frame_draw_copied(
        build->frame, smooth ? &voxel_light_smooth_program : &voxel_light_faces_program, &uniforms,
        &flat_texture_cover);
    draw->textures[0].surface = build->found;
    if (!smooth)
        return;
    draw->textures[1].surface = flat->texels;
    draw->textures[2].surface = table;
}

static void light_found(const ViewBuild *build)
{
    const VoxelView *view = build->view;
    const GpSurface *table = view->shading == VOXEL_SMOOTH ? make_run_table(build->frame) : NULL;
    light_voxels(build, build->flat, &view->paint, VOXEL_KIND_FIRST, table);
    if (!view->second)
        return;
    light_voxels(build, build->flat, &view->hit_paint, VOXEL_KIND_BOTH, table);
    light_voxels(build, view->second, &view->second_paint, VOXEL_KIND_SECOND, table);
}

/* --- haze ------------------------------------------------------------------------------------- */

static GpSurface *make_ramp(Frame *frame, const uint8_t *transfer)
{
    GpSurface *ramp = frame_surface(frame, GP_A8R8G8B8, RAMP, 1, 1);
    for (uint32_t i = 0; ramp->level[0].texels && i < RAMP; i++) {
        float rgba[4];
        for (int c = 0; c < 4; c++)
            rgba[c] = (float)transfer[4 * i + (uint32_t)c] / 255;
        gp_texel_store(GP_A8R8G8B8, gp_surface_texel(&ramp->level[0], 4, i, 0), rgba, 0);
    }
    return ramp;
}

/* The scan, with the voxels in it unless those are opaque, and have been drawn. */
static GpDraw *draw_scan(const ViewBuild *build)
{
    static const GpSampler linear = {
        .min = GP_LINEAR, .mag = GP_LINEAR, .address_u = GP_CLAMP, .address_v = GP_CLAMP
    };
    const VoxelView *view = build->view;
    VoxelLightUniforms light;
    set_ray(build, &light);
    VoxelScanUniforms uniforms = { .view = slices_uniforms(build),
                                   .slopes = flat_texture_layout(view->scan) };
    for (int k = 0; k < 3; k++) {
        uniforms.light[k] = light.light[k];
        uniforms.to_eye[k] = -light.at[k];
    }
    const GpGeometry quads = view_slices_quads(build->frame, &build->slices, false);
    const bool mixed = view->mode == VOXEL_TRANSPARENT;
    GpDraw *draw = frame_draw_copied(
        build->frame, mixed ? &voxel_scan_mixed_program : &voxel_scan_program, &uniforms, &quads);
    if (mixed) {
        draw->textures[0].surface = build->flat->texels;
        draw->textures[3].surface = build->blocks;
    }
    draw->textures[1] = (GpTexture){ view->scan->texels, linear };
    draw->textures[2] = (GpTexture){ make_ramp(build->frame, view->transfer), linear };
    return draw;
}

/* Summed up in halves, since many slices add less than a byte can tell. */
static void draw_haze(const ViewBuild *build)
{
    Frame *frame = build->frame;
    GpSurface *haze = frame_surface(frame, GP_A16B16G16R16F, build->width, build->height, 1);
    GpPass *pass = frame_pass(frame, "haze", haze, build->depth, nothing);
    pass->depth.clear_depth = false;
    GpDraw *draw = build->view->scan
                       ? draw_scan(build)
                       : draw_slices(build, &voxel_haze_program, &voxel_haze_two_program, false);
    draw->state.blend[0] = over;
    draw->state.depth.test = build->depth ? GP_LESS : GP_ALWAYS;

    frame_pass(frame, "over", frame->color, NULL, nothing)->color[0].clear = false;
    draw = frame_draw(frame, &texel_copy_program, NULL, &flat_texture_cover);
    draw->textures[0].surface = haze;
    draw->state.blend[0] = over;
}

static GpResult check_view(const FlatTexture *flat, const VoxelView *view, GpError *error)
{
    const FlatTexture *second = view->second, *scan = view->scan;
    if (flat->bits != 1)
        return gp_fail(error, GP_ERROR_INVALID, "slices show volumes of 1 bit a voxel, not %u",
                       flat->bits);
    if (second && (second->size != flat->size || second->bits != flat->bits))
        return gp_fail(error, GP_ERROR_INVALID, "volumes of %u and %u voxels a side in one picture",
                       flat->size, second->size);
    if (scan && scan->size != flat->size)
        return gp_fail(error, GP_ERROR_INVALID, "a scan of %u voxels a side around %u", scan->size,
                       flat->size);
    if (scan && second && view->mode == VOXEL_TRANSPARENT)
        return gp_fail(error, GP_ERROR_INVALID, "a scan with two transparent volumes in it");
    return GP_OK;
}

GpResult voxel_view_build(const FlatTexture *flat, const VoxelView *view, uint32_t width,
                          uint32_t height, Frame *frame, GpError *error)
{
    ViewBuild build = { .flat = flat,
                        .view = view,
                        .frame = frame,
                        .width = width,
                        .height = height,
                        .aspect = (double)width / height };
    const float background[4] = { view->background[0], view->background[1], view->background[2],
                                  1 };
    const bool anywhere = view->scan || voxel_range_is_empty(&view->range);
    const VoxelRange range = anywhere ? voxel_range_whole(flat->size) : view->range;
    GpResult result = check_view(flat, view, error);
    if (!result)
        result = view_slices_find(&range, &view->camera, build.aspect, &build.slices, error);
    if (result)
        return result;
    frame->color = frame_surface(frame, GP_A8R8G8B8, width, height, 1);
    find_blocks(&build);
    if (view->mode == VOXEL_OPAQUE)
        find_voxels(&build);
    frame_pass(frame, "light", frame->color, NULL, background);
    if (view->mode == VOXEL_OPAQUE)
        light_found(&build);
    if (view->mode == VOXEL_TRANSPARENT || view->scan)
        draw_haze(&build);
    return frame_result(frame, error);
}
