/* Grids of points as few triangles: cells are merged where what they stand for is flat.
 *
 * Squares of 32 x 32 cells are halved along their diagonals, and halved again, until each triangle
 * is as near to the points that it stands for as was asked. A triangle is halved together with its
 * neighbour across the long side, so that no crack opens, between squares neither.
 * source Evans, Kirkpatrick, Townsend, "Right-triangulated irregular networks", Algorithmica 30,
 *      2001
 */
#ifndef APPS_DEPTH_IMAGES_DRAWING_MERGE_H
#define APPS_DEPTH_IMAGES_DRAWING_MERGE_H

#include "pipeline/base/base.h"

enum { MERGE_SIDE = 32 }; /* cells of a patch */
enum { MERGE_ASIDE = 4 }; /* times as far as out of the surface points may be aside within it */

/* Points in rows. Seen from outside, rows go down and columns to the right. */
typedef struct MergeGrid {
    uint32_t columns, rows;     /* of points */
    bool wraps;                 /* the last column is the first one again */
    const float (*position)[3]; /* [rows][columns]; x infinite: there is none */
    const float (*normal)[3];   /* [rows][columns], unit length; NULL: unknown */
    /* [rows][columns]: MERGE_CUT_RIGHT, MERGE_CUT_DOWN: no triangle has this side; NULL: none is
     * cut */
    const uint8_t *cut;
    bool whole_cells; /* only cells of which all points and sides are there */
    /* [rows + 1][columns + 1]: how many points above and to the left of a place are needed;
     * triangles are left out whose box has none. NULL: all are */
    const uint32_t *needed;
} MergeGrid;

enum { MERGE_CUT_RIGHT = 1, MERGE_CUT_DOWN = 2 };

/* Triangles of one square of the grid: neighbours in memory, and all that is needed to leave them
 * out. */
typedef struct MergedPatch {
    uint32_t first_vertex, vertex_count, first_index, index_count;
    double center[3], radius; /* of a ball about them */
    double axis[3];           /* their normals are within an angle about it, whose sine is */
    double sine;              /* this; 1: anywhere */
} MergedPatch;

/* Owned by whoever made it, until merged_free; a zeroed one is empty. */
typedef struct MergedMesh {
    uint32_t vertex_count, index_count, patch_count;
    uint32_t *points;     /* [vertex_count]: which point of the grid, row * columns + column */
    uint32_t *indices;    /* [index_count], counter-clockwise from outside */
    MergedPatch *patches; /* only those that have triangles; square by square, in rows */
} MergedMesh;

/* Merges cells so far that no point of the grid is farther than `tolerance` from where the triangle
 * that stands for it has it, by its place along the grid: with normals, so far along its own, and
 * MERGE_ASIDE times as far aside, where only its colour is seen to move. Next to points that are
 * missing, and at cuts, nothing is merged. A half of a cell is there where its three points are and
 * no side is cut, unless only whole cells are asked for.
 * errors GP_ERROR_MEMORY */
GpResult merge_grid(const MergeGrid *grid, double tolerance, MergedMesh *mesh, GpError *error);
void merged_free(MergedMesh *mesh);

/* Finds the ball and the cone of a patch whose other members are there.
 * in   points: which position each vertex has; NULL: its own */
void merged_patch_bound(const float (*position)[3], const uint32_t *points, const uint32_t *indices,
                        MergedPatch *patch);

/* Whether some triangle of a patch may show its outside to an eye; parallel: eye is the direction
 * towards it. */
bool merged_may_face(const MergedPatch *patch, const double eye[3], bool parallel);

#endif
