/* The peer check: the same scenes through glasspipe, through Mesa's llvmpipe, and through a plain
 * exact rasterizer in binary64, compared pixel by pixel.
 *
 * The third picture is what makes the comparison more than a count: two renderers that differ
 * by more than rounding are each held against the exact one, so a difference has a culprit.
 */
#ifndef PEER_H
#define PEER_H

#include <glasspipe/glasspipe.h>
#include "shaders_c/materials/phong.h"

enum { PEER_SIZE = 1024, PEER_PIXELS = PEER_SIZE * PEER_SIZE };

#define PEER_NOTHING 0xffffffffu /* triangle number of a pixel that nothing covers */

typedef struct PeerVertex {
    float position[3], normal[3];
} PeerVertex;

typedef struct PeerScene {
    PeerVertex *vertices;
    uint32_t vertex_count;
    uint32_t *indices; /* three a triangle */
    uint32_t index_count;
    PhongUniforms uniforms; /* mvp: Direct3D's clip space */
    float gl_mvp[4][4];     /* the same camera, OpenGL's clip space; rows as in mvp */
} PeerScene;

/* A picture: rows from the top. Alpha is 255 where something was drawn, 0 elsewhere. */
typedef struct PeerPicture {
    uint8_t (*rgba)[4];
    float *depth;       /* window depth, 1 where nothing was drawn */
    uint32_t *triangle; /* number of the visible triangle, or PEER_NOTHING; NULL: not known */
} PeerPicture;

/* A corner of a triangle, y down. */
typedef struct PeerCorner {
    int64_t x, y;              /* as glasspipe snaps it: 24.8 fixed point */
    double unsnapped[2], z, w; /* pixels; window depth; clip w */
} PeerCorner;

/* The exact picture. */
typedef struct PeerTruth {
    PeerCorner *corners; /* one a vertex */
    double *depth;
    uint32_t *triangle; /* the nearest; among equal depths the first */
} PeerTruth;

GpResult peer_picture_create(bool with_triangles, PeerPicture *picture);
void peer_picture_free(PeerPicture *picture);

/* --- scenes.c --------------------------------------------------------------------------------- */

/* A torus about the z axis, radii 0.85 and 0.42, tilted 55 degrees about x, of around x across
 * quads, two triangles each; the camera looks at its centre along -z from the given distance.
 * Errors: GP_ERROR_MEMORY. Owns: the caller; peer_scene_free. */
GpResult peer_torus(uint32_t around, uint32_t across, double distance, PeerScene *scene);

/* Flat triangles of many colours that share edges and face the camera, corners at half pixels, so
 * that many pixel centres lie exactly on edges, where the fill rule decides. As peer_torus. */
GpResult peer_lattice(PeerScene *scene);

/* The bunny, centred, its longest side 2, with area-weighted vertex normals.
 * in   path: binary little-endian PLY, vertices of three floats, faces of three ints
 * errors GP_ERROR_IO (not there), GP_ERROR_FORMAT (another layout), GP_ERROR_MEMORY */
GpResult peer_bunny(const char *path, PeerScene *scene, GpError *error);

void peer_scene_free(PeerScene *scene);

/* --- glasspipe.c ------------------------------------------------------------------------------ */

/* Draws a scene with glasspipe; the picture's triangles stay unknown.
 * in   shift: pixels to move the viewport to the right by; 0 but where a fault is wanted */
GpResult peer_draw_glasspipe(const PeerScene *scene, float shift, PeerPicture *picture,
                             GpError *error);

/* Clip positions as glasspipe's vertex stage computes them, one a vertex. */
void peer_clip_positions(const PeerScene *scene, float (*clip)[4]);

/* --- opengl.c --------------------------------------------------------------------------------- */

typedef struct PeerGl PeerGl;

/* Opens llvmpipe through surfaceless EGL; nothing of it is needed to build.
 * errors GP_ERROR_UNSUPPORTED: no library, no such platform, or another driver; says which */
GpResult peer_gl_open(PeerGl **gl, GpError *error);
void peer_gl_close(PeerGl **gl);
const char *peer_gl_name(const PeerGl *gl);

typedef enum PeerVertices {
    PEER_OWN_VERTICES,  /* OpenGL multiplies by gl_mvp, y up: how anyone would draw the scene */
    PEER_SAME_VERTICES, /* glasspipe's clip positions, y down: what differs comes later */
} PeerVertices;

/* Draws a scene with OpenGL ES. Errors: GP_ERROR_MEMORY, GP_ERROR_UNSUPPORTED (an OpenGL error). */
GpResult peer_draw_gl(PeerGl *gl, const PeerScene *scene, PeerVertices vertices,
                      PeerPicture *picture, GpError *error);

/* --- truth.c ---------------------------------------------------------------------------------- */

/* Draws a scene exactly: coverage in integers, the rest in binary64, from the corners that
 * glasspipe's vertex stage and viewport give. Errors: GP_ERROR_MEMORY. */
GpResult peer_draw_truth(const PeerScene *scene, PeerTruth *truth);
void peer_truth_free(PeerTruth *truth);

/* Whether a triangle covers the centre of a pixel. */
bool peer_covers(const PeerScene *scene, const PeerTruth *truth, uint32_t triangle, int x, int y);

/* Where the corners of a triangle are for the purpose of interpolation. The model (R4) says
 * snapped; llvmpipe takes coverage from snapped corners but planes from those before snapping,
 * which OpenGL permits, and moves every value by its slope times up to half a sub-pixel step. */
typedef enum PeerPlanes { PEER_SNAPPED, PEER_UNSNAPPED } PeerPlanes;

/* Depth and colour (not rounded, 0..255) of a triangle's planes at the centre of a pixel, exact to
 * binary64; rgb may be NULL. A triangle without area gives depth 1 and black. */
double peer_evaluate(const PeerScene *scene, const PeerTruth *truth, uint32_t triangle,
                     PeerPlanes planes, int x, int y, double rgb[3]);

/* An edge and how far a sample is from it, all in 1/256 pixel: distance = |value| / sqrt(length2)
 * along the edge, both exact integers; beyond the ends of the edge, the distance to the end. */
typedef struct PeerEdge {
    uint32_t triangle;
    int64_t value, length2;
    double distance;
} PeerEdge;

/* The edge of one triangle that is nearest to the centre of a pixel. */
PeerEdge peer_nearest_edge_of(const PeerScene *scene, const PeerTruth *truth, uint32_t triangle,
                              int x, int y);

/* The nearest edge of all triangles. */
PeerEdge peer_nearest_edge(const PeerScene *scene, const PeerTruth *truth, int x, int y);

/* The unit to count llvmpipe's errors of depth in. It evaluates z = a + x dz/dx + y dz/dy in
 * binary32 from the corner of the screen, so a small steep triangle carries the roundings of terms
 * as large as 1024 times its slope: 2^-24 (1 + 1024 (|dz/dx| + |dz/dy|)). */
double peer_plane_rounding(const PeerScene *scene, const PeerTruth *truth, uint32_t triangle);

/* --- difference.c ----------------------------------------------------------------------------- */

/* What a pixel's difference comes from. */
typedef enum PeerCause {
    PEER_AGREES,   /* both empty, or the same triangle with colours within 1/255 */
    PEER_ONE_ONLY, /* drawn by one renderer only */
    /* another triangle there, the sample hardly off an edge of that or of the exact one: corners
     * were snapped differently */
    PEER_EDGE,
    /* another triangle there, which covers the sample and which llvmpipe's depths, with what they
     * may err, let win */
    PEER_TIE,
    PEER_SHADING, /* the same triangle, more than 1/255 apart, ours the exact colour rounded */
    PEER_OURS,    /* glasspipe's colour is not the exact one, rounded */
    PEER_UNKNOWN,
    PEER_CAUSES
} PeerCause;

typedef struct PeerDifference {
    int x, y;
    PeerCause cause;
    bool ours_covers, theirs_covers;
    int color; /* largest difference of a channel, in codes */
    uint32_t exact_triangle, their_triangle;
    double depth_gap; /* EDGE, TIE: their triangle's exact depth there minus the nearest one's */
    PeerEdge edge;    /* ONE_ONLY: the nearest edge; EDGE, TIE: the nearest of the two triangles */

    /* how far each is from what it should be, where both cover */
    double our_color, our_depth;     /* codes; depth: exact picture */
    double their_color, their_depth; /* codes; units of peer_plane_rounding: unsnapped planes */
} PeerDifference;

/* Largest distance of a rounded colour from the exact one, in codes: a half, and what shading in
 * binary32 adds. Measured: 0.5005 by glasspipe, 0.5063 by llvmpipe from its own planes. */
#define PEER_COLOR_REACH 0.51

/* Most roundings (units of peer_plane_rounding) in a depth of llvmpipe. Measured: 3.8. */
#define PEER_DEPTH_REACH 6.0

/* Farthest that a sample may lie from an edge which corners snapped differently decide, in 1/256
 * pixel: both ends moved by one step in x and in y. Measured: 0.64. */
#define PEER_EDGE_REACH 1.415

/* Explains one pixel. */
PeerDifference peer_explain(const PeerScene *scene, const PeerTruth *truth, const PeerPicture *ours,
                            const PeerPicture *theirs, int x, int y);

/* --- pictures.c ------------------------------------------------------------------------------- */

/* Writes two PNG files: "out/peer/NAME_sides.png", glasspipe left and llvmpipe right; and
 * "out/peer/NAME_difference.png", where a pixel that agrees is a dim grey of the picture, one that
 * is 1/255 apart blue, farther apart red, covered by one only white. errors GP_ERROR_IO,
 * GP_ERROR_MEMORY */
GpResult peer_write_pictures(const char *name, const PeerPicture *ours, const PeerPicture *theirs,
                             GpError *error);

#endif
