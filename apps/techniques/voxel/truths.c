/* Exact voxels found when they are asked for, and what a volume has wrong. */
#include "apps/techniques/voxel/truths.h"

#include "apps/truth/voxel_truth.h"

#include <string.h>

/* --- at a size -------------------------------------------------------------------------------- */

static const double surface_margin = 1e-3, solid_margin = 1.0 / 128; /* voxels */

/* What rounding may decide about insides is near the surface. */
static void find_inside(const TruthTriangle *triangles, uint32_t count, const VoxelTruth *truth)
{
    voxel_solid(triangles, count, truth->size, truth->least);
    voxel_near(triangles, count, truth->size, solid_margin, truth->most);
    for (size_t i = 0; i < voxel_bytes(truth->size); i++) {
        uint8_t inside = truth->least[i], near = truth->most[i];
        truth->least[i] = (uint8_t)(inside & ~near);
        truth->most[i] = inside | near;
    }
}

static void find(const TruthTriangle *triangles, uint32_t count, const VoxelTruth *truth)
{
    const uint32_t size = truth->size;
    switch (truth->kind) {
    case VOXEL_TRUTH_TOUCHED:
        voxel_surface(triangles, count, size, -surface_margin, truth->least);
        voxel_surface(triangles, count, size, surface_margin, truth->most);
        break;
    case VOXEL_TRUTH_SAMPLED:
        voxel_thin(triangles, count, size, VOXEL_ALL_AXES, -surface_margin, truth->least);
        voxel_thin(triangles, count, size, VOXEL_ALL_AXES, surface_margin, truth->most);
        break;
    case VOXEL_TRUTH_INSIDE:
        find_inside(triangles, count, truth);
        break;
    }
}

/* NULL without memory; the caller frees them. */
static TruthTriangle *make_triangles(const GpMesh *mesh, const VoxelBox *space)
{
    TruthTriangle *triangles = gp_alloc(mesh->triangle_count, sizeof *triangles);
    if (triangles)
        voxel_triangles(mesh->positions, mesh->indices, mesh->triangle_count, space, triangles);
    return triangles;
}

const VoxelTruth *voxel_truths_find(VoxelTruths *truths, const VoxelScene *scene,
                                    VoxelTruthKind kind, uint32_t size)
{
    for (int i = 0; i < truths->count; i++)
        if (truths->truths[i].kind == kind && truths->truths[i].size == size)
            return &truths->truths[i];
    if (truths->count == VOXEL_MAX_TRUTHS)
        return NULL;
    VoxelTruth *truth = &truths->truths[truths->count];
    const VoxelBox space = voxel_scene_box(scene, size);
    TruthTriangle *triangles = make_triangles(&scene->mesh, &space);
    *truth =
        (VoxelTruth){ kind, size, gp_alloc(voxel_bytes(size), 1), gp_alloc(voxel_bytes(size), 1) };
    bool good = triangles && truth->least && truth->most;
    if (good) {
        find(triangles, scene->mesh.triangle_count, truth);
        truths->count++;
    } else {
        gp_free(truth->least);
        gp_free(truth->most);
    }
    gp_free(triangles);
    return good ? truth : NULL;
}

void voxel_truths_free(VoxelTruths *truths)
{
    for (int i = 0; i < truths->count; i++) {
        gp_free(truths->truths[i].least);
        gp_free(truths->truths[i].most);
    }
    voxel_distance_free(&truths->distance);
    voxel_probes_free(&truths->probes);
    *truths = (VoxelTruths){ .count = 0 };
}

void voxel_truth_compare(const VoxelTruth *truth, const uint8_t *bits, uint64_t *missing,
                         uint64_t *extra)
{
    *missing = *extra = 0;
    for (size_t i = 0; i < voxel_bytes(truth->size); i++) {
        *missing += (unsigned)__builtin_popcount(truth->least[i] & ~bits[i]);
        *extra += (unsigned)__builtin_popcount(bits[i] & (uint8_t)~truth->most[i]);
    }
}

/* --- at no size ------------------------------------------------------------------------------- */

static const VoxelBox model_space = { .scale = 1 };

double voxel_truths_distance(VoxelTruths *truths, const VoxelScene *scene, uint32_t size,
                             const uint8_t *bits)
{
    if (!truths->has_distance) {
        TruthTriangle *triangles = make_triangles(&scene->mesh, &model_space);
        truths->has_distance =
            triangles &&
            !voxel_distance_make(triangles, scene->mesh.triangle_count, &truths->distance);
        gp_free(triangles);
    }
    const VoxelBox space = voxel_scene_box(scene, size);
    VoxelApart apart;
    if (!truths->has_distance || voxel_distance_find(&truths->distance, &space, bits, &apart))
        return (double)NAN;
    return 1000 * fmax(apart.to_voxels, apart.to_model);
}

double voxel_truths_wrong_volume(VoxelTruths *truths, const VoxelScene *scene, uint32_t size,
                                 const uint8_t *bits)
{
    if (!truths->has_probes) {
        TruthTriangle *triangles = make_triangles(&scene->mesh, &model_space);
        truths->has_probes =
            triangles && !voxel_probes_make(triangles, scene->mesh.triangle_count, &truths->probes);
        gp_free(triangles);
    }
    const VoxelBox space = voxel_scene_box(scene, size);
    return truths->has_probes ? 1000 * voxel_probes_wrong(&truths->probes, &space, bits)
                              : (double)NAN;
}
