/* Voxels of parametric surfaces and of points. */
#include "apps/techniques/voxel/inputs/parametric.h"

#include "apps/scene/teapot.h"
#include "shaders_c/voxel/inputs/points.h"

#include <math.h>
#include <string.h>

/* --- surfaces --------------------------------------------------------------------------------- */

#define TURN 6.28318530717958647692

/* Lengths of the derivatives by u and v are at most those of slope; the surface is in the box from
 * -reach to reach. */
typedef struct Surface {
    const char *name;
    const GpProgram *program;
    float radius, width;
    double slope[2];
    float reach[3];
} Surface;

/* A point of the band is at most radius + width/2 from the axis, and width/2 from the circle, about
 * which it turns half as fast; of the figure of eight at most 5/4, and (1, 2) is the longest
 * derivative of (sin v, sin 2v). */
static const Surface surfaces[] = {
    { "sphere", &voxel_sphere_program, 1, 0, { TURN, TURN / 2 }, { 1, 1, 1 } },
    { "torus", &voxel_torus_program, 0.7f, 0.3f, { TURN, TURN * 0.3 }, { 1, 0.3f, 1 } },
    { "moebius", &voxel_moebius_program, 0.75f, 0.5f, { TURN * 1.01, 0.5 }, { 1, 0.25f, 1 } },
    { "klein", &voxel_klein_program, 2, 0, { TURN * 3.31, TURN * 2.237 }, { 3.25f, 1.25f, 3.25f } },
};

static const char teapot[] = "teapot";

static const Surface *find_surface(const char *name)
{
    for (size_t i = 0; i < GP_COUNT(surfaces); i++)
        if (strcmp(name, surfaces[i].name) == 0)
            return &surfaces[i];
    return NULL;
}

static GpResult refuse_name(const char *name, GpError *error)
{
    return gp_fail(error, GP_ERROR_INVALID,
                   "'%.40s' is no parametric surface: expected sphere, torus, moebius, klein or "
                   "teapot",
                   name);
}

GpResult voxel_parametric_box(const char *name, uint32_t size, VoxelBox *box, GpError *error)
{
    if (strcmp(name, teapot) == 0) {
        float control[TEAPOT_PATCHES][4][4][3];
        teapot_control(control);
        *box = voxel_box(control[0][0][0], NULL, TEAPOT_PATCHES * 4 * 4, size);
        return GP_OK;
    }
    const Surface *surface = find_surface(name);
    if (!surface)
        return refuse_name(name, error);
    const float *r = surface->reach;
    const float corners[2][3] = { { -r[0], -r[1], -r[2] }, { r[0], r[1], r[2] } };
    *box = voxel_box(corners[0], NULL, 2, size);
    return GP_OK;
}

/* --- grids of points -------------------------------------------------------------------------- */

static double points_along(double slope, double step, const VoxelBox *box)
{
    return ceil(slope * box->scale / step) + 1;
}

static double points_of(const double slope[2], double step, const VoxelBox *box)
{
    return points_along(slope[0], step, box) * points_along(slope[1], step, box);
}

/* Appends the points of a surface, at most `step` voxels apart. */
static void draw_grid(Frame *frame, const GpProgram *program,
                      const VoxelParametricUniforms *uniforms, const double slope[2], double step,
                      const VoxelBox *box)
{
    const uint32_t columns = (uint32_t)points_along(slope[0], step, box);
    const uint32_t rows = (uint32_t)points_along(slope[1], step, box);
    float(*uv)[2] = frame_alloc(frame, (size_t)columns * rows, sizeof *uv);
    for (uint32_t row = 0; uv && row < rows; row++)
        for (uint32_t column = 0; column < columns; column++) {
            float *point = uv[(size_t)row * columns + column];
            point[0] = (float)(column / (columns - 1.0));
            point[1] = (float)(row / (rows - 1.0));
        }
    const GpGeometry grid = { .primitive = GP_POINTS,
                              .vertex_count = columns * rows,
                              .streams = { [GP_TEXCOORD0] = { uv, 0, 2, GP_FLOAT32 } } };
    frame_draw_copied(frame, program, uniforms, &grid)->state.blend[0].op = GP_BLEND_LOGIC_OR;
}

static VoxelPointsUniforms place_points(const VoxelBox *box, const FlatTexture *flat)
{
    return (VoxelPointsUniforms){
        .flat = flat_texture_layout(flat),
        .scale = (float)box->scale,
        .offset = { (float)box->offset[0], (float)box->offset[1], (float)box->offset[2] },
    };
}

/* A patch's derivative is a mean of three times the steps between its control points. */
static void bound_slopes(const float control[4][4][3], double slope[2])
{
    slope[0] = slope[1] = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 3; j++) {
            const float *pair[2][2] = { { control[i][j], control[i][j + 1] },
                                        { control[j][i], control[j + 1][i] } };
            for (int way = 0; way < 2; way++) {
                double square = 0;
                for (int k = 0; k < 3; k++) {
                    const double d = (double)pair[way][1][k] - (double)pair[way][0][k];
                    square += d * d;
                }
                const double length = 3 * sqrt(square);
                slope[way] = length > slope[way] ? length : slope[way];
            }
        }
}

static GpResult check_points(double points, double step, GpError *error)
{
    if (points <= VOXEL_PARAMETRIC_MAX_POINTS)
        return GP_OK;
    return gp_fail(error, GP_ERROR_INVALID, "%.3g points of %g voxels apart: at most %d", points,
                   step, VOXEL_PARAMETRIC_MAX_POINTS);
}

static GpResult draw_teapot(double step, const VoxelBox *box, Frame *frame, const FlatTexture *flat,
                            GpError *error)
{
    float control[TEAPOT_PATCHES][4][4][3];
    double slope[TEAPOT_PATCHES][2], points = 0;
    teapot_control(control);
    for (int i = 0; i < TEAPOT_PATCHES; i++) {
        bound_slopes(control[i], slope[i]);
        points += points_of(slope[i], step, box);
    }
    GpResult result = check_points(points, step, error);
    if (result)
        return result;
    flat_texture_pass(frame, "patches", flat);
    for (int i = 0; i < TEAPOT_PATCHES; i++) {
        VoxelParametricUniforms uniforms = { .place = place_points(box, flat) };
        memcpy(uniforms.control, control[i], sizeof control[i]);
        draw_grid(frame, &voxel_bezier_program, &uniforms, slope[i], step, box);
    }
    return frame_result(frame, error);
}

GpResult voxel_parametric(const char *name, double step, const VoxelBox *box, Frame *frame,
                          const FlatTexture *flat, GpError *error)
{
    GP_ASSERT(flat->bits == 1 && step > 0);
    if (strcmp(name, teapot) == 0)
        return draw_teapot(step, box, frame, flat, error);
    const Surface *surface = find_surface(name);
    if (!surface)
        return refuse_name(name, error);
    GpResult result = check_points(points_of(surface->slope, step, box), step, error);
    if (result)
        return result;
    const VoxelParametricUniforms uniforms = { .place = place_points(box, flat),
                                               .radius = surface->radius,
                                               .width = surface->width };
    flat_texture_pass(frame, surface->name, flat);
    draw_grid(frame, surface->program, &uniforms, surface->slope, step, box);
    return frame_result(frame, error);
}

/* --- points ----------------------------------------------------------------------------------- */

GpResult voxel_points(const float *positions, uint32_t count, const VoxelBox *box, Frame *frame,
                      const FlatTexture *flat, GpError *error)
{
    GP_ASSERT(flat->bits == 1);
    if (count == 0)
        return gp_fail(error, GP_ERROR_INVALID, "no points");
    const VoxelPointsUniforms uniforms = place_points(box, flat);
    const GpGeometry points = { .primitive = GP_POINTS,
                                .vertex_count = count,
                                .streams = { [GP_POSITION] = { positions, 0, 3, GP_FLOAT32 } } };
    flat_texture_pass(frame, "points", flat);
    frame_draw_copied(frame, &voxel_points_program, &uniforms, &points)->state.blend[0].op =
        GP_BLEND_LOGIC_OR;
    return frame_result(frame, error);
}
