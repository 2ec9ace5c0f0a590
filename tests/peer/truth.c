/* The exact picture: every pixel of every triangle's box, no cleverness.
 *
 * Corners are taken as glasspipe snaps them, for R4 makes the snapped triangle the model's
 * triangle; from there on nothing is shared with the pipeline. Edge values are exact integers;
 * depth and attributes are binary64, 2^29 times finer than what either renderer computes in. */
#include "tests/peer/peer.h"

#include "pipeline/units/viewport.h"

#include <math.h>
#include <stdlib.h>

/* A triangle with area > 0 (clockwise, y down) and the numbers of its corners. */
typedef struct Triangle {
    PeerCorner corner[3];
    uint32_t vertex[3];
    int64_t area;
} Triangle;

static int64_t edge_value(const PeerCorner *from, const PeerCorner *to, int64_t x, int64_t y)
{
    return (to->x - from->x) * (y - from->y) - (to->y - from->y) * (x - from->x);
}

static Triangle get_triangle(const PeerScene *scene, const PeerTruth *truth, uint32_t number)
{
    Triangle t;
    for (int i = 0; i < 3; i++)
        t.vertex[i] = scene->indices[3 * number + (uint32_t)i];
    const PeerCorner *c = truth->corners;
    t.area = edge_value(&c[t.vertex[0]], &c[t.vertex[1]], c[t.vertex[2]].x, c[t.vertex[2]].y);
    if (t.area < 0) {
        uint32_t swap = t.vertex[1];
        t.vertex[1] = t.vertex[2];
        t.vertex[2] = swap;
        t.area = -t.area;
    }
    for (int i = 0; i < 3; i++)
        t.corner[i] = c[t.vertex[i]];
    return t;
}

/* Edge values at a pixel's centre; edge i is opposite corner i. Inside by the top-left rule (R5):
 * on an edge that goes exactly right (top) or up (left) counts. */
static bool covers(const Triangle *t, int x, int y, int64_t value[3])
{
    int64_t center_x = x * 256 + 128, center_y = y * 256 + 128;
    bool inside = t->area > 0;
    for (int i = 0; i < 3; i++) {
        const PeerCorner *from = &t->corner[(i + 1) % 3], *to = &t->corner[(i + 2) % 3];
        bool top_or_left = to->y < from->y || (to->y == from->y && to->x > from->x);
        value[i] = edge_value(from, to, center_x, center_y);
        inside = inside && (value[i] > 0 || (value[i] == 0 && top_or_left));
    }
    return inside;
}

bool peer_covers(const PeerScene *scene, const PeerTruth *truth, uint32_t triangle, int x, int y)
{
    Triangle t = get_triangle(scene, truth, triangle);
    int64_t value[3];
    return covers(&t, x, y, value);
}

/* --- shading ---------------------------------------------------------------------------------- */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalize(double a[3])
{
    double length = sqrt(dot(a, a));
    for (int c = 0; c < 3; c++)
        a[c] /= length;
}

/* Blinn-Phong as shaders_c/materials/phong_shared.h states it, in binary64. */
static void shade(const PhongUniforms *u, double normal[3], const double world[3], double rgb[3])
{
    double light[3], view[3], half[3];
    for (int c = 0; c < 3; c++) {
        light[c] = (double)u->light[c];
        view[c] = (double)u->eye[c] - world[c];
    }
    normalize(normal);
    normalize(view);
    for (int c = 0; c < 3; c++)
        half[c] = view[c] + light[c];
    normalize(half);
    double diffuse = fmax(dot(normal, light), 0);
    double highlight = (double)u->specular * pow(fmax(dot(normal, half), 0), (double)u->shininess);
    for (int c = 0; c < 3; c++) {
        double color = (double)u->diffuse[c] * diffuse + (double)u->ambient[c] + highlight;
        rgb[c] = 255 * fmin(fmax(color, 0), 1);
    }
}

/* Edge values, in pixels squared, from corners before snapping. */
static double unsnapped_values(const Triangle *t, int x, int y, double value[3])
{
    double area = 0;
    for (int i = 0; i < 3; i++) {
        const double *from = t->corner[(i + 1) % 3].unsnapped;
        const double *to = t->corner[(i + 2) % 3].unsnapped;
        value[i] =
            (to[0] - from[0]) * (y + 0.5 - from[1]) - (to[1] - from[1]) * (x + 0.5 - from[0]);
        area += value[i];
    }
    return area;
}

/* Shares of the corners in a screen-linear value; false where the triangle has no area. */
static bool screen_shares(const Triangle *t, PeerPlanes planes, int x, int y, double share[3])
{
    double value[3], area = (double)t->area;
    if (planes == PEER_SNAPPED) {
        int64_t exact[3];
        covers(t, x, y, exact);
        for (int i = 0; i < 3; i++)
            value[i] = (double)exact[i];
    } else
        area = unsnapped_values(t, x, y, value);
    for (int i = 0; i < 3; i++)
        share[i] = value[i] / area;
    return area != 0;
}

double peer_evaluate(const PeerScene *scene, const PeerTruth *truth, uint32_t triangle,
                     PeerPlanes planes, int x, int y, double rgb[3])
{
    Triangle t = get_triangle(scene, truth, triangle);
    double share[3], depth = 0, reciprocal_w = 0, normal[3] = { 0 }, world[3] = { 0 };
    if (!screen_shares(&t, planes, x, y, share)) {
        for (int c = 0; rgb && c < 3; c++)
            rgb[c] = 0;
        return 1;
    }
    for (int i = 0; i < 3; i++) {
        depth += share[i] * t.corner[i].z;
        reciprocal_w += share[i] / t.corner[i].w;
    }
    for (int i = 0; rgb && i < 3; i++) {
        double weight = share[i] / t.corner[i].w / reciprocal_w;
        const PeerVertex *vertex = &scene->vertices[t.vertex[i]];
        for (int c = 0; c < 3; c++) {
            normal[c] += weight * (double)vertex->normal[c];
            world[c] += weight * (double)vertex->position[c];
        }
    }
    if (rgb)
        shade(&scene->uniforms, normal, world, rgb);
    return depth;
}

/* --- drawing ---------------------------------------------------------------------------------- */

static int clamp_pixel(int64_t pixel)
{
    return pixel < 0 ? 0 : pixel >= PEER_SIZE ? PEER_SIZE - 1 : (int)pixel;
}

/* Pixels whose centres may lie inside, and one more on every side. */
static void get_box(const Triangle *t, int low[2], int high[2])
{
    int64_t x0 = t->corner[0].x, x1 = x0, y0 = t->corner[0].y, y1 = y0;
    for (int i = 1; i < 3; i++) {
        x0 = t->corner[i].x < x0 ? t->corner[i].x : x0;
        x1 = t->corner[i].x > x1 ? t->corner[i].x : x1;
        y0 = t->corner[i].y < y0 ? t->corner[i].y : y0;
        y1 = t->corner[i].y > y1 ? t->corner[i].y : y1;
    }
    low[0] = clamp_pixel(x0 / 256 - 1);
    low[1] = clamp_pixel(y0 / 256 - 1);
    high[0] = clamp_pixel(x1 / 256 + 1);
    high[1] = clamp_pixel(y1 / 256 + 1);
}

static void draw_triangle(const PeerScene *scene, PeerTruth *truth, uint32_t number)
{
    Triangle t = get_triangle(scene, truth, number);
    int low[2], high[2];
    get_box(&t, low, high);
    for (int y = low[1]; y <= high[1]; y++)
        for (int x = low[0]; x <= high[0]; x++) {
            int64_t value[3];
            size_t pixel = (size_t)y * PEER_SIZE + (size_t)x;
            if (!covers(&t, x, y, value))
                continue;
            double depth = 0;
            for (int i = 0; i < 3; i++)
                depth += (double)value[i] * t.corner[i].z;
            depth /= (double)t.area;
            if (depth < truth->depth[pixel]) {
                truth->depth[pixel] = depth;
                truth->triangle[pixel] = number;
            }
        }
}

static GpResult place_corners(const PeerScene *scene, PeerTruth *truth)
{
    float(*clip)[4] = gp_alloc(scene->vertex_count, sizeof *clip);
    if (!clip)
        return GP_ERROR_MEMORY;
    peer_clip_positions(scene, clip);
    GpViewport viewport = gp_viewport_resolve(&(GpViewport){ 0 }, PEER_SIZE, PEER_SIZE);
    for (uint32_t i = 0; i < scene->vertex_count; i++) {
        GpScreenVertex screen;
        bool in_range = gp_viewport_position(&viewport, clip[i], &screen);
        GP_ASSERT(in_range); /* the scenes lie inside the viewport: nothing is ever clipped */
        double w = (double)clip[i][3];
        truth->corners[i] = (PeerCorner){
            .x = screen.x,
            .y = screen.y,
            .unsnapped = { (1 + (double)clip[i][0] / w) * PEER_SIZE / 2,
                           (1 - (double)clip[i][1] / w) * PEER_SIZE / 2 },
            .z = (double)screen.z,
            .w = w,
        };
    }
    gp_free(clip);
    return GP_OK;
}

GpResult peer_draw_truth(const PeerScene *scene, PeerTruth *truth)
{
    *truth = (PeerTruth){
        .corners = gp_alloc(scene->vertex_count, sizeof *truth->corners),
        .depth = gp_alloc(PEER_PIXELS, sizeof *truth->depth),
        .triangle = gp_alloc(PEER_PIXELS, sizeof *truth->triangle),
    };
    if (!truth->corners || !truth->depth || !truth->triangle || place_corners(scene, truth)) {
        peer_truth_free(truth);
        return GP_ERROR_MEMORY;
    }
    for (size_t i = 0; i < PEER_PIXELS; i++) {
        truth->depth[i] = 1;
        truth->triangle[i] = PEER_NOTHING;
    }
    for (uint32_t i = 0; i < scene->index_count / 3; i++)
        draw_triangle(scene, truth, i);
    return GP_OK;
}

void peer_truth_free(PeerTruth *truth)
{
    gp_free(truth->corners);
    gp_free(truth->depth);
    gp_free(truth->triangle);
    *truth = (PeerTruth){ 0 };
}

double peer_plane_rounding(const PeerScene *scene, const PeerTruth *truth, uint32_t triangle)
{
    Triangle t = get_triangle(scene, truth, triangle);
    double by_x = 0, by_y = 0;
    for (int i = 0; i < 3; i++) {
        const PeerCorner *from = &t.corner[(i + 1) % 3], *to = &t.corner[(i + 2) % 3];
        by_x -= (double)(to->y - from->y) * t.corner[i].z;
        by_y += (double)(to->x - from->x) * t.corner[i].z;
    }
    double per_pixel = 256 / (double)t.area;
    return 0x1p-24 * (1 + PEER_SIZE * (fabs(by_x * per_pixel) + fabs(by_y * per_pixel)));
}

/* --- distances -------------------------------------------------------------------------------- */

static double length(int64_t x, int64_t y)
{
    return sqrt((double)(x * x + y * y));
}

PeerEdge peer_nearest_edge_of(const PeerScene *scene, const PeerTruth *truth, uint32_t triangle,
                              int x, int y)
{
    Triangle t = get_triangle(scene, truth, triangle);
    int64_t center_x = x * 256 + 128, center_y = y * 256 + 128;
    PeerEdge nearest = { .triangle = triangle, .distance = HUGE_VAL };
    for (int i = 0; i < 3; i++) {
        const PeerCorner *from = &t.corner[i], *to = &t.corner[(i + 1) % 3];
        int64_t dx = to->x - from->x, dy = to->y - from->y, length2 = dx * dx + dy * dy;
        int64_t along = dx * (center_x - from->x) + dy * (center_y - from->y);
        int64_t value = edge_value(from, to, center_x, center_y);
        double distance = along < 0         ? length(center_x - from->x, center_y - from->y)
                          : along > length2 ? length(center_x - to->x, center_y - to->y)
                          : length2 == 0    ? length(center_x - from->x, center_y - from->y)
                                            : (double)llabs(value) / sqrt((double)length2);
        if (distance < nearest.distance)
            nearest = (PeerEdge){ triangle, value, length2, distance };
    }
    return nearest;
}

PeerEdge peer_nearest_edge(const PeerScene *scene, const PeerTruth *truth, int x, int y)
{
    PeerEdge nearest = { .triangle = PEER_NOTHING, .distance = HUGE_VAL };
    for (uint32_t i = 0; i < scene->index_count / 3; i++) {
        PeerEdge edge = peer_nearest_edge_of(scene, truth, i, x, y);
        if (edge.distance < nearest.distance)
            nearest = edge;
    }
    return nearest;
}
