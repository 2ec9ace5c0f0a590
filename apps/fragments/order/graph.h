/* Directed graphs: what comes before what, and what comes before itself. */
#ifndef APPS_FRAGMENTS_ORDER_GRAPH_H
#define APPS_FRAGMENTS_ORDER_GRAPH_H

#include "pipeline/base/base.h"

/* Pairs as they are found. A zeroed one is empty. */
typedef struct Pairs {
    uint32_t (*pair)[2]; /* before, after */
    size_t count, room;
    bool failed; /* memory was short, and some are missing */
} Pairs;

void pairs_add(Pairs *edges, uint32_t before, uint32_t after);
void pairs_free(Pairs *edges);

/* Pairs by the node that they begin at. */
typedef struct Graph {
    uint32_t count;
    size_t *first;   /* [count + 1] of each node in after */
    uint32_t *after; /* nodes that come after it; some more than once */
} Graph;

/* errors GP_ERROR_MEMORY */
GpResult graph_make(uint32_t node_count, const Pairs *edges, Graph *graph);
void graph_free(Graph *graph);

/* Numbers the strongly connected components: nodes that come before each other have one number, and
 * what comes after has a lower number than what is before.
 * out    component: [count]
 * errors GP_ERROR_MEMORY
 * source Tarjan, "Depth-first search and linear graph algorithms", 1972, without recursion */
GpResult graph_components(const Graph *graph, uint32_t *component, uint32_t *component_count);

/* Puts all nodes into an order in which none comes before what is to be before it, but where nodes
 * come before each other in a circle: that is cut at the first of them.
 * in     nodes: [count] all, those first that come first where nothing else is said
 * out    sequence: [count]; cuts: how often a circle was cut
 * errors GP_ERROR_MEMORY
 * source Kahn, "Topological sorting of large networks", Communications of the ACM 5(11), 1962 */
GpResult graph_sequence(const Graph *graph, const uint32_t *nodes, uint32_t *sequence,
                        uint32_t *cuts);

#endif
