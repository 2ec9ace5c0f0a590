#include "apps/techniques/voxel/result.h"

#include "apps/frame/picture.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <xxhash.h>

/* --- taking ----------------------------------------------------------------------------------- */

/* The tight range of the bits of a volume; a loop over bytes that are not 0. */
static VoxelRange range_of_bits(const uint8_t *bits, uint32_t size)
{
    VoxelRange range = { { size, size, size }, { 0, 0, 0 } };
    const size_t bytes = ((size_t)size * size * size + 7) / 8;
    for (size_t byte = 0; byte < bytes; byte++)
        for (unsigned rest = bits[byte]; rest; rest &= rest - 1) {
            const size_t i = 8 * byte + (size_t)__builtin_ctz(rest);
            const uint32_t at[3] = { (uint32_t)(i % size), (uint32_t)(i / size % size),
                                     (uint32_t)(i / size / size) };
            for (int k = 0; k < 3; k++) {
                range.low[k] = at[k] < range.low[k] ? at[k] : range.low[k];
                range.end[k] = at[k] + 1 > range.end[k] ? at[k] + 1 : range.end[k];
            }
        }
    return range;
}

GpResult voxel_result_take(const VoxelPairMade *made, const GpSurface *picture, bool is_touching,
                           VoxelResult *result)
{
    static const GpVolumeType types[] = {
        [1] = GP_VOLUME_BITS, [8] = GP_VOLUME_U8, [16] = GP_VOLUME_U16
    };
    const FlatTexture *sheet = &made->result;
    const size_t bytes = flat_texture_bytes(sheet);
    uint8_t *voxels = gp_alloc(bytes, 1);
    if (!voxels)
        return GP_ERROR_MEMORY;
    flat_texture_read(sheet, voxels);
    result->volume = (GpVolume){ .type = types[sheet->bits], .data = voxels };
    for (int k = 0; k < 3; k++) {
        result->volume.dims[k] = sheet->size;
        result->volume.spacing[k] = 1 / made->box.scale;
    }
    result->picture = picture;
    result->hash = picture ? gp_surface_hash(picture) : XXH3_64bits(voxels, bytes);
    result->voxels = flat_texture_count(sheet);
    result->is_touching = is_touching;
    if (is_touching)
        result->where = range_of_bits(voxels, sheet->size);
    return GP_OK;
}

GpResult voxel_result_write(const VoxelResult *result, const char *path, GpError *error)
{
    return result->picture ? picture_write_surface(path, result->picture, true, error)
                           : gp_volume_write(path, &result->volume, error);
}

/* --- telling ---------------------------------------------------------------------------------- */

void voxel_result_print(const VoxelResult *result)
{
    const uint32_t *dims = result->volume.dims, *low = result->where.low, *end = result->where.end;
    if (result->picture)
        picture_print_hash(result->picture, result->hash);
    else
        printf("hash VOXELS %ux%ux%u %016" PRIx64 "\n", dims[0], dims[1], dims[2], result->hash);
    printf("%s %" PRIu64 "\n", result->is_touching ? "touching" : "voxels", result->voxels);
    if (result->is_touching && result->voxels)
        printf("range %u..%u %u..%u %u..%u\n", low[0], end[0] - 1, low[1], end[1] - 1, low[2],
               end[2] - 1);
    if (result->has_facts)
        voxel_facts_print(&result->facts);
}

static json_t *range_json(const VoxelRange *range)
{
    json_t *array = json_array();
    for (int k = 0; k < 3; k++)
        json_array_append_new(
            array, json_pack("[I, I]", (json_int_t)range->low[k], (json_int_t)range->end[k] - 1));
    return array;
}

json_t *voxel_result_json(const VoxelResult *result, const RunStatistics *statistics,
                          const GpSurface *color)
{
    const json_int_t size = result->volume.dims[0];
    json_t *object = run_json(statistics, result->hash, color);
    if (!result->picture) {
        json_t *volume =
            json_pack("{s:s, s:I, s:I, s:I, s:I}", "format", "VOXELS", "width", size, "height",
                      size, "depth", size, "bytes", (json_int_t)gp_volume_bytes(&result->volume));
        json_object_update(object, volume);
        json_decref(volume);
    }
    json_object_set_new(object, result->is_touching ? "touching" : "voxels",
                        json_integer((json_int_t)result->voxels));
    if (result->is_touching && result->voxels)
        json_object_set_new(object, "range", range_json(&result->where));
    json_object_set_new(object, "triangles", json_integer((json_int_t)result->triangles));
    if (result->has_facts)
        json_object_set_new(object, "report", voxel_facts_json(&result->facts));
    return object;
}
