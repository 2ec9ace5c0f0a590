/* Surfaces by formulas: planar depth images of them, and what other eyes see of them, in double. */
#ifndef TESTS_DEPTH_FORMULA_H
#define TESTS_DEPTH_FORMULA_H

#include "apps/depth_images/drawing/view.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

#include <math.h>

enum { FORMULA_IMAGE = 64, FORMULA_SIDE = 96 };

typedef enum Formula {
    FORMULA_FLAT,  /* faces the source: z = 0 */
    FORMULA_PLANE, /* leans */
    FORMULA_STEP,  /* z = 0.5 where x is below 0, else -0.5; its wall is not seen by the source */
    FORMULA_BALL,  /* of radius 1 about 0 */
} Formula;

/* Where a ray meets a formula first, in multiples of its direction; INFINITY: nowhere. */
double formula_meet(Formula formula, const double from[3], const double direction[3]);

/* What the source sees: from z = 5, some 3.6 wide at z = 0. Colours are 0.5 + 0.5 sin(2 p), and
 * there are normals. owns: the caller, until formula_free */
DepthImage formula_image(Formula formula, bool is_parallel);
void formula_free(DepthImage *image);

/* A camera that looks at 0 from a direction; parallel: its picture is as high as it is far / 2. */
Camera formula_camera(double x, double y, double z, bool is_parallel);

/* How a picture is off from what a camera sees, over what is nearer to the z axis than 1.4 along x
 * and y; next to edges of what is covered it may be either way. */
typedef struct FormulaOff {
    uint32_t covered, missing, extra;
    double color, depth;           /* largest; depth as a share of itself */
    double mean_color, mean_depth; /* over what both cover */
} FormulaOff;

FormulaOff formula_compare(Formula formula, const Camera *camera, const Frame *frame);

/* A frame with an empty picture and a depth buffer, for a method to draw over. float_color: else 8
 * bits */
WarpTarget formula_target(bool float_color, Frame *frame);

/* Fails the running test where a picture has a NaN, or a depth outside 0 to 1. returns covered
 * pixels */
uint32_t formula_check_numbers(const Frame *frame);

#endif
