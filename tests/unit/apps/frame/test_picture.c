/* Surfaces as picture files: which channels and values a file has of every format, and what comes
 * back. */
#include "apps/frame/picture.h"
#include "tests/support/folder.h"
#include "tests/support/surfaces/texels.h"

#include <math.h>

enum { WIDTH = 5, HEIGHT = 3 };

/* A texel's own colours, which eight bits and halves hold. */
static void color_at(uint32_t x, uint32_t y, float rgba[4])
{
    for (uint32_t c = 0; c < 4; c++)
        rgba[c] = (float)((x * 50 + y * 17 + c * 31) % 256) / 255;
}

static void store(GpFormat format, const float rgba[4], void *texel)
{
    const uint16_t d16 = (uint16_t)(rgba[0] * 65535);
    const uint32_t d24 = (uint32_t)(rgba[0] * 16777215) << 8 | 0x5a;
    if (format == GP_D16)
        memcpy(texel, &d16, sizeof d16);
    else if (format == GP_D24S8)
        memcpy(texel, &d24, sizeof d24);
    else if (format == GP_D32F)
        memcpy(texel, rgba, sizeof *rgba);
    else
        gp_texel_store(format, texel, rgba, 0);
}

static GpSurface *make_surface(GpFormat format)
{
    GpSurface *surface = make(format, WIDTH, HEIGHT, 1);
    for (uint32_t y = 0; y < HEIGHT; y++)
        for (uint32_t x = 0; x < WIDTH; x++) {
            float rgba[4];
            color_at(x, y, rgba);
            store(format, rgba, texel_at(surface, 0, x, y));
        }
    return surface;
}

/* A file's channels; its values are those of the surface from channel `first` on, within `off`; one
 * more than the surface has is 0. */
static void check_file(const char *path, const GpSurface *surface, int channels, int first,
                       double off)
{
    const GpFormatInfo *info = gp_format_info(surface->format);
    GpError error = { "" };
    Picture picture;
    if (picture_read(path, &picture, &error))
        fail_msg("%s", error.text);
    assert_int_equal(picture.width, WIDTH);
    assert_int_equal(picture.height, HEIGHT);
    assert_int_equal(picture.channels, channels);
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        float rgba[4];
        load(surface, 0, i % WIDTH, i / WIDTH, rgba);
        for (int c = 0; c < channels; c++) {
            const float right = info->channels == 2 && c == 2 ? 0 : rgba[first + c];
            const float read = picture.values[(int)i * channels + c];
            if (fabs((double)(read - right)) > off)
                fail_msg("%s, texel %u, channel %d: %g instead of %g", info->name, i, c,
                         (double)read, (double)right);
        }
    }
    picture_free(&picture);
}

typedef struct Case {
    GpFormat format;
    const char *extension;
    int channels, opaque; /* of a file; of one without alpha */
    double off;
} Case;

static void files_have_the_channels_of_their_formats(void **state)
{
    (void)state;
    static const Case cases[] = {
        { GP_A8R8G8B8, "png", 4, 3, 0 },
        { GP_A8R8G8B8, "exr", 4, 3, 0 },
        { GP_X8R8G8B8, "png", 3, 3, 0 },
        { GP_R8, "png", 1, 1, 0 },
        { GP_G16R16F, "exr", 3, 3, 0 },
        { GP_A16B16G16R16F, "exr", 4, 3, 0 },
        { GP_R32F, "exr", 1, 1, 0 },
        { GP_A32B32G32R32F, "exr", 4, 3, 0 },
        { GP_A32B32G32R32F, "pfm", 3, 3, 0 },
        { GP_A32B32G32R32F, "png", 4, 3, 0.5 / 255 },
        { GP_D16, "png", 1, 1, 0 },
        { GP_D24S8, "png", 1, 1, 0.5 / 65535 },
        { GP_D32F, "png", 1, 1, 0.5 / 65535 },
        { GP_D32F, "exr", 1, 1, 0 },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const Case *the = &cases[i];
        GpError error = { "" };
        char name[16];
        snprintf(name, sizeof name, "a.%s", the->extension);
        GpSurface *surface = make_surface(the->format);
        for (int opaque = 0; opaque < 2; opaque++) {
            if (picture_write_surface(in_folder(name), surface, opaque, NULL, &error))
                fail_msg("%s", error.text);
            check_file(in_folder(name), surface, opaque ? the->opaque : the->channels, 0, the->off);
        }
        if (gp_format_info(the->format)->channels == 4) {
            assert_int_equal(picture_write_alpha(in_folder(name), surface, NULL, &error), GP_OK);
            if (strcmp(the->extension, "pfm") != 0)
                check_file(in_folder(name), surface, 1, 3, the->off);
        }
        gp_surface_destroy(&surface);
    }
}

static void channels_are_repeated_added_and_left_out(void **state)
{
    (void)state;
    static const float has[5][4] = { { 0 }, { 2 }, { 2, 3 }, { 2, 3, 4 }, { 2, 3, 4, 5 } };
    static const float wants[5][5][4] = {
        [1] = { [1] = { 2 }, [2] = { 2, 1 }, [3] = { 2, 2, 2 }, [4] = { 2, 2, 2, 1 } },
        [2] = { [1] = { 2 }, [2] = { 2, 3 }, [3] = { 2, 2, 2 }, [4] = { 2, 2, 2, 3 } },
        [3] = { [1] = { 2 }, [2] = { 2, 1 }, [3] = { 2, 3, 4 }, [4] = { 2, 3, 4, 1 } },
        [4] = { [1] = { 2 }, [2] = { 2, 5 }, [3] = { 2, 3, 4 }, [4] = { 2, 3, 4, 5 } },
    };
    for (int from = 1; from <= 4; from++)
        for (int to = 1; to <= 4; to++) {
            Picture picture = { 1, 1, from, gp_alloc((size_t)from, sizeof(float)) };
            memcpy(picture.values, has[from], (size_t)from * sizeof(float));
            assert_int_equal(picture_set_channels(&picture, to, NULL), GP_OK);
            assert_int_equal(picture.channels, to);
            for (int c = 0; c < to; c++)
                if (picture.values[c] != wants[from][to][c])
                    fail_msg("%d of %d channels, channel %d: %g", to, from, c,
                             (double)picture.values[c]);
            picture_free(&picture);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(files_have_the_channels_of_their_formats, folder_set_up,
                                        folder_tear_down),
        cmocka_unit_test(channels_are_repeated_added_and_left_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
