/* Exact voxels found when they are asked for, and what a volume has wrong. */
#include "apps/techniques/voxel/truths.h"

#include "apps/base/content.h"
#include "apps/truth/voxel_winding.h"

#include <string.h>

/* --- in a volume ------------------------------------------------------------------------------ */

static const double surface_margin = 1e-3, solid_margin = 1.0 / 128; /* voxels */

/* What rounding may decide about insides is near the surface. errors GP_ERROR_MEMORY */
static GpResult find_inside(const TruthTriangle *triangles, uint32_t count, const VoxelTruth *truth)
{
    const uint32_t size = truth->space.size;
    VoxelWinding winding;
    GpResult result = voxel_winding_make(triangles, count, size, 2, &winding);
    if (result)
        return result;
    const uint8_t *bits = truth->kind == VOXEL_TRUTH_WOUND ? winding.inside : winding.odd;
    voxel_near(triangles, count, size, solid_margin, truth->most);
    for (size_t i = 0; i < voxel_bytes(size); i++) {
        uint8_t inside = bits[i], near = truth->most[i];
        truth->least[i] = (uint8_t)(inside & ~near);
        truth->most[i] = inside | near;
    }
    voxel_winding_free(&winding);
    return GP_OK;
}

static GpResult find(const TruthTriangle *triangles, uint32_t count, const VoxelTruth *truth)
{
    const uint32_t size = truth->space.size;
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

static bool is_same_space(const VoxelBox *a, const VoxelBox *b)
{
    return a->size == b->size && a->scale == b->scale &&
           memcmp(a->offset, b->offset, sizeof a->offset) == 0;
}

static int kept(const VoxelTruths *truths)
{
    return truths->count < VOXEL_MAX_TRUTHS ? truths->count : VOXEL_MAX_TRUTHS;
}

static void free_truth(VoxelTruth *truth)
{
    gp_free(truth->least);
    gp_free(truth->most);
    *truth = (VoxelTruth){ .least = NULL };
}

const VoxelTruth *voxel_truths_find(VoxelTruths *truths, const VoxelScene *scene,
                                    VoxelTruthKind kind, const VoxelBox *space)
{
    for (int i = 0; i < kept(truths); i++)
        if (truths->truths[i].kind == kind && is_same_space(&truths->truths[i].space, space))
            return &truths->truths[i];
    TruthTriangle *triangles = voxel_true_triangles(scene, space);
    VoxelTruth truth = { kind, *space, gp_alloc(voxel_bytes(space->size), 1),
                         gp_alloc(voxel_bytes(space->size), 1) };
    const bool good = triangles && truth.least && truth.most &&
                      !find(triangles, scene->mesh.triangle_count, &truth);
    gp_free(triangles);
    if (!good) {
        free_truth(&truth);
        return NULL;
    }
    VoxelTruth *place = &truths->truths[truths->count++ % VOXEL_MAX_TRUTHS];
    free_truth(place);
    *place = truth;
    return place;
}

void voxel_truths_free(VoxelTruths *truths)
{
    for (int i = 0; i < kept(truths); i++)
        free_truth(&truths->truths[i]);
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
    for (size_t i = 0; i < voxel_bytes(truth->space.size); i++) {
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

double voxel_truths_least_distance(VoxelTruths *truths, const VoxelScene *scene,
                                   const VoxelBox *space)
{
    double least;
    if (!make_distance(truths, scene) ||
        voxel_distance_least(&truths->distance, space, truths->pool, &least))
        return 0;
    return 1000 * least;
}

static double find_distance(VoxelTruths *truths, const VoxelScene *scene, const VoxelBox *space,
                            const uint8_t *bits)
{
    VoxelApart apart;
    if (!make_distance(truths, scene) ||
        voxel_distance_find(&truths->distance, space, bits, truths->pool, &apart))
        return (double)NAN;
    return 1000 * fmax(apart.to_voxels, apart.to_model);
}

static double find_wrong_volume(VoxelTruths *truths, const VoxelScene *scene, VoxelInside inside,
                                const VoxelBox *space, const uint8_t *bits)
{
    VoxelProbes *probes = &truths->probes[inside];
    bool *has = &truths->has_probes[inside];
    if (!*has) {
        TruthTriangle *triangles = model_triangles(scene);
        *has =
            triangles && !voxel_probes_make(triangles, scene->mesh.triangle_count, inside, probes);
        gp_free(triangles);
    }
    return *has ? 1000 * voxel_probes_wrong(probes, space, bits, truths->pool) : (double)NAN;
}

/* --- once for a volume ------------------------------------------------------------------------ */

/* in   against: the surface, or the inside by one of two rules
 * out  hash: for remember; returns NULL where the volume is new */
static const VoxelFound *recall(const VoxelTruths *truths, int against, const VoxelBox *space,
                                const uint8_t *bits, uint64_t *hash)
{
    const double about[] = { against,          space->size,      space->scale,
                             space->offset[0], space->offset[1], space->offset[2] };
    *hash = content_hash_bytes(bits, voxel_bytes(space->size),
                               content_hash_bytes(about, sizeof about, 0));
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

double voxel_truths_distance(VoxelTruths *truths, const VoxelScene *scene, const VoxelBox *space,
                             const uint8_t *bits)
{
    uint64_t hash;
    const VoxelFound *found = recall(truths, SURFACE, space, bits, &hash);
    return found ? found->error : remember(truths, hash, find_distance(truths, scene, space, bits));
}

double voxel_truths_wrong_volume(VoxelTruths *truths, const VoxelScene *scene, VoxelInside inside,
                                 const VoxelBox *space, const uint8_t *bits)
{
    uint64_t hash;
    const VoxelFound *found = recall(truths, INSIDES + (int)inside, space, bits, &hash);
    return found ? found->error
                 : remember(truths, hash, find_wrong_volume(truths, scene, inside, space, bits));
}
