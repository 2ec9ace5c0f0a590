#include "apps/scene/patterns.h"

#include <string.h>

enum { SIDE = 256 };

typedef struct Color {
    float r, g, b, a;
} Color;

/* Colour of the texel (x, y) of SIDE x SIDE. All arithmetic is on integers, or exact in floats. */
typedef Color PatternFn(int x, int y);

static Color grey(float value)
{
    return (Color){ value, value, value, 1 };
}

static Color scale(Color color, float by)
{
    return (Color){ color.r * by, color.g * by, color.b * by, color.a };
}

static Color checker(int x, int y)
{
    return (x / 32 + y / 32) % 2 == 0 ? (Color){ 0.92f, 0.90f, 0.86f, 1 }
                                      : (Color){ 0.34f, 0.37f, 0.43f, 1 };
}

static Color gradient(int x, int y)
{
    return (Color){ (float)x / (SIDE - 1), (float)y / (SIDE - 1), 0.25f, 1 };
}

/* A hash of two whole numbers, 0 to 1 in 256 steps. */
static float hash_unit(int x, int y)
{
    uint32_t h = (uint32_t)x * 0x9e3779b1u ^ (uint32_t)y * 0x85ebca6bu;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return (float)(h >> 24) / 255.0f;
}

static Color bricks(int x, int y)
{
    int row = y / 32, shifted = (x + (row % 2) * 32) % SIDE;
    if (y % 32 < 3 || shifted % 64 < 3)
        return (Color){ 0.74f, 0.71f, 0.66f, 1 };
    Color brick = { 0.68f, 0.29f, 0.20f, 1 };
    float fine = hash_unit(x, y) * 0.12f;
    return scale(brick, 0.78f + 0.3f * hash_unit(shifted / 64, row + 100) - fine);
}

/* The digits 0 to 7 in 3x5 dots, the top row in the highest bits. */
static bool digit_dot(int digit, int x, int y)
{
    static const uint16_t digits[8] = { 075557, 026227, 071747, 071717,
                                        055711, 074717, 074757, 071111 };
    return x >= 0 && x < 3 && y >= 0 && y < 5 && (digits[digit] >> ((4 - y) * 3 + 2 - x) & 1);
}

static Color uv_grid(int x, int y)
{
    int column = x / 32, row = y / 32, inside_x = x % 32, inside_y = y % 32;
    Color color = { 0.25f + 0.08f * (float)column, 0.85f - 0.06f * (float)row,
                    0.35f + 0.05f * (float)(7 - column + row) / 2, 1 };
    if (inside_x == 0 || inside_y == 0)
        return grey(1);
    /* Dots of 3x3 texels: the column's digit, a gap, the row's digit. */
    int dot_x = (inside_x - 6) / 3, dot_y = (inside_y - 9) / 3;
    bool in_box = inside_x >= 6 && inside_y >= 9;
    if (in_box && (digit_dot(column, dot_x, dot_y) || digit_dot(row, dot_x - 4, dot_y)))
        return grey(0.05f);
    return (column + row) % 2 == 0 ? color : scale(color, 0.72f);
}

/* One octave: values at the corners of cells, blended with the weight 3t^2 - 2t^3. */
static float noise_octave(int x, int y, int cell)
{
    int cells = SIDE / cell, column = x / cell, row = y / cell;
    float u = ((float)(x % cell) + 0.5f) / (float)cell,
          v = ((float)(y % cell) + 0.5f) / (float)cell;
    u = u * u * (3 - 2 * u);
    v = v * v * (3 - 2 * v);
    int right = (column + 1) % cells, below = (row + 1) % cells;
    float top = hash_unit(column, row) * (1 - u) + hash_unit(right, row) * u;
    float bottom = hash_unit(column, below) * (1 - u) + hash_unit(right, below) * u;
    return top * (1 - v) + bottom * v;
}

static Color noise(int x, int y)
{
    return grey(0.5f * noise_octave(x, y, 64) + 0.3f * noise_octave(x, y, 32) +
                0.2f * noise_octave(x, y, 16));
}

static Color dots(int x, int y)
{
    int dx = x % 64 - 32, dy = y % 64 - 32;
    Color white = grey(1);
    white.a = dx * dx + dy * dy < 22 * 22 ? 1 : 0;
    return white;
}

/* Where two circles overlap, tip up, with veins. */
static Color leaf(int x, int y)
{
    int dx = x - 128, dy = y - 128, ax = dx < 0 ? -dx : dx;
    bool inside = (ax + 66) * (ax + 66) + dy * dy < 140 * 140;
    bool stalk = ax < 4 && dy > 0;
    bool vein = ax < 3 || (dy + ax + 256) % 32 < 3;
    Color color = vein ? (Color){ 0.62f, 0.78f, 0.30f, 1 } : (Color){ 0.20f, 0.52f, 0.16f, 1 };
    color.a = inside || stalk ? 1 : 0;
    return color;
}

static Color glow(int x, int y)
{
    float dx = ((float)x - 127.5f) / 128, dy = ((float)y - 127.5f) / 128;
    float falloff = 1 - (dx * dx + dy * dy);
    Color white = grey(1);
    white.a = falloff > 0 ? falloff * falloff : 0;
    return white;
}

/* The last one is dyed afterwards. */
static const struct {
    const char *name;
    PatternFn *texel;
} patterns[] = { { "checker", checker }, { "gradient", gradient }, { "bricks", bricks },
                 { "uv", uv_grid },      { "noise", noise },       { "dots", dots },
                 { "leaf", leaf },       { "glow", glow },         { "levels", checker } };

static void draw(GpSurface *surface, PatternFn *texel)
{
    for (uint32_t y = 0; y < SIDE; y++)
        for (uint32_t x = 0; x < SIDE; x++) {
            Color color = texel((int)x, (int)y);
            const float rgba[4] = { color.r, color.g, color.b, color.a };
            /* sRGB has the same bytes: what changes is how they are read. */
            gp_texel_store(GP_A8R8G8B8, gp_surface_texel(&surface->level[0], 4, x, y), rgba, 0);
        }
}

/* Dyes each level: its texels keep their lightness. */
static void dye_levels(GpSurface *surface)
{
    static const float dye[][3] = { { 1, 1, 1 },           { 1, 0.45f, 0.4f },  { 1, 0.8f, 0.3f },
                                    { 0.5f, 0.95f, 0.4f }, { 0.4f, 0.85f, 1 },  { 0.55f, 0.5f, 1 },
                                    { 1, 0.5f, 0.95f },    { 0.7f, 0.7f, 0.7f } };
    for (uint32_t i = 1; i < surface->levels; i++) {
        const GpLevel *level = &surface->level[i];
        const float *by = dye[i < GP_COUNT(dye) ? i : GP_COUNT(dye) - 1];
        for (uint32_t at = 0; at < level->width * level->height; at++) {
            float rgba[4];
            uint8_t *texel = gp_surface_texel(level, 4, at % level->width, at / level->width);
            gp_texel_load(GP_A8R8G8B8, texel, rgba);
            for (int c = 0; c < 3; c++)
                rgba[c] *= by[c];
            gp_texel_store(GP_A8R8G8B8, texel, rgba, 0);
        }
    }
}

const char *pattern_name(size_t i)
{
    return i < GP_COUNT(patterns) ? patterns[i].name : NULL;
}

GpResult pattern_create(const char *name, bool srgb, bool mips, GpSurface **surface, GpError *error)
{
    size_t index = 0;
    while (index < GP_COUNT(patterns) && strcmp(name, patterns[index].name) != 0)
        index++;
    if (index == GP_COUNT(patterns))
        return gp_fail(error, GP_ERROR_INVALID, "no builtin picture '%.40s'", name);
    GpSurfaceDesc desc = { .format = srgb ? GP_A8R8G8B8_SRGB : GP_A8R8G8B8,
                           .width = SIDE,
                           .height = SIDE,
                           .levels = mips ? GP_MAX_LEVELS : 1,
                           .name = name };
    GpSurface *made = NULL;
    GpResult result = gp_surface_create(&desc, &made, error);
    if (result)
        return result;
    draw(made, patterns[index].texel);
    if (mips)
        gp_surface_build_mips(made);
    if (mips && strcmp(name, "levels") == 0)
        dye_levels(made);
    *surface = made;
    return GP_OK;
}
