/* Which of two triangles hides the other. */
#ifndef APPS_FRAGMENTS_ORDER_FRONT_H
#define APPS_FRAGMENTS_ORDER_FRONT_H

#include "apps/base/camera.h"
#include "apps/fragments/drawing/view.h"

enum { FRONT_FIRST = 1, FRONT_SECOND = 2 };

/* From where a mesh is seen, and the planes of its triangles. Borrowed. */
typedef struct FrontView {
    const FragmentMesh *mesh;
    const double (*planes)[4]; /* by triangle: normal, unit length or 0, and distance */
    double doubt;              /* distances within it of 0 are looked at exactly */
    double eye[3];             /* the eye; of parallel rays their direction, unit length */
    bool is_parallel;
} FrontView;

FrontView front_view(const FragmentMesh *mesh, const double (*planes)[4], double doubt,
                     const Camera *camera);

/* in   a, b: triangles that some ray from the eye meets both of, as the screen has them
 * returns FRONT_FIRST where a is in front of b on some ray that meets both, FRONT_SECOND where b is
 *        in front of a, both where they cut each other. Of two in one plane the first of the mesh
 *        is in front
 * source Newell, Newell and Sancha, "A solution to the hidden surface problem", 1972: planes first,
 *        then the corners of what they have in common on the screen */
unsigned front_of_two(const FrontView *view, uint32_t a, uint32_t b);

#endif
