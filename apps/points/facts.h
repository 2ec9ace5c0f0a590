/* What is known of a model of points: what its file held, what was made, and how it is sampled. */
#ifndef APPS_POINTS_FACTS_H
#define APPS_POINTS_FACTS_H

#include "apps/base/json.h"
#include "apps/base/text.h"
#include "apps/points/cloud.h"
#include "pipeline/io/mesh/mesh.h"

/* Least, mean and largest of many. */
typedef struct FactRange {
    double least, mean, most;
} FactRange;

typedef struct PointsFacts {
    uint32_t read;       /* points or vertices of the file */
    uint32_t triangles;  /* of the file; 0: it holds points */
    uint32_t left_out;   /* duplicates, or vertices that no triangle uses */
    uint32_t turned;     /* parts of a mesh that showed their inside (orient.h) */
    uint32_t split;      /* vertices on creases, for each side but the first (creases.h) */
    uint32_t subdivided; /* times */
    uint32_t sampled;    /* points spread over the triangles; 0: they are the vertices */
    uint32_t count;      /* surfels */
    bool had_normals, had_radii, had_colors;
    uint32_t normals_made, normals_undefined; /* the second: of neighbours on a line */
    uint32_t zero_normals;                    /* of those in the file: made as well */
    uint32_t radii_made;
    float low[3], high[3]; /* the box */
    FactRange spacing; /* distances to the nearest other point; of a mesh's vertices: along edges */
    FactRange radius;
    double area;         /* that they stand for together */
    uint32_t boundary;   /* points at a boundary or a hole */
    uint32_t components; /* sets of points that nothing connects: neighbours, or edges */
} PointsFacts;

/* Fills what the surfels themselves tell: count, had_, box, radius and area. */
void facts_of_surfels(const Surfels *surfels, PointsFacts *facts);

/* Fills what the triangles tell: spacing, boundary and components.
 * in     mesh: as mesh_keep_referenced leaves it. errors GP_ERROR_MEMORY */
GpResult facts_of_mesh(const GpMesh *mesh, PointsFacts *facts);

/* Fills what the neighbours tell. in: surfels: how many there are */
void facts_of_cloud(const CloudFacts *cloud, const GpPoints *points, uint32_t surfels,
                    PointsFacts *facts);

/* As lines for people, and as members for --json (NULL: not asked for). */
void facts_report(const PointsFacts *facts, Text *lines, json_t *members);

#endif
