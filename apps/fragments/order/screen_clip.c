#include "apps/fragments/order/screen_clip.h"

#include <math.h>
#include <string.h>

ScreenView screen_view(uint32_t width, uint32_t height)
{
    const float low = -32704, high = 32704, w = (float)width, h = (float)height;
    const float left = low * 2.0f / w - 1.0f, right = high * 2.0f / w - 1.0f;
    const float bottom = 1.0f - high * 2.0f / h, top = 1.0f - low * 2.0f / h;
    return (ScreenView){ w,
                         h,
                         { { 0, 0, 1, 0 },
                           { 0, 0, -1, 1 },
                           { 1, 0, 0, -left },
                           { -1, 0, 0, right },
                           { 0, 1, 0, -bottom },
                           { 0, -1, 0, top } } };
}

static float distance_to(const float plane[4], const float clip[4])
{
    return plane[0] * clip[0] + plane[1] * clip[1] + plane[2] * clip[2] + plane[3] * clip[3];
}

bool screen_is_inside(const ScreenView *view, const float clip[4])
{
    bool inside = clip[3] > 0;
    for (int i = 0; i < SCREEN_PLANES && inside; i++)
        inside = distance_to(view->planes[i], clip) >= 0;
    return inside;
}

void screen_place(const ScreenView *view, const float clip[4], int32_t place[2])
{
    const float rw = 1.0f / clip[3];
    place[0] = (int32_t)nearbyintf((clip[0] * rw + 1.0f) * view->width * 0.5f * 256.0f);
    place[1] = (int32_t)nearbyintf((1.0f - clip[1] * rw) * view->height * 0.5f * 256.0f);
}

/* Always from the inside end, in double, rounded once. */
static void cut_edge(const float inside[4], float inside_distance, const float outside[4],
                     float outside_distance, float corner[4])
{
    const double d = (double)inside_distance, t = d / (d - (double)outside_distance);
    for (int c = 0; c < 4; c++)
        corner[c] = (float)((double)inside[c] + t * ((double)outside[c] - (double)inside[c]));
}

static int cut_by(const float plane[4], int count, float clip[SCREEN_CORNERS][4])
{
    float before[SCREEN_CORNERS][4];
    int after = 0;
    memcpy(before, clip, sizeof before);
    for (int i = 0; i < count; i++) {
        const float *here = before[i], *next = before[(i + 1) % count];
        const float distance = distance_to(plane, here), next_distance = distance_to(plane, next);
        if (distance >= 0)
            memcpy(clip[after++], here, sizeof clip[0]);
        if (distance >= 0 && !(next_distance >= 0))
            cut_edge(here, distance, next, next_distance, clip[after++]);
        else if (!(distance >= 0) && next_distance >= 0)
            cut_edge(next, next_distance, here, distance, clip[after++]);
    }
    return after;
}

static float between(float value, float low, float high)
{
    return value < low ? low : value > high ? high : value;
}

int screen_cut(const ScreenView *view, float clip[SCREEN_CORNERS][4])
{
    int count = 3;
    for (int i = 0; i < SCREEN_PLANES && count > 0; i++)
        count = cut_by(view->planes[i], count, clip);
    for (int i = 0; i < count; i++) {
        const float w = clip[i][3];
        if (!(w > 0))
            return 0;
        clip[i][0] = between(clip[i][0], -view->planes[2][3] * w, view->planes[3][3] * w);
        clip[i][1] = between(clip[i][1], -view->planes[4][3] * w, view->planes[5][3] * w);
    }
    return count;
}
