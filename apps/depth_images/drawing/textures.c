#include "apps/depth_images/drawing/textures.h"

#include <math.h>

/* A picture whose texels count as much as their weight. */
typedef struct Weighted {
    uint32_t width, height;
    float (*texel)[4]; /* values times weight, and weight */
} Weighted;

enum { MOST_LEVELS = 16 };

static bool halve(const Weighted *from, Weighted *to)
{
    to->width = (from->width + 1) / 2;
    to->height = (from->height + 1) / 2;
    to->texel = gp_alloc((size_t)to->width * to->height, sizeof *to->texel);
    for (uint32_t y = 0; y < from->height && to->texel; y++)
        for (uint32_t x = 0; x < from->width; x++)
            for (int c = 0; c < 4; c++)
                to->texel[(size_t)(y / 2) * to->width + x / 2][c] +=
                    from->texel[(size_t)y * from->width + x][c];
    return to->texel != NULL;
}

/* Where a texel has no weight, it takes the mean of the square of the next level that it is part
 * of. */
static void fill(const Weighted *from, Weighted *to)
{
    for (uint32_t y = 0; y < to->height; y++)
        for (uint32_t x = 0; x < to->width; x++) {
            float *texel = to->texel[(size_t)y * to->width + x];
            const float *mean = from->texel[(size_t)(y / 2) * from->width + x / 2];
            for (int c = 0; c < 3 && texel[3] == 0; c++)
                texel[c] = mean[c] / mean[3];
            texel[3] = texel[3] == 0 ? 1 : texel[3];
        }
}

/* source the pull and push of Gortler, Grzeszczuk, Szeliski, Cohen, "The lumigraph", SIGGRAPH
 *      1996 */
static bool spread(Weighted levels[MOST_LEVELS])
{
    int count = 1;
    bool has_memory = true;
    while (has_memory && (levels[count - 1].width > 1 || levels[count - 1].height > 1)) {
        has_memory = halve(&levels[count - 1], &levels[count]);
        count += has_memory;
    }
    if (has_memory && levels[count - 1].texel[0][3] > 0)
        for (int i = count - 1; i > 0; i--)
            fill(&levels[i], &levels[i - 1]);
    for (int i = 1; i < count; i++)
        gp_free(levels[i].texel);
    return has_memory;
}

static uint8_t byte_of(float value)
{
    return (uint8_t)(value >= 1 ? 255 : value > 0 ? value * 255 + 0.5f : 0);
}

static void store(const Weighted *picture, float scale, float offset, GpSurface *surface)
{
    for (uint32_t y = 0; y < picture->height; y++)
        for (uint32_t x = 0; x < picture->width; x++) {
            const float *value = picture->texel[(size_t)y * picture->width + x];
            uint8_t *texel = gp_surface_texel(&surface->level[0], 4, x, y);
            for (int c = 0; c < 3; c++)
                texel[2 - c] = byte_of(value[c] * scale + offset);
            texel[3] = 255;
        }
    gp_surface_build_mips(surface);
}

/* values: [height][width][3]; a texel is value * scale + offset */
static GpResult make_texture(const DepthPixels *pixels, const float *values, float scale,
                             float offset, uint32_t level_count, GpSurface **surface,
                             GpError *error)
{
    const size_t count = (size_t)pixels->width * pixels->height;
    const GpSurfaceDesc desc = { .format = GP_A8R8G8B8,
                                 .width = pixels->width,
                                 .height = pixels->height,
                                 .levels = level_count };
    Weighted levels[MOST_LEVELS] = { { pixels->width, pixels->height,
                                       gp_alloc(count, 4 * sizeof(float)) } };
    GpSurface *made = NULL;
    GpResult result = gp_surface_create(&desc, &made, error);
    for (size_t i = 0; i < count && levels[0].texel; i++) {
        const bool shows = isfinite(pixels->depth[i]);
        for (int c = 0; c < 3 && shows; c++)
            levels[0].texel[i][c] = values[3 * i + (size_t)c];
        levels[0].texel[i][3] = shows ? 1 : 0;
    }
    if (!result && (!levels[0].texel || !spread(levels)))
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    if (result)
        gp_surface_destroy(&made);
    else
        store(&levels[0], scale, offset, made);
    gp_free(levels[0].texel);
    *surface = made;
    return result;
}

GpResult depth_color_texture(const DepthPixels *pixels, uint32_t levels, GpSurface **surface,
                             GpError *error)
{
    return make_texture(pixels, pixels->color, 1, 0, levels, surface, error);
}

GpResult depth_normal_texture(const DepthPixels *pixels, const float *normals, uint32_t levels,
                              GpSurface **surface, GpError *error)
{
    return make_texture(pixels, normals, 0.5f, 0.5f, levels, surface, error);
}

GpResult depth_textures_open(const DepthPixels *pixels, const float *normals,
                             DepthTextures *textures, GpError *error)
{
    DepthTextures made = { .color = NULL };
    GpResult result = depth_color_texture(pixels, GP_MAX_LEVELS, &made.color, error);
    if (!result && normals)
        result = depth_normal_texture(pixels, normals, GP_MAX_LEVELS, &made.normal, error);
    if (result)
        depth_textures_close(&made);
    else
        *textures = made;
    return result;
}

void depth_textures_close(DepthTextures *textures)
{
    gp_surface_destroy(&textures->color);
    gp_surface_destroy(&textures->normal);
}
