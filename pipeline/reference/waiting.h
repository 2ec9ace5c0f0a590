/* Fragments that wait for the end of their pass, where it has an order by depth. */
#ifndef GP_REFERENCE_WAITING_H
#define GP_REFERENCE_WAITING_H

#include "pipeline/list/list.h"
#include "pipeline/resources/packet.h"

/* One fragment, shaded, before stencil, depth and blending. */
typedef struct GpWaitingFragment {
    int32_t x, y;
    uint32_t key, sequence; /* gp_order_key; of those of the pass, as submitted */
    uint32_t draw, primitive;
    bool front;
    float depth;
    float color[GP_MAX_TARGETS][4];
} GpWaitingFragment;

typedef struct GpWaiting {
    GpWaitingFragment *fragment;
    size_t count, room;
    bool failed; /* no memory */
} GpWaiting;

/* Adds the living pixels of a shaded quad; min_depth, max_depth: its viewport's. */
void gp_waiting_add(GpWaiting *waiting, GpOrder order, const GpQuad *quad, float min_depth,
                    float max_depth, uint32_t draw, uint32_t primitive);

/* By rows of pixels, those of each pixel in its order. */
void gp_waiting_sort(GpWaiting *waiting);

/* From fragment number `first` on, how many are of its pixel; sorted. */
uint32_t gp_waiting_of_pixel(const GpWaiting *waiting, size_t first);

/* A quad of which the fragment alone is alive. */
void gp_waiting_quad(const GpWaitingFragment *fragment, GpQuad *quad);

/* Leaves `failed` as it is. */
void gp_waiting_free(GpWaiting *waiting);

#endif
