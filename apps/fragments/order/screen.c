#include "apps/fragments/order/screen.h"

#include "apps/fragments/order/screen_clip.h"

#include <string.h>

static const ScreenBox empty_box = { INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN };

/* A vertex after the vertex shader, and on the screen where nothing has to be cut there. */
typedef struct Seen {
    float clip[4];
    int32_t place[2];
    bool is_inside;
} Seen;

typedef struct Work {
    const FragmentMesh *mesh;
    ScreenView view;
    ScreenBox picture;
    Seen *seen;
    Screen screen;
} Work;

static void see_vertex(const Work *work, const float to_clip[4][4], const float at[3], Seen *seen)
{
    for (int row = 0; row < 4; row++)
        seen->clip[row] = at[0] * to_clip[row][0] + at[1] * to_clip[row][1] +
                          at[2] * to_clip[row][2] + to_clip[row][3];
    seen->is_inside = screen_is_inside(&work->view, seen->clip);
    if (seen->is_inside)
        screen_place(&work->view, seen->clip, seen->place);
}

static int64_t doubled_area(const ScreenTriangle *t)
{
    return (int64_t)(t->x[1] - t->x[0]) * (t->y[2] - t->y[0]) -
           (int64_t)(t->x[2] - t->x[0]) * (t->y[1] - t->y[0]);
}

static void add_to_box(ScreenBox *box, const ScreenTriangle *t)
{
    for (int c = 0; c < 3; c++) {
        box->x0 = t->x[c] < box->x0 ? t->x[c] : box->x0;
        box->y0 = t->y[c] < box->y0 ? t->y[c] : box->y0;
        box->x1 = t->x[c] > box->x1 ? t->x[c] : box->x1;
        box->y1 = t->y[c] > box->y1 ? t->y[c] : box->y1;
    }
}

/* Room for the triangles of one more face. */
static bool make_room(Screen *screen)
{
    if (screen->triangle_count + SCREEN_CORNERS <= screen->triangle_room)
        return true;
    const uint32_t room = screen->triangle_room + screen->triangle_room / 2 + 64;
    ScreenTriangle *triangles = gp_alloc_unset((size_t)room * sizeof *triangles);
    if (!triangles)
        return false;
    memcpy(triangles, screen->triangles, screen->triangle_count * sizeof *triangles);
    gp_free(screen->triangles);
    screen->triangles = triangles;
    screen->triangle_room = room;
    return true;
}

/* Adds a triangle that covers something; returns its signed area. */
static int64_t add_triangle(Screen *screen, ScreenFace *face, ScreenTriangle t)
{
    const int64_t area = doubled_area(&t);
    if (area == 0)
        return 0;
    if (area < 0) {
        const int32_t x = t.x[1], y = t.y[1];
        t.x[1] = t.x[2];
        t.y[1] = t.y[2];
        t.x[2] = x;
        t.y[2] = y;
    }
    add_to_box(&face->box, &t);
    screen->triangles[screen->triangle_count++] = t;
    face->count++;
    return area;
}

static int64_t add_corners(Screen *screen, ScreenFace *face, const int32_t a[2], const int32_t b[2],
                           const int32_t c[2])
{
    return add_triangle(screen, face,
                        (ScreenTriangle){ { a[0], b[0], c[0] }, { a[1], b[1], c[1] } });
}

/* The fan that the machine makes of a face that is cut. */
static int64_t add_cut(Work *work, const Seen *const seen[3], ScreenFace *face)
{
    float clip[SCREEN_CORNERS][4];
    int32_t place[SCREEN_CORNERS][2];
    int64_t area = 0;
    for (int c = 0; c < 3; c++)
        memcpy(clip[c], seen[c]->clip, sizeof clip[c]);
    const int count = screen_cut(&work->view, clip);
    for (int c = 0; c < count; c++)
        screen_place(&work->view, clip[c], place[c]);
    for (int c = 2; c < count; c++)
        area += add_corners(&work->screen, face, place[0], place[c - 1], place[c]);
    return area;
}

static bool see_face(Work *work, uint32_t number)
{
    ScreenFace *face = &work->screen.faces[number];
    const Seen *seen[3];
    if (!make_room(&work->screen))
        return false;
    for (uint32_t c = 0; c < 3; c++)
        seen[c] = &work->seen[work->mesh->indices[3 * (size_t)number + c]];
    *face = (ScreenFace){ .box = empty_box, .first = work->screen.triangle_count };
    const int64_t area =
        seen[0]->is_inside && seen[1]->is_inside && seen[2]->is_inside
            ? add_corners(&work->screen, face, seen[0]->place, seen[1]->place, seen[2]->place)
            : add_cut(work, seen, face);
    face->is_turned = area > 0;
    if (face->count == 0 || !screen_boxes_meet(&face->box, &work->picture)) {
        face->box = empty_box;
        work->screen.triangle_count = face->first;
        face->count = 0;
    }
    return true;
}

GpResult screen_make(const FragmentMesh *mesh, const FragmentView *view, Screen *screen,
                     GpError *error)
{
    Work work = { .mesh = mesh,
                  .view = screen_view(view->width, view->height),
                  .picture = { 0, 0, (int32_t)view->width * 256, (int32_t)view->height * 256 } };
    float to_clip[4][4];
    camera_matrix(&view->camera, (double)view->width / view->height, to_clip);
    work.seen = gp_alloc(mesh->vertex_count, sizeof *work.seen);
    work.screen.faces = gp_alloc(mesh->triangle_count, sizeof *work.screen.faces);
    work.screen.triangle_room = mesh->triangle_count + 64;
    work.screen.triangles =
        gp_alloc_unset(work.screen.triangle_room * sizeof *work.screen.triangles);
    bool done = work.seen && work.screen.faces && work.screen.triangles;
    for (uint32_t i = 0; i < mesh->vertex_count && done; i++)
        see_vertex(&work, (const float(*)[4])to_clip, mesh->positions[i], &work.seen[i]);
    for (uint32_t i = 0; i < mesh->triangle_count && done; i++)
        done = see_face(&work, i);
    gp_free(work.seen);
    if (!done) {
        screen_free(&work.screen);
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    }
    *screen = work.screen;
    return GP_OK;
}

void screen_free(Screen *screen)
{
    gp_free(screen->faces);
    gp_free(screen->triangles);
    *screen = (Screen){ .faces = NULL };
}

/* --- meeting ---------------------------------------------------------------------------------- */

/* Whether an edge of one has the other beyond it, or on it. */
static bool is_parted(const ScreenTriangle *one, const ScreenTriangle *other)
{
    for (int e = 0; e < 3; e++) {
        const int next = e == 2 ? 0 : e + 1;
        const int64_t dx = one->x[next] - one->x[e], dy = one->y[next] - one->y[e];
        bool beyond = true;
        for (int c = 0; c < 3 && beyond; c++)
            beyond = dx * (other->y[c] - one->y[e]) - dy * (other->x[c] - one->x[e]) <= 0;
        if (beyond)
            return true;
    }
    return false;
}

bool screen_faces_meet(const Screen *screen, const ScreenFace *a, const ScreenFace *b)
{
    for (uint32_t i = 0; i < a->count; i++)
        for (uint32_t k = 0; k < b->count; k++) {
            const ScreenTriangle *one = &screen->triangles[a->first + i];
            const ScreenTriangle *other = &screen->triangles[b->first + k];
            if (!is_parted(one, other) && !is_parted(other, one))
                return true;
        }
    return false;
}
