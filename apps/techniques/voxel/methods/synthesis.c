/* The synthesis: directional flat textures into the one of the volume. */
#include "apps/techniques/voxel/methods/synthesis.h"

#include "shaders_c/voxel/methods/turn.h"

#include <string.h>

static uint32_t count_octets(const FlatTexture *flat)
{
    return (flat->size + 7) / 8;
}

/* For each depth its patch's origin, and where in a texel it is (methods/turn.h). */
static const GpSurface *make_places(Frame *frame, const FlatTexture *flat)
{
    GpSurface *table = frame_surface(frame, GP_A32B32G32R32F, flat->size, 1, 1);
    const uint32_t bytes = flat->bits / 8;
    uint8_t *texel = table->level[0].texels;
    for (uint32_t depth = 0; texel && depth < flat->size; depth++) {
        const GpViewport patch = flat_texture_patch(flat, depth / flat->per_texel);
        const uint32_t part = depth % flat->per_texel;
        const float row = ((float)(part % 8) + 0.5f) / 8;
        const float place[4] = { patch.x, patch.y, bytes ? (float)part : row,
                                 (float)(bytes ? part * bytes : part / 8) };
        memcpy(texel + depth * sizeof place, place, sizeof place);
    }
    return table;
}

/* Bit t of s at (s, t). */
static const GpSurface *make_bits(Frame *frame)
{
    uint8_t codes[8][256];
    for (int t = 0; t < 8; t++)
        for (int s = 0; s < 256; s++)
            codes[t][s] = s >> t & 1 ? 255 : 0;
    return voxel_table(frame, 256, 8, 1, codes[0]);
}

VoxelTables voxel_tables_make(Frame *frame, const FlatTexture *flat)
{
    VoxelTables tables = { .places = make_places(frame, flat) };
    if (flat->bits == 1) {
        tables.bits = make_bits(frame);
        tables.found =
            frame_surface(frame, GP_A8R8G8B8, count_octets(flat) * flat->slabs, flat->size, 1);
    }
    return tables;
}

static void draw_turned(int axis, const FlatTexture *from, const VoxelTables *tables,
                        const GpProgram *program, const GpBlend *blend, Frame *frame)
{
    VoxelTurnUniforms uniforms = { .flat = flat_texture_layout(from),
                                   .octets = (float)count_octets(from),
                                   .slabs = (float)from->slabs };
    uniforms.depth[axis] = uniforms.across[1 - axis] = 1;
    uniforms.aside[axis] = uniforms.down[1 - axis] = 1;
    GpDraw *draw = frame_draw_copied(frame, program, &uniforms, &flat_texture_cover);
    draw->textures[0] = voxel_texels(from->texels);
    draw->textures[1] = voxel_texels(tables->places);
    if (program == &voxel_turn_bits_program) {
        draw->textures[2] = voxel_texels(tables->bits);
        draw->textures[3] = voxel_texels(tables->found);
    }
    draw->state.blend[0] = *blend;
}

void voxel_turn(int axis, const FlatTexture *from, const VoxelTables *tables, const FlatTexture *to,
                const GpBlend *blend, Frame *frame)
{
    static const char *const names[2] = { "turn x", "turn y" };
    const GpBlend replace = { .op = GP_BLEND_OFF };
    const GpProgram *program =
        from->bits == 8 ? &voxel_turn_bytes_program : &voxel_turn_pairs_program;
    if (from->bits == 1) {
        program = &voxel_turn_bits_program;
        frame_pass(frame, "found", tables->found, NULL, (const float[4]){ 0, 0, 0, 0 });
        draw_turned(axis, from, tables, &voxel_found_program, &replace, frame);
    }
    flat_texture_pass(frame, names[axis], to)->color[0].clear = false;
    draw_turned(axis, from, tables, program, blend, frame);
}

void voxel_synthesize(const VoxelSetting *setting, Frame *frame, const VoxelDirections *directions)
{
    const FlatTexture *volume = &directions->along[2];
    const VoxelTables tables = voxel_tables_make(frame, volume);
    GpBlend blend = voxel_directions_blend(setting);
    if (setting->bits == 1)
        blend = (GpBlend){ .op = GP_BLEND_LOGIC_OR };
    for (int axis = 0; axis < 2; axis++)
        voxel_turn(axis, &directions->along[axis], &tables, volume, &blend, frame);
}
