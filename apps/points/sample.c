#include "apps/points/sample.h"

#include "apps/base/vector.h"
#include "apps/points/triangle.h"
#include "apps/points/vertices.h"

#include <string.h>

enum { CANDIDATES = 3, PASSES = 20, SWEEPS = 32, NO_SAMPLE = UINT32_MAX };

typedef struct Candidate {
    float position[3];
    float near2;       /* squared: at most as far as this is the nearest of the samples */
    uint32_t triangle; /* of the mesh */
} Candidate;

typedef struct Sample {
    float position[3], normal[3]; /* the second: the triangle's */
    uint32_t number;              /* of the candidate */
    uint32_t next;                /* sample of the same hash */
} Sample;

/* Samples in cubes of a grid, which are found by their hash: those of one hash are a list. */
typedef struct Sampler {
    const GpMesh *mesh;
    Candidate *candidates; /* [candidate_count] */
    uint32_t candidate_count;
    Sample *samples; /* [wanted] */
    uint32_t wanted, count;
    uint32_t *first; /* [hash_mask + 1] samples */
    uint32_t hash_mask;
    double cube; /* its side: twice the largest distance that is kept */
} Sampler;

static const float *corner_of(const GpMesh *mesh, uint32_t triangle, int corner)
{
    return mesh->positions + 3 * (size_t)mesh->indices[3 * (size_t)triangle + (size_t)corner];
}

/* Weights of the corners for a candidate: a sequence in a square, of which one half is folded
 * over. */
static void weights_of(uint32_t number, double weight[3])
{
    const double u = 0.5 + number * 0.7548776662466927, v = 0.5 + number * 0.5698402909980532;
    weight[1] = u - floor(u);
    weight[2] = v - floor(v);
    if (weight[1] + weight[2] > 1) {
        weight[1] = 1 - weight[1];
        weight[2] = 1 - weight[2];
    }
    weight[0] = 1 - weight[1] - weight[2];
}

static void mix(const Sampler *sampler, uint32_t number, const float *values, size_t size,
                double mixed[3])
{
    double weight[3];
    const uint32_t *index =
        sampler->mesh->indices + 3 * (size_t)sampler->candidates[number].triangle;
    weights_of(number, weight);
    vector_set(mixed, 0, 0, 0);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            mixed[k] += weight[i] * (double)values[size * index[i] + (size_t)k];
    }
}

static void lay_out(Sampler *sampler, double area)
{
    const GpMesh *mesh = sampler->mesh;
    uint32_t triangle = 0;
    double end = mesh_triangle_area(mesh, 0), place[3];
    for (uint32_t i = 0; i < sampler->candidate_count; i++) {
        const double at = (i + 0.5) / sampler->candidate_count * area;
        while (at >= end && triangle + 1 < mesh->triangle_count)
            end += mesh_triangle_area(mesh, ++triangle);
        Candidate *candidate = &sampler->candidates[i];
        *candidate = (Candidate){ .triangle = triangle, .near2 = INFINITY };
        mix(sampler, i, mesh->positions, 3, place);
        for (int k = 0; k < 3; k++)
            candidate->position[k] = (float)place[k];
    }
}

/* --- distances -------------------------------------------------------------------------------- */

/* The cube of a place that is `shift` cubes farther along each axis. */
static void cube_of(const Sampler *sampler, const float position[3], double shift, int64_t cube[3])
{
    for (int k = 0; k < 3; k++) {
        const double at = floor((double)position[k] / sampler->cube + shift);
        cube[k] = (int64_t)(at < -0x1p62 ? -0x1p62 : at > 0x1p62 ? 0x1p62 : at);
    }
}

static uint32_t hash_of(const Sampler *sampler, int64_t x, int64_t y, int64_t z)
{
    uint64_t hash = (uint64_t)x * 0x9e3779b97f4a7c15u + (uint64_t)y * 0xc2b2ae3d27d4eb4fu +
                    (uint64_t)z * 0x165667b19e3779f9u;
    hash ^= hash >> 32;
    hash *= 0xd6e8feb86659fd93u;
    return (uint32_t)(hash >> 32) & sampler->hash_mask;
}

static void normal_of(const GpMesh *mesh, uint32_t triangle, float normal[3])
{
    double edges[2][3], product[3];
    const float *from = corner_of(mesh, triangle, 0);
    for (int e = 0; e < 2; e++) {
        const float *to = corner_of(mesh, triangle, 1 + e);
        for (int k = 0; k < 3; k++)
            edges[e][k] = (double)to[k] - (double)from[k];
    }
    vector_cross(edges[0], edges[1], product);
    vector_normalize(product);
    for (int k = 0; k < 3; k++)
        normal[k] = (float)product[k];
}

static bool looks_the_same_way(const float a[3], const float b[3])
{
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] +
               (double)a[2] * (double)b[2] >=
           0;
}

/* Squared distance to the nearest sample, at least where it is below the square of half a cube's
 * side: so near are only those of the eight cubes around the nearest corner of the grid. */
static float nearest_sample(const Sampler *sampler, const Candidate *candidate)
{
    int64_t at[3];
    float nearest = INFINITY, normal[3];
    normal_of(sampler->mesh, candidate->triangle, normal);
    cube_of(sampler, candidate->position, -0.5, at);
    for (int i = 0; i < 8; i++) {
        uint32_t s =
            sampler
                ->first[hash_of(sampler, at[0] + (i & 1), at[1] + (i >> 1 & 1), at[2] + (i >> 2))];
        while (s != NO_SAMPLE) {
            const Sample *sample = &sampler->samples[s];
            const float distance2 = (float)triangle_side(candidate->position, sample->position);
            if (distance2 < nearest && looks_the_same_way(normal, sample->normal))
                nearest = distance2;
            s = sample->next;
        }
    }
    return nearest;
}

static void take(Sampler *sampler, uint32_t number)
{
    int64_t at[3];
    Candidate *candidate = &sampler->candidates[number];
    cube_of(sampler, candidate->position, 0, at);
    uint32_t *first = &sampler->first[hash_of(sampler, at[0], at[1], at[2])];
    Sample *sample = &sampler->samples[sampler->count];
    *sample = (Sample){ .number = number, .next = *first };
    memcpy(sample->position, candidate->position, sizeof sample->position);
    normal_of(sampler->mesh, candidate->triangle, sample->normal);
    *first = sampler->count++;
    candidate->near2 = 0;
}

/* A sweep over the surface, which passes by most candidates: neighbours in memory follow each
 * other, but are hardly ever near enough on the surface to crowd. */
static void sweep(Sampler *sampler, uint32_t first, double limit2)
{
    for (uint64_t i = first; i < sampler->candidate_count && sampler->count < sampler->wanted;
         i += SWEEPS) {
        Candidate *candidate = &sampler->candidates[i];
        if ((double)candidate->near2 > limit2)
            candidate->near2 = nearest_sample(sampler, candidate);
        if ((double)candidate->near2 > limit2)
            take(sampler, (uint32_t)i);
    }
}

/* Candidates are looked at again only when the distance has become less than what they were found
 * at: samples only become more. */
static void take_all(Sampler *sampler)
{
    double distance = sampler->cube / 2;
    for (int pass = 0; pass <= PASSES; pass++, distance *= 0.93) {
        for (uint32_t i = 0; i < SWEEPS; i++)
            sweep(sampler, i * 13 % SWEEPS, pass < PASSES ? distance * distance : 0);
    }
}

/* --- all -------------------------------------------------------------------------------------- */

static GpResult copy_samples(const Sampler *sampler, GpPoints *points)
{
    const GpMesh *mesh = sampler->mesh;
    const size_t count = sampler->count;
    GpPoints made = { .positions = gp_alloc_unset(3 * count * sizeof(float)),
                      .normals = gp_alloc_unset(3 * count * sizeof(float)),
                      .colors = mesh->colors ? gp_alloc_unset(3 * count) : NULL,
                      .count = sampler->count };
    if (!made.positions || !made.normals || (mesh->colors && !made.colors)) {
        gp_points_free(&made);
        return GP_ERROR_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        const uint32_t number = sampler->samples[i].number;
        double mixed[3];
        memcpy(made.positions + 3 * i, sampler->candidates[number].position, 3 * sizeof(float));
        mix(sampler, number, mesh->normals, 3, mixed);
        vector_normalize(mixed);
        for (size_t k = 0; k < 3; k++)
            made.normals[3 * i + k] = (float)mixed[k];
        if (!mesh->colors)
            continue;
        mix(sampler, number, mesh->colors, 4, mixed);
        for (size_t k = 0; k < 3; k++)
            made.colors[3 * i + k] = color_byte((float)mixed[k]);
    }
    *points = made;
    return GP_OK;
}

GpResult mesh_sample(const GpMesh *mesh, uint32_t count, GpPoints *points)
{
    const double area = mesh_area(mesh);
    if (count < 1 || count > 1u << 30 || !(area > 0))
        return GP_ERROR_INVALID;
    /* 2 / sqrt 3: in the densest lattice each point stands for sqrt 3 / 2 distance^2. */
    Sampler sampler = { .mesh = mesh,
                        .candidate_count = CANDIDATES * count,
                        .wanted = count,
                        .cube = 2 * 0.9 * sqrt(1.1547005383792515 * area / count) };
    uint32_t hashes = 64;
    while (hashes < count && hashes < 1u << 30)
        hashes *= 2;
    sampler.hash_mask = hashes - 1;
    sampler.candidates = gp_alloc_unset(sampler.candidate_count * sizeof(Candidate));
    sampler.samples = gp_alloc_unset(count * sizeof(Sample));
    sampler.first = gp_alloc_unset(hashes * sizeof(uint32_t));
    GpResult result = GP_ERROR_MEMORY;
    if (sampler.candidates && sampler.samples && sampler.first) {
        memset(sampler.first, 0xff, hashes * sizeof(uint32_t)); /* NO_SAMPLE */
        lay_out(&sampler, area);
        take_all(&sampler);
        result = copy_samples(&sampler, points);
    }
    gp_free(sampler.candidates);
    gp_free(sampler.samples);
    gp_free(sampler.first);
    return result;
}
