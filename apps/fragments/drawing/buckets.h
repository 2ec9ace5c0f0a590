/* Bucket peeling: fragments go into buckets by their depths. Two in one bucket collide, and one is
 * lost.
 * source Liu, Huang, Liu and Wu, "Efficient depth peeling via bucket sort", High Performance
 *      Graphics 2009 */
#ifndef APPS_FRAGMENTS_DRAWING_BUCKETS_H
#define APPS_FRAGMENTS_DRAWING_BUCKETS_H

#include "apps/fragments/drawing/view.h"

typedef enum BucketKind {
    BUCKETS_ONE_PASS, /* BUCKETS of equal depth, of one fragment each */
    /* half as many, of the nearest and the farthest: the first pass finds their depths, the second
     * their colours */
    BUCKETS_TWO_PASSES,
    /* the first pass finds where there are fragments, in BUCKET_BITS parts; each such part is a
     * bucket, as far as there are any */
    BUCKETS_ADAPTIVE,
} BucketKind;

typedef struct BucketSetting {
    BucketKind kind;
} BucketSetting;

/* As view.h has it, without glass. Colours have 8 bits a channel.
 * errors GP_ERROR_INVALID: triangles of several alphas; GP_ERROR_MEMORY */
GpResult buckets_add(const FragmentMesh *mesh, const BucketSetting *setting,
                     const FragmentView *view, GpSurface *color, GpSurface *depth, Frame *frame,
                     GpError *error);

#endif
