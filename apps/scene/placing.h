/* What an object's keys do to its vertices, whatever these are part of: transform, fit, color. */
#ifndef APPS_SCENE_PLACING_H
#define APPS_SCENE_PLACING_H

#include "apps/base/bounds.h"
#include "apps/base/json_reader.h"

/* Positions and normals, three floats each, `stride` bytes apart. */
typedef struct PlacedVertices {
    float *positions, *normals;
    size_t stride;
    uint32_t count;
} PlacedVertices;

/* What became of them. */
typedef struct Placed {
    bool mirrored;
    bool uneven;  /* not all axes have one scale */
    double scale; /* of lengths, where they have */
} Placed;

/* "transform", then "fit", where they are there: positions by the matrix, normals by its inverse
 * transpose, at unit length. */
Placed scene_place(Node transform, Node fit, const PlacedVertices *vertices);

/* "color": one colour for all vertices, or from their place in the box, or their normals. */
typedef struct SceneColor {
    bool given;
    int source; /* 0 position, 1 normal, -1 one colour */
    float color[4];
    Bounds box;
} SceneColor;

SceneColor scene_color(Node node, const PlacedVertices *vertices);
void scene_color_at(const SceneColor *color, const float position[3], const float normal[3],
                    float rgba[4]);

#endif
