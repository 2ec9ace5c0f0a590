/* How volumes lie in flat textures, what draws into them, and their voxels. */
#include "apps/techniques/voxel/volume/flat_texture.h"

#include <string.h>

/* Patches in a row: as near to a square as makes a flat texture of up to 2048 texels wide where one
 * is enough, as the printed ones are, and wider where it is not. */
static uint32_t choose_columns(uint32_t size, uint32_t slabs)
{
    uint32_t width = 2048;
    while ((width / size) * (width / size) < slabs && width < GP_MAX_SIZE)
        width *= 2;
    uint32_t columns = width / size;
    return columns < slabs ? columns : slabs;
}

GpResult flat_texture_check(uint32_t size, uint32_t bits, GpError *error)
{
    if (size < 8 || size > 1024)
        return gp_fail(error, GP_ERROR_INVALID, "a volume of %u voxels a side: expected 8 to 1024",
                       size);
    if (bits != 1 && bits != 8 && bits != 16)
        return gp_fail(error, GP_ERROR_INVALID, "%u bits a voxel: expected 1, 8 or 16", bits);
    uint32_t per_texel = 32 / bits, slabs = (size + per_texel - 1) / per_texel;
    uint32_t columns = GP_MAX_SIZE / size;
    if ((slabs + columns - 1) / columns * size > GP_MAX_SIZE)
        return gp_fail(error, GP_ERROR_INVALID,
                       "%u voxels a side of %u bits: more than a surface of %d x %d texels holds",
                       size, bits, GP_MAX_SIZE, GP_MAX_SIZE);
    return GP_OK;
}

FlatTexture flat_texture_make_slabs(Frame *frame, uint32_t size, uint32_t bits, uint32_t slabs)
{
    FlatTexture flat = { .size = size, .bits = bits, .per_texel = 32 / bits, .slabs = slabs };
    flat.columns = choose_columns(size, slabs);
    uint32_t rows = (slabs + flat.columns - 1) / flat.columns;
    flat.texels = frame_surface(frame, GP_A8R8G8B8, flat.columns * size, rows * size, 1);
    return flat;
}

FlatTexture flat_texture_make(Frame *frame, uint32_t size, uint32_t bits)
{
    uint32_t per_texel = 32 / bits;
    return flat_texture_make_slabs(frame, size, bits, (size + per_texel - 1) / per_texel);
}

static const float corners[3][2] = { { -1, 1 }, { 3, 1 }, { -1, -3 } };

const GpGeometry flat_texture_cover = {
    .vertex_count = GP_COUNT(corners),
    .streams = { [GP_POSITION] = { .data = corners, .components = 2 } },
};

GpViewport flat_texture_patch(const FlatTexture *flat, uint32_t slab)
{
    return (GpViewport){ .x = (float)(slab % flat->columns * flat->size),
                         .y = (float)(slab / flat->columns * flat->size),
                         .width = (float)flat->size,
                         .height = (float)flat->size };
}

GpDraw *flat_texture_draw(Frame *frame, const GpProgram *program, const void *uniforms,
                          const FlatTexture *flat, uint32_t slab)
{
    GpDraw *draw = frame_draw_copied(frame, program, uniforms, &flat_texture_cover);
    draw->viewport = flat_texture_patch(flat, slab);
    return draw;
}

GpDraw *flat_texture_draw_slab(Frame *frame, const GpProgram *program, const FlatTexture *flat,
                               uint32_t slab)
{
    const FlatTextureSlab uniforms = { .size = (float)flat->size,
                                       .base = (float)(slab * flat->per_texel) };
    return flat_texture_draw(frame, program, &uniforms, flat, slab);
}

GpDraw *flat_texture_blend(Frame *frame, const GpProgram *program, const GpSurface *from,
                           GpBlendOp op)
{
    GpDraw *draw = frame_draw(frame, program, NULL, &flat_texture_cover);
    draw->textures[0].surface = from;
    draw->state.blend[0].op = op;
    return draw;
}

FlatTextureLayout flat_texture_layout(const FlatTexture *flat)
{
    return (FlatTextureLayout){ .size = (float)flat->size,
                                .per_texel = (float)flat->per_texel,
                                .columns = (float)flat->columns,
                                .width = (float)flat->texels->width,
                                .height = (float)flat->texels->height };
}

GpPass *flat_texture_pass(Frame *frame, const char *name, const FlatTexture *flat)
{
    return frame_pass(frame, name, flat->texels, NULL, (const float[4]){ 0, 0, 0, 0 });
}

/* --- voxels ----------------------------------------------------------------------------------- */

uint8_t *flat_texture_texel(const FlatTexture *flat, uint32_t slab, uint32_t x, uint32_t y)
{
    return gp_surface_texel(&flat->texels->level[0], sizeof(uint32_t),
                            slab % flat->columns * flat->size + x,
                            slab / flat->columns * flat->size + y);
}

size_t flat_texture_bytes(const FlatTexture *flat)
{
    return ((size_t)flat->size * flat->size * flat->size * flat->bits + 7) / 8;
}

static void put_voxel(uint8_t *voxels, size_t index, uint32_t bits, uint32_t value)
{
    if (bits == 1) {
        voxels[index / 8] |= (uint8_t)(value << index % 8);
    } else {
        voxels[index * (bits / 8)] = (uint8_t)value;
        if (bits == 16)
            voxels[index * 2 + 1] = (uint8_t)(value >> 8);
    }
}

void flat_texture_read(const FlatTexture *flat, uint8_t *voxels)
{
    const uint32_t size = flat->size, bits = flat->bits;
    const uint32_t mask = bits == 16 ? 0xffff : (1u << bits) - 1;
    memset(voxels, 0, flat_texture_bytes(flat));
    for (uint32_t slab = 0; slab < flat->slabs; slab++)
        for (uint32_t y = 0; y < size; y++)
            for (uint32_t x = 0; x < size; x++) {
                uint32_t word, z = slab * flat->per_texel;
                memcpy(&word, flat_texture_texel(flat, slab, x, y), sizeof word);
                for (; word && z < size; z++, word >>= bits)
                    if (word & mask)
                        put_voxel(voxels, x + size * (y + (size_t)size * z), bits, word & mask);
            }
}

/* Voxels of a word that are not 0: those of several bits are gathered in their lowest. */
static uint32_t count_voxels(uint32_t word, uint32_t bits)
{
    for (uint32_t shift = bits / 2; shift; shift /= 2)
        word |= word >> shift;
    return (uint32_t)__builtin_popcount(bits == 8    ? word & 0x01010101
                                        : bits == 16 ? word & 0x00010001
                                                     : word);
}

uint64_t flat_texture_count(const FlatTexture *flat)
{
    const GpLevel *level = &flat->texels->level[0];
    uint64_t count = 0;
    for (uint32_t y = 0; y < level->height; y++) {
        const uint8_t *row = gp_surface_texel(level, sizeof(uint32_t), 0, y);
        for (uint32_t x = 0, word; x < level->width; x++) {
            memcpy(&word, row + sizeof word * (size_t)x, sizeof word);
            if (word) /* most are empty where surfaces meet */
                count += count_voxels(word, flat->bits);
        }
    }
    return count;
}
