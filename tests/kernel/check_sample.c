/* The texture units of the fast executor, at every lane width, against gp_texture_read: the same
 * bits for random textures, samplers and coordinates, with what is awkward about each drawn often.
 *
 * One line a width with the first difference, if any, then the count of passed and failed widths.
 * An argument replays one seed. Exit status 1 on a failure.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "pipeline/fast/lanes/texture/sample.h"
#include "pipeline/list/isa.h"
#include "pipeline/units/texture_read.h"
#include "tests/support/random.h"

enum { WIDEST = 16, TEXTURES = 3000, SAMPLERS = 4, PACKETS = 12 };

/* --- chance ----------------------------------------------------------------------------------- */

static uint32_t below(Random *random, uint32_t limit)
{
    return (uint32_t)random_int(random, 0, (int32_t)limit - 1);
}

static float odd_float(Random *random)
{
    static const float odd[] = {
        0.0f,
        -0.0f,
        0x1p-149f,
        -0x1p-149f,
        0x1p-126f,
        -0x1p-30f,
        0x1p-24f,
        1.0f,
        -1.0f,
        1.5f,
        -1.5f,
        2.0f,
        -2.0f,
        10.0f,
        -10.0f,
        0.5f,
        -0.5f,
        8192.0f,
        0x1p23f,
        -0x1p23f,
        0x1p31f,
        -0x1p40f,
        0x1p127f,
        -0x1p127f,
        3.4e38f,
        -3.4e38f,
        __builtin_inff(),
        -__builtin_inff(),
        __builtin_nanf(""),
    };
    uint32_t i = below(random, (uint32_t)GP_COUNT(odd) + 4);
    return i < GP_COUNT(odd) ? odd[i] : gp_bits_float(random_word(random));
}

/* --- textures --------------------------------------------------------------------------------- */

static float texel_float(Random *random)
{
    uint32_t kind = below(random, 16);
    return kind == 0   ? odd_float(random)
           : kind < 12 ? random_float(random, 0, 1)
                       : random_float(random, -1000, 1000);
}

static void fill_level(Random *random, GpFormat format, const GpLevel *level)
{
    const GpFormatInfo *info = gp_format_info(format);
    for (uint32_t y = 0; y < level->height; y++)
        for (uint32_t x = 0; x < level->width; x++) {
            uint8_t *texel = gp_surface_texel(level, info->bytes, x, y);
            float rgba[4];
            for (int c = 0; c < 4; c++)
                rgba[c] = texel_float(random);
            if (info->is_float) {
                gp_texel_store(format, texel, rgba, 0);
            } else if (format == GP_D32F) {
                memcpy(texel, rgba, 4);
            } else {
                for (int i = 0; i < info->bytes; i++)
                    texel[i] = (uint8_t)(below(random, 8) ? random_word(random)
                                                          : 255 * (random_word(random) & 1));
            }
        }
}

static uint32_t any_size(Random *random)
{
    uint32_t kind = below(random, 16);
    return kind == 0  ? 1u << below(random, 11)
           : kind < 8 ? 1u << below(random, 6)
                      : 1 + below(random, 40);
}

static GpSurface *any_surface(Random *random)
{
    GpSurface *surface = NULL;
    GpSurfaceDesc desc = {
        .format = (GpFormat)(GP_FORMAT_NONE + 1 + below(random, GP_FORMATS - 1)),
        .width = any_size(random),
        .height = any_size(random),
        .levels = below(random, 3) ? GP_MAX_LEVELS : 1,
    };
    uint32_t largest = below(random, 64);
    if (largest < 2)
        desc.width = largest ? 8192 : 8191, desc.height = 1 + below(random, 2);
    else if (largest < 4)
        desc.height = largest & 1 ? 8192 : 8191, desc.width = 1 + below(random, 2);
    if (gp_surface_create(&desc, &surface, NULL) != GP_OK)
        exit(2);
    for (uint32_t i = 0; i < surface->levels; i++)
        fill_level(random, surface->format, &surface->level[i]);
    return surface;
}

static GpSampler any_sampler(Random *random, GpFormat format)
{
    GpSampler s = {
        .min = (GpFilter)below(random, GP_FILTERS),
        .mip = (GpMipFilter)below(random, GP_MIP_FILTERS),
        .address_u = (GpAddress)below(random, GP_ADDRESSES),
        .address_v = (GpAddress)below(random, GP_ADDRESSES),
        .compare = gp_format_info(format)->is_depth && below(random, 4),
    };
    s.mag = below(random, 2) ? s.min : (GpFilter)below(random, GP_FILTERS);
    for (int c = 0; c < 4; c++)
        s.border[c] = below(random, 8) ? random_float(random, -0.25f, 1.25f) : odd_float(random);
    if (below(random, 2))
        s.lod_bias = below(random, 8) ? random_float(random, -3, 3) : odd_float(random);
    if (below(random, 3) == 0)
        s.min_lod = below(random, 8) ? random_float(random, -1, 6) : odd_float(random);
    if (below(random, 3) == 0)
        s.max_lod = below(random, 8) ? random_float(random, -1, 6) : odd_float(random);
    s.has_max_lod = below(random, 8) == 0;
    return s;
}

/* --- packets ---------------------------------------------------------------------------------- */

/* One value for each lane, like a texture coordinate over quads. */
static void any_coordinates(Random *random, int lanes, uint32_t size, float *value)
{
    uint32_t kind = below(random, 5);
    float start = random_float(random, -2.5f, 2.5f);
    float step = random_float(random, -4, 4) / (float)size / (float)(1u << below(random, 6));
    float lower_step = random_float(random, -4, 4) / (float)size;

    for (int lane = 0; lane < lanes; lane++) {
        value[lane] =
            start + step * (float)(lane / 4 * 2 + (lane & 1)) + lower_step * (float)(lane >> 1 & 1);
        if (kind == 0) { /* texel centres and edges, a few ulps around */
            float n = (float)size;
            float texel = (float)(int32_t)random_float(random, -3 * n, 3 * n) +
                          0.5f * (float)below(random, 2);
            value[lane] = gp_bits_float(gp_float_bits(texel / n) + below(random, 7) - 3);
        } else if (kind == 1) { /* half steps of the rounding */
            float n = (float)size * 512;
            value[lane] = (float)(int32_t)random_float(random, -2 * n, 2 * n) / n;
        } else if (kind == 2 && below(random, 4) == 0) {
            value[lane] = odd_float(random);
        } else if (kind == 3) {
            value[lane] = random_float(random, -12, 12);
        }
    }
}

typedef struct Packet {
    _Alignas(64) float coord[4 * WIDEST];
    _Alignas(64) float gradient[4 * WIDEST];
    _Alignas(64) float texel[4 * WIDEST], wanted[4 * WIDEST];
} Packet;

static GpTextureRead any_read(Random *random, int lanes, const GpSurface *surface, Packet *p)
{
    any_coordinates(random, lanes, surface->width, p->coord);
    any_coordinates(random, lanes, surface->height, p->coord + lanes);
    for (int lane = 0; lane < lanes; lane++) {
        float edge = (float)below(random, 65536) / 65535.0f;
        p->coord[2 * lanes + lane] = below(random, 2)   ? random_float(random, -0.25f, 1.25f)
                                     : below(random, 2) ? edge
                                                        : odd_float(random);
        p->coord[3 * lanes + lane] =
            below(random, 8) ? random_float(random, -2, 8) : odd_float(random);
    }
    float spread = 8.0f / (float)surface->width;
    for (int i = 0; i < 4 * lanes; i++)
        p->gradient[i] =
            below(random, 16) ? random_float(random, -spread, spread) : odd_float(random);
    return (GpTextureRead){ .lanes = lanes,
                            .mode = (GpLodMode)below(random, 4),
                            .coord = p->coord,
                            .gradient = p->gradient,
                            .texel = p->texel };
}

/* Lane and channel as one number, of the first difference; -1 where there is none. */
static int first_difference(const Packet *p, int lanes)
{
    for (int i = 0; i < 4 * lanes; i++) {
        bool numbers = p->texel[i] == p->texel[i] || p->wanted[i] == p->wanted[i];
        if (numbers && gp_float_bits(p->texel[i]) != gp_float_bits(p->wanted[i]))
            return i;
    }
    return -1;
}

static bool check_texture(uint64_t seed, int lanes, GpTextureFn read_texture)
{
    Random random = { .state = seed * 0x9e3779b97f4a7c15u };
    GpSurface *surface = any_surface(&random);
    bool same = true;

    for (int i = 0; same && i < SAMPLERS * PACKETS; i++) {
        static FastSampler samplers[GP_MAX_SAMPLERS];
        static GpTexture textures[GP_MAX_SAMPLERS];
        static Packet packet;
        int slot = i / PACKETS;
        if (i % PACKETS == 0) {
            bool unbound = below(&random, 64) == 0;
            textures[slot] = (GpTexture){ .surface = unbound ? NULL : surface,
                                          .sampler = any_sampler(&random, surface->format) };
            fast_prepare_sampler(&textures[slot], &samplers[slot]);
        }
        GpShaderCall call = { .textures = textures, .executor = samplers };
        GpTextureRead read = any_read(&random, lanes, surface, &packet);
        read.slot = slot;
        memset(packet.texel, 0xa5, sizeof packet.texel);
        memset(packet.wanted, 0x5a, sizeof packet.wanted);
        read_texture(&call, &read);
        read.texel = packet.wanted;
        gp_texture_read(&textures[slot], &read, lanes, NULL);
        int at = first_difference(&packet, lanes);
        same = at < 0;
        if (!same)
            printf("  seed %llu: %s %ux%u, lane %d channel %d at (%a, %a): %a, should be %a\n",
                   (unsigned long long)seed, gp_format_info(surface->format)->name, surface->width,
                   surface->height, at % lanes, at / lanes, (double)packet.coord[at % lanes],
                   (double)packet.coord[lanes + at % lanes], (double)packet.texel[at],
                   (double)packet.wanted[at]);
    }
    gp_surface_destroy(&surface);
    return same;
}

int main(int count, char **arguments)
{
    static const struct Width {
        int lanes;
        const char *isa; /* that an x86 processor needs */
        GpTextureFn read_texture;
    } widths[] = {
        { 4, "sse2", fast_read_texture_lanes4 },
        { 8, "avx2", fast_read_texture_lanes8 },
        { 16, "avx512", fast_read_texture_lanes16 },
    };
    uint64_t seed = count > 1 ? strtoull(arguments[1], NULL, 10) : 1;
    uint64_t end = count > 1 ? seed + 1 : seed + TEXTURES;
    int passed = 0, failed = 0;

    for (size_t i = 0; i < GP_COUNT(widths); i++) {
        const struct Width *width = &widths[i];
#if defined __x86_64__
        if (!gp_isa_runs(width->isa)) {
            printf("lanes%-2d skipped: no %s here\n", width->lanes, width->isa);
            continue;
        }
#endif
        bool same = true;
        for (uint64_t s = seed; same && s < end; s++)
            same = check_texture(s, width->lanes, width->read_texture);
        printf("lanes%-2d %s\n", width->lanes, same ? "ok" : "FAILED");
        passed += same;
        failed += !same;
    }
    printf("%d passed, %d failed\n", passed, failed);
    return failed || !passed;
}
