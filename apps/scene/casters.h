/* What of a scene casts shadows under a light, and what only receives them.
 *
 * A floor under everything but the light shades nothing, since the light is above it as is all that
 * it could shade; the same holds of whatever lies in a plane that has the scene and the light on
 * one side, whichever way it is turned. What is judged is a piece, triangles that hang together by
 * their corners: a floor, a wall, a room that is open or holds its light. The bottom of a box is no
 * piece.
 */
#ifndef APPS_SCENE_CASTERS_H
#define APPS_SCENE_CASTERS_H

#include "apps/scene/scene.h"

/* The triangles of an object that cast. */
typedef struct SceneCaster {
    const uint32_t *indices; /* the geometry's own where all do */
    uint32_t index_count;    /* 0: it only receives */
} SceneCaster;

typedef struct SceneCasters {
    const Scene *scene;
    const SceneLight *light;
    const SceneCaster *objects; /* [draws of the first pass] */
} SceneCasters;

/* Looks at the objects of the first pass.
 * owns   the frame, which knows where memory was missing
 * note   A vertex within 2^-20 of the scene's largest coordinate from a plane lies on it: that is
 *        16 times what positions are rounded by, which turned ones are. What is shaded wrongly for
 *        it lies no deeper than that below a floor. A light so near to a plane, or as good as along
 *        it, is on neither side. */
SceneCasters scene_casters(const Scene *scene, const SceneLight *light, Frame *frame);

bool caster_casts(const SceneCasters *casters, uint32_t object);

/* The vertices of what casts: all of an object where all of it does, else those of the triangles,
 * some of them more than once. */
typedef struct CasterVertices {
    const uint32_t *indices; /* NULL: all, in order */
    uint32_t next, count;
} CasterVertices;

CasterVertices caster_vertices(const SceneCasters *casters, uint32_t object);
bool caster_next_vertex(CasterVertices *vertices, uint32_t *vertex);

#endif
