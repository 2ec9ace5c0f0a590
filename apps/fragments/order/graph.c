#include "apps/fragments/order/graph.h"

#include "pipeline/base/grow.h"

void pairs_add(Pairs *edges, uint32_t before, uint32_t after)
{
    uint32_t(*pair)[2] =
        gp_grown(edges->pair, edges->count, &edges->room, sizeof *pair, &edges->failed);
    if (!pair)
        return;
    edges->pair = pair;
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

/* --- a sequence ------------------------------------------------------------------------------- */

typedef struct Sequence {
    const Graph *graph;
    uint32_t *component, components;
    uint32_t *first; /* [components + 1] of each in members, what comes before the others first */
    uint32_t *members;
    uint32_t *before;             /* [count] of its component, that are not in the sequence yet */
    uint32_t *list, count, taken; /* the sequence; those of it whose turn it was to free others */
} Sequence;

/* Members of components, as they come in a list. */
static void list_members(Sequence *s, const uint32_t *nodes)
{
    const uint32_t last = s->components - 1;
    uint32_t *next = s->first + 1; /* counts, then where one goes, then ends */
    for (uint32_t n = 0; n < s->graph->count; n++)
        next[last - s->component[n] + 1]++;
    for (uint32_t c = 0; c < s->components; c++)
        next[c + 1] += next[c];
    for (uint32_t i = 0; i < s->graph->count; i++)
        s->members[next[last - s->component[nodes[i]]]++] = nodes[i];
    for (uint32_t n = 0; n < s->graph->count; n++)
        for (size_t i = s->graph->first[n]; i < s->graph->first[n + 1]; i++)
            s->before[s->graph->after[i]] += s->component[s->graph->after[i]] == s->component[n];
}

enum { IS_LISTED = UINT32_MAX };

static void list_node(Sequence *s, uint32_t node)
{
    s->before[node] = IS_LISTED;
    s->list[s->count++] = node;
}

/* Takes nodes from what comes behind them, which is listed where nothing is left before it. */
static void free_others(Sequence *s)
{
    while (s->taken < s->count) {
        const uint32_t node = s->list[s->taken++];
        for (size_t i = s->graph->first[node]; i < s->graph->first[node + 1]; i++) {
            const uint32_t after = s->graph->after[i];
            if (s->component[after] == s->component[node] && s->before[after] != IS_LISTED &&
                --s->before[after] == 0)
                list_node(s, after);
        }
    }
}

/* Every component of more than one is a circle. */
static uint32_t cut_circles(Sequence *s)
{
    uint32_t cuts = 0;
    for (uint32_t c = 0; c < s->components; c++)
        for (uint32_t i = s->first[c]; i < s->first[c + 1]; i++)
            if (s->before[s->members[i]] != IS_LISTED) {
                cuts += s->before[s->members[i]] > 0;
                list_node(s, s->members[i]);
                free_others(s);
            }
    return cuts;
}

GpResult graph_sequence(const Graph *graph, const uint32_t *nodes, uint32_t *sequence,
                        uint32_t *cuts)
{
    const size_t count = (size_t)graph->count + 2;
    Sequence s = { .graph = graph,
                   .component = gp_alloc(count, sizeof(uint32_t)),
                   .first = gp_alloc(count, sizeof(uint32_t)),
                   .members = gp_alloc(count, sizeof(uint32_t)),
                   .before = gp_alloc(count, sizeof(uint32_t)),
                   .list = sequence };
    GpResult result = s.component && s.first && s.members && s.before
                          ? graph_components(graph, s.component, &s.components)
                          : GP_ERROR_MEMORY;
    if (!result) {
        list_members(&s, nodes);
        *cuts = cut_circles(&s);
    }
    gp_free(s.component);
    gp_free(s.first);
    gp_free(s.members);
    gp_free(s.before);
    return result;
}
