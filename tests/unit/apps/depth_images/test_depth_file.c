/* Files of depth images: what was written is read, bit for bit, and written again as it was; what
 * is broken is refused by a line that says where, and never by a crash. */
#include "apps/depth_images/depth_file.h"
#include "pipeline/io/file.h"
#include "pipeline/io/image/image_file.h"
#include "pipeline/io/image/layers_file.h"
#include "tests/support/folder.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <stdlib.h>

/* --- models ----------------------------------------------------------------------------------- */

static const DepthPlane plane = { .eye = { 0.1, -2, 1.0 / 3 },
                                  .right = { 0, 0, 1 },
                                  .up = { 0, 1, 0 },
                                  .forward = { 1, 0, 0 },
                                  .left = -0.5,
                                  .bottom = -1.0 / 7,
                                  .width = 1,
                                  .height = 2.0 / 7 };
static const DepthCylinder cylinder = {
    .center = { 1, 2, 3 }, .axis = { 0, 1, 0 }, .zero = { 0, 0, 1 }, .radius = 0.1, .height = 3
};

static void fill(DepthPixels *pixels, uint32_t width, uint32_t height, bool normals, uint64_t seed)
{
    Random random = { seed };
    assert_int_equal(depth_pixels_make(width, height, normals, pixels), GP_OK);
    for (uint32_t i = 0; i < width * height; i++) {
        if (random_int(&random, 0, 3) == 0)
            continue;
        pixels->depth[i] = random_int(&random, 0, 9) ? random_float(&random, 0, 5) : 0;
        for (uint32_t k = 0; k < 3; k++) {
            pixels->color[3 * i + k] = random_float(&random, 0, 1);
            if (normals)
                pixels->normal[3 * i + k] = k == i % 3 ? -1 : 0;
        }
    }
}

/* 0: one layer, no normals; 1: two layers; 2: a cylinder and its caps; 3: six faces. */
enum { MODELS = 4 };
static DepthModel model_of(int number)
{
    static const uint32_t counts[MODELS] = { 1, 1, 3, 6 };
    DepthModel model = { .count = counts[number] };
    for (uint32_t i = 0; i < model.count; i++) {
        DepthImage *image = &model.images[i];
        image->is_cylinder = number == 2 && i == 0;
        if (image->is_cylinder)
            image->cylinder = cylinder;
        else
            image->plane = plane;
        image->plane.is_parallel = !image->is_cylinder && i & 1;
        if (image->is_cylinder)
            image->cylinder = cylinder;
        fill(&image->front, 3 + i, 2, number > 0, 10 * i + 1);
        if (number > 0)
            fill(&image->behind, 3 + i, 2, true, 10 * i + 2);
    }
    return model;
}

static void assert_same_pixels(const DepthPixels *a, const DepthPixels *b)
{
    assert_true(a->width == b->width && a->height == b->height && !a->normal == !b->normal);
    const size_t bytes = (size_t)a->width * a->height * sizeof(float);
    if (a->width == 0)
        return;
    assert_memory_equal(a->depth, b->depth, bytes);
    assert_memory_equal(a->color, b->color, 3 * bytes);
    if (a->normal)
        assert_memory_equal(a->normal, b->normal, 3 * bytes);
}

static void what_is_read_is_what_was_written_bit_for_bit(void **state)
{
    (void)state;
    for (int number = 0; number < MODELS; number++) {
        GpError error = { "" };
        DepthModel model = model_of(number), again;
        GpFile first, second;
        if (depth_file_write(in_folder("a.exr"), &model, &error))
            fail_msg("%s", error.text);
        if (depth_file_read(in_folder("a.exr"), &again, &error))
            fail_msg("model %d: %s", number, error.text);
        assert_int_equal(again.count, model.count);
        for (uint32_t i = 0; i < model.count; i++) {
            const DepthImage *a = &model.images[i], *b = &again.images[i];
            char texts[2][DEPTH_TEXT];
            depth_place_write(a, texts[0]);
            depth_place_write(b, texts[1]);
            assert_string_equal(texts[0], texts[1]);
            assert_true(a->is_cylinder == b->is_cylinder);
            if (!a->is_cylinder)
                assert_true(a->plane.eye[2] == b->plane.eye[2] &&
                            a->plane.height == b->plane.height &&
                            a->plane.is_parallel == b->plane.is_parallel);
            assert_same_pixels(&a->front, &b->front);
            assert_same_pixels(&a->behind, &b->behind);
        }
        assert_int_equal(depth_file_write(in_folder("b.exr"), &again, &error), GP_OK);
        assert_int_equal(gp_file_read(in_folder("a.exr"), &first, &error), GP_OK);
        assert_int_equal(gp_file_read(in_folder("b.exr"), &second, &error), GP_OK);
        assert_int_equal(first.size, second.size);
        assert_memory_equal(first.data, second.data, first.size);
        gp_file_free(&first);
        gp_file_free(&second);
        depth_model_free(&model);
        depth_model_free(&again);
    }
}

/* --- what is broken --------------------------------------------------------------------------- */

static void assert_refused(const char *path, const char *expected)
{
    DepthModel model = { .count = 77 };
    GpError error = { "" };
    const GpResult result = depth_file_read(path, &model, &error);
    if (result == GP_OK || strncmp(error.text, path, strlen(path)) != 0 ||
        !strstr(error.text, expected) || strchr(error.text, '\n'))
        fail_msg("%s: \"%s\" instead of \"%s\"", gp_result_name(result), error.text, expected);
    assert_int_equal(model.count, 77);
}

/* Each prefix of a small file and each byte of it changed; of one with parts every seventh, unless
 * GP_TEST_EVERY_BYTE is set. Changes may go unseen (a sample is as good as another), but what is
 * read then keeps every promise. */
static void broken_files_are_refused_or_read_as_models(void **state)
{
    (void)state;
    GpError error = { "" };
    uint32_t refused = 0;
    for (int number = 1; number < 3; number++) {
        DepthModel model = model_of(number), read;
        GpFile file;
        if (depth_file_write(in_folder("a.exr"), &model, &error))
            fail_msg("%s", error.text);
        assert_int_equal(gp_file_read(in_folder("a.exr"), &file, &error), GP_OK);
        char path[400];
        strcpy(path, in_folder("b.exr"));
        const size_t step = number == 1 || getenv("GP_TEST_EVERY_BYTE") ? 1 : 7;
        for (size_t size = 0; size < file.size; size += step) {
            put_file("b.exr", file.data, size);
            assert_refused(path, "");
        }
        for (size_t i = 0; i < file.size; i += step) {
            char *byte = &file.data[i];
            const char before = *byte;
            *byte = (char)(i & 1 ? before + 1 : before ^ 0x80);
            put_file("b.exr", file.data, file.size);
            *byte = before;
            error.text[0] = '\0';
            if (depth_file_read(path, &read, &error) != GP_OK) {
                assert_true(error.text[0] && !strchr(error.text, '\n'));
                refused++;
                continue;
            }
            for (uint32_t n = 0; n < read.count; n++)
                for (uint32_t p = 0; p < read.images[n].front.width * read.images[n].front.height;
                     p++)
                    assert_true(read.images[n].front.depth[p] >= 0);
            depth_model_free(&read);
        }
        gp_file_free(&file);
        depth_model_free(&model);
    }
    assert_true(refused > 500);
}

/* A file of one part with these channels, all samples one value, and this text. */
static const char *put_part(const char *const channels[], const char *text, float value)
{
    GpLayers *layers = gp_alloc(1, sizeof *layers);
    GpError error = { "" };
    layers->count = 1;
    GpLayer *layer = &layers->layer[0];
    layer->width = 3;
    layer->height = 2;
    for (; channels[layer->channel_count]; layer->channel_count++)
        strcpy(layer->channel[layer->channel_count], channels[layer->channel_count]);
    strcpy(layer->text, text);
    layer->samples = gp_alloc(6 * layer->channel_count, sizeof(float));
    for (uint32_t i = 0; i < 6 * layer->channel_count; i++)
        layer->samples[i] = value;
    const char *path = in_folder("part.exr");
    if (gp_layers_write(path, "depthImage", layers, &error))
        fail_msg("%s", error.text);
    gp_layers_free(layers);
    gp_free(layers);
    return path;
}

#define PLANE    "plane parallel eye 0 0 0 right 1 0 0 up 0 1 0 forward 0 0 -1 window -1 -1 2 2"
#define CYLINDER "cylinder center 0 0 0 axis 0 1 0 zero 0 0 1 radius 1 height 2"

static void missing_channels_are_named(void **state)
{
    (void)state;
    static const struct {
        const char *channels[12], *expected;
    } rows[] = {
        { { "R", "G", "B" }, "no channel Z" },
        { { "Z" }, "no channel B" },
        { { "R", "G", "B", "Z", "N.X", "N.Y" }, "no channel N.Z" },
        { { "R", "G", "B", "Z", "behind.Z" }, "no channel behind.B" },
        { { "R", "G", "B", "Z", "behind.N.X", "behind.N.Y", "behind.N.Z" }, "no channel behind.Z" },
        { { "A" }, "no channel Z" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        assert_refused(put_part(rows[i].channels, PLANE, 0.5F), rows[i].expected);
}

static void samples_that_make_no_sense_are_refused_with_their_pixel(void **state)
{
    (void)state;
    static const char *const few[] = { "R", "G", "B", "Z", NULL };
    static const char *const many[] = { "R", "G", "B", "Z", "N.X", "N.Y", "N.Z", NULL };
    assert_refused(put_part(few, PLANE, NAN),
                   "pixel (0, 0) of Z: expected a depth from 0 on, or infinite");
    assert_refused(put_part(few, PLANE, -1e-9F), "expected a depth from 0 on");
    assert_refused(put_part(few, PLANE, INFINITY), "expected colours that are finite");
    assert_refused(put_part(many, PLANE, 1), "expected normals of length 1");
    DepthModel model;
    assert_int_equal(depth_file_read(put_part(few, CYLINDER, 0), &model, NULL), GP_OK);
    assert_true(model.images[0].is_cylinder && model.images[0].cylinder.height == 2);
    depth_model_free(&model);
}

static void places_that_make_no_sense_are_refused(void **state)
{
    (void)state;
    static const char *const few[] = { "R", "G", "B", "Z", NULL };
    static const struct {
        const char *text, *expected;
    } rows[] = {
        { "", "not a depth image: no attribute depthImage" },
        { "sphere", "expected \"cylinder\"" },
        { "plane", "expected \"cylinder\"" },
        { "cylinder", "expected \"center\" with 3 finite numbers" },
        { "cylinder center 0 0", "expected \"center\" with 3 finite numbers" },
        { "cylinder center 0 nan 0", "expected \"center\"" },
        { "cylinder center 0 inf 0", "expected \"center\"" },
        { "cylinder center 0 0 0 axis 0 1 0 zero 0 0 1 radius 0 height 2", "a radius above 0" },
        { "cylinder center 0 0 0 axis 0 1 0 zero 0 0 1 radius 1 height -2", "a height above 0" },
        { "cylinder center 0 0 0 axis 0 1 0 zero 0 0.1 1 radius 1 height 2",
          "square to each other" },
        { "cylinder center 0 0 0 axis 0 2 0 zero 0 0 1 radius 1 height 2", "unit vectors" },
        { CYLINDER " 7", "nothing behind its last number" },
        { "plane parallel eye 0 0 0 right 1 0 0 up 0 1 0 forward 0 0 1 window -1 -1 2 2",
          "right x up = -forward" },
        { "plane perspective eye 0 0 0 right 1 0 0 up 1 1 0 forward 0 0 -1 window -1 -1 2 2",
          "square to each other" },
        { "plane perspective eye 0 0 0 right 1 0 0 up 0 1 0 forward 0 0 -1 window -1 -1 0 2",
          "a width and a height above 0" },
        { "plane perspective eye 0 0 0 right 1 0 0 up 0 1 0 forward 0 0 -1 window -1 -1 2",
          "expected \"window\" with 4 finite numbers" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++)
        assert_refused(put_part(few, rows[i].text, 0.5F), rows[i].expected);
}

static void other_files_are_not_depth_images(void **state)
{
    (void)state;
    GpError error = { "" };
    float rgba[16] = { 0.5F };
    const GpImage picture = { 2, 2, 4, GP_IMAGE_F32, rgba };
    assert_int_equal(gp_image_write(in_folder("picture.exr"), &picture, NULL, &error), GP_OK);
    assert_refused(in_folder("picture.exr"), "not a depth image: no attribute depthImage");
    assert_refused(in_folder("none.exr"), "");
    assert_refused("depth.png", "expected a name that ends with .exr");
    assert_int_equal(gp_file_write(in_folder("text.exr"), "plane", 5, &error), GP_OK);
    assert_refused(in_folder("text.exr"), "expected the number of OpenEXR files");
}

static void nothing_is_left_where_a_file_cannot_be_written(void **state)
{
    (void)state;
    GpError error = { "" };
    DepthModel model = model_of(0);
    assert_int_equal(depth_file_write(in_folder("no/such/folder.exr"), &model, &error),
                     GP_ERROR_IO);
    assert_int_equal(depth_file_write(in_folder("a.png"), &model, &error), GP_ERROR_INVALID);
    assert_int_equal(folder_count(false), 0);
    depth_model_free(&model);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(what_is_read_is_what_was_written_bit_for_bit),
        TEST(broken_files_are_refused_or_read_as_models),
        TEST(missing_channels_are_named),
        TEST(samples_that_make_no_sense_are_refused_with_their_pixel),
        TEST(places_that_make_no_sense_are_refused),
        TEST(other_files_are_not_depth_images),
        TEST(nothing_is_left_where_a_file_cannot_be_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
