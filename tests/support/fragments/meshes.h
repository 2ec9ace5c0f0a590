/* Small meshes whose fragments are put in order, and views of them. */
#ifndef TESTS_FRAGMENTS_MESHES_H
#define TESTS_FRAGMENTS_MESHES_H

#include "apps/fragments/drawing/view.h"
#include "apps/fragments/pieces/pieces.h"
#include "tests/support/random.h"

typedef struct FragmentCase {
    const char *name;
    bool is_clean; /* closed, and cuts itself nowhere */
    /* owns: */
    float (*positions)[3];
    uint32_t *indices;
    uint32_t vertex_count, triangle_count;
} FragmentCase;

enum { FRAGMENT_CASES = 9 };

/* One after the other; fails the running test where memory is short: knot, teapot (open, its parts
 * cut each other), rings (two that hang in each other), nested (balls in each other), dent (a ball
 * with a hollow side), beams (three in a circle, so that each is in front of the next), fan (of
 * sheets that stand about an axis), crossed (two sheets that cut each other), twins (a sheet twice,
 * once turned over). */
FragmentCase fragment_case(int number);
void fragment_case_free(FragmentCase *made);

FragmentMesh fragment_case_mesh(const FragmentCase *made);

/* A camera that looks at about the middle from any side, perspective or parallel, from near or far;
 * where that is asked for from inside too, so that the near plane cuts the mesh. */
Camera fragment_case_camera(const FragmentCase *made, bool inside_too, Random *random);

#endif
