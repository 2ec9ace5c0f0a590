#include "apps/frame/strips.h"

#include "apps/frame/picture.h"
#include "pipeline/io/file.h"
#include "pipeline/io/image/png_rows.h"

#include <stdio.h>
#include <string.h>
#include <xxhash.h>

struct Strips {
    const char *path;
    GpFormat format;
    uint32_t width, height;
    uint32_t x, y, band; /* what is there: columns of the band, rows before it; its rows */
    size_t bytes;        /* of a texel */
    uint8_t *texels;     /* of the band */
    XXH3_state_t hash;
    bool is_ppm;
    GpPngRows *rows;      /* NULL before the first band, and of a PPM */
    GpFilePieces *pieces; /* of a PPM */
};

bool strips_can_write(const char *path)
{
    return gp_file_has_extension(path, "png") || gp_file_has_extension(path, "ppm");
}

GpResult strips_begin(const char *path, GpFormat format, uint32_t width, uint32_t height,
                      Strips **strips, GpError *error)
{
    if (!strips_can_write(path))
        return gp_fail(error, GP_ERROR_INVALID,
                       "%s: a picture of %ux%u is written in strips: expected .png or .ppm", path,
                       width, height);
    Strips *made = gp_alloc(1, sizeof *made);
    if (!made)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: out of memory", path);
    made->path = path;
    made->format = format;
    made->width = width;
    made->height = height;
    made->bytes = gp_format_info(format)->bytes;
    made->is_ppm = gp_file_has_extension(path, "ppm");
    XXH3_64bits_reset(&made->hash);
    *strips = made;
    return GP_OK;
}

/* --- a band ----------------------------------------------------------------------------------- */

static GpResult begin_file(Strips *s, const GpImage *like, GpError *error)
{
    GpImage whole = *like;
    whole.width = s->width;
    whole.height = s->height;
    if (!s->is_ppm)
        return gp_png_begin(s->path, &whole, &s->rows, error);
    char head[64];
    GpResult result = gp_file_begin(s->path, &s->pieces, error);
    const int length = snprintf(head, sizeof head, "P6\n%u %u\n%d\n", s->width, s->height,
                                like->type == GP_IMAGE_U16 ? 65535 : 255);
    return result ? result : gp_file_add(s->pieces, head, (size_t)length, error);
}

/* Samples are the machine's; PPM's come the highest byte first. */
static void swap_bytes(uint8_t *samples, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const uint8_t low = samples[2 * i];
        samples[2 * i] = samples[2 * i + 1];
        samples[2 * i + 1] = low;
    }
}

static GpResult write_row(Strips *s, GpImage *row, GpError *error)
{
    const size_t count = (size_t)row->width * row->channels;
    if (!s->is_ppm)
        return gp_png_add(s->rows, row->data, 1, error);
    if (row->type == GP_IMAGE_U16)
        swap_bytes(row->data, count);
    return gp_file_add(s->pieces, row->data, count * gp_image_sample_size(row->type), error);
}

/* The samples of a row's part, which a surface can hold. */
static GpResult sample_part(const Strips *s, const uint8_t *texels, uint32_t width, GpImage *image,
                            GpError *error)
{
    const GpSurfaceDesc desc = {
        .format = s->format, .width = width, .height = 1, .memory = (void *)texels
    };
    GpSurface *part = NULL;
    GpResult result = gp_surface_create(&desc, &part, error);
    if (!result)
        result = picture_samples(s->path, part, &part->window, image, error);
    gp_surface_destroy(&part);
    return result;
}

/* All parts of a row, one behind the other in `row', which is made for the first. */
static GpResult sample_row(const Strips *s, const uint8_t *texels, GpImage *row, GpError *error)
{
    GpResult result = GP_OK;
    size_t used = 0;
    for (uint32_t x = 0; x < s->width && !result; x += GP_MAX_SIZE) {
        const uint32_t width = s->width - x < GP_MAX_SIZE ? s->width - x : GP_MAX_SIZE;
        GpImage part = { .data = NULL };
        result = sample_part(s, texels + x * s->bytes, width, &part, error);
        if (!result && !row->data) {
            *row = (GpImage){ s->width, 1, part.channels, part.type, NULL };
            result = gp_image_alloc(row, s->path, error);
        }
        const size_t size = (size_t)width * part.channels * gp_image_sample_size(part.type);
        if (!result)
            memcpy((uint8_t *)row->data + used, part.data, size);
        used += size;
        gp_image_free(&part);
    }
    return result;
}

static GpResult write_band(Strips *s, GpError *error)
{
    const size_t pitch = s->width * s->bytes;
    GpImage row = { .data = NULL };
    GpResult result = GP_OK;
    XXH3_64bits_update(&s->hash, s->texels, s->band * pitch);
    for (uint32_t y = 0; y < s->band && !result; y++) {
        result = sample_row(s, s->texels + y * pitch, &row, error);
        if (!result && s->y == 0 && y == 0)
            result = begin_file(s, &row, error);
        if (!result)
            result = write_row(s, &row, error);
    }
    gp_image_free(&row);
    gp_free(s->texels);
    s->texels = NULL;
    s->y += s->band;
    s->x = s->band = 0;
    return result;
}

GpResult strips_add(Strips *s, const void *texels, uint32_t width, uint32_t height, GpError *error)
{
    const size_t pitch = s->width * s->bytes, row = width * s->bytes;
    if (!s->texels) {
        s->band = height;
        s->texels = gp_alloc(height, pitch);
        if (!s->texels)
            return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for %u rows", s->path, height);
    }
    GP_ASSERT(height == s->band && width <= s->width - s->x && s->y + height <= s->height);
    for (uint32_t y = 0; y < height; y++)
        memcpy(s->texels + y * pitch + s->x * s->bytes, (const uint8_t *)texels + y * row, row);
    s->x += width;
    return s->x == s->width ? write_band(s, error) : GP_OK;
}

GpResult strips_end(Strips **strips, bool whole, uint64_t *hash, GpError *error)
{
    Strips *ended = *strips;
    *strips = NULL;
    if (!ended)
        return GP_OK;
    GP_ASSERT(!whole || ended->y == ended->height);
    *hash = XXH3_64bits_digest(&ended->hash);
    GpResult result = ended->is_ppm ? gp_file_end(&ended->pieces, whole, error)
                                    : gp_png_end(&ended->rows, whole, error);
    gp_free(ended->texels);
    gp_free(ended);
    return result;
}
