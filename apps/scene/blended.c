#include "apps/scene/blended.h"

#include "apps/scene/volumes.h"

#include <stdio.h>

static bool is_blended(const GpDraw *draw)
{
    return draw->state.blend[0].op != GP_BLEND_OFF;
}

SceneBlended scene_take_blended(Loader *loader, Node *pass)
{
    Frame *frame = loader->frame;
    const Scene *scene = loader->scene;
    const bool more = loader->splat_count > 0 || loader->volumes || scene->shadows;
    if (!more || loader->reader.result || frame->arena.result)
        return (SceneBlended){ .count = 0 };
    const GpPass *read = &frame->list.passes[frame->list.pass_count - 1];
    SceneBlended blended = { .order = read->order };
    if (read->order == GP_ORDER_SUBMITTED)
        return blended;
    blended.draws = frame_alloc(frame, read->draw_count + 1, sizeof *blended.draws);
    if (!blended.draws)
        return blended;
    blended.count = frame_take(frame, is_blended, blended.draws);
    if (blended.count > 0 && blended.order != GP_ORDER_DEPTH) {
        Node order = node_member(pass, "order");
        node_fail(&order, GP_ERROR_FORMAT,
                  "what is blended over splats, volumes and shadows comes the farthest first: "
                  "expected depth");
    }
    return blended;
}

void scene_draw_blended(Loader *loader, const Node *pass, const SceneBlended *blended,
                        SceneVolume *volumes, const SceneView *view, const char *name)
{
    static const float none[4] = { 0 };
    char text[300];
    if (blended->count == 0)
        return;
    snprintf(text, sizeof text, "%.200s-sorted", name);
    GpPass *made =
        frame_pass(loader->frame, scene_copy(loader, text), view->color, view->depth, none);
    made->color[0].clear = made->depth.clear_depth = false;
    made->order = blended->order;
    for (uint32_t i = 0; i < blended->count && !loader->reader.result; i++) {
        GpDraw *draw = frame_draw(loader->frame, NULL, NULL, &blended->draws[i].geometry);
        *draw = blended->draws[i];
        scene_see_through(loader, pass, volumes, view, draw);
    }
}
