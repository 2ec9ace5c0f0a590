/* Facts about a mesh that decide what its inside is.
 *
 * A line that crosses a closed surface goes in as often as it comes out. Where a surface has an
 * boundary, or three triangles at one edge, a line beside that edge may cross an odd number of
 * triangles, and whatever fills insides by counting fills the rest of the line.
 */
#ifndef APPS_SCENE_MESH_REPORT_H
#define APPS_SCENE_MESH_REPORT_H

#include "pipeline/base/base.h"

/* Vertices at the same place are one here. An edge belongs to triangles that have three different
 * corners. */
typedef struct MeshReport {
    uint64_t edges;
    uint64_t boundary_edges;     /* of one triangle */
    uint64_t non_manifold_edges; /* of three or more */
    uint64_t odd_edges;          /* of an odd number: open ones among them */
    /* of two triangles that run along it the same way: one is turned over */
    uint64_t inconsistent_edges;
    /* of triangles more of which run along it one way than the other: without any, every line
     * enters as often as it leaves */
    uint64_t unbalanced_edges;
    uint64_t duplicates; /* triangles with the corners of an earlier one, in any order */
    uint64_t degenerate; /* triangles without area */
    bool is_closed;      /* each edge has two triangles, which run along it in opposite ways */
    bool is_inside_out;  /* closed, and its triangles are seen clockwise from outside */
    /* enclosed, in the file's unit; negative: inside out. Of a mesh that is not closed it depends
     * on where its first vertex lies */
    double volume;
} MeshReport;

/* in     positions: finite; indices: [3 * triangle_count], all < vertex_count
 * errors GP_ERROR_MEMORY */
GpResult mesh_report(const float *positions, uint32_t vertex_count, const uint32_t *indices,
                     uint32_t triangle_count, MeshReport *report);

/* What a mesh that is not closed lacks, as words: "223 boundary edges, 1 non-manifold edge". */
void mesh_report_faults(const MeshReport *report, char *text, size_t size);

#endif
