/* Exact voxels found when they are asked for, and what a volume has wrong. */
#include "apps/techniques/voxel/truths.h"

#include "apps/base/content.h"
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
    gp_pool_destroy(&truths->pool);
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

GpResult voxel_truths_prepare(VoxelTruths *truths, int threads, GpError *error)
{
    return truths->pool ? GP_OK : gp_pool_create(threads, &truths->pool, error);
}

/* The triangles, as the model has them. NULL without memory; the caller frees them. */
static TruthTriangle *model_triangles(const VoxelScene *scene)
{
    return voxel_true_triangles(scene, &model_space);
}

/* False without memory. */
static bool make_distance(VoxelTruths *truths, const VoxelScene *scene)
{
    if (truths->has_distance)
        return true;
    TruthTriangle *triangles = model_triangles(scene);
    truths->has_distance =
        triangles && !voxel_distance_make(triangles, scene->mesh.triangle_count, &truths->distance);
    gp_free(triangles);
    return truths->has_distance;
}

double voxel_truths_least_distance(VoxelTruths *truths, const VoxelScene *scene, uint32_t size)
{
    const VoxelBox space = voxel_scene_box(scene, size);
    double least;
    if (!make_distance(truths, scene) ||
        voxel_distance_least(&truths->distance, &space, truths->pool, &least))
        return 0;
    return 1000 * least;
}

static double find_distance(VoxelTruths *truths, const VoxelScene *scene, uint32_t size,
                            const uint8_t *bits)
{
    const VoxelBox space = voxel_scene_box(scene, size);
    VoxelApart apart;
    if (!make_distance(truths, scene) ||
        voxel_distance_find(&truths->distance, &space, bits, truths->pool, &apart))
        return (double)NAN;
    return 1000 * fmax(apart.to_voxels, apart.to_model);
}

static double find_wrong_volume(VoxelTruths *truths, const VoxelScene *scene, VoxelInside inside,
                                uint32_t size, const uint8_t *bits)
{
    VoxelProbes *probes = &truths->probes[inside];
    bool *has = &truths->has_probes[inside];
    if (!*has) {
        TruthTriangle *triangles = model_triangles(scene);
        *has =
            triangles && !voxel_probes_make(triangles, scene->mesh.triangle_count, inside, probes);
        gp_free(triangles);
    }
    const VoxelBox space = voxel_scene_box(scene, size);
    return *has ? 1000 * voxel_probes_wrong(probes, &space, bits, truths->pool) : (double)NAN;
}

/* --- once for a volume ------------------------------------------------------------------------ */

/* in   against: the surface, or the inside by one of two rules
 * out  hash: for remember; returns NULL where the volume is new */
static const VoxelFound *recall(const VoxelTruths *truths, int against, uint32_t size,
                                const uint8_t *bits, uint64_t *hash)
{
    const uint32_t about[2] = { (uint32_t)against, size };
    *hash = content_hash_bytes(bits, voxel_bytes(size), content_hash_bytes(about, sizeof about, 0));
    for (int i = 0; i < truths->found_count; i++)
        if (truths->found[i].hash == *hash)
            return &truths->found[i];
    return NULL;
}

static double remember(VoxelTruths *truths, uint64_t hash, double error)
{
    if (!isnan(error) && truths->found_count < VOXEL_MAX_FOUND)
        truths->found[truths->found_count++] = (VoxelFound){ hash, error };
    return error;
}

enum { SURFACE, INSIDES }; /* against what: the insides have a number each */

double voxel_truths_distance(VoxelTruths *truths, const VoxelScene *scene, uint32_t size,
                             const uint8_t *bits)
{
    uint64_t hash;
    const VoxelFound *found = recall(truths, SURFACE, size, bits, &hash);
    return found ? found->error : remember(truths, hash, find_distance(truths, scene, size, bits));
}

double voxel_truths_wrong_volume(VoxelTruths *truths, const VoxelScene *scene, VoxelInside inside,
                                 uint32_t size, const uint8_t *bits)
{
    uint64_t hash;
    const VoxelFound *found = recall(truths, INSIDES + (int)inside, size, bits, &hash);
    return found ? found->error
                 : remember(truths, hash, find_wrong_volume(truths, scene, inside, size, bits));
}
