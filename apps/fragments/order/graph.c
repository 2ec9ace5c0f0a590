#include "apps/fragments/order/graph.h"

#include <string.h>

void pairs_add(Pairs *edges, uint32_t before, uint32_t after)
{
    if (edges->count == edges->room) {
        const size_t room = edges->room * 2 + 1024;
        uint32_t(*pair)[2] = gp_alloc_unset(room * sizeof *pair);
        if (!pair) {
            edges->failed = true;
            return;
        }
        if (edges->count > 0)
            memcpy(pair, edges->pair, edges->count * sizeof *pair);
        gp_free(edges->pair);
        edges->pair = pair;
        edges->room = room;
    }
    edges->pair[edges->count][0] = before;
    edges->pair[edges->count++][1] = after;
}

void pairs_free(Pairs *edges)
{
    gp_free(edges->pair);
    *edges = (Pairs){ .pair = NULL };
}

GpResult graph_make(uint32_t node_count, const Pairs *edges, Graph *graph)
{
    Graph made = { .count = node_count,
                   .first = gp_alloc((size_t)node_count + 2, sizeof *made.first),
                   .after = gp_alloc_unset((edges->count + 1) * sizeof *made.after) };
    if (edges->failed || !made.first || !made.after) {
        graph_free(&made);
        return GP_ERROR_MEMORY;
    }
    size_t *next = made.first + 1; /* counts, then where a node's next edge goes, then its end */
    for (size_t i = 0; i < edges->count; i++)
        next[edges->pair[i][0] + 1]++;
    for (uint32_t n = 0; n < node_count; n++)
        next[n + 1] += next[n];
    for (size_t i = 0; i < edges->count; i++)
        made.after[next[edges->pair[i][0]]++] = edges->pair[i][1];
    *graph = made;
    return GP_OK;
}

void graph_free(Graph *graph)
{
    gp_free(graph->first);
    gp_free(graph->after);
    *graph = (Graph){ .count = 0 };
}

/* --- components ------------------------------------------------------------------------------- */

enum { NONE = UINT32_MAX };

typedef struct Search {
    const Graph *graph;
    uint32_t *number, *low; /* of each node, in the order of visits, from 1; 0: not yet */
    size_t *next;           /* its next edge */
    uint32_t *stack, *path; /* nodes without a component; nodes being visited */
    uint32_t visits, stacked, depth;
    uint32_t *component, components;
} Search;

static void enter(Search *search, uint32_t node)
{
    search->number[node] = search->low[node] = ++search->visits;
    search->next[node] = search->graph->first[node];
    search->stack[search->stacked++] = node;
    search->path[search->depth++] = node;
}

static void leave(Search *search, uint32_t node)
{
    search->depth--;
    if (search->depth > 0) {
        const uint32_t before = search->path[search->depth - 1];
        if (search->low[node] < search->low[before])
            search->low[before] = search->low[node];
    }
    if (search->low[node] != search->number[node])
        return;
    uint32_t member;
    do {
        member = search->stack[--search->stacked];
        search->component[member] = search->components;
    } while (member != node);
    search->components++;
}

static void visit(Search *search, uint32_t root)
{
    enter(search, root);
    while (search->depth > 0) {
        const uint32_t node = search->path[search->depth - 1];
        if (search->next[node] == search->graph->first[node + 1]) {
            leave(search, node);
            continue;
        }
        const uint32_t after = search->graph->after[search->next[node]++];
        if (search->number[after] == 0)
            enter(search, after);
        else if (search->component[after] == NONE && search->number[after] < search->low[node])
            search->low[node] = search->number[after];
    }
}

GpResult graph_components(const Graph *graph, uint32_t *component, uint32_t *component_count)
{
    const size_t count = (size_t)graph->count + 1;
    Search search = { .graph = graph,
                      .number = gp_alloc(count, sizeof(uint32_t)),
                      .low = gp_alloc(count, sizeof(uint32_t)),
                      .next = gp_alloc(count, sizeof(size_t)),
                      .stack = gp_alloc(count, sizeof(uint32_t)),
                      .path = gp_alloc(count, sizeof(uint32_t)),
                      .component = component };
    const bool done = search.number && search.low && search.next && search.stack && search.path;
    for (uint32_t n = 0; n < graph->count && done; n++)
        component[n] = NONE;
    for (uint32_t n = 0; n < graph->count && done; n++)
        if (search.number[n] == 0)
            visit(&search, n);
    *component_count = search.components;
    gp_free(search.number);
    gp_free(search.low);
    gp_free(search.next);
    gp_free(search.stack);
    gp_free(search.path);
    return done ? GP_OK : GP_ERROR_MEMORY;
}
