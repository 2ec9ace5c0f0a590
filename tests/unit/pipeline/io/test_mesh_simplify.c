/* Meshes with fewer triangles: those of a plane need hardly any, borders stay, and what the library
 * cannot have is left as it is. */
#include "pipeline/io/mesh/simplify.h"
#include "tests/support/unit.h"

#include <math.h>

enum { SIDE = 21, POINTS = SIDE * SIDE, TRIANGLES = 2 * (SIDE - 1) * (SIDE - 1) };

typedef struct Sheet {
    float positions[POINTS][3];
    uint32_t indices[TRIANGLES][3];
} Sheet;

/* A square of unit cells; bump: its height in the middle. */
static void make_sheet(double bump, Sheet *sheet)
{
    for (uint32_t i = 0; i < POINTS; i++) {
        const double x = i % SIDE - 10.0, y = i / SIDE - 10.0;
        sheet->positions[i][0] = (float)x;
        sheet->positions[i][1] = (float)y;
        sheet->positions[i][2] = (float)(bump / (1 + (x * x + y * y) / 8));
    }
    for (uint32_t i = 0; i < TRIANGLES; i++) {
        const uint32_t cell = i / 2, at = cell / (SIDE - 1) * SIDE + cell % (SIDE - 1);
        const uint32_t corners[2][3] = { { at, at + 1, at + SIDE },
                                         { at + 1, at + SIDE + 1, at + SIDE } };
        memcpy(sheet->indices[i], corners[i % 2], sizeof sheet->indices[i]);
    }
}

static GpSimplified simplify(const Sheet *sheet, uint32_t triangles, uint32_t least)
{
    const GpSimplifyInput input = { &sheet->positions[0][0], &sheet->indices[0][0], POINTS,
                                    triangles, least };
    GpSimplified left;
    GpError error = { "" };
    const GpResult result = gp_mesh_simplify(&input, &left, &error);
    if (result == GP_ERROR_UNSUPPORTED) {
        print_message("# skipped: %s\n", error.text);
        skip();
    }
    assert_int_equal(result, GP_OK);
    return left;
}

/* Of its shadow; triangles that turned over count below 0. */
static double area_of(const Sheet *sheet, const GpSimplified *left)
{
    double area = 0;
    for (uint32_t i = 0; i < left->triangle_count; i++) {
        const float *corner[3];
        for (uint32_t k = 0; k < 3; k++) {
            assert_true(left->indices[3 * i + k] < left->vertex_count);
            corner[k] = sheet->positions[left->vertices[left->indices[3 * i + k]]];
        }
        const double a[2] = { (double)corner[1][0] - (double)corner[0][0],
                              (double)corner[1][1] - (double)corner[0][1] };
        const double b[2] = { (double)corner[2][0] - (double)corner[0][0],
                              (double)corner[2][1] - (double)corner[0][1] };
        assert_true(a[0] * b[1] - a[1] * b[0] >= 0);
        area += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return area;
}

static void a_plane_needs_its_border_only(void **state)
{
    (void)state;
    static Sheet sheet;
    make_sheet(0, &sheet);
    GpSimplified left = simplify(&sheet, TRIANGLES, 0);
    const uint32_t border = 4 * (SIDE - 1); /* and one more, which cannot go without a sliver */
    assert_in_range(left.vertex_count, border, border + 1);
    assert_int_equal(left.triangle_count, 2 * left.vertex_count - border - 2);
    assert_true(area_of(&sheet, &left) == (SIDE - 1) * (SIDE - 1));
    gp_simplified_free(&left);
}

/* The top stays, since taking it away costs most; vertices are those that were there. */
static void as_many_triangles_are_left_as_asked(void **state)
{
    (void)state;
    static Sheet sheet;
    make_sheet(5, &sheet);
    GpSimplified left = simplify(&sheet, TRIANGLES, 300);
    assert_in_range(left.triangle_count, 299, 301);
    assert_true(fabs(area_of(&sheet, &left) - (SIDE - 1) * (SIDE - 1)) < 1e-9);
    bool has_top = false;
    for (uint32_t i = 0; i < left.vertex_count; i++) {
        assert_true(i == 0 || left.vertices[i] > left.vertices[i - 1]);
        has_top |= left.vertices[i] == POINTS / 2;
    }
    assert_true(has_top);
    gp_simplified_free(&left);
}

/* A third triangle at an edge inside the sheet: it stays, and so do its corners. */
static void what_does_not_fit_stays(void **state)
{
    (void)state;
    static struct {
        Sheet sheet;
        uint32_t more[3];
    } both;
    make_sheet(0, &both.sheet);
    const uint32_t edge[3] = { 10 * SIDE + 10, 10 * SIDE + 11, 15 * SIDE + 5 };
    memcpy(both.more, edge, sizeof edge);
    GpSimplified left = simplify(&both.sheet, TRIANGLES + 1, 0);
    uint32_t found = 0;
    for (uint32_t i = 0; i < left.vertex_count; i++)
        found += left.vertices[i] == edge[0] || left.vertices[i] == edge[1] ||
                 left.vertices[i] == edge[2];
    assert_int_equal(found, 3);
    assert_in_range(left.triangle_count, 4 * (SIDE - 1) - 2 + 1, 150);
    gp_simplified_free(&left);
}

static void nothing_is_left_of_nothing(void **state)
{
    (void)state;
    static Sheet sheet;
    make_sheet(0, &sheet);
    GpSimplified left = simplify(&sheet, 0, 0);
    assert_int_equal(left.triangle_count + left.vertex_count, 0);
    gp_simplified_free(&left);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plane_needs_its_border_only),
        cmocka_unit_test(as_many_triangles_are_left_as_asked),
        cmocka_unit_test(what_does_not_fit_stays),
        cmocka_unit_test(nothing_is_left_of_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
