#include "apps/fragments/drawing/cpu.h"

#include "apps/fragments/drawing/passes.h"
#include "apps/fragments/drawing/stream.h"
#include "pipeline/base/grow.h"

/* Fragments as they come, chained by pixels. */
typedef struct Link {
    float depth;
    uint32_t triangle, next; /* next: 1 + number of the pixel's fragment before; 0: none */
} Link;

typedef struct Buffer {
    uint32_t width;
    uint32_t *last; /* [height][width] 1 + number of a pixel's last fragment; 0: none */
    Link *links;
    size_t count, room;
} Buffer;

static bool take(void *context, const StreamFragment *fragment)
{
    Buffer *buffer = context;
    Link *list = gp_grown(buffer->links, buffer->count, &buffer->room, sizeof *list, NULL);
    if (!list)
        return false;
    buffer->links = list;
    uint32_t *last = &buffer->last[(size_t)fragment->y * buffer->width + fragment->x];
    buffer->links[buffer->count++] = (Link){ fragment->depth, fragment->triangle, *last };
    *last = (uint32_t)buffer->count;
    return true;
}

static bool is_before(const Link *a, const Link *b)
{
    return a->depth < b->depth || (a->depth == b->depth && a->triangle < b->triangle);
}

/* Sorts a pixel's chain by putting each in its place. returns its first link, 1 + number */
static uint32_t sort_links(Link *links, uint32_t last)
{
    uint32_t first = 0;
    while (last) {
        Link *link = &links[last - 1];
        const uint32_t after = link->next;
        uint32_t *place = &first;
        while (*place && is_before(&links[*place - 1], link))
            place = &links[*place - 1].next;
        link->next = *place;
        *place = last;
        last = after;
    }
    return first;
}

static void put_together(const FragmentMesh *mesh, Buffer *buffer, GpSurface *layers)
{
    for (uint32_t y = 0; y < layers->height; y++)
        for (uint32_t x = 0; x < layers->width; x++) {
            float rgba[4] = { 0, 0, 0, 1 };
            uint32_t at = sort_links(buffer->links, buffer->last[(size_t)y * buffer->width + x]);
            for (; at; at = buffer->links[at - 1].next) {
                const float *color = mesh->colors[buffer->links[at - 1].triangle];
                for (int k = 0; k < 3; k++)
                    rgba[k] += rgba[3] * color[3] * color[k];
                rgba[3] *= 1 - color[3];
            }
            gp_texel_store(layers->format, gp_surface_texel(&layers->level[0], 16, x, y), rgba, 0);
        }
}

GpResult cpu_add(const FragmentMesh *mesh, const FragmentView *view, GpSurface *color,
                 GpSurface *depth, Frame *frame, GpError *error)
{
    if (depth)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "the processor's lists know of nothing opaque");
    const FragmentPasses passes = fragment_passes(mesh, view, color, depth, frame);
    GpSurface *layers = fragment_surface(&passes, GP_A32B32G32R32F);
    Buffer buffer = { .width = view->width,
                      .last = gp_alloc((size_t)view->width * view->height, sizeof *buffer.last) };
    GpResult result = layers->level[0].texels && buffer.last
                          ? fragment_stream(mesh, view, take, &buffer, error)
                          : gp_fail(error, GP_ERROR_MEMORY, "no memory for lists of fragments");
    if (!result) {
        put_together(mesh, &buffer, layers);
        fragment_put_over(&passes, layers);
        result = frame_result(frame, error);
    }
    gp_free(buffer.links);
    gp_free(buffer.last);
    return result;
}
