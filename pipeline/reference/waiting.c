#include "pipeline/reference/waiting.h"

#include "pipeline/base/grow.h"
#include "pipeline/units/fragment_order.h"

#include <stdlib.h>
#include <string.h>

void gp_waiting_add(GpWaiting *waiting, GpOrder order, const GpQuad *quad, float min_depth,
                    float max_depth, uint32_t draw, uint32_t primitive)
{
    for (int pixel = 0; pixel < 4; pixel++) {
        if (!(quad->mask >> pixel & 1))
            continue;
        GpWaitingFragment *list = gp_grown(waiting->fragment, waiting->count, &waiting->room,
                                           sizeof *list, &waiting->failed);
        if (!list)
            return;
        waiting->fragment = list;
        GpWaitingFragment *fragment = &list[waiting->count];
        *fragment = (GpWaitingFragment){
            .x = quad->x + pixel % 2,
            .y = quad->y + pixel / 2,
            .key = gp_order_key(order, quad->depth[pixel], min_depth, max_depth),
            .sequence = (uint32_t)waiting->count,
            .draw = draw,
            .primitive = primitive,
            .front = quad->front,
            .depth = quad->depth[pixel],
        };
        for (int t = 0; t < GP_MAX_TARGETS; t++)
            for (int c = 0; c < 4; c++)
                fragment->color[t][c] = quad->color[t][c][pixel];
        waiting->count++;
    }
}

static int by_turn(const void *one, const void *other)
{
    const GpWaitingFragment *a = one, *b = other;
    if (a->y != b->y)
        return a->y < b->y ? -1 : 1;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    if (a->key != b->key)
        return a->key < b->key ? -1 : 1;
    return a->sequence < b->sequence ? -1 : 1;
}

void gp_waiting_sort(GpWaiting *waiting)
{
    if (waiting->count)
        qsort(waiting->fragment, waiting->count, sizeof *waiting->fragment, by_turn);
}

uint32_t gp_waiting_of_pixel(const GpWaiting *waiting, size_t first)
{
    const GpWaitingFragment *fragment = &waiting->fragment[first];
    uint32_t count = 1;
    while (first + count < waiting->count && fragment[count].x == fragment->x &&
           fragment[count].y == fragment->y)
        count++;
    return count;
}

void gp_waiting_quad(const GpWaitingFragment *fragment, GpQuad *quad)
{
    const int pixel = (fragment->x & 1) + 2 * (fragment->y & 1);
    memset(quad, 0, sizeof *quad);
    quad->x = fragment->x & ~1;
    quad->y = fragment->y & ~1;
    quad->mask = 1u << pixel;
    quad->front = fragment->front;
    quad->depth[pixel] = fragment->depth;
    for (int t = 0; t < GP_MAX_TARGETS; t++)
        for (int c = 0; c < 4; c++)
            quad->color[t][c][pixel] = fragment->color[t][c];
}

void gp_waiting_free(GpWaiting *waiting)
{
    gp_free(waiting->fragment);
    *waiting = (GpWaiting){ .failed = waiting->failed };
}
