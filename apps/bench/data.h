/* What the builders of benchmark cases share: matrices, passes and generated data. */
#ifndef APPS_BENCH_DATA_H
#define APPS_BENCH_DATA_H

#include "apps/bench/cases.h"

/* Nearer wins and stays. */
extern const GpDepthState bench_depth_less;

extern const GpBlend bench_blend_add;

/* Model to clip, for pictures that are square. */
void bench_matrix(const Camera *camera, double world[4][4], float clip[4][4]);

/* A pass that clears the frame's picture, of this format, and its depth buffer, which it makes. */
GpPass *bench_pass(Frame *frame, const char *name, GpFormat format);

/* --- full-screen quads ------------------------------------------------------------------------ */

/* A corner comes with its position in clip space: x and y -1 or 1, z 1/2. */
typedef struct BenchCorner {
    float position[3];
    float value[4]; /* colour, or texture coordinates */
} BenchCorner;

typedef void BenchCornerFn(int quad, int corner, BenchCorner *out);

BenchCornerFn bench_corner_color;   /* random colours */
BenchCornerFn bench_corner_plain;   /* (0, 0) to (1, 1), v upwards */
BenchCornerFn bench_corner_shifted; /* the same, moved by a random number of texels of 1024 */
BenchCornerFn bench_corner_rotated; /* turned by 30 degrees, 1.7 times larger, and moved */

/* Quads one over the other, two triangles each; semantic: GP_COLOR or GP_TEXCOORD0. */
GpGeometry bench_quads(Frame *frame, int count, GpSemantic semantic, BenchCornerFn *fill);

/* --- data ------------------------------------------------------------------------------------- */

/* A well mixed 32-bit number. */
uint32_t bench_hash(uint32_t x);

/* Sine of an angle in radians, the same everywhere. */
double bench_sine(double radians);

/* Noise over squares, 1024x1024, A8R8G8B8, row 0 at v = 0; alpha is a checker of 32 texels. */
GpSurface *bench_noise(Frame *frame, bool mips);

/* 64x64, A8R8G8B8: waves in red and green, u and v in blue and alpha. */
GpSurface *bench_waves(Frame *frame);

/* --- meshes: positions and normals ------------------------------------------------------------ */

/* A file's mesh, moved and scaled so that its box is centred and its longest side is 2.
 * errors those of gp_data_find and gp_mesh_read; GP_ERROR_FORMAT where the counts are others */
GpResult bench_model(Frame *frame, const char *name, uint32_t vertices, uint32_t triangles,
                     GpGeometry *geometry, GpError *error);

/* Around the z axis, radii 0.85 and 0.42; vertices are shared. */
GpGeometry bench_torus(Frame *frame, int around, int across);

/* y = -1, 8 by 8. */
GpGeometry bench_plane(void);

/* Points, positions only, 3 floats each. */
GpGeometry bench_points(const float *positions, uint32_t count);

/* --- constants of the peers' workloads -------------------------------------------------------- */

/* clang-format off */
#define BENCH_LIGHT      { 0.557086f, 0.742781f, 0.371391f } /* (3, 4, 2), unit length */
#define BENCH_ALBEDO     { 0.80f, 0.55f, 0.40f }
#define BENCH_AMBIENT    0.15f
/* clang-format on */

extern const float bench_background[4], bench_black[4];

#endif
