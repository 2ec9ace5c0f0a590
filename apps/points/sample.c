#include "apps/points/sample.h"

#include "apps/base/vector.h"
#include "apps/points/triangle.h"
#include "apps/points/vertices.h"

#include <string.h>

enum { CANDIDATES = 3, PASSES = 20, NO_SAMPLE = UINT32_MAX };

typedef struct Candidate {
    float position[3];
    float near2;       /* squared: at most as far as this is the nearest of the samples */
    uint32_t triangle; /* of the mesh */
} Candidate;

/* Samples in cubes of a grid, which are found by their hash: those of one hash are a list. */
typedef struct Sampler {
    const GpMesh *mesh;
    Candidate *candidates; /* [candidate_count] */
    uint32_t candidate_count;
    uint32_t *samples; /* [wanted] numbers of candidates */
    uint32_t wanted, count;
    uint32_t *first, *next; /* [hash_mask + 1], [wanted] of samples */
    uint32_t hash_mask;
    double cube; /* its side: the largest distance that is kept */
} Sampler;

static const float *corner_of(const GpMesh *mesh, uint32_t triangle, int corner)
{
    return mesh->positions + 3 * (size_t)mesh->indices[3 * (size_t)triangle + (size_t)corner];
}

/* Weights of the corners for a candidate: a sequence in a square, of which one half is folded over. */
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

/* --- distances ---------------------------------------------------------------------------------- */

static void cube_of(const Sampler *sampler, const float position[3], int64_t cube[3])
{
    for (int k = 0; k < 3; k++)
        cube[k] = (int64_t)floor((double)position[k] / sampler->cube);
}

static uint32_t hash_of(const Sampler *sampler, int64_t x, int64_t y, int64_t z)
{
    uint64_t hash = (uint64_t)x * 0x9e3779b97f4a7c15u + (uint64_t)y * 0xc2b2ae3d27d4eb4fu +
                    (uint64_t)z * 0x165667b19e3779f9u;
    hash ^= hash >> 32;
    hash *= 0xd6e8feb86659fd93u;
    return (uint32_t)(hash >> 32) & sampler->hash_mask;
}

static bool looks_the_same_way(const GpMesh *mesh, uint32_t a, uint32_t b)
{
    double normals[2][3];
    for (int i = 0; i < 2; i++) {
        double edges[2][3];
        const float *from = corner_of(mesh, i ? b : a, 0);
        for (int e = 0; e < 2; e++) {
            const float *to = corner_of(mesh, i ? b : a, 1 + e);
            for (int k = 0; k < 3; k++)
                edges[e][k] = (double)to[k] - (double)from[k];
        }
        vector_cross(edges[0], edges[1], normals[i]);
    }
    return a == b || vector_dot(normals[0], normals[1]) >= 0;
}

/* Squared distance to the nearest sample, at least where it is below the square of a cube's side. */
static float nearest_sample(const Sampler *sampler, const Candidate *candidate)
{
    int64_t at[3];
    float nearest = INFINITY;
    cube_of(sampler, candidate->position, at);
    for (int64_t i = 0; i < 27; i++) {
        const uint32_t hash =
            hash_of(sampler, at[0] + i % 3 - 1, at[1] + i / 3 % 3 - 1, at[2] + i / 9 - 1);
        for (uint32_t s = sampler->first[hash]; s != NO_SAMPLE; s = sampler->next[s]) {
            const Candidate *sample = &sampler->candidates[sampler->samples[s]];
            const float distance2 = (float)triangle_side(candidate->position, sample->position);
            if (distance2 < nearest &&
                looks_the_same_way(sampler->mesh, candidate->triangle, sample->triangle))
                nearest = distance2;
        }
    }
    return nearest;
}

static void take(Sampler *sampler, uint32_t number)
{
    int64_t at[3];
    cube_of(sampler, sampler->candidates[number].position, at);
    uint32_t *first = &sampler->first[hash_of(sampler, at[0], at[1], at[2])];
    sampler->samples[sampler->count] = number;
    sampler->next[sampler->count] = *first;
    *first = sampler->count++;
    sampler->candidates[number].near2 = 0;
}

/* A step that visits all of `count` numbers, about 0.618 of them wide. */
static uint32_t jump_over(uint32_t count)
{
    uint32_t step = (uint32_t)(0.6180339887498949 * count) | 1;
    for (;; step++) {
        uint32_t a = count, b = step;
        while (b != 0) {
            const uint32_t rest = a % b;
            a = b;
            b = rest;
        }
        if (a == 1)
            return step % count;
    }
}

/* Candidates are tested again only when the distance has become less than what they were found at:
 * samples only become more. */
static void take_all(Sampler *sampler)
{
    const uint32_t step = jump_over(sampler->candidate_count);
    double distance = sampler->cube;
    for (int pass = 0; pass <= PASSES; pass++, distance *= 0.93) {
        const double limit2 = pass < PASSES ? distance * distance : 0;
        uint32_t number = 0;
        for (uint32_t i = 0; i < sampler->candidate_count && sampler->count < sampler->wanted;
             i++) {
            Candidate *candidate = &sampler->candidates[number];
            if ((double)candidate->near2 > limit2)
                candidate->near2 = nearest_sample(sampler, candidate);
            if ((double)candidate->near2 > limit2)
                take(sampler, number);
            number = (uint32_t)(((uint64_t)number + step) % sampler->candidate_count);
        }
    }
}

/* --- all ---------------------------------------------------------------------------------------- */

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
        const uint32_t number = sampler->samples[i];
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
                        .cube = 0.9 * sqrt(1.1547005383792515 * area / count) };
    uint32_t hashes = 64;
    while (hashes < count && hashes < 1u << 30)
        hashes *= 2;
    sampler.hash_mask = hashes - 1;
    sampler.candidates = gp_alloc_unset(sampler.candidate_count * sizeof(Candidate));
    sampler.samples = gp_alloc_unset(count * sizeof(uint32_t));
    sampler.next = gp_alloc_unset(count * sizeof(uint32_t));
    sampler.first = gp_alloc_unset(hashes * sizeof(uint32_t));
    GpResult result = GP_ERROR_MEMORY;
    if (sampler.candidates && sampler.samples && sampler.next && sampler.first) {
        memset(sampler.first, 0xff, hashes * sizeof(uint32_t)); /* NO_SAMPLE */
        lay_out(&sampler, area);
        take_all(&sampler);
        result = copy_samples(&sampler, points);
    }
    gp_free(sampler.candidates);
    gp_free(sampler.samples);
    gp_free(sampler.next);
    gp_free(sampler.first);
    return result;
}
