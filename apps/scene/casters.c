#include "apps/scene/casters.h"

#include "apps/base/mesh_places.h"
#include "apps/base/vector.h"
#include "apps/scene/bounds.h"

#include <stdlib.h>
#include <string.h>

enum {
    MOST_PLANES = 16, /* of a scene */
    MOST_LOOKED = 64, /* planes that are held against every vertex */
    DIRECTIONS = 26   /* in which the farthest vertices are known */
};

typedef struct Plane {
    double normal[3], distance; /* normal . p + distance: above 0 towards the light */
} Plane;

/* A triangle whose plane may have the scene on one side. */
typedef struct Candidate {
    double area;
    uint32_t object, triangle;
} Candidate;

typedef struct Search {
    const Scene *scene;
    const SceneLight *light;
    const GpPass *pass;
    double tolerance;
    double farthest[DIRECTIONS][3];
    Plane planes[MOST_PLANES];
    int plane_count;
} Search;

/* --- planes ----------------------------------------------------------------------------------- */

static void corners_of(const GpDraw *draw, uint32_t triangle, double corners[3][3])
{
    for (uint32_t i = 0; i < 3; i++)
        draw_position(draw, draw->geometry.indices[3 * triangle + i], corners[i]);
}

static double height_above(const Plane *plane, const double point[3])
{
    return vector_dot(plane->normal, point) + plane->distance;
}

/* The plane of a triangle, turned to the light. False where there is none, or the light is on
 * neither side. out area: twice */
static bool find_plane(const Search *search, double corners[3][3], Plane *plane, double *area)
{
    const SceneLight *light = search->light;
    double side[2][3];
    vector_subtract(corners[1], corners[0], side[0]);
    vector_subtract(corners[2], corners[0], side[1]);
    vector_cross(side[0], side[1], plane->normal);
    *area = sqrt(vector_dot(plane->normal, plane->normal));
    if (*area == 0)
        return false;
    vector_normalize(plane->normal);
    plane->distance = -vector_dot(plane->normal, corners[0]);
    const double height = light->directional ? vector_dot(plane->normal, light->position)
                                             : height_above(plane, light->position);
    /* a corner that is off by the tolerance tilts the plane by so much */
    const double tilt = search->tolerance / sqrt(*area);
    const double least = light->directional ? tilt : search->tolerance;
    for (int k = 0; k < 3 && height < 0; k++)
        plane->normal[k] = -plane->normal[k];
    plane->distance = height < 0 ? -plane->distance : plane->distance;
    return fabs(height) > least;
}

static bool lies_on(const Search *search, const Plane *plane, double corners[3][3])
{
    for (int i = 0; i < 3; i++)
        if (fabs(height_above(plane, corners[i])) > search->tolerance)
            return false;
    return true;
}

static bool lies_on_any(const Search *search, double corners[3][3])
{
    for (int i = 0; i < search->plane_count; i++)
        if (lies_on(search, &search->planes[i], corners))
            return true;
    return false;
}

/* --- all vertices ----------------------------------------------------------------------------- */

static bool has_farthest_above(const Search *search, const Plane *plane)
{
    for (int i = 0; i < DIRECTIONS; i++)
        if (height_above(plane, search->farthest[i]) < -search->tolerance)
            return false;
    return true;
}

static bool has_all_above(const Search *search, const Plane *plane)
{
    for (uint32_t i = 0; i < search->pass->draw_count; i++) {
        const GpDraw *draw = &search->pass->draws[i];
        for (uint32_t j = 0; j < draw->geometry.vertex_count; j++) {
            double position[3];
            draw_position(draw, j, position);
            if (height_above(plane, position) < -search->tolerance)
                return false;
        }
    }
    return true;
}

/* The vertices farthest along the axes and their diagonals, both ways: most planes have one of them
 * below. */
static void find_farthest(Search *search)
{
    enum { WAYS = DIRECTIONS / 2 };
    double most[2][WAYS], way[WAYS][3], largest = 0;
    for (int d = 0; d < WAYS; d++) {
        vector_set(way[d], d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1);
        most[0][d] = most[1][d] = -HUGE_VAL;
    }
    for (uint32_t i = 0; i < search->pass->draw_count; i++) {
        const GpDraw *draw = &search->pass->draws[i];
        for (uint32_t j = 0; j < draw->geometry.vertex_count; j++) {
            double p[3];
            draw_position(draw, j, p);
            largest = fmax(largest, vector_extent(p));
            for (int d = 0; d < WAYS; d++) {
                const double along = vector_dot(way[d], p);
                if (along > most[0][d]) {
                    most[0][d] = along;
                    memcpy(search->farthest[d], p, sizeof p);
                }
                if (-along > most[1][d]) {
                    most[1][d] = -along;
                    memcpy(search->farthest[WAYS + d], p, sizeof p);
                }
            }
        }
    }
    search->tolerance = 0x1p-20 * largest;
}

/* --- the search ------------------------------------------------------------------------------- */

/* The largest first, then by number. */
static int compare(const void *a, const void *b)
{
    const Candidate *x = a, *y = b;
    if (x->area != y->area)
        return x->area > y->area ? -1 : 1;
    if (x->object != y->object)
        return x->object < y->object ? -1 : 1;
    return (x->triangle > y->triangle) - (x->triangle < y->triangle);
}

static uint32_t find_candidates(const Search *search, Candidate *candidates)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < search->pass->draw_count; i++) {
        const GpDraw *draw = &search->pass->draws[i];
        for (uint32_t j = 0; j < draw->geometry.index_count / 3; j++) {
            double corners[3][3], area;
            Plane plane;
            corners_of(draw, j, corners);
            if (find_plane(search, corners, &plane, &area) && has_farthest_above(search, &plane))
                candidates[count++] = (Candidate){ area, i, j };
        }
    }
    return count;
}

/* Planes of large triangles first: those of slivers lie askew, and are found to lie on others. */
static void find_planes(Search *search, Candidate *candidates, uint32_t count)
{
    int looked = 0;
    qsort(candidates, count, sizeof *candidates, compare);
    for (uint32_t i = 0; i < count && looked < MOST_LOOKED && search->plane_count < MOST_PLANES;
         i++) {
        double corners[3][3], area;
        Plane *plane = &search->planes[search->plane_count];
        corners_of(&search->pass->draws[candidates[i].object], candidates[i].triangle, corners);
        if (lies_on_any(search, corners))
            continue;
        looked++;
        find_plane(search, corners, plane, &area);
        search->plane_count += has_all_above(search, plane);
    }
}

/* --- pieces ----------------------------------------------------------------------------------- */

static uint32_t root_of(uint32_t *parent, uint32_t i)
{
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

/* in   receives: of each triangle
 * out  place: of each vertex, the piece that it is in; casts: of each piece */
static void find_pieces(const GpGeometry *geometry, const bool *receives, uint32_t *place,
                        uint32_t *parent, bool *casts)
{
    for (uint32_t i = 0; i < geometry->vertex_count; i++)
        parent[i] = i;
    for (uint32_t i = 0; i < geometry->index_count; i += 3) {
        const uint32_t root = root_of(parent, place[geometry->indices[i]]);
        for (uint32_t k = 1; k < 3; k++)
            parent[root_of(parent, place[geometry->indices[i + k]])] = root;
    }
    for (uint32_t i = 0; i < geometry->vertex_count; i++)
        place[i] = root_of(parent, place[i]);
    for (uint32_t i = 0; i < geometry->index_count / 3; i++)
        casts[place[geometry->indices[3 * i]]] |= !receives[i];
}

/* Leaves out the pieces all of whose triangles receive. Without memory all cast, and the frame
 * knows. */
static SceneCaster choose_triangles(const GpDraw *draw, const bool *receives, Frame *frame)
{
    const GpGeometry *geometry = &draw->geometry;
    const uint32_t vertices = geometry->vertex_count;
    SceneCaster caster = { geometry->indices, geometry->index_count };
    float *positions = gp_alloc(vertices, 3 * sizeof *positions);
    uint32_t *place = gp_alloc(vertices, sizeof *place), count = 0;
    uint32_t *parent = gp_alloc(vertices, sizeof *parent);
    bool *casts = gp_alloc(vertices, sizeof *casts);
    uint32_t *indices = frame_alloc(frame, geometry->index_count, sizeof *indices);
    for (uint32_t i = 0; positions && i < vertices; i++) {
        double position[3];
        draw_position(draw, i, position);
        for (size_t k = 0; k < 3; k++)
            positions[3 * (size_t)i + k] = (float)position[k];
    }
    if (!positions || !place || !parent || !casts || !indices ||
        mesh_places(positions, vertices, place)) {
        frame_fail(frame);
    } else {
        find_pieces(geometry, receives, place, parent, casts);
        for (uint32_t i = 0; i < geometry->index_count; i++)
            if (casts[place[geometry->indices[i - i % 3]]])
                indices[count++] = geometry->indices[i];
        if (count < geometry->index_count)
            caster = (SceneCaster){ indices, count };
    }
    gp_free(positions);
    gp_free(place);
    gp_free(parent);
    gp_free(casts);
    return caster;
}

static SceneCaster look_at(const Search *search, const GpDraw *draw, bool *receives, Frame *frame)
{
    const uint32_t count = draw->geometry.index_count / 3;
    uint32_t receivers = 0;
    for (uint32_t i = 0; i < count && search->plane_count > 0; i++) {
        double corners[3][3];
        corners_of(draw, i, corners);
        receives[i] = lies_on_any(search, corners);
        receivers += receives[i];
    }
    if (receivers == count && count > 0)
        return (SceneCaster){ NULL, 0 };
    return receivers > 0 ? choose_triangles(draw, receives, frame)
                         : (SceneCaster){ draw->geometry.indices, draw->geometry.index_count };
}

SceneCasters scene_casters(const Scene *scene, const SceneLight *light, Frame *frame)
{
    Search search = { .scene = scene, .light = light, .pass = &scene->list.passes[0] };
    const GpPass *pass = search.pass;
    size_t triangles = 1;
    for (uint32_t i = 0; i < pass->draw_count; i++)
        triangles += pass->draws[i].geometry.index_count / 3;
    Candidate *candidates = gp_alloc(triangles, sizeof *candidates);
    bool *receives = gp_alloc(triangles, sizeof *receives);
    SceneCaster *objects = frame_alloc(frame, pass->draw_count, sizeof *objects);
    if (!candidates || !receives || !objects) {
        frame_fail(frame);
    } else {
        find_farthest(&search);
        find_planes(&search, candidates, find_candidates(&search, candidates));
    }
    for (uint32_t i = 0; receives && objects && i < pass->draw_count; i++)
        objects[i] = look_at(&search, &pass->draws[i], receives, frame);
    gp_free(candidates);
    gp_free(receives);
    return (SceneCasters){ scene, light, receives ? objects : NULL };
}

bool caster_casts(const SceneCasters *casters, uint32_t object)
{
    return casters->objects && casters->objects[object].index_count > 0;
}

CasterVertices caster_vertices(const SceneCasters *casters, uint32_t object)
{
    const GpGeometry *geometry = &casters->scene->list.passes[0].draws[object].geometry;
    if (!caster_casts(casters, object))
        return (CasterVertices){ NULL, 0, 0 };
    const SceneCaster *caster = &casters->objects[object];
    return caster->indices == geometry->indices
               ? (CasterVertices){ NULL, 0, geometry->vertex_count }
               : (CasterVertices){ caster->indices, 0, caster->index_count };
}

bool caster_next_vertex(CasterVertices *vertices, uint32_t *vertex)
{
    if (vertices->next == vertices->count)
        return false;
    *vertex = vertices->indices ? vertices->indices[vertices->next] : vertices->next;
    vertices->next++;
    return true;
}
