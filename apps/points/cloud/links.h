/* Points that are linked to their neighbours, and normals turned the same way along the links
 * (planes.h says how). */
#ifndef APPS_POINTS_CLOUD_LINKS_H
#define APPS_POINTS_CLOUD_LINKS_H

#include "pipeline/base/base.h"

typedef struct LinkedPoint {
    float normal[3]; /* unit length */
    float area;      /* about what it stands for, in any unit */
    bool is_given;   /* the normal's side is known; it is not turned */
} LinkedPoint;

typedef struct Links {
    LinkedPoint *points; /* [count] */
    const float *places; /* [3 * count] */
    uint32_t *links;     /* [each * count] others, or the point itself: none */
    uint32_t count;      /* below 2^29 */
    uint32_t each;       /* at most 8 */
} Links;

/* Turns normals.
 * out    components: sets of points without a link between them
 * errors GP_ERROR_MEMORY */
GpResult links_orient(Links *links, uint32_t *components);

#endif
