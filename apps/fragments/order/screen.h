/* Where the faces of a mesh are on the screen, to the bit that the machine draws them at.
 *
 * Vertices go through the arithmetic of the vertex shader (m4x4) and of the machine's own units, so
 * that two faces which do not meet here share no pixel there. */
#ifndef APPS_FRAGMENTS_ORDER_SCREEN_H
#define APPS_FRAGMENTS_ORDER_SCREEN_H

#include "apps/fragments/drawing/view.h"

/* Corners in 1/256 pixel, y down; turned so that the doubled area is positive. */
typedef struct ScreenTriangle {
    int32_t x[3], y[3];
} ScreenTriangle;

/* Half open, in 1/256 pixel; nothing is drawn of a face whose box is empty. */
typedef struct ScreenBox {
    int32_t x0, y0, x1, y1;
} ScreenBox;

typedef struct ScreenFace {
    ScreenBox box;
    uint32_t first; /* of its triangles: one, or the fan that clipping leaves */
    uint8_t count;
    bool is_turned; /* its corners are seen clockwise */
} ScreenFace;

/* Owns all. */
typedef struct Screen {
    ScreenFace *faces; /* [triangle_count] */
    ScreenTriangle *triangles;
    uint32_t triangle_count, triangle_room;
} Screen;

/* errors GP_ERROR_MEMORY */
GpResult screen_make(const FragmentMesh *mesh, const FragmentView *view, Screen *screen,
                     GpError *error);
void screen_free(Screen *screen);

/* Whether two faces have a point inside both: where they have none, no pixel is drawn by both. */
bool screen_faces_meet(const Screen *screen, const ScreenFace *a, const ScreenFace *b);

static inline bool screen_boxes_meet(const ScreenBox *a, const ScreenBox *b)
{
    return a->x0 < b->x1 && b->x0 < a->x1 && a->y0 < b->y1 && b->y0 < a->y1;
}

#endif
