#include "apps/truth/ray_scene.h"

#include "apps/truth/ray_tree.h"

struct TruthScene {
    TruthTriangle *triangles;
    TruthNode *nodes;
    uint32_t *order; /* the triangles of the tree's leaves */
    uint32_t count;
    double extent; /* the largest |coordinate| */
};

/* What to look for: meetings at t > from, not with triangle `skip`. */
typedef struct Search {
    TruthRay ray;
    double from;
    uint32_t skip;
    bool any;      /* one is enough; else the first */
    TruthHit best; /* so far; before any, t is the limit and the triangle none */
    /* For the boxes: the reciprocal of the direction, and the origin moved either way, so that
     * boxes are larger than all that rounding does. */
    double reciprocal[3], low_origin[3], high_origin[3];
} Search;

GpResult truth_scene_create(const TruthTriangle *triangles, uint32_t count, TruthScene **scene)
{
    double extent = 0;
    for (size_t i = 0; i < 9 * (size_t)count; i++) {
        const double coordinate = triangles[i / 9].corner[i / 3 % 3][i % 3];
        if (!isfinite(coordinate))
            return GP_ERROR_INVALID;
        extent = fmax(extent, fabs(coordinate));
    }
    TruthScene *made = gp_alloc(1, sizeof *made);
    if (!made)
        return GP_ERROR_MEMORY;
    *made = (TruthScene){
        .triangles = gp_alloc(count, sizeof *made->triangles),
        .nodes = gp_alloc(2 * (size_t)count, sizeof *made->nodes),
        .order = gp_alloc(count, sizeof *made->order),
        .count = count,
        .extent = extent,
    };
    if (!made->triangles || !made->nodes || !made->order ||
        (count > 0 && truth_tree_build(triangles, count, made->order, made->nodes))) {
        truth_scene_destroy(&made);
        return GP_ERROR_MEMORY;
    }
    for (uint32_t i = 0; i < count; i++)
        made->triangles[i] = triangles[i];
    *scene = made;
    return GP_OK;
}

GpResult truth_scene_fail(GpError *error, GpResult result)
{
    return gp_fail(error, result, "%s",
                   result == GP_ERROR_INVALID ? "the truth is of finite coordinates, and one is not"
                                              : "no memory for the truth");
}

void truth_scene_destroy(TruthScene **scene)
{
    if (!*scene)
        return;
    gp_free((*scene)->triangles);
    gp_free((*scene)->nodes);
    gp_free((*scene)->order);
    gp_free(*scene);
    *scene = NULL;
}

const TruthTriangle *truth_scene_triangle(const TruthScene *scene, uint32_t number)
{
    GP_ASSERT(number < scene->count);
    return &scene->triangles[number];
}

/* A length that is nothing beside the scene and the point, and far above what rounding moves. */
static double nothing_at(const TruthScene *scene, const double point[3])
{
    return 0x1p-40 * fmax(scene->extent, vector_extent(point));
}

static Search make_search(const TruthScene *scene, const double origin[3],
                          const double direction[3])
{
    Search search = { .ray = truth_ray(origin, direction),
                      .skip = TRUTH_NO_TRIANGLE,
                      .best = { .t = HUGE_VAL, .triangle = TRUTH_NO_TRIANGLE } };
    double slack = nothing_at(scene, origin);
    for (int i = 0; i < 3; i++) {
        search.reciprocal[i] = 1 / direction[i];
        search.low_origin[i] = origin[i] + slack;
        search.high_origin[i] = origin[i] - slack;
    }
    return search;
}

/* Slab by slab. Where the ray runs along a side of the box a product is 0 * infinity, not a number,
 * which takes part in no comparison: that slab holds the whole ray. */
static bool meets_box(const Search *search, const TruthNode *node)
{
    double enter = search->from, leave = search->best.t;
    for (int i = 0; i < 3; i++) {
        double low = (node->box.low[i] - search->low_origin[i]) * search->reciprocal[i];
        double high = (node->box.high[i] - search->high_origin[i]) * search->reciprocal[i];
        double first = search->reciprocal[i] < 0 ? high : low;
        double last = search->reciprocal[i] < 0 ? low : high;
        enter = first > enter ? first : enter;
        leave = last < leave ? last : leave;
    }
    return enter <= leave;
}

static void search_leaf(const TruthScene *scene, const TruthNode *leaf, Search *search)
{
    for (uint32_t i = leaf->first; i < leaf->first + leaf->count; i++) {
        TruthHit hit = { .triangle = scene->order[i] };
        const TruthHit *best = &search->best;
        if (hit.triangle != search->skip &&
            truth_ray_triangle(&search->ray, &scene->triangles[hit.triangle], &hit.t, hit.share) &&
            hit.t > search->from &&
            (hit.t < best->t || (hit.t == best->t && hit.triangle < best->triangle)))
            search->best = hit;
    }
}

/* Returns whether anything was found, which search->best then is. */
static bool run_search(const TruthScene *scene, Search *search)
{
    uint32_t waiting[TRUTH_TREE_DEPTH + 1], count = 0;
    bool found = false;
    if (scene->count > 0)
        waiting[count++] = 0;
    while (count > 0 && !(found && search->any)) {
        const TruthNode *node = &scene->nodes[waiting[--count]];
        if (!meets_box(search, node))
            continue;
        if (node->count > 0) {
            search_leaf(scene, node, search);
            found = search->best.triangle != TRUTH_NO_TRIANGLE;
        } else {
            uint32_t low_is_nearer = search->ray.direction[node->axis] > 0;
            waiting[count++] = node->first + low_is_nearer;
            waiting[count++] = node->first + !low_is_nearer;
        }
    }
    return found;
}

bool truth_first_hit(const TruthScene *scene, const double origin[3], const double direction[3],
                     TruthHit *hit)
{
    Search search = make_search(scene, origin, direction);
    if (!run_search(scene, &search))
        return false;
    *hit = search.best;
    return true;
}

/* Whether anything is met before t = `end`. */
static bool is_blocked(const TruthScene *scene, const double from[3], const double direction[3],
                       double end, uint32_t skip)
{
    Search search = make_search(scene, from, direction);
    search.from = nothing_at(scene, from) / vector_extent(direction);
    search.best.t = end;
    search.skip = skip;
    search.any = true;
    return run_search(scene, &search);
}

bool truth_blocked(const TruthScene *scene, const double from[3], const double to[3], uint32_t skip)
{
    double direction[3];
    vector_subtract(to, from, direction);
    double length = vector_extent(direction);
    return length > 0 &&
           is_blocked(scene, from, direction, 1 - nothing_at(scene, to) / length, skip);
}

bool truth_blocked_along(const TruthScene *scene, const double from[3], const double direction[3],
                         uint32_t skip)
{
    return is_blocked(scene, from, direction, HUGE_VAL, skip);
}
