/* Which triangles of a mesh each column of a cylinder's image may show. */
#ifndef APPS_DEPTH_IMAGES_MAKING_COLUMNS_H
#define APPS_DEPTH_IMAGES_MAKING_COLUMNS_H

#include "apps/depth_images/depth_image.h"
#include "pipeline/io/mesh/mesh.h"

/* Columns that a triangle may be in: `count` of them, at least one, from `first` on, round the
 * seam. */
typedef struct ColumnRange {
    uint32_t first, count;
} ColumnRange;

/* in   mesh: positions and indices; columns: of the image
 * out  ranges: [triangle_count], owned by the caller until gp_free. A column's middle half plane
 *      meets no other triangle, even where corners are rounded to 1/256 of a column's width at the
 *      wall
 * errors GP_ERROR_MEMORY */
GpResult columns_of(const DepthCylinder *cylinder, const GpMesh *mesh, uint32_t columns,
                    ColumnRange **ranges);

#endif
