/* Voxels of parametric surfaces and of points. */
#include "apps/techniques/voxel/inputs/parametric.h"

#include "apps/scene/teapot.h"
#include "shaders_c/voxel/inputs/parametric.h"
#include "shaders_c/voxel/inputs/points.h"

#include <math.h>
#include <string.h>

/* --- surfaces --------------------------------------------------------------------------------- */

#define TURN 6.28318530717958647692

/* The most that derivatives are long: by u and v, and by u u, u v and v v. */
typedef struct Bends {
    double slope[2], bend[3];
} Bends;

/* The surface is in the box from -reach to reach. */
typedef struct Surface {
    const char *name;
    const GpProgram *program;
    float radius, width;
    Bends bends;
    float reach[3];
} Surface;

#define SQUARE (TURN * TURN)

/* A point of the band is at most a = width/2 from the circle, about which it turns half as fast;
 * one of the figure of eight a = 5/4, and (1, 2) is the longest derivative of (sin v, sin 2v), (1,
 * 4) more than its second. Going round at a distance r + a from the axis and turning, by u u it is
 * at most a/4 + (r + a) + a, and by u v 3/2 of what it is by v; a turn is the unit. */
static const Surface surfaces[] = {
    { "sphere",
      &voxel_sphere_program,
      1,
      0,
      { { TURN, TURN / 2 }, { SQUARE, SQUARE / 2, SQUARE / 4 } },
      { 1, 1, 1 } },
    { "torus",
      &voxel_torus_program,
      0.7f,
      0.3f,
      { { TURN, TURN * 0.3 }, { SQUARE, SQUARE * 0.3, SQUARE * 0.3 } },
      { 1, 0.3f, 1 } },
    { "moebius",
      &voxel_moebius_program,
      0.75f,
      0.5f,
      { { TURN * 1.01, 0.5 }, { SQUARE * 1.3125, TURN * 0.75, 0 } },
      { 1, 0.25f, 1 } },
    { "klein",
      &voxel_klein_program,
      2,
      0,
      { { TURN * 3.31, TURN * 2.237 }, { SQUARE * 4.8125, SQUARE * 3.356, SQUARE * 4.124 } },
      { 3.25f, 1.25f, 3.25f } },
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

/* --- grids ------------------------------------------------------------------------------------ */

/* Longer than this, in voxels, no leg of a triangle is: the squares over their columns stay small,
 * and none reaches over more than two slabs. */
#define LONGEST 2.0

/* Cells along u and v. */
typedef struct Grid {
    double cells[2];
} Grid;

/* A third of the bound for each of u u, u v and v v would do; legs are as long as halves of the
 * rest allow, and both are cut where u v takes more than its half. */
static Grid choose_grid(const Bends *bends, double chord, const VoxelBox *box)
{
    const double room = 2 * chord / box->scale; /* of h h |Suu| and k k |Svv|: 8 / 4 */
    double leg[2];
    for (int i = 0; i < 2; i++) {
        const double bend = bends->bend[2 * i], longest = LONGEST / (bends->slope[i] * box->scale);
        leg[i] = fmin(fmin(longest, bend > 0 ? sqrt(room / bend) : longest), 1);
    }
    const double mixed = leg[0] * leg[1] * bends->bend[1] / room;
    Grid grid;
    for (int i = 0; i < 2; i++)
        grid.cells[i] = ceil(sqrt(fmax(mixed, 1)) / leg[i]);
    return grid;
}

static double triangles_of(const Grid *grid)
{
    return 2 * grid->cells[0] * grid->cells[1];
}

/* Triangles of a draw: as many as stay in a core's caches from their vertices to their pixels. */
enum { A_DRAW = 1 << 15 };

/* Appends rows of cells: of each its upper and its lower triangle, in the slab that holds its
 * lowest point and in the one above. in uv: of the first row's corners; cells: their first
 * corners */
static void draw_rows(Frame *frame, const GpProgram *program, VoxelParametricUniforms *uniforms,
                      float (*uv)[2], uint32_t columns, const uint32_t *cells, uint32_t count,
                      uint32_t rows)
{
    for (uint32_t half = 0; half < 2; half++)
        for (uint32_t step = 0; step < 2; step++) {
            const uint32_t corner[3] = { half ? columns + 1 : 0, 1, columns };
            GpGeometry triangles = { .primitive = GP_POINTS,
                                     .vertex_count = columns * rows - 1,
                                     .indices = cells,
                                     .index_count = count };
            for (int i = 0; i < 3; i++)
                triangles.streams[GP_TEXCOORD0 + i] =
                    (GpStream){ uv + corner[i], 0, 2, GP_FLOAT32 };
            triangles.streams[GP_POSITION] = triangles.streams[GP_TEXCOORD0];
            uniforms->columns.step = (float)step;
            frame_draw_copied(frame, program, uniforms, &triangles)->state.blend[0].op =
                GP_BLEND_LOGIC_OR;
        }
}

/* Appends the triangles of a surface. */
static void draw_grid(Frame *frame, const GpProgram *program, VoxelParametricUniforms *uniforms,
                      const Grid *grid)
{
    const uint32_t columns = (uint32_t)grid->cells[0] + 1, rows = (uint32_t)grid->cells[1];
    const uint32_t band = columns > A_DRAW ? 1 : A_DRAW / columns; /* rows of a draw */
    float(*uv)[2] = frame_alloc(frame, (size_t)columns * (rows + 1), sizeof *uv);
    uint32_t *cells = frame_alloc(frame, (size_t)band * columns, sizeof *cells), count = 0;
    if (!uv || !cells)
        return;
    for (uint32_t i = 0; i < columns * (rows + 1); i++) {
        uv[i][0] = (float)(i % columns / grid->cells[0]);
        uv[i][1] = (float)(i / columns / grid->cells[1]);
    }
    for (uint32_t i = 0; i < band * columns; i++)
        if (i % columns + 1 < columns)
            cells[count++] = i;
    for (uint32_t row = 0; row < rows; row += band) {
        const uint32_t these = rows - row < band ? rows - row : band;
        draw_rows(frame, program, uniforms, uv + (size_t)row * columns, columns, cells,
                  these * (columns - 1), these);
    }
}

static VoxelColumnsUniforms place_surface(const VoxelBox *box, const FlatTexture *flat)
{
    return (VoxelColumnsUniforms){ .flat = flat_texture_layout(flat), .motion = voxel_still(box) };
}

/* Longest of the sums a - b - c + d, or a - 2 b + c where b is c, of control points that lie so. */
static double most_bent(const float control[4][4][3], const int (*steps)[2], double times)
{
    double most = 0;
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 4; column++) {
            if (row + steps[2][0] > 3 || column + steps[2][1] > 3)
                continue;
            double square = 0;
            for (int k = 0; k < 3; k++) {
                const double d = (double)control[row][column][k] -
                                 (double)control[row + steps[0][0]][column + steps[0][1]][k] -
                                 (double)control[row + steps[1][0]][column + steps[1][1]][k] +
                                 (double)control[row + steps[2][0]][column + steps[2][1]][k];
                square += d * d;
            }
            most = fmax(most, times * sqrt(square));
        }
    return most;
}

/* A patch's derivatives are means of steps between its control points, three times them by u and by
 * v, of steps of steps six times them by u u and by v v, and nine by u v. */
static Bends bound_bends(const float control[4][4][3])
{
    static const int by_uu[3][2] = { { 0, 1 }, { 0, 1 }, { 0, 2 } };
    static const int by_vv[3][2] = { { 1, 0 }, { 1, 0 }, { 2, 0 } };
    static const int by_uv[3][2] = { { 0, 1 }, { 1, 0 }, { 1, 1 } };
    Bends bends = { .bend = { most_bent(control, by_uu, 6), most_bent(control, by_uv, 9),
                              most_bent(control, by_vv, 6) } };
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
                bends.slope[way] = fmax(bends.slope[way], 3 * sqrt(square));
            }
        }
    return bends;
}

static GpResult check_triangles(double triangles, double chord, GpError *error)
{
    if (triangles <= VOXEL_PARAMETRIC_MOST)
        return GP_OK;
    return gp_fail(error, GP_ERROR_INVALID,
                   "%.3g triangles, to be within %g voxels of the surface: at most %d", triangles,
                   chord, VOXEL_PARAMETRIC_MOST);
}

static GpResult draw_teapot(double chord, const VoxelBox *box, Frame *frame,
                            const FlatTexture *flat, GpError *error)
{
    float control[TEAPOT_PATCHES][4][4][3];
    Grid grids[TEAPOT_PATCHES];
    double triangles = 0;
    teapot_control(control);
    for (int i = 0; i < TEAPOT_PATCHES; i++) {
        const Bends bends = bound_bends(control[i]);
        grids[i] = choose_grid(&bends, chord, box);
        triangles += triangles_of(&grids[i]);
    }
    GpResult result = check_triangles(triangles, chord, error);
    if (result)
        return result;
    flat_texture_pass(frame, "patches", flat);
    for (int i = 0; i < TEAPOT_PATCHES; i++) {
        VoxelParametricUniforms uniforms = { .columns = place_surface(box, flat) };
        memcpy(uniforms.control, control[i], sizeof control[i]);
        draw_grid(frame, &voxel_bezier_program, &uniforms, &grids[i]);
    }
    return frame_result(frame, error);
}

GpResult voxel_parametric(const char *name, double chord, const VoxelBox *box, Frame *frame,
                          const FlatTexture *flat, GpError *error)
{
    GP_ASSERT(flat->bits == 1 && chord > 0);
    if (strcmp(name, teapot) == 0)
        return draw_teapot(chord, box, frame, flat, error);
    const Surface *surface = find_surface(name);
    if (!surface)
        return refuse_name(name, error);
    const Grid grid = choose_grid(&surface->bends, chord, box);
    GpResult result = check_triangles(triangles_of(&grid), chord, error);
    if (result)
        return result;
    VoxelParametricUniforms uniforms = { .columns = place_surface(box, flat),
                                         .radius = surface->radius,
                                         .width = surface->width };
    flat_texture_pass(frame, surface->name, flat);
    draw_grid(frame, surface->program, &uniforms, &grid);
    return frame_result(frame, error);
}

/* --- points ----------------------------------------------------------------------------------- */

GpResult voxel_points(const float *positions, uint32_t count, const VoxelBox *box, Frame *frame,
                      const FlatTexture *flat, GpError *error)
{
    GP_ASSERT(flat->bits == 1);
    if (count == 0)
        return gp_fail(error, GP_ERROR_INVALID, "no points");
    const VoxelPointsUniforms uniforms = {
        .flat = flat_texture_layout(flat),
        .scale = (float)box->scale,
        .offset = { (float)box->offset[0], (float)box->offset[1], (float)box->offset[2] },
    };
    const GpGeometry points = { .primitive = GP_POINTS,
                                .vertex_count = count,
                                .streams = { [GP_POSITION] = { positions, 0, 3, GP_FLOAT32 } } };
    flat_texture_pass(frame, "points", flat);
    frame_draw_copied(frame, &voxel_points_program, &uniforms, &points)->state.blend[0].op =
        GP_BLEND_LOGIC_OR;
    return frame_result(frame, error);
}
