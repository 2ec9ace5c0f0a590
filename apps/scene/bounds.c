#include "apps/scene/bounds.h"

#include <math.h>
#include <string.h>

static const Box empty_box = { { HUGE_VAL, HUGE_VAL, HUGE_VAL },
                               { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };

void draw_position(const GpDraw *draw, uint32_t vertex, double position[3])
{
    const GpStream *stream = &draw->geometry.streams[GP_POSITION];
    float p[3];
    memcpy(p, (const char *)stream->data + (size_t)vertex * stream->stride, sizeof p);
    for (int k = 0; k < 3; k++)
        position[k] = (double)p[k];
}

static void add_point(Box *box, const double point[3])
{
    for (int k = 0; k < 3; k++) {
        box->low[k] = fmin(box->low[k], point[k]);
        box->high[k] = fmax(box->high[k], point[k]);
    }
}

Box draw_box(const GpDraw *draw)
{
    Box box = empty_box;
    double position[3];
    for (uint32_t i = 0; i < draw->geometry.vertex_count; i++) {
        draw_position(draw, i, position);
        add_point(&box, position);
    }
    return box;
}

Box scene_box(const Scene *scene)
{
    const GpPass *pass = &scene->list.passes[0];
    Box all = empty_box;
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        Box box = draw_box(&pass->draws[i]);
        add_point(&all, box.low);
        add_point(&all, box.high);
    }
    return all;
}

bool only_receives(const Scene *scene, const SceneLight *light, const GpDraw *draw)
{
    Box own = draw_box(draw);
    if (own.high[0] > own.low[0] && own.high[1] > own.low[1] && own.high[2] > own.low[2])
        return false;
    Box all = scene_box(scene);
    for (int k = 0; k < 3; k++) {
        double plane = own.low[k];
        double from_light = light->position[k] - (light->directional ? 0 : plane);
        if (own.high[k] > plane)
            continue;
        if ((from_light > 0 && all.low[k] >= plane) || (from_light < 0 && all.high[k] <= plane))
            return true;
    }
    return false;
}
