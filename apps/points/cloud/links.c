#include "apps/points/cloud/links.h"

#include "apps/base/vector.h"

#include <math.h>

enum { WEIGHTS = 1024 };

/* --- sets of points whose sides are known from each other ------------------------------------- */

/* A point's parent, and whether the two look opposite ways (TURNED). The root of a set is its own
 * parent. */
#define TURNED 0x80000000u

typedef uint32_t Parent;

static uint32_t parent_index(Parent parent)
{
    return parent & ~TURNED;
}

/* The root of a point, and whether the point is turned against it; shortens the way there. */
static Parent find_root(Parent *parents, uint32_t point)
{
    Parent turned = 0;
    while (parent_index(parents[point]) != point) {
        const Parent parent = parents[point];
        const Parent above = parents[parent_index(parent)];
        turned ^= parent & TURNED;
        if (parent_index(above) != parent_index(parent)) {
            turned ^= above & TURNED;
            parents[point] = above ^ (parent & TURNED);
        }
        point = parent_index(parents[point]);
    }
    return point | turned;
}

/* --- the spanning tree ------------------------------------------------------------------------ */

static bool is_linked_to(const Links *links, uint32_t from, uint32_t to)
{
    const uint32_t *own = links->links + (size_t)links->each * from;
    for (uint32_t i = 0; i < links->each; i++) {
        if (own[i] == to)
            return true;
    }
    return false;
}

static float dot_of(const Links *links, uint32_t a, uint32_t b)
{
    const float *x = links->points[a].normal, *y = links->points[b].normal;
    return (float)((double)x[0] * (double)y[0] + (double)x[1] * (double)y[1] +
                   (double)x[2] * (double)y[2]);
}

/* The weight of a link in steps; WEIGHTS for what is none, or one that its other end has. */
static uint32_t weight_of(const Links *links, uint32_t link)
{
    const uint32_t from = link / links->each, to = links->links[link];
    if (from == to || (from > to && is_linked_to(links, to, from)))
        return WEIGHTS;
    const float weight = (1 - fabsf(dot_of(links, from, to))) * (WEIGHTS - 1) + 0.5F;
    return weight > 0 ? (uint32_t)weight : 0;
}

/* All links, those of the least weight first. NULL: no memory. owns: the caller */
static uint32_t *sort_links(const Links *links, uint32_t *count)
{
    const uint32_t all = links->each * links->count;
    uint32_t first[WEIGHTS + 2] = { 0 };
    uint16_t *weights = gp_alloc_unset(all * sizeof *weights + 1);
    for (uint32_t link = 0; weights && link < all; link++) {
        weights[link] = (uint16_t)weight_of(links, link);
        first[weights[link] + 1]++;
    }
    for (int i = 1; i <= WEIGHTS; i++)
        first[i] += first[i - 1];
    *count = first[WEIGHTS];
    uint32_t *sorted = weights ? gp_alloc_unset(*count * sizeof *sorted + 1) : NULL;
    for (uint32_t link = 0; sorted && link < all; link++) {
        if (weights[link] < WEIGHTS)
            sorted[first[weights[link]]++] = link;
    }
    gp_free(weights);
    return sorted;
}

static void connect(const Links *links, const uint32_t *sorted, uint32_t count, Parent *parents)
{
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t a = sorted[i] / links->each, b = links->links[sorted[i]];
        const Parent root_a = find_root(parents, a), root_b = find_root(parents, b);
        if (parent_index(root_a) == parent_index(root_b))
            continue;
        const Parent opposite = dot_of(links, a, b) < 0 ? TURNED : 0;
        const Parent turned = (root_a ^ root_b ^ opposite) & TURNED;
        if (parent_index(root_a) < parent_index(root_b))
            parents[parent_index(root_b)] = parent_index(root_a) | turned;
        else
            parents[parent_index(root_a)] = parent_index(root_b) | turned;
    }
}

/* --- components ------------------------------------------------------------------------------- */

typedef struct Component {
    int64_t votes; /* of given normals: as they stand, against turned */
    double area, place[3], normal[3], flux;
} Component;

static void add_point(const LinkedPoint *point, const float place[3], const float origin[3],
                      bool is_turned, Component *to)
{
    const double area = (double)point->area, sign = is_turned ? -1 : 1;
    double from[3], normal[3];
    for (int i = 0; i < 3; i++) {
        from[i] = (double)place[i] - (double)origin[i];
        normal[i] = sign * area * (double)point->normal[i];
        to->place[i] += area * from[i];
        to->normal[i] += normal[i];
    }
    to->area += area;
    to->flux += vector_dot(normal, from);
    if (point->is_given)
        to->votes += is_turned ? -1 : 1;
}

static bool is_to_be_turned(const Component *component)
{
    if (component->votes != 0)
        return component->votes < 0;
    const double area = component->area > 0 ? component->area : 1;
    const double flux = component->flux - vector_dot(component->normal, component->place) / area;
    if (fabs(flux) > 1e-3 * area * sqrt(area))
        return flux < 0;
    int largest = 2; /* a flat one: as its normals look in sum */
    for (int i = 1; i >= 0; i--) {
        if (fabs(component->normal[i]) > fabs(component->normal[largest]))
            largest = i;
    }
    return component->normal[largest] < 0;
}

/* numbers: of a root's component, from 1 on. */
static void turn(Links *links, Parent *parents, const uint32_t *numbers, Component *components)
{
    for (uint32_t i = 0; i < links->count; i++) {
        const Parent root = find_root(parents, i);
        const uint32_t number = numbers[parent_index(root)] - 1;
        add_point(&links->points[i], links->places + 3 * (size_t)i, links->places,
                  (root & TURNED) != 0, &components[number]);
    }
    for (uint32_t i = 0; i < links->count; i++) {
        const Parent root = find_root(parents, i);
        const uint32_t number = numbers[parent_index(root)] - 1;
        const bool is_turned = (root & TURNED) != 0;
        LinkedPoint *point = &links->points[i];
        for (int k = 0; k < 3 && !point->is_given; k++)
            point->normal[k] *= is_turned != is_to_be_turned(&components[number]) ? -1.0F : 1.0F;
    }
}

GpResult links_orient(Links *links, uint32_t *components)
{
    uint32_t count = 0, found = 0;
    uint32_t *sorted = sort_links(links, &count);
    Parent *parents = gp_alloc_unset(links->count * sizeof *parents);
    uint32_t *numbers = gp_alloc(links->count, sizeof *numbers);
    Component *each = NULL;
    if (sorted && parents && numbers) {
        for (uint32_t i = 0; i < links->count; i++)
            parents[i] = i;
        connect(links, sorted, count, parents);
        for (uint32_t i = 0; i < links->count; i++) {
            if (parent_index(parents[i]) == i)
                numbers[i] = ++found;
        }
        each = gp_alloc(found, sizeof *each);
        if (each)
            turn(links, parents, numbers, each);
    }
    const bool done = each != NULL;
    gp_free(sorted);
    gp_free(parents);
    gp_free(numbers);
    gp_free(each);
    if (done)
        *components = found;
    return done ? GP_OK : GP_ERROR_MEMORY;
}
