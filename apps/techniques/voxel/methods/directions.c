/* Triangles drawn into four slabs at once, and the slabs gathered into flat textures. */
#include "apps/techniques/voxel/methods/directions.h"

#include "shaders_c/voxel/volume/patch_copy.h"
#include "shaders_c/voxel/methods/sheets.h"

#include <string.h>

/* --- what passes are made of ------------------------------------------------------------------ */

const GpSurface *voxel_table(Frame *frame, uint32_t width, uint32_t height, uint32_t channels,
                             const uint8_t *codes)
{
    GpSurface *table = frame_surface(frame, GP_A8R8G8B8, width, height, 1);
    uint8_t *texel = table->level[0].texels;
    for (uint32_t i = 0; texel && i < width * height; i++, texel += 4) { /* bytes are B G R A */
        texel[2] = codes[i * channels];
        texel[1] = channels > 1 ? codes[i * channels + 1] : 0;
    }
    return table;
}

GpTexture voxel_texels(const GpSurface *surface)
{
    return (GpTexture){ .surface = surface,
                        .sampler = { .address_u = GP_CLAMP, .address_v = GP_CLAMP } };
}

GpBlend voxel_directions_blend(const VoxelSetting *setting)
{
    const bool counts = setting->value == VOXEL_DENSITY && setting->blend == VOXEL_ADD;
    if (setting->bits == 1 && setting->blend == VOXEL_OR)
        return (GpBlend){ .op = GP_BLEND_LOGIC_OR };
    if (setting->bits == 1 || counts)
        return (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_ONE };
    return (GpBlend){ .op = GP_BLEND_MAX };
}

/* --- uniforms --------------------------------------------------------------------------------- */

/* Which bytes of a texel voxels are, and how values become whole numbers of 8 or 16 bits. */
static void describe_values(const VoxelSetting *setting, VoxelSheetsUniforms *u)
{
    const bool wide = setting->bits == 16;
    for (int c = 0; c < 4; c++) {
        const int byte = gp_format_info(GP_A8R8G8B8)->first_byte[c];
        u->voxel_of[c] = (float)(wide ? byte / 2 : byte);
        u->low[c] = !wide || byte % 2 == 0 ? 1 : 0;
        u->high[c] = 1 - u->low[c];
    }
    if (setting->value == VOXEL_DENSITY) {
        u->offset = setting->blend == VOXEL_ADD ? 1 : wide ? 0xffff : 0xff;
    } else if (setting->value == VOXEL_NORMAL) {
        const float level = wide ? 254 : 14, next = wide ? 256 : 16;
        memcpy(u->levels, (const float[3]){ level, level, 0 }, sizeof u->levels);
        memcpy(u->weights, (const float[3]){ 1, next, 0 }, sizeof u->weights);
        u->offset = 1 + next; /* both numbers begin at 1 */
    } else if (wide) {
        memcpy(u->levels, (const float[3]){ 31, 63, 31 }, sizeof u->levels);
        memcpy(u->weights, (const float[3]){ 2048, 32, 1 }, sizeof u->weights);
    } else {
        memcpy(u->levels, (const float[3]){ 7, 7, 3 }, sizeof u->levels);
        memcpy(u->weights, (const float[3]){ 32, 4, 1 }, sizeof u->weights);
    }
}

static VoxelSheetsUniforms describe_axis(const VoxelModel *model, const VoxelSetting *setting,
                                         int axis)
{
    VoxelSheetsUniforms u = { .size = (float)setting->size,
                              .per_texel = (float)(32 / setting->bits) };
    const VoxelModel along = voxel_model_along(model, axis);
    memcpy(u.to_flat, along.motion.to_voxels, sizeof u.to_flat);
    memcpy(u.to_volume, model->motion.to_voxels, sizeof u.to_volume);
    if (setting->bits != 1)
        describe_values(setting, &u);
    return u;
}

static const GpProgram *choose_program(const VoxelSetting *setting)
{
    static const GpProgram *const of_value[] = { [VOXEL_DENSITY] = &voxel_density_program,
                                                 [VOXEL_NORMAL] = &voxel_normals_program,
                                                 [VOXEL_COLOR] = &voxel_colors_program };
    return setting->bits == 1 ? &voxel_bits_program : of_value[setting->value];
}

/* --- directions ------------------------------------------------------------------------------- */

static GpGeometry list_of(const VoxelModel *model, const VoxelSort *sort, uint32_t list)
{
    GpGeometry geometry = voxel_model_geometry(model);
    geometry.indices = sort->indices + sort->start[list];
    geometry.index_count = sort->start[list + 1] - sort->start[list];
    geometry.streams[GP_NORMAL] = (GpStream){ .data = model->normals, .components = 3 };
    geometry.streams[GP_COLOR] =
        (GpStream){ .data = model->colors, .stride = 4 * sizeof(float), .components = 3 };
    return geometry;
}

static void draw_axis(const VoxelModel *model, const VoxelSetting *setting, int axis, Frame *frame,
                      const VoxelSort *sort, const FlatTexture *targets, const GpSurface *powers)
{
    static const char *const names[3] = { "along x", "along y", "along z" };
    GpPass *pass = frame_pass(frame, names[axis], NULL, NULL, NULL);
    for (int i = 0; i < GP_MAX_TARGETS; i++)
        pass->color[i] = (GpColorTarget){ .surface = targets[i].texels, .clear = true };

    for (uint32_t g = 0; g < sort->groups; g++) {
        GpGeometry list = list_of(model, sort, (uint32_t)axis * sort->groups + g);
        if (list.index_count == 0)
            continue;
        VoxelSheetsUniforms uniforms = describe_axis(model, setting, axis);
        uniforms.first_slab = (float)(GP_MAX_TARGETS * g);
        GpDraw *draw = frame_draw_copied(frame, choose_program(setting), &uniforms, &list);
        draw->viewport = flat_texture_patch(targets, g);
        if (setting->bits == 1)
            draw->textures[0] = voxel_texels(powers);
        for (int i = 0; i < GP_MAX_TARGETS; i++)
            draw->state.blend[i] = voxel_directions_blend(setting);
    }
}

/* Puts slabs where a flat texture has them: slab i is patch i / 4 of target i % 4. */
static void gather(Frame *frame, const FlatTexture *from, const FlatTexture *to)
{
    flat_texture_pass(frame, "gather", to);
    for (uint32_t slab = 0; slab < to->slabs; slab++) {
        const FlatTexture *target = &from[slab % GP_MAX_TARGETS];
        const float width = (float)target->texels->width, height = (float)target->texels->height;
        GpViewport patch = flat_texture_patch(target, slab / GP_MAX_TARGETS);
        const PatchCopyUniforms uniforms = { { patch.x / width, patch.y / height },
                                             { patch.width / width, patch.height / height } };
        GpDraw *draw = flat_texture_draw(frame, &patch_copy_program, &uniforms, to, slab);
        draw->textures[0] = voxel_texels(target->texels);
    }
}

VoxelDirections voxel_directions_make(const VoxelSetting *setting, Frame *frame,
                                      const FlatTexture *z)
{
    VoxelDirections directions = { .along = { { .texels = NULL } } };
    for (int axis = setting->axes == 1 ? 2 : 0; axis < 3; axis++)
        directions.along[axis] =
            axis == 2 && z ? *z : flat_texture_make(frame, setting->size, setting->bits);
    return directions;
}

void voxel_directions_draw(const VoxelModel *model, const VoxelSetting *setting,
                           VoxelSortBy sort_by, Frame *frame, const VoxelDirections *directions)
{
    const FlatTexture *z = &directions->along[2];
    const uint32_t groups = (z->slabs + GP_MAX_TARGETS - 1) / GP_MAX_TARGETS;
    VoxelSort sort = { .by = sort_by,
                       .groups = groups,
                       .group_depth = GP_MAX_TARGETS * (double)z->per_texel,
                       .spans = frame_alloc(frame, model->triangle_count, sizeof(VoxelSpans)) };
    if (sort.spans)
        sort.indices = frame_alloc(frame, voxel_sort_count(model, &sort) + 1, sizeof(uint32_t));
    if (!sort.indices)
        return;
    voxel_sort_fill(model, &sort);

    static const uint8_t codes[8] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    const GpSurface *powers = setting->bits == 1 ? voxel_table(frame, 8, 1, 1, codes) : NULL;
    FlatTexture targets[GP_MAX_TARGETS];
    for (int i = 0; i < GP_MAX_TARGETS; i++)
        targets[i] = flat_texture_make_slabs(frame, setting->size, setting->bits, groups);
    for (int axis = setting->axes == 1 ? 2 : 0; axis < 3; axis++) {
        draw_axis(model, setting, axis, frame, &sort, targets, powers);
        gather(frame, targets, &directions->along[axis]);
    }
}
