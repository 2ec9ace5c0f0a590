#include "apps/scene/placing.h"

#include "apps/base/camera.h"

#include <math.h>
#include <string.h>

enum { FAR = 1000000 }; /* no coordinate of a scene lies beyond */

static Bounds vertex_bounds(const PlacedVertices *vertices)
{
    return bounds_of(vertices->positions, vertices->stride, NULL, vertices->count);
}

static float *vertex_at(float *first, const PlacedVertices *vertices, uint32_t i)
{
    return (void *)((char *)first + i * vertices->stride);
}

/* --- to the world ----------------------------------------------------------------------------- */

/* "fit" [x, y, z, size]: the centre of the box goes to x and z, its floor to y, its longest side to
 * size. */
static double read_fit(const Node *node, const PlacedVertices *vertices, double m[4][4])
{
    double fit[4] = { 0 };
    node_doubles(*node, fit, 4, -FAR, FAR);
    node_without_default(node);
    if (!(fit[3] > 0))
        node_fail(node, GP_ERROR_FORMAT, "expected x, y, z and a size above 0");
    const Bounds box = vertex_bounds(vertices);
    const double longest = bounds_longest(&box), *low = box.low, *high = box.high;
    double s = longest > 0 ? fit[3] / longest : 1;
    matrix_identity(m);
    for (int i = 0; i < 3; i++) {
        m[i][i] = s;
        m[i][3] = fit[i] - s * (i == 1 ? low[i] : 0.5 * (low[i] + high[i]));
    }
    return s;
}

/* "transform": scale, then rotate [axis x, y, z, degrees], then translate; all before "fit". */
static void read_transform(Node node, double m[4][4], double scale[3])
{
    node_define(&node, "transform");
    Node scale_node = node_member(&node, "scale"), rotate = node_member(&node, "rotate");
    double turn[4] = { 0, 1, 0, 0 }, move[3] = { 0 };
    vector_set(scale, 1, 1, 1);
    if (node_is(&scale_node, JSON_REAL))
        scale[0] = scale[1] = scale[2] = node_double(scale_node, 1, -FAR, FAR);
    if (node_is_not(&scale_node, JSON_REAL))
        node_doubles(scale_node, scale, 3, -FAR, FAR);
    node_doubles(rotate, turn, 4, -FAR, FAR);
    node_doubles(node_member(&node, "translate"), move, 3, -FAR, FAR);
    if (vector_dot(turn, turn) == 0.0)
        node_fail(&rotate, GP_ERROR_FORMAT, "expected an axis with some length, and degrees");
    if (scale[0] == 0.0 || scale[1] == 0.0 || scale[2] == 0.0)
        node_fail(&scale_node, GP_ERROR_FORMAT, "expected numbers other than 0");

    matrix_rotation(turn, turn[3], m);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            m[i][j] *= scale[j];
        m[i][3] = move[i];
    }
    node_close(&node);
}

/* Three doubles, and one that means nothing: columns of a matrix, so that a product is found in all
 * rows at once, each summed in its order. */
typedef double double4 __attribute__((vector_size(4 * sizeof(double))));

/* Positions by m, normals by its inverse transpose. returns whether m mirrors */
static bool transform_vertices(const PlacedVertices *vertices, double m[4][4])
{
    double normals[3][3];
    double4 column[4] = { { 0 } }, turn[3] = { { 0 } };
    matrix_normals(m, normals);
    const bool mirrored = vector_dot(m[0], normals[0]) < 0.0;
    for (int row = 0; row < 3; row++)
        for (int c = 0; c < 4; c++) {
            column[c][row] = m[row][c];
            if (c < 3)
                turn[c][row] = normals[row][c];
        }
    for (uint32_t i = 0; i < vertices->count; i++) {
        float *position = vertex_at(vertices->positions, vertices, i);
        float *direction = vertex_at(vertices->normals, vertices, i);
        const double4 world = column[0] * (double)position[0] + column[1] * (double)position[1] +
                              column[2] * (double)position[2] + column[3];
        const double4 n = (turn[0] * (double)direction[0] + turn[1] * (double)direction[1] +
                           turn[2] * (double)direction[2]) *
                          (mirrored ? -1.0 : 1.0);
        const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        const double4 normal = n / (length > 0 ? length : 1);
        for (int k = 0; k < 3; k++) {
            position[k] = (float)world[k];
            direction[k] = (float)normal[k];
        }
    }
    return mirrored;
}

Placed scene_place(Node transform, Node fit, const PlacedVertices *vertices)
{
    Placed placed = { .scale = 1 };
    double m[4][4], scale[3];
    if (node_exists(&transform)) {
        read_transform(transform, m, scale);
        placed.mirrored = transform_vertices(vertices, m);
        placed.uneven = fabs(scale[0]) != fabs(scale[1]) || fabs(scale[0]) != fabs(scale[2]);
        placed.scale = fabs(scale[0]);
    }
    if (node_exists(&fit)) {
        placed.scale *= read_fit(&fit, vertices, m);
        transform_vertices(vertices, m);
    }
    return placed;
}

/* --- colours ---------------------------------------------------------------------------------- */

SceneColor scene_color(Node node, const PlacedVertices *vertices)
{
    static const char *const sources[] = { "position", "normal" };
    SceneColor color = { .given = node_exists(&node), .source = -1, .color = { 1, 1, 1, 1 } };
    if (!color.given)
        return color;
    if (node_is(&node, JSON_STRING))
        color.source = node_name(node, 0, sources, 2);
    if (node_is_not(&node, JSON_STRING))
        node_numbers(node, color.color, 4, 0, 1);
    node_without_default(&node);
    color.box = vertex_bounds(vertices);
    return color;
}

void scene_color_at(const SceneColor *color, const float position[3], const float normal[3],
                    float rgba[4])
{
    const Bounds *box = &color->box;
    memcpy(rgba, color->color, sizeof color->color);
    for (int k = 0; k < 3; k++) {
        double size = box->high[k] > box->low[k] ? box->high[k] - box->low[k] : 1;
        if (color->source == 0)
            rgba[k] = (float)(((double)position[k] - box->low[k]) / size);
        else if (color->source == 1)
            rgba[k] = 0.5f + 0.5f * normal[k];
    }
}
