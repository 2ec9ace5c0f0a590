/* Textures that are warped for an eye: each texel's place is on its line to the eye, what is nearer
 * hides what is farther, gaps are filled where one surface goes on, and only there. */
#include "apps/depth_images/rivals/prewarp.h"
#include "apps/depth_images/rivals/slab_quad.h"
#include "tests/support/depth/formula.h"

typedef struct Warped {
    DepthImage image;
    DepthSlab slab;
    PrewarpInput input;
    Prewarped made;
} Warped;

static void warp(Formula formula, bool is_parallel, const Camera *camera, double plane, double cut,
                 Warped *warped)
{
    *warped = (Warped){ .image = formula_image(formula, is_parallel) };
    assert_true(slab_find(&warped->image.plane, &warped->image.front, &warped->slab));
    warped->input = (PrewarpInput){ .slab = &warped->slab,
                                    .pixels = &warped->image.front,
                                    .is_parallel = !(camera->fovy > 0),
                                    .plane = plane,
                                    .cut = cut };
    slab_eye(&warped->slab, camera, warped->input.eye);
    assert_int_equal(prewarp_make(&warped->input, &warped->made), GP_OK);
    assert_true(warped->made.width > 0 && warped->made.height > 0);
}

static void warped_free(Warped *warped)
{
    gp_free(warped->made.texel);
    formula_free(&warped->image);
}

/* How far a texel is on the plane from where the line from the eye to the place that it shows meets
 * it, in texels. */
static double off_of(const Warped *warped, uint32_t x, uint32_t y)
{
    const Prewarped *made = &warped->made;
    const double *eye = warped->input.eye, plane = warped->input.plane;
    const float *texel = made->texel[(size_t)y * made->width + x];
    const uint32_t at[2] = { x, y }, size[2] = { made->width, made->height };
    double most = 0;
    for (int k = 0; k < 2; k++) {
        const double way =
            (eye[k] - (double)texel[k] * eye[3]) / (eye[2] - (double)texel[2] * eye[3]);
        const double meets = (double)texel[k] + (plane - (double)texel[2]) * way;
        const double wanted = made->first[k] + (at[k] + 0.5) / size[k] * made->side[k];
        most = fmax(most, fabs(meets - wanted) / made->side[k] * size[k]);
    }
    return most;
}

static uint32_t count_texels(const Warped *warped, double *most_off)
{
    uint32_t count = 0;
    *most_off = 0;
    for (uint32_t y = 0; y < warped->made.height; y++)
        for (uint32_t x = 0; x < warped->made.width; x++)
            if (warped->made.texel[(size_t)y * warped->made.width + x][3] > 0) {
                *most_off = fmax(*most_off, off_of(warped, x, y));
                count++;
            }
    return count;
}

static void texels_show_what_is_on_their_lines(void **state)
{
    (void)state;
    for (int way = 0; way < 24; way++) {
        const Camera camera = formula_camera(1.4, 0.7, way & 8 ? -4.5 : 4.5, way & 2);
        Warped warped;
        double off;
        warp(way & 4 ? FORMULA_PLANE : FORMULA_BALL, way & 1, &camera, way % 3 / 2.0, 0.02,
             &warped);
        const uint32_t count = count_texels(&warped, &off);
        print_message("# %u texels of %u x %u, off by %.3f\n", count, warped.made.width,
                      warped.made.height, off);
        assert_true(count > 500 && off < 0.6);
        warped_free(&warped);
    }
}

static void gaps_are_filled_where_one_surface_goes_on(void **state)
{
    (void)state;
    const Camera camera = formula_camera(3, 0, 4, false);
    uint32_t count[3];
    for (int way = 0; way < 3; way++) {
        Warped warped;
        double off;
        warp(way < 2 ? FORMULA_STEP : FORMULA_PLANE, true, &camera, 0.5, way ? 0.02 : -1, &warped);
        count[way] = count_texels(&warped, &off);
        if (way == 2) { /* what is seen of a plane has no gap: each row's texels are side by side */
            for (uint32_t y = 4; y + 4 < warped.made.height; y++) {
                uint32_t turns = 0;
                for (uint32_t x = 1; x < warped.made.width; x++) {
                    const float(*row)[4] =
                        (const float(*)[4])warped.made.texel + (size_t)y * warped.made.width;
                    turns += row[x][3] > 0 && !(row[x - 1][3] > 0);
                }
                assert_in_range(turns, 0, 1);
            }
        }
        warped_free(&warped);
    }
    print_message("# texels: %u, cut at the step %u; of a plane %u\n", count[0], count[1],
                  count[2]);
    assert_true(count[0] > count[1] + 200);
}

/* The step goes from 4.5 before the source to 5.5: by 2 / 9 of the nearer. */
static void pixels_are_of_two_surfaces_by_how_far_their_depths_differ(void **state)
{
    (void)state;
    static const double cuts[] = { 0.02, 0.222, 0.223, -1 };
    const Camera camera = formula_camera(3, 0, 4, false);
    for (int is_parallel = 0; is_parallel < 2; is_parallel++) {
        uint32_t count[4];
        for (int i = 0; i < 4; i++) {
            Warped warped;
            double off;
            warp(FORMULA_STEP, is_parallel, &camera, 0.5, cuts[i], &warped);
            count[i] = count_texels(&warped, &off);
            warped_free(&warped);
        }
        print_message("# texels: %u %u, %u %u\n", count[0], count[1], count[2], count[3]);
        assert_true(count[0] == count[1] && count[1] < count[2] && count[2] == count[3]);
    }
}

/* From aside the step's front plane hides some of the one behind. */
static void what_is_nearer_hides_what_is_farther(void **state)
{
    (void)state;
    const Camera camera = formula_camera(-3, 0, 4, false);
    Warped warped;
    warp(FORMULA_STEP, true, &camera, 0.5, 0.02, &warped);
    double last = -1;
    const float(*row)[4] =
        (const float(*)[4])warped.made.texel + (size_t)(warped.made.height / 2) * warped.made.width;
    for (uint32_t x = 0; x < warped.made.width; x++) {
        if (!(row[x][3] > 0))
            continue;
        assert_true((double)row[x][0] > last); /* nothing of the hidden part comes through */
        last = (double)row[x][0];
    }
    assert_true(last > 0.9);
    warped_free(&warped);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texels_show_what_is_on_their_lines),
        cmocka_unit_test(gaps_are_filled_where_one_surface_goes_on),
        cmocka_unit_test(pixels_are_of_two_surfaces_by_how_far_their_depths_differ),
        cmocka_unit_test(what_is_nearer_hides_what_is_farther),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
