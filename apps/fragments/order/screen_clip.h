/* The machine's arithmetic from clip space to the screen, of positions alone
 * (pipeline/CONVENTIONS.md). */
#ifndef APPS_FRAGMENTS_ORDER_SCREEN_CLIP_H
#define APPS_FRAGMENTS_ORDER_SCREEN_CLIP_H

#include <stdbool.h>
#include <stdint.h>

enum { SCREEN_PLANES = 6, SCREEN_CORNERS = 3 + SCREEN_PLANES };

/* A picture, and where triangles are cut. */
typedef struct ScreenView {
    float width, height;
    float planes[SCREEN_PLANES][4]; /* near, far, guard band: inside where . clip >= 0 (R3) */
} ScreenView;

ScreenView screen_view(uint32_t width, uint32_t height);

/* Whether nothing has to be cut at a corner. */
bool screen_is_inside(const ScreenView *view, const float clip[4]);

/* In 1/256 pixel, y down (R17, R2). in clip: inside */
void screen_place(const ScreenView *view, const float clip[4], int32_t place[2]);

/* Cuts a triangle; returns the corners of the polygon that is left, 0: none. */
int screen_cut(const ScreenView *view, float clip[SCREEN_CORNERS][4]);

#endif
