/* A volume's file tells where it lies: read here by other means than the program's own, header line
 * by line, and put back. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

#include <math.h>

/* What an NRRD file says. */
typedef struct Placed {
    uint32_t dims[3];
    double step[3], origin[3]; /* places of cells' centres: origin + index * step */
    unsigned char cells[64 * 64 * 64];
} Placed;

static const char *value_of(const char *header, const char *field)
{
    const char *at = strstr(header, field);
    if (!at)
        fail_msg("no '%s' in:\n%s", field, header);
    return at + strlen(field);
}

static void read_placed(const char *path, Placed *placed)
{
    static char file[1 << 16];
    assert_int_equal(shell("sed '/^$/q' %s", path), 0);
    const size_t header = strlen(out);
    memcpy(file, out, header + 1);
    assert_int_equal(sscanf(value_of(file, "\nsizes:"), "%u %u %u", &placed->dims[0],
                            &placed->dims[1], &placed->dims[2]),
                     3);
    assert_int_equal(sscanf(value_of(file, "\nspace directions:"), " (%lf,0,0) (0,%lf,0) (0,0,%lf)",
                            &placed->step[0], &placed->step[1], &placed->step[2]),
                     3);
    assert_int_equal(sscanf(value_of(file, "\nspace origin:"), " (%lf,%lf,%lf)", &placed->origin[0],
                            &placed->origin[1], &placed->origin[2]),
                     3);
    expect_contains(file, "\nspace dimension: 3\n");
    expect_contains(file, "\ncenterings: cell cell cell\n");
    assert_null(strstr(file, "\nspacings:")); /* the format has either */
    assert_int_equal(shell("tail -c +%zu %s | gunzip >cells", header + 1, path), 0);
    const size_t count = (size_t)placed->dims[0] * placed->dims[1] * placed->dims[2];
    assert_true(count <= sizeof placed->cells);
    FILE *cells = fopen("cells", "rb");
    assert_non_null(cells);
    assert_int_equal(fread(placed->cells, 1, sizeof placed->cells, cells), count);
    fclose(cells);
}

/* The box of the cells that are set, in the model's space. */
static void box_of_cells(const Placed *placed, double low[3], double high[3])
{
    for (int k = 0; k < 3; k++) {
        low[k] = HUGE_VAL;
        high[k] = -HUGE_VAL;
    }
    const uint32_t *dims = placed->dims;
    for (uint32_t i = 0; i < dims[0] * dims[1] * dims[2]; i++) {
        const uint32_t at[3] = { i % dims[0], i / dims[0] % dims[1], i / dims[0] / dims[1] };
        for (int k = 0; placed->cells[i] && k < 3; k++) {
            const double centre = placed->origin[k] + at[k] * placed->step[k];
            low[k] = fmin(low[k], centre - placed->step[k] / 2);
            high[k] = fmax(high[k], centre + placed->step[k] / 2);
        }
    }
}

static bool cell_is_set(const Placed *placed, const double point[3])
{
    size_t at[3];
    for (int k = 0; k < 3; k++)
        at[k] = (size_t)floor((point[k] - placed->origin[k]) / placed->step[k] + 0.5);
    return placed->cells[at[0] + placed->dims[0] * (at[1] + placed->dims[1] * at[2])];
}

/* A part of 16 x 8 x 4 that lies 450,000 from the origin, where floats are 1/32 apart, holds its
 * own corners in cells that are set, and those cells reach no more than one beyond it. */
static void a_part_far_from_the_origin_is_put_back(void **state)
{
    (void)state;
    static Placed placed;
    static const double from[3] = { 450000, -225000.5, 1024.25 }, side[3] = { 16, 8, 4 };
    char text[1024];
    int used = snprintf(text, sizeof text, "OFF\n8 12 0\n");
    for (int i = 0; i < 8; i++)
        used += snprintf(text + used, sizeof text - (size_t)used, "%.17g %.17g %.17g\n",
                         from[0] + (i & 1 ? side[0] : 0), from[1] + (i & 2 ? side[1] : 0),
                         from[2] + (i & 4 ? side[2] : 0));
    snprintf(text + used, sizeof text - (size_t)used,
             "3 0 2 1\n3 1 2 3\n3 4 5 6\n3 5 7 6\n3 0 1 4\n3 1 5 4\n"
             "3 2 6 3\n3 3 6 7\n3 0 4 2\n3 2 4 6\n3 1 3 5\n3 3 7 5\n");
    write_file("far.off", text);
    static const char *const options[] = { "", "--kind solid", "--xform 1.5 -674985 337520 -1520" };
    for (size_t i = 0; i < GP_COUNT(options); i++) {
        double low[3], high[3];
        assert_int_equal(
            shell("glasspipe voxelize far.off -n 40 --json -o far.nrrd %s", options[i]), 0);
        json_t *object = parse_output(), *transform = json_object_get(object, "transform");
        const double scale = json_number_value(json_object_get(transform, "scale"));
        read_placed("far.nrrd", &placed);
        box_of_cells(&placed, low, high);
        for (size_t k = 0; k < 3; k++) {
            const double offset =
                json_number_value(json_array_get(json_object_get(transform, "offset"), k));
            assert_true(fabs(scale * placed.origin[k] + offset - 0.5) < 1e-7);
            assert_true(fabs(scale * placed.step[k] - 1) < 1e-14);
            assert_true(fabs(low[k] - from[k]) <= 1.001 * placed.step[k]);
            assert_true(fabs(high[k] - (from[k] + side[k])) <= 1.001 * placed.step[k]);
        }
        json_decref(object);
        for (int corner = 0; corner < 8; corner++) {
            double point[3];
            for (int k = 0; k < 3; k++) { /* just inside; a solid has a cell by its centre */
                const double in = i == 1 ? placed.step[k] : 0.01 * side[k];
                point[k] = from[k] + (corner >> k & 1 ? side[k] - in : in);
            }
            assert_true(cell_is_set(&placed, point));
        }
    }
}

/* Of two, each has its own place in the volume. */
static void two_models_have_a_transform_each(void **state)
{
    (void)state;
    assert_int_equal(shell("glasspipe voxelize builtin:cube --with builtin:cube --fit 0.5 "
                           "--move 0.25 0 0 -n 40 --json"),
                     0);
    json_t *object = parse_output();
    const json_t *first = json_object_get(object, "transform");
    const json_t *second = json_object_get(object, "with_transform");
    const double scale = json_number_value(json_object_get(first, "scale"));
    assert_true(scale == 37.5 / 2); /* side 2 in 40 - 2.5 voxels */
    assert_true(json_number_value(json_object_get(second, "scale")) == scale / 2);
    const json_t *x = json_array_get(json_object_get(second, "offset"), 0);
    assert_true(fabs(json_number_value(x) - (20 + 0.25 * 37.5)) < 1e-9);
    json_decref(object);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(a_part_far_from_the_origin_is_put_back),
        PROGRAM_TEST(two_models_have_a_transform_each),
    };
    return cmocka_run_group_tests_name("cli volume place", tests, find_program, NULL);
}
