#include "apps/volumes/drawing/splat_modes.h"

#include "shaders_c/volume/splat_flat.h"
#include "shaders_c/volume/splat_quad.h"
#include "shaders_c/volume/splat_texture.h"

#include <string.h>

enum {
    MOST_DRAWS = 4000000, /* a list of more would fill the memory of most machines */
    OTHER_DRAWS = 100000, /* at least as many as sheets are put under each other with */
};

static GpDraw *begin_draw(const VoxelFeed *feed, const GpProgram *program, const void *uniforms,
                          const GpGeometry *geometry)
{
    GpDraw *draw = frame_draw(feed->sheets->frame, program, uniforms, geometry);
    draw->textures[0].surface = feed->sheets->look;
    sheets_set_state(feed->sheets, draw);
    return draw;
}

/* --- vertex buffers, at once and one by one --------------------------------------------------- */

static GpGeometry voxel_geometry(const Voxel *first, uint32_t count)
{
    return (GpGeometry){
        .primitive = GP_POINTS,
        .vertex_count = count,
        .streams = { [GP_TEXCOORD0] = { &first->value, sizeof *first, 4, GP_UINT8 },
                     [GP_TEXCOORD1] = { first->place, sizeof *first, 4, GP_UINT8 } },
    };
}

static void draw_voxels(const VoxelFeed *feed, const VoxelRun *run, VoxelFilter filter,
                        uint32_t at_once)
{
    static const GpProgram *const programs[] = {
        [VOXEL_EWA] = &voxel_ewa_program,
        [VOXEL_RECONSTRUCTION] = &voxel_reconstruction_program,
        [VOXEL_LOW_PASS] = &voxel_low_pass_program,
    };
    static const GpProgram *const flat[] = {
        [VOXEL_EWA] = &voxel_flat_ewa_program,
        [VOXEL_RECONSTRUCTION] = &voxel_flat_reconstruction_program,
        [VOXEL_LOW_PASS] = &voxel_low_pass_program,
    };
    for (uint32_t i = 0; i < run->count; i += at_once) {
        const GpGeometry geometry =
            voxel_geometry(feed->sheets->order->voxels + run->first + i, at_once);
        if (feed->sheets->setting->flat)
            begin_draw(feed, flat[filter], feed->flat, &geometry);
        else
            begin_draw(feed, programs[filter], feed->sheets->uniforms, &geometry);
    }
}

/* --- textures --------------------------------------------------------------------------------- */

/* Slices z side by side, about as wide as high. */
static GpResult make_values(const Field *field, Frame *frame, VoxelFeed *feed, GpError *error)
{
    const uint32_t *size = field->size;
    uint32_t columns = 1;
    while ((uint64_t)columns * columns * size[0] < (uint64_t)size[2] * size[1])
        columns++;
    const uint64_t width = (uint64_t)columns * size[0],
                   height = (uint64_t)((size[2] + columns - 1) / columns) * size[1];
    if (width > GP_MAX_SIZE || height > GP_MAX_SIZE)
        return gp_fail(
            error, GP_ERROR_UNSUPPORTED,
            "a volume of %u x %u x %u samples: one flat texture has no room for it; modes "
            "vb, im and qd need none",
            size[0], size[1], size[2]);
    uint8_t *attributes = gp_alloc_unset(4 * field_samples(field));
    feed->columns = columns;
    feed->values = frame_surface(frame, GP_A8R8G8B8, (uint32_t)width, (uint32_t)height, 1);
    if (!attributes || !feed->values->level[0].texels) {
        gp_free(attributes);
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for the values");
    }
    voxels_attributes(field, attributes);
    for (uint32_t z = 0; z < size[2]; z++)
        for (uint32_t y = 0; y < size[1]; y++) {
            const uint8_t *from = attributes + 4 * ((size_t)z * size[1] + y) * size[0];
            uint8_t *to = feed->values->level[0].texels +
                          (size_t)(z / columns * size[1] + y) * feed->values->level[0].pitch +
                          4 * (size_t)(z % columns) * size[0];
            for (uint32_t x = 0; x < size[0]; x++, from += 4, to += 4) {
                const uint8_t texel[4] = { from[3], from[2], from[1], from[0] }; /* b g r a */
                memcpy(to, texel, sizeof texel);
            }
        }
    gp_free(attributes);
    return GP_OK;
}

static uint32_t coordinate(const Voxel *voxel, uint32_t axis)
{
    const uint32_t high[3] = { voxel->place[3] >> 5, voxel->place[3] >> 2 & 7u,
                               voxel->place[3] & 3u };
    return voxel->place[axis] + 256 * high[axis];
}

/* Across and down of the voxels of a run. */
static const uint8_t *slice_places(const VoxelFeed *feed, const VoxelRun *run)
{
    const VoxelOrder *order = feed->sheets->order;
    uint8_t *places = frame_alloc(feed->sheets->frame, run->count, 4), *place = places;
    for (uint32_t i = 0; i < run->count && places; i++, place += 4)
        for (int k = 0; k < 2; k++) {
            const uint32_t at = coordinate(&order->voxels[run->first + i], order->axis[1 + k]);
            place[k] = (uint8_t)at;
            place[2 + k] = (uint8_t)(at >> 8);
        }
    return places;
}

static void draw_textured(const VoxelFeed *feed, uint32_t slice, const VoxelRun *run,
                          VoxelFilter filter)
{
    static const GpProgram *const programs[2][VOXEL_LOW_PASS + 1] = {
        { &voxel_vt_ewa_program, &voxel_vt_reconstruction_program, &voxel_vt_low_pass_program },
        { &voxel_pt_ewa_program, &voxel_pt_reconstruction_program, &voxel_pt_low_pass_program },
    };
    const Sheets *sheets = feed->sheets;
    const uint8_t *places = slice_places(feed, run);
    if (!places || !sheets->uniforms)
        return;
    VoxelTextureUniforms uniforms = {
        .voxel = *sheets->uniforms,
        .columns = (float)feed->columns,
        .size = { (float)sheets->splats->field->size[0], (float)sheets->splats->field->size[1] },
        .texel = { 1 / (float)feed->values->width, 1 / (float)feed->values->height },
    };
    uniforms.origin[sheets->order->axis[0]] = (float)slice;
    uniforms.across[sheets->order->axis[1]] = 1;
    uniforms.down[sheets->order->axis[2]] = 1;
    const GpGeometry geometry = { .primitive = GP_POINTS,
                                  .vertex_count = run->count,
                                  .streams = { [GP_TEXCOORD0] = { places, 4, 4, GP_UINT8 } } };
    const GpProgram *program = programs[sheets->setting->mode == VOXELS_PT][filter];
    begin_draw(feed, program, frame_copy(sheets->frame, &uniforms, sizeof uniforms), &geometry)
        ->textures[1]
        .surface = feed->values;
}

/* --- quads ------------------------------------------------------------------------------------ */

static uint32_t longest_run(const Sheets *sheets)
{
    const uint32_t *run_of = sheets->splats->run_of[sheets->eye.along];
    const VoxelRun *runs = sheets->splats->runs[sheets->eye.along];
    uint32_t longest = 1;
    for (uint32_t i = 0; i < run_of[sheets->order->slices]; i++)
        longest = runs[i].count > longest ? runs[i].count : longest;
    return longest;
}

static void make_corners(VoxelFeed *feed)
{
    static const uint32_t quad[6] = { 0, 1, 2, 2, 1, 3 };
    const uint32_t most = longest_run(feed->sheets);
    uint8_t *corners = frame_alloc(feed->sheets->frame, most, 8);
    uint32_t *indices = frame_alloc(feed->sheets->frame, most, sizeof quad);
    for (uint32_t i = 0; i < 4 * most && corners; i++) {
        corners[2 * i] = i & 1;
        corners[2 * i + 1] = i >> 1 & 1;
    }
    for (uint32_t i = 0; i < 6 * most && indices; i++)
        indices[i] = i / 6 * 4 + quad[i % 6];
    feed->corners = corners;
    feed->indices = indices;
}

static void draw_quads(const VoxelFeed *feed, const VoxelRun *run, VoxelFilter filter)
{
    static const GpProgram *const programs[] = {
        [VOXEL_EWA] = &voxel_qd_ewa_program,
        [VOXEL_RECONSTRUCTION] = &voxel_qd_reconstruction_program,
        [VOXEL_LOW_PASS] = &voxel_qd_low_pass_program,
    };
    const Voxel *from = feed->sheets->order->voxels + run->first;
    Voxel *corners = frame_alloc(feed->sheets->frame, 4 * (size_t)run->count, sizeof *corners);
    if (!corners || !feed->corners || !feed->indices)
        return;
    for (uint32_t i = 0; i < 4 * run->count; i++)
        corners[i] = from[i / 4];
    GpGeometry geometry = voxel_geometry(corners, 4 * run->count);
    geometry.primitive = GP_TRIANGLES;
    geometry.streams[GP_TEXCOORD2] = (GpStream){ feed->corners, 2, 2, GP_UINT8 };
    geometry.indices = feed->indices;
    geometry.index_count = 6 * run->count;
    begin_draw(feed, programs[filter], feed->sheets->uniforms, &geometry);
}

/* --- all of them ------------------------------------------------------------------------------ */

static GpResult reserve_draws(const Sheets *sheets, GpError *error)
{
    const uint64_t count = volume_splats_count(sheets->splats);
    if (count > MOST_DRAWS)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "%llu voxels: mode im has a draw for each, of %zu bytes, and stops at %u",
                       (unsigned long long)count, sizeof(GpDraw), (unsigned)MOST_DRAWS);
    frame_reserve(sheets->frame, (uint32_t)count + OTHER_DRAWS);
    return GP_OK;
}

/* A kernel's tenth is left of it along its normal. */
static const VoxelFlatUniforms *flat_uniforms(const Sheets *sheets)
{
    VoxelFlatUniforms uniforms = { .opaque =
                                       sheets->setting->alphas ? 0.5f : sheets_extinction(0.5),
                                   .flatness = 0.99f };
    if (sheets->uniforms)
        uniforms.voxel = *sheets->uniforms;
    return frame_copy(sheets->frame, &uniforms, sizeof uniforms);
}

GpResult voxel_feed_begin(Sheets *sheets, VoxelFeed *feed, GpError *error)
{
    const VoxelMode mode = sheets->setting->mode;
    *feed = (VoxelFeed){ .sheets = sheets };
    if (sheets->setting->flat)
        feed->flat = flat_uniforms(sheets);
    if (mode == VOXELS_VT || mode == VOXELS_PT)
        return make_values(sheets->splats->field, sheets->frame, feed, error);
    if (mode == VOXELS_IM)
        return reserve_draws(sheets, error);
    if (mode == VOXELS_QD)
        make_corners(feed);
    return GP_OK;
}

void voxel_feed_run(const VoxelFeed *feed, uint32_t slice, const VoxelRun *run, VoxelFilter filter)
{
    switch (feed->sheets->setting->mode) {
    case VOXELS_VT:
    case VOXELS_PT:
        draw_textured(feed, slice, run, filter);
        break;
    case VOXELS_QD:
        draw_quads(feed, run, filter);
        break;
    case VOXELS_IM:
        draw_voxels(feed, run, filter, 1);
        break;
    default:
        draw_voxels(feed, run, filter, run->count);
    }
}

/* Of all three directions, as table 4 counts them. */
double volume_splats_bytes(const VolumeSplats *splats, VoxelMode mode)
{
    const double voxels = (double)volume_splats_count(splats);
    const double texture = 4 * (double)field_samples(splats->field);
    switch (mode) {
    case VOXELS_VT:
    case VOXELS_PT:
        return voxels > 0 ? 3 * 4 + texture / voxels : 0;
    case VOXELS_QD:
        return 3 * 4 * sizeof(Voxel);
    default:
        return 3 * sizeof(Voxel);
    }
}
