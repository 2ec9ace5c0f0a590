/* Exact solids, one along each axis, held against each other; and how facts are told. */
#include "apps/techniques/voxel/facts.h"

#include "apps/base/json.h"
#include "apps/techniques/voxel/truths.h"
#include "apps/truth/voxel_winding.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* --- solids ----------------------------------------------------------------------------------- */

/* Voxels that are not the same in three solids. */
static uint64_t count_disagreements(const uint8_t *const solids[3], uint32_t size)
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

GpResult voxel_facts_find_solids(const VoxelScene *scene, uint32_t size, VoxelFacts *facts,
                                 GpError *error)
{
    const VoxelScene in_its_box = { .mesh = scene->mesh }; /* nothing is cut off */
    const VoxelBox box = voxel_scene_box(&in_its_box, size);
    TruthTriangle *triangles = voxel_true_triangles(scene, &box);
    VoxelWinding along[3] = { { .odd = NULL } };
    VoxelFacts found = { .mesh = facts->mesh, .has_solids = true };
    GpResult result = triangles ? GP_OK : GP_ERROR_MEMORY;
    for (int axis = 0; axis < 3 && !result; axis++) {
        result =
            voxel_winding_make(triangles, scene->mesh.triangle_count, size, axis, &along[axis]);
        found.odd_columns[axis] = along[axis].odd_columns;
    }
    if (!result) {
        const uint8_t *const solids[3] = { along[0].odd, along[1].odd, along[2].odd };
        found.disagreements = count_disagreements(solids, size);
        found.doubled = found.mesh.unbalanced_edges ? 0 : along[2].doubled;
        *facts = found;
    }
    for (int axis = 0; axis < 3; axis++)
        voxel_winding_free(&along[axis]);
    gp_free(triangles);
    return gp_fail(error, result, "out of memory");
}

GpResult voxel_facts_count_doubled(const VoxelScene *scene, const MeshReport *mesh,
                                   const VoxelBox *box, uint64_t *doubled, GpError *error)
{
    *doubled = 0;
    if (mesh->unbalanced_edges)
        return GP_OK;
    TruthTriangle *triangles = voxel_true_triangles(scene, box);
    VoxelWinding winding = { .odd = NULL };
    GpResult result = triangles ? voxel_winding_make(triangles, scene->mesh.triangle_count,
                                                     box->size, 2, &winding)
                                : GP_ERROR_MEMORY;
    *doubled = winding.doubled;
    voxel_winding_free(&winding);
    gp_free(triangles);
    return gp_fail(error, result, "out of memory");
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
        { "unbalanced_edges", mesh->unbalanced_edges },
        { "duplicate_triangles", mesh->duplicates },
        { "degenerate_triangles", mesh->degenerate },
        { "odd_columns_x", facts->odd_columns[0] },
        { "odd_columns_y", facts->odd_columns[1] },
        { "odd_columns_z", facts->odd_columns[2] },
        { "disagreeing_voxels", facts->disagreements },
        { "doubled_voxels", facts->doubled },
    };
    const size_t count = facts->has_solids ? GP_COUNT(counts) : GP_COUNT(counts) - 5;
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
