/* R48: Direct3D 9's own examples of textured quads, through the whole machine. */
#include <glasspipe/glasspipe.h>
#include "shaders_c/common/blit.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

enum { SIZE = 4 };

typedef struct Corner {
    float position[3], uv[2];
} Corner;

static GpSurface *square(void)
{
    GpSurface *surface = NULL;
    GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = SIZE, .height = SIZE };
    assert_int_equal(gp_surface_create(&desc, &surface, NULL), GP_OK);
    return surface;
}

/* Draws the texture on the quad from (low, low) to (high, high), in Direct3D 9's screen
 * coordinates: the centre of pixel (i, j) is (i, j). */
static void draw_quad(float low, float high, const GpSurface *texture, GpSurface *picture,
                      const GpDeviceDesc *desc)
{
    static const uint32_t order[6] = { 0, 1, 2, 0, 2, 3 };
    Corner corners[4];
    for (int i = 0; i < 4; i++) {
        bool right = i == 1 || i == 2, lower = i >= 2;
        corners[i] = (Corner){ { (right ? high : low) / (SIZE / 2) - 1,
                                 1 - (lower ? high : low) / (SIZE / 2), 0 },
                               { right, lower } };
    }
    GpDraw draw = { .program = &blit_program,
                    .geometry = { .vertex_count = 4, .indices = order, .index_count = 6 },
                    .viewport = { .width = SIZE, .height = SIZE, .d3d9_centers = true } };
    draw.geometry.streams[GP_POSITION] =
        (GpStream){ corners[0].position, sizeof corners[0], 3, GP_FLOAT32 };
    draw.geometry.streams[GP_TEXCOORD0] =
        (GpStream){ corners[0].uv, sizeof corners[0], 2, GP_FLOAT32 };
    draw.textures[0].surface = texture;
    draw.textures[0].sampler = (GpSampler){
        .min = GP_LINEAR, .mag = GP_LINEAR, .address_u = GP_CLAMP, .address_v = GP_CLAMP
    };
    draw.uniforms = &draw; /* the program has none */
    GpPass pass = { .color[0] = { .surface = picture, .clear = true },
                    .draws = &draw,
                    .draw_count = 1 };
    run_list_on(desc, &(GpList){ &pass, 1 });
}

static GpSurface *checkered(void)
{
    GpSurface *texture = square();
    for (int i = 0; i < SIZE * SIZE * 4; i++)
        texture->level[0].texels[i] = (uint8_t)(i * 37 + i / 5 * 11);
    return texture;
}

static void r48_quad_shifted_by_half_a_pixel_reproduces_the_texture(void **state)
{
    (void)state;
    for (size_t d = 0; device_here(d); d++) {
        GpSurface *texture = checkered(), *picture = square();
        draw_quad(-0.5f, 3.5f, texture, picture, device_here(d));
        assert_memory_equal(picture->level[0].texels, texture->level[0].texels, SIZE * SIZE * 4);
        gp_surface_destroy(&texture);
        gp_surface_destroy(&picture);
    }
}

static void r48_quad_on_pixel_centres_mixes_four_texels(void **state)
{
    (void)state;
    for (size_t d = 0; device_here(d); d++) {
        GpSurface *texture = checkered(), *picture = square();
        const uint8_t *texels = texture->level[0].texels;
        draw_quad(0, 4, texture, picture, device_here(d));
        for (int y = 0; y < SIZE; y++)
            for (int x = 0; x < SIZE; x++)
                for (int c = 0; c < 4; c++) {
                    int left = x ? x - 1 : 0, upper = y ? y - 1 : 0, sum = 0;
                    sum += texels[(upper * SIZE + left) * 4 + c];
                    sum += texels[(upper * SIZE + x) * 4 + c];
                    sum += texels[(y * SIZE + left) * 4 + c];
                    sum += texels[(y * SIZE + x) * 4 + c];
                    /* the mean as a float (R40), and that as a byte (R24): where it lies half-way
                       between two bytes, the float's rounding decides */
                    assert_int_equal(picture->level[0].texels[(y * SIZE + x) * 4 + c],
                                     gp_unorm_from_float((float)sum / (4 * 255), 8));
                }
        gp_surface_destroy(&texture);
        gp_surface_destroy(&picture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(r48_quad_shifted_by_half_a_pixel_reproduces_the_texture),
        cmocka_unit_test(r48_quad_on_pixel_centres_mixes_four_texels),
    };
    return cmocka_run_group_tests_name("texels_to_pixels", tests, NULL, NULL);
}
