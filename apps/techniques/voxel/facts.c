/* Three solids, one along each axis, held against each other; and how facts are told. */
#include "apps/techniques/voxel/facts.h"

#include "apps/base/json.h"
#include "apps/truth/voxel_nearest.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* --- solids ----------------------------------------------------------------------------------- */

uint64_t voxel_odd_columns(const uint8_t *parity, uint32_t size)
{
    uint64_t count = 0;
    for (size_t i = 0; i < (size_t)size * size; i++)
        count += parity[i / 8] >> i % 8 & 1;
    return count;
}

uint64_t voxel_disagreements(const uint8_t *const solids[3], uint32_t size)
{
    uint64_t count = 0;
    for (size_t i = 0; i < voxel_bytes(size); i++) {
        unsigned differs = (solids[0][i] ^ solids[1][i]) | (solids[0][i] ^ solids[2][i]);
        count += (unsigned)__builtin_popcount(differs);
    }
    return count;
}

/* --- finding ---------------------------------------------------------------------------------- */

GpResult voxel_facts_find(const VoxelScene *scene, VoxelFacts *facts, GpError *error)
{
    const GpMesh *mesh = &scene->mesh;
    VoxelFacts found = { .has_solids = false };
    GpResult result = mesh_report(mesh->positions, mesh->vertex_count, mesh->indices,
                                  mesh->triangle_count, &found.mesh);
    if (!result)
        *facts = found;
    return result ? gp_fail(error, result, "out of memory") : GP_OK;
}

/* Bits of a volume as it was before it was turned. out back: zeroed */
static void turn_back(const uint8_t *turned, uint32_t size, int axis, uint8_t *back)
{
    const size_t step[3] = { 1, size, (size_t)size * size }, end = size * step[2];
    for (size_t i = 0; (i = voxel_next(turned, size, i)) < end; i++) {
        uint32_t at[3];
        voxel_place(i, size, at);
        size_t to =
            at[0] * step[(axis + 1) % 3] + at[1] * step[(axis + 2) % 3] + at[2] * step[axis];
        back[to / 8] = (uint8_t)(back[to / 8] | 1u << to % 8);
    }
}

static GpResult find_solid(const VoxelModel *model, uint32_t size, GpDevice *device, uint8_t *bits,
                           GpError *error)
{
    const VoxelSetting setting = {
        .kind = VOXEL_SOLID, .method = VOXEL_XOR, .size = size, .bits = 1, .axes = 3
    };
    Frame frame = { .color = NULL };
    FlatTexture flat;
    GpResult result = voxel_build(model, &setting, &frame, &flat, error);
    if (!result)
        result = gp_device_run(device, &frame.list, error);
    if (!result)
        flat_texture_read(&flat, bits);
    frame_free(&frame);
    return result;
}

GpResult voxel_facts_find_solids(const VoxelScene *scene, uint32_t size, GpDevice *device,
                                 VoxelFacts *facts, GpError *error)
{
    const VoxelScene in_its_box = { .mesh = scene->mesh }; /* nothing is cut off */
    const VoxelBox box = voxel_scene_box(&in_its_box, size);
    const VoxelModel model = voxel_scene_model(scene, &box);
    const size_t bytes = voxel_bytes(size);
    uint8_t *turned = gp_alloc(bytes, 1);
    uint8_t *solids[3] = { gp_alloc(bytes, 1), gp_alloc(bytes, 1), gp_alloc(bytes, 1) };
    VoxelFacts found = { .mesh = facts->mesh, .has_solids = true };
    GpResult result = turned && solids[0] && solids[1] && solids[2]
                          ? GP_OK
                          : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (int axis = 0; axis < 3 && !result; axis++) {
        const VoxelModel along = voxel_model_along(&model, axis);
        result = find_solid(&along, size, device, turned, error);
        if (!result) {
            found.odd_columns[axis] = voxel_odd_columns(turned, size);
            turn_back(turned, size, axis, solids[axis]);
        }
    }
    if (!result) {
        const uint8_t *const all[3] = { solids[0], solids[1], solids[2] };
        found.disagreements = voxel_disagreements(all, size);
        *facts = found;
    }
    gp_free(turned);
    for (int axis = 0; axis < 3; axis++)
        gp_free(solids[axis]);
    return result;
}

/* --- telling ---------------------------------------------------------------------------------- */

json_t *voxel_facts_json(const VoxelFacts *facts)
{
    const MeshReport *mesh = &facts->mesh;
    const struct {
        const char *name;
        uint64_t value;
    } counts[] = {
        { "edges", mesh->edges },
        { "boundary_edges", mesh->boundary_edges },
        { "non_manifold_edges", mesh->non_manifold_edges },
        { "odd_edges", mesh->odd_edges },
        { "inconsistently_oriented_edges", mesh->inconsistent_edges },
        { "duplicate_triangles", mesh->duplicates },
        { "degenerate_triangles", mesh->degenerate },
        { "odd_columns_x", facts->odd_columns[0] },
        { "odd_columns_y", facts->odd_columns[1] },
        { "odd_columns_z", facts->odd_columns[2] },
        { "disagreeing_voxels", facts->disagreements },
    };
    const size_t count = facts->has_solids ? GP_COUNT(counts) : GP_COUNT(counts) - 4;
    json_t *object = json_pack("{s:b, s:b, s:o}", "closed", mesh->is_closed, "inside_out",
                               mesh->is_inside_out, "enclosed_volume", json_number(mesh->volume));
    for (size_t i = 0; i < count; i++)
        json_object_set_new(object, counts[i].name, json_integer((json_int_t)counts[i].value));
    return object;
}

void voxel_facts_add(const VoxelFacts *facts, Text *lines)
{
    json_t *object = voxel_facts_json(facts), *value;
    const char *key;
    json_object_foreach(object, key, value)
    {
        char name[40];
        text_copy(name, sizeof name, key);
        for (char *c = name; *c; c++)
            *c = *c == '_' ? ' ' : *c;
        if (strncmp(name, "non ", 4) == 0) /* a prefix: "non-manifold edges" */
            name[3] = '-';
        if (json_is_boolean(value))
            text_add(lines, "%-30s %s\n", name, json_is_true(value) ? "yes" : "no");
        else
            text_add(lines, json_is_real(value) ? "%-30s %.9g\n" : "%-30s %.0f\n", name,
                     json_number_value(value));
    }
    json_decref(object);
}
