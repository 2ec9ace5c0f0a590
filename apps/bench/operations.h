/* Arithmetic that a frame asks for, counted: what its shaders do, and what the fixed units do for
 * them by their definitions. Of these a processor cannot do less. */
#ifndef APPS_BENCH_OPERATIONS_H
#define APPS_BENCH_OPERATIONS_H

#include <glasspipe/glasspipe.h>

/* Additions, multiplications, comparisons and the like of one component; a division or a root is
 * one. */
typedef struct DrawOperations {
    double vertex; /* of the vertex shader, a vertex */
    /* of the pixel shader and of what comes before and after it, a fragment; 0 where no pixel
     * shader runs */
    double fragment;
} DrawOperations;

/* Counted in a run of the shaders step by step: of made-up inputs, with the draw's own uniforms. A
 * loop that ends when all lanes are done is counted as these have it. All 0 where shaders cannot be
 * counted. */
DrawOperations draw_operations(const GpPass *pass, const GpDraw *draw);

#endif
