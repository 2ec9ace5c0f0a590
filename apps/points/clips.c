#include "apps/points/clips.h"

#include "apps/base/camera.h"
#include "apps/base/vector.h"
#include "apps/points/sides.h"

#include <string.h>

/* The edges of a crease that end and begin at a vertex, as its own side's triangles turn. */
typedef struct Wedge {
    double before[3], after[3]; /* directions along the crease */
    bool has_before, has_after;
} Wedge;

/* Whether triangles meet at a side at more than an angle. */
static bool is_crease(const GpMesh *mesh, size_t side, size_t mate, double cosine)
{
    double own[3], other[3];
    triangle_cross(mesh, side / 3, own);
    triangle_cross(mesh, mate / 3, other);
    return vector_dot(own, other) < cosine * sqrt(vector_dot(own, own) * vector_dot(other, other));
}

static void find_wedges(const GpMesh *mesh, const Sides *sides, double cosine, Wedge *wedges)
{
    for (size_t s = 0; s < 3 * (size_t)mesh->triangle_count; s++) {
        const size_t mate = sides->mate[s];
        if (mate == NO_SIDE || !is_crease(mesh, s, mate, cosine))
            continue;
        const bool opposite = sides->corners[s] == sides->corners[side_end(mate)];
        const uint32_t begin = mesh->indices[s], end = mesh->indices[side_end(s)];
        double along[3];
        for (size_t k = 0; k < 3; k++)
            along[k] = (double)mesh->positions[3 * (size_t)end + k] -
                       (double)mesh->positions[3 * (size_t)begin + k];
        vector_normalize(along);
        /* where a crease ends, one vertex has both of its sides */
        if (begin != mesh->indices[opposite ? side_end(mate) : mate] && !wedges[begin].has_after) {
            memcpy(wedges[begin].after, along, sizeof along);
            wedges[begin].has_after = true;
        }
        if (end != mesh->indices[opposite ? mate : side_end(mate)] && !wedges[end].has_before) {
            memcpy(wedges[end].before, along, sizeof along);
            wedges[end].has_before = true;
        }
    }
}

/* source Abramowitz and Stegun 4.4.45, within 7e-5 */
static double angle_of(double cosine)
{
    const double x = fmin(fabs(cosine), 1);
    const double angle =
        sqrt(1 - x) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - x * 0.0187293)));
    return cosine < 0 ? 3.141592653589793 - angle : angle;
}

/* What is inwards of an edge, in the surfel's plane: the triangle lies to the left of its sides. */
static void find_inward(const double normal[3], const double along[3], double inward[3])
{
    vector_cross(normal, along, inward);
    vector_normalize(inward);
}

static SurfelClip clip_of(const Wedge *wedge, const Surfel *surfel)
{
    const double normal[3] = { (double)surfel->normal[0], (double)surfel->normal[1],
                               (double)surfel->normal[2] };
    const double *before = wedge->has_before ? wedge->before : wedge->after;
    const double *after = wedge->has_after ? wedge->after : wedge->before;
    double inward[2][3], turn[3];
    find_inward(normal, before, inward[0]);
    find_inward(normal, after, inward[1]);
    vector_cross(before, after, turn);
    const bool is_convex = vector_dot(turn, normal) >= 0;
    const double bend = angle_of(vector_dot(inward[0], inward[1])), half = 3.141592653589793;
    const double angle = fmax(is_convex ? half - bend : half + bend, 0.1);
    SurfelClip clip;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            clip.inward[i][k] = (float)inward[i][k];
    clip.inward[0][3] = is_convex ? 1 : -1;
    clip.inward[1][3] = (float)sqrt(2 * half / angle);
    return clip;
}

/* clips: room for all that have a wedge */
static void put_last(const Wedge *wedges, const Surfel *from, uint32_t count, Surfels *surfels)
{
    uint32_t whole = 0, clipped = 0;
    const uint32_t first = count - surfels->clip_count;
    for (uint32_t v = 0; v < count; v++) {
        if (!wedges[v].has_before && !wedges[v].has_after) {
            surfels->surfels[whole++] = from[v];
            continue;
        }
        surfels->clips[clipped] = clip_of(&wedges[v], &from[v]);
        surfels->surfels[first + clipped++] = from[v];
    }
}

GpResult surfels_clip(const GpMesh *mesh, double degrees, Surfels *surfels)
{
    Sides sides;
    double sine, cosine;
    const uint32_t count = surfels->count;
    GpResult result = sides_find(mesh, &sides);
    if (result != GP_OK)
        return result;
    Wedge *wedges = gp_alloc(count, sizeof *wedges);
    Surfel *from = gp_alloc_unset(count * sizeof *from);
    uint32_t clips = 0;
    result = GP_ERROR_MEMORY;
    if (wedges && from) {
        angle_sincos(degrees, &sine, &cosine);
        find_wedges(mesh, &sides, cosine, wedges);
        for (uint32_t v = 0; v < count; v++)
            clips += wedges[v].has_before || wedges[v].has_after;
        surfels->clips = gp_alloc_unset(clips * sizeof *surfels->clips + 1);
    }
    if (surfels->clips) {
        surfels->clip_count = clips;
        memcpy(from, surfels->surfels, count * sizeof *from);
        put_last(wedges, from, count, surfels);
        result = GP_OK;
    }
    gp_free(wedges);
    gp_free(from);
    sides_free(&sides);
    return result;
}
