/* Volumes drawn by slices: planes through every layer of voxels across the view. A slice stands for
 * the slab of space behind it, up to the next one, in which a ray moves by at most one voxel along
 * any axis. */
#ifndef SHADERS_SLICES_H
#define SHADERS_SLICES_H

/* Places are (u, v, w): w goes across the slices, u and v are the two other axes. */
typedef struct SliceUniforms {
    float to_clip[4][4]; /* from (u, v, w) */
    float axes[3][3];    /* x, y, z of (u, v, w) */
    float eye[4];        /* 1: a place; 0: where rays come from, all parallel */
    float thickness;     /* of a slab, by w, with the sign of the rays */
} SliceUniforms;

#endif
