/* Cylindrical depth images as strips of cells from column to column, so that they can be drawn in
 * the order that lets the nearer win without a depth test.
 *
 * Along a ray from an eye outside, azimuths go away from the eye's and heights from the eye's
 * height. So cells come in the order of their azimuths, from the far side to the eye's on both
 * sides, and of their heights, from the ends to the eye's.
 * source McMillan, "A list-priority rendering algorithm for redisplaying projected surfaces", 1995;
 *        paper 001, section 3.2
 */
#ifndef APPS_DEPTH_IMAGES_DRAWING_CYLINDER_STRIPS_H
#define APPS_DEPTH_IMAGES_DRAWING_CYLINDER_STRIPS_H

#include "apps/depth_images/depth_image.h"
#include "apps/depth_images/drawing/merge.h"
#include "apps/frame/frame.h"

typedef struct CylinderVertex {
    float turn[3];  /* cosine and sine of the azimuth, height above the centre */
    float texel[3]; /* place on the textures, depth */
} CylinderVertex;

/* The image with every `step`th column and row; the first column is behind the last again. Only
 * cells whose four pixels show something. A zeroed one is empty. */
typedef struct CylinderStrips {
    uint32_t step, strips, rows; /* rows of points */
    CylinderVertex *vertices;    /* [strips + 1][rows] */
    uint32_t *first; /* [strips][rows]: the index at which a cell begins, and behind the last */
    uint32_t *falling, *rising; /* cells of a strip from the top, and from the foot */
    uint32_t parts;             /* of a strip, one above the other */
    MergedPatch *bounds;        /* [strips][parts] */
} CylinderStrips;

/* errors GP_ERROR_MEMORY; owns: the caller, until cylinder_strips_close */
GpResult cylinder_strips_open(const DepthImage *image, uint32_t step, CylinderStrips *strips,
                              GpError *error);
void cylinder_strips_close(CylinderStrips *strips);

/* Appends draws like `draw` to the frame's last pass, in order. Parts of strips all of whose
 * triangles turn away from the eye are left out, which shows nothing else where insides are not
 * drawn.
 * in   eye: world; NULL: none are left out; place: where the image has it, as depth_cylinder_place
 * returns triangles that are drawn */
uint32_t cylinder_strips_draw(const CylinderStrips *strips, const GpDraw *draw, const double eye[3],
                              const double place[2], Frame *frame);

#endif
