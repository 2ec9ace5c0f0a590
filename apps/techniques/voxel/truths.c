/* Exact voxels found when they are asked for, and what a volume has wrong. */
#include "apps/techniques/voxel/truths.h"

#include "apps/truth/voxel_winding.h"

#include <string.h>

/* --- at a size -------------------------------------------------------------------------------- */

static const double surface_margin = 1e-3, solid_margin = 1.0 / 128; /* voxels */

/* What rounding may decide about insides is near the surface. errors GP_ERROR_MEMORY */
static GpResult find_inside(const TruthTriangle *triangles, uint32_t count, const VoxelTruth *truth)
{
    VoxelWinding winding;
    GpResult result = voxel_winding_make(triangles, count, truth->size, 2, &winding);
    if (result)
        return result;
    const uint8_t *bits = truth->kind == VOXEL_TRUTH_WOUND ? winding.inside : winding.odd;
    voxel_near(triangles, count, truth->size, solid_margin, truth->most);
    for (size_t i = 0; i < voxel_bytes(truth->size); i++) {
        uint8_t inside = bits[i], near = truth->most[i];
        truth->least[i] = (uint8_t)(inside & ~near);
        truth->most[i] = inside | near;
    }
    voxel_winding_free(&winding);
    return GP_OK;
}

static GpResult find(const TruthTriangle *triangles, uint32_t count, const VoxelTruth *truth)
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
    case VOXEL_TRUTH_WOUND:
        return find_inside(triangles, count, truth);
    }
    return GP_OK;
}

TruthTriangle *voxel_true_triangles(const VoxelScene *scene, const VoxelBox *space)
{
    const GpMesh *mesh = &scene->mesh;
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
    TruthTriangle *triangles = voxel_true_triangles(scene, &space);
    *truth =
        (VoxelTruth){ kind, size, gp_alloc(voxel_bytes(size), 1), gp_alloc(voxel_bytes(size), 1) };
    bool good = triangles && truth->least && truth->most &&
                !find(triangles, scene->mesh.triangle_count, truth);
    truths->count += good;
    if (!good) {
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
    for (int i = 0; i < 2; i++)
        voxel_probes_free(&truths->probes[i]);
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
        TruthTriangle *triangles = voxel_true_triangles(scene, &model_space);
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

double voxel_truths_wrong_volume(VoxelTruths *truths, const VoxelScene *scene, VoxelInside inside,
                                 uint32_t size, const uint8_t *bits)
{
    VoxelProbes *probes = &truths->probes[inside];
    bool *has = &truths->has_probes[inside];
    if (!*has) {
        TruthTriangle *triangles = voxel_true_triangles(scene, &model_space);
        *has =
            triangles && !voxel_probes_make(triangles, scene->mesh.triangle_count, inside, probes);
        gp_free(triangles);
    }
    const VoxelBox space = voxel_scene_box(scene, size);
    return *has ? 1000 * voxel_probes_wrong(probes, &space, bits) : (double)NAN;
}
