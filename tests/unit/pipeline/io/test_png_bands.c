/* PNG files are written in bands, by any number of threads or row by row: the same bytes, which
 * libpng reads as the picture that was written. */
#include "pipeline/io/image/image_file.h"
#include "pipeline/io/image/png_rows.h"
#include "tests/support/folder.h"
#include "tests/support/random.h"

static GpError error;

static size_t row_bytes(const GpImage *image)
{
    return (size_t)image->width * image->channels * gp_image_sample_size(image->type);
}

/* Noise here, slopes there, one colour in the rest: each neighbour is the nearest one somewhere. */
static void draw(GpImage *image)
{
    const size_t row = row_bytes(image);
    uint8_t *bytes = image->data;
    Random random = { 7 + image->channels };
    for (size_t y = 0; y < image->height; y++)
        for (size_t i = 0; i < row; i++)
            bytes[y * row + i] = (uint8_t)(y % 3 == 0    ? random_bits(&random)
                                           : i < row / 2 ? i + 2 * y
                                                         : 200 - y / 8);
}

static void check_read(const GpImage *image, const char *name)
{
    GpImage read;
    assert_int_equal(gp_image_read(in_folder(name), &read, &error), GP_OK);
    assert_true(read.width == image->width && read.height == image->height);
    assert_true(read.channels == image->channels && read.type == image->type);
    assert_memory_equal(read.data, image->data, row_bytes(image) * image->height);
    gp_image_free(&read);
}

static void check_same(const GpFile *a, const GpFile *b)
{
    assert_int_equal(a->size, b->size);
    assert_memory_equal(a->data, b->data, a->size);
}

static void check_threads(const GpImage *image, const GpFile *alone)
{
    static const int threads[] = { 1, 2, 3, 16 };
    for (size_t i = 0; i < GP_COUNT(threads); i++) {
        GpPool *pool = NULL;
        GpFile file;
        assert_int_equal(gp_pool_create(threads[i], &pool, &error), GP_OK);
        assert_int_equal(gp_image_encode("a.png", image, pool, &file, &error), GP_OK);
        check_same(&file, alone);
        gp_file_free(&file);
        gp_pool_destroy(&pool);
    }
}

/* in portion: rows at a time */
static void check_rows(const GpImage *image, const GpFile *alone, uint32_t portion)
{
    const uint8_t *data = image->data;
    GpPngRows *rows = NULL;
    GpFile file;
    assert_int_equal(gp_png_begin(in_folder("rows.png"), image, &rows, &error), GP_OK);
    for (uint32_t y = 0; y < image->height; y += portion) {
        const uint32_t left = image->height - y;
        assert_int_equal(
            gp_png_add(rows, data + y * row_bytes(image), left < portion ? left : portion, &error),
            GP_OK);
    }
    assert_int_equal(gp_png_end(&rows, true, &error), GP_OK);
    assert_int_equal(gp_file_read(in_folder("rows.png"), &file, &error), GP_OK);
    check_same(&file, alone);
    gp_file_free(&file);
}

static void check(uint32_t width, uint32_t height, uint32_t channels, GpImageType type)
{
    GpImage image = { .width = width, .height = height, .channels = channels, .type = type };
    GpFile alone;
    assert_int_equal(gp_image_alloc(&image, "a.png", &error), GP_OK);
    draw(&image);
    assert_int_equal(gp_image_encode("a.png", &image, NULL, &alone, &error), GP_OK);
    check_threads(&image, &alone);
    check_rows(&image, &alone, 1);
    check_rows(&image, &alone, 37);
    check_rows(&image, &alone, height);
    check_read(&image, "rows.png");
    gp_file_free(&alone);
    gp_image_free(&image);
}

static void every_kind_of_sample(void **state)
{
    (void)state;
    for (uint32_t channels = 1; channels <= 4; channels++)
        for (GpImageType type = GP_IMAGE_U8; type <= GP_IMAGE_U16; type++)
            check(301, 700, channels, type);
}

/* Bands of many rows, of one, and fewer rows than a band has; rows shorter than a step of the
 * filter. */
static void every_shape(void **state)
{
    (void)state;
    check(1, 1, 1, GP_IMAGE_U8);
    check(1, 3, 4, GP_IMAGE_U16);
    check(3, 2, 3, GP_IMAGE_U8);
    check(1, 65536, 1, GP_IMAGE_U8);
    check(65536, 3, 3, GP_IMAGE_U16);
    check(32768, 5, 4, GP_IMAGE_U8);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, folder_set_up, folder_tear_down)
    const struct CMUnitTest tests[] = {
        TEST(every_kind_of_sample),
        TEST(every_shape),
    };
    return cmocka_run_group_tests_name("png bands", tests, NULL, NULL);
}
