/* Merged grids: near to their points everywhere, without cracks, and left out only where nothing
 * shows. */
#include "apps/depth_images/drawing/merge.h"
#include "apps/base/camera.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <math.h>
#include <stdio.h>

enum { MOST_POINTS = 130 * 130 };

static float positions[MOST_POINTS][3];
static uint8_t cuts[MOST_POINTS];
static uint32_t used[MOST_POINTS];

typedef struct Grid {
    const char *what;
    uint32_t columns, rows;
    bool wraps;
    int holes; /* one point in so many; 0: none */
    double tolerance, waves;
} Grid;

static const Grid grids[] = {
    { "waves", 65, 33, false, 0, 0.01, 0.2 },
    { "uneven sides", 50, 71, false, 0, 0.02, 0.2 },
    { "with holes", 97, 64, false, 90, 0.05, 0.2 },
    { "around", 129, 64, true, 0, 0.03, 0.2 },
    { "around, uneven", 101, 40, true, 0, 0.03, 0.2 },
    { "around, with holes", 65, 65, true, 60, 0.1, 0.2 },
    { "every cell", 33, 33, false, 0, 0, 0.2 },
    { "two points", 2, 2, false, 0, 1, 0.2 },
};

/* Waves; around a cylinder where the grid wraps, whose ends have the same bits. */
static MergeGrid make_grid(const Grid *grid, Random *random)
{
    memset(cuts, 0, sizeof cuts);
    for (uint32_t y = 0; y < grid->rows; y++)
        for (uint32_t x = 0; x < grid->columns; x++) {
            float *position = positions[y * grid->columns + x];
            const double u = (double)x / (grid->columns - 1), v = (double)y / grid->rows;
            double wave, sine, cosine;
            angle_sincos(720 * v + 360 * u, &wave, &cosine);
            angle_sincos(360 * u, &sine, &cosine);
            const double out = 1 + grid->waves * wave * (y % 17 == 3 ? 1.3 : 1);
            position[0] = (float)(grid->wraps ? out * cosine : 3 * u);
            position[1] = (float)(-3 * v);
            position[2] = (float)(grid->wraps ? -out * sine : out);
            if (grid->wraps && x == grid->columns - 1)
                memcpy(position, positions[y * grid->columns], sizeof positions[0]);
            else if (grid->holes && random_int(random, 0, grid->holes) == 0)
                position[0] = INFINITY;
            if (grid->holes && random_int(random, 0, grid->holes) == 0 && x + 1 < grid->columns)
                cuts[y * grid->columns + x] = MERGE_CUT_RIGHT;
        }
    return (MergeGrid){ .columns = grid->columns,
                        .rows = grid->rows,
                        .wraps = grid->wraps,
                        .position = (const float(*)[3])positions,
                        .cut = cuts };
}

static MergedMesh merge(const MergeGrid *grid, double tolerance)
{
    MergedMesh mesh;
    assert_int_equal(merge_grid(grid, tolerance, &mesh, NULL), GP_OK);
    return mesh;
}

static void place_of(const MergeGrid *grid, const MergedMesh *mesh, uint32_t index, long place[2])
{
    const uint32_t point = mesh->points[mesh->indices[index]];
    place[0] = point % grid->columns;
    place[1] = point / grid->columns;
}

/* The largest distance of points of the grid from the triangle that they lie in. */
static double farthest(const MergeGrid *grid, const MergedMesh *mesh)
{
    double most = 0;
    for (uint32_t i = 0; i < mesh->index_count; i += 3) {
        long a[2], b[2], c[2];
        place_of(grid, mesh, i, a);
        place_of(grid, mesh, i + 1, b);
        place_of(grid, mesh, i + 2, c);
        const double area = (double)((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        for (long y = 0; y < grid->rows && area != 0; y++)
            for (long x = 0; x < grid->columns; x++) {
                const double s = ((double)((b[0] - x) * (c[1] - y) - (b[1] - y) * (c[0] - x))) /
                                 area,
                             t = ((double)((c[0] - x) * (a[1] - y) - (c[1] - y) * (a[0] - x))) /
                                 area,
                             r = 1 - s - t;
                double square = 0;
                if (s < 0 || t < 0 || r < 0)
                    continue;
                for (int k = 0; k < 3; k++) {
                    const double at = s * (double)grid->position[a[1] * grid->columns + a[0]][k] +
                                      t * (double)grid->position[b[1] * grid->columns + b[0]][k] +
                                      r * (double)grid->position[c[1] * grid->columns + c[0]][k];
                    const double off = at - (double)grid->position[y * grid->columns + x][k];
                    square += off * off;
                }
                assert_true(isfinite(square)); /* no triangle stands for what is not there */
                most = fmax(most, sqrt(square));
            }
    }
    return most;
}

/* The same point at both ends of a grid that wraps. */
static uint32_t joined(const MergeGrid *grid, uint32_t point)
{
    return grid->wraps && point % grid->columns == grid->columns - 1 ? point - grid->columns + 1
                                                                     : point;
}

/* Corners of triangles that lie within a side of another: there a crack may open. */
static uint32_t cracks(const MergeGrid *grid, const MergedMesh *mesh)
{
    uint32_t count = 0;
    memset(used, 0, sizeof used);
    for (uint32_t i = 0; i < mesh->index_count; i++)
        used[joined(grid, mesh->points[mesh->indices[i]])] = 1;
    for (uint32_t i = 0; i < mesh->index_count; i++) {
        long a[2], b[2];
        place_of(grid, mesh, i, a);
        place_of(grid, mesh, i % 3 == 2 ? i - 2 : i + 1, b);
        const long dx = labs(b[0] - a[0]), dy = labs(b[1] - a[1]), n = dx > dy ? dx : dy;
        for (long k = 1; k < n; k++)
            if (k * (b[0] - a[0]) % n == 0 && k * (b[1] - a[1]) % n == 0) {
                const long x = a[0] + k * (b[0] - a[0]) / n, y = a[1] + k * (b[1] - a[1]) / n;
                count += used[joined(grid, (uint32_t)(y * grid->columns + x))];
            }
    }
    return count;
}

static double area_of(const MergeGrid *grid, const MergedMesh *mesh)
{
    double area = 0;
    for (uint32_t i = 0; i < mesh->index_count; i += 3) {
        long a[2], b[2], c[2];
        place_of(grid, mesh, i, a);
        place_of(grid, mesh, i + 1, b);
        place_of(grid, mesh, i + 2, c);
        const long twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        assert_true(twice <= 0); /* rows go down: counter-clockwise from outside */
        area -= (double)twice / 2;
    }
    return area;
}

/* Halves of cells that have their three points and no cut side: what must be there. */
static double area_there(const MergeGrid *grid)
{
    double area = 0;
    for (uint32_t y = 0; y + 1 < grid->rows; y++)
        for (uint32_t x = 0; x + 1 < grid->columns; x++) {
            const uint32_t at = y * grid->columns + x, n = grid->columns;
            const bool falls = ((x ^ y) & 1) == 0;
            const uint32_t corner[2][3] = { { at, falls ? at + n + 1 : at + 1, at + n },
                                            { falls ? at : at + n, at + n + 1, at + 1 } };
            /* halves with the right angle below on the left and above on the right, or the
             * others */
            const uint32_t other[2][3] = { { at, at + 1, at + n }, { at + n + 1, at + n, at + 1 } };
            for (int i = 0; i < 2; i++) {
                const uint32_t *c = falls ? corner[i] : other[i];
                const bool upper = falls ? i == 1 : i == 0;
                const bool is_cut = grid->cut[upper ? at : at + n] & MERGE_CUT_RIGHT;
                if (!is_cut && isfinite(grid->position[c[0]][0]) &&
                    isfinite(grid->position[c[1]][0]) && isfinite(grid->position[c[2]][0]))
                    area += 0.5;
            }
        }
    return area;
}

static void points_are_near_their_triangles(void **state)
{
    (void)state;
    Random random = { 1 };
    for (size_t i = 0; i < GP_COUNT(grids); i++) {
        const MergeGrid grid = make_grid(&grids[i], &random);
        MergedMesh mesh = merge(&grid, grids[i].tolerance);
        const double off = farthest(&grid, &mesh);
        print_message("# %s: %u triangles for %u, off by %.4f\n", grids[i].what,
                      mesh.index_count / 3, 2 * (grid.columns - 1) * (grid.rows - 1), off);
        assert_true(off <= grids[i].tolerance + 1e-6);
        assert_true(mesh.index_count > 0);
        merged_free(&mesh);
    }
}

static void no_crack_opens_and_nothing_is_lost(void **state)
{
    (void)state;
    Random random = { 2 };
    for (size_t i = 0; i < GP_COUNT(grids); i++)
        for (double more = 1; more < 100; more *= 4) {
            const MergeGrid grid = make_grid(&grids[i], &random);
            MergedMesh mesh = merge(&grid, grids[i].tolerance * more);
            assert_int_equal(cracks(&grid, &mesh), 0);
            assert_true(area_of(&grid, &mesh) == area_there(&grid));
            merged_free(&mesh);
        }
}

static void what_is_flat_is_merged(void **state)
{
    (void)state;
    for (uint32_t y = 0; y < 65; y++)
        for (uint32_t x = 0; x < 65; x++)
            memcpy(positions[y * 65 + x], ((float[3]){ (float)x, -(float)y, 0 }),
                   sizeof positions[0]);
    MergeGrid grid = { .columns = 65, .rows = 65, .position = (const float(*)[3])positions };
    MergedMesh mesh = merge(&grid, 1e-3);
    assert_int_equal(mesh.index_count, 4 * 2 * 3);
    merged_free(&mesh);
    positions[33 * 65 + 33][2] = 1; /* one point that stands out */
    mesh = merge(&grid, 1e-3);
    assert_in_range(mesh.index_count / 3, 20, 80);
    assert_true(farthest(&grid, &mesh) < 1e-6);
    merged_free(&mesh);
}

/* Whether the outside of some triangle of a patch is turned to the eye. */
static bool faces(const MergeGrid *grid, const MergedMesh *mesh, const MergedPatch *patch,
                  const double eye[3])
{
    for (uint32_t i = patch->first_index; i < patch->first_index + patch->index_count; i += 3) {
        double corner[3][3], side[2][3], normal[3];
        for (uint32_t n = 0; n < 3; n++)
            for (int k = 0; k < 3; k++)
                corner[n][k] = (double)grid->position[mesh->points[mesh->indices[i + n]]][k];
        vector_subtract(corner[1], corner[0], side[0]);
        vector_subtract(corner[2], corner[0], side[1]);
        vector_cross(side[0], side[1], normal);
        vector_subtract(eye, corner[0], side[0]);
        if (vector_dot(normal, side[0]) > 0)
            return true;
    }
    return false;
}

static void only_what_turns_away_is_left_out(void **state)
{
    (void)state;
    Random random = { 3 };
    const Grid smooth = { "around, smooth", 129, 64, true, 0, 0.01, 0.02 };
    const MergeGrid grid = make_grid(&smooth, &random);
    MergedMesh mesh = merge(&grid, smooth.tolerance);
    uint32_t left_out = 0, turned = 0;
    for (int i = 0; i < 100; i++) {
        double eye[3];
        for (int k = 0; k < 3; k++)
            eye[k] = random_int(&random, -400, 400) / 100.0;
        for (uint32_t p = 0; p < mesh.patch_count; p++) {
            const bool may = merged_may_face(&mesh.patches[p], eye, false);
            const bool does = faces(&grid, &mesh, &mesh.patches[p], eye);
            assert_true(may || !does);
            left_out += !may;
            turned += !does;
        }
    }
    print_message("# %u of %u patches that turn away are left out\n", left_out, turned);
    assert_true(left_out > 20);
    merged_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_near_their_triangles),
        cmocka_unit_test(no_crack_opens_and_nothing_is_lost),
        cmocka_unit_test(what_is_flat_is_merged),
        cmocka_unit_test(only_what_turns_away_is_left_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
