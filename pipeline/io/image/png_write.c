/* PNG files, written in bands of rows that are filtered and deflated each for itself: threads take
 * one each, and their number changes no byte. libpng, which writes row after row, takes 15 ms for a
 * picture of 1024 x 768; this 10, with two threads 6.5, and no more bytes.
 * source ISO/IEC 15948: 5.3 (chunks), 9.2 (filters), 10.1 (deflate); RFC 1950 */
#include "pipeline/base/pool.h"
#include "pipeline/io/bytes.h"
#include "pipeline/io/image/image_codec.h"
#include "pipeline/io/image/png_rows.h"

#include <zlib.h>

/* A third of the time of level 6, for 9 % more bytes. To try all filters takes as long as it
 * saves. */
enum { LEVEL = 4, PAETH = 4 };

/* Four windows of deflate: what a band does not find in those before it costs less than 1 %. */
enum { BAND_BYTES = 1 << 17 };

/* --- bands ------------------------------------------------------------------------------------ */

typedef struct Layout {
    size_t row, pixel, sample; /* bytes */
    uint32_t rows;             /* of a band, but for the last */
    uint32_t height;
} Layout;

static Layout layout_of(const GpImage *image)
{
    const size_t sample = gp_image_sample_size(image->type), pixel = image->channels * sample;
    const size_t row = image->width * pixel, rows = BAND_BYTES / (row + 1);
    return (Layout){ row, pixel, sample, rows ? (uint32_t)rows : 1, image->height };
}

typedef int16_t Shorts __attribute__((vector_size(16)));
typedef uint8_t Bytes __attribute__((vector_size(8)));
enum { WIDE = 8 };

typedef struct Band {
    uint8_t *rows;     /* the one above the band, then the band's, as files hold samples */
    uint8_t *filtered; /* with a byte before each row */
    uint8_t *packed;
    size_t room; /* of packed */
    z_stream deflate;
} Band;

static void end_band(Band *band)
{
    deflateEnd(&band->deflate);
    gp_free(band->rows);
    gp_free(band->filtered);
    gp_free(band->packed);
    *band = (Band){ .rows = NULL };
}

/* False, and nothing is left to end, where there is no memory. */
static bool begin_band(const Layout *layout, Band *band)
{
    const size_t bytes = layout->rows * (layout->row + 1);
    *band = (Band){ .rows = gp_alloc(1, bytes + layout->row + WIDE),
                    .filtered = gp_alloc_unset(bytes + WIDE) };
    if (deflateInit2(&band->deflate, LEVEL, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) ==
        Z_OK) {
        band->room = deflateBound(&band->deflate, bytes) + 64; /* and the end of a band */
        band->packed = gp_alloc_unset(band->room);
    }
    if (band->rows && band->filtered && band->packed)
        return true;
    end_band(band);
    return false;
}

static inline Shorts load(const uint8_t *at)
{
    Bytes bytes;
    memcpy(&bytes, at, WIDE);
    return __builtin_convertvector(bytes, Shorts);
}

static inline Shorts choose(Shorts mask, Shorts a, Shorts b)
{
    return (mask & a) | (~mask & b);
}

static inline Shorts absolute(Shorts x)
{
    return choose(x < 0, -x, x);
}

/* The difference to that neighbour, of three, which is nearest to left + above - corner. Goes a
 * little beyond a row's end: there is room. */
static void filter_row(const Layout *layout, const uint8_t *row, const uint8_t *above, uint8_t *out)
{
    const size_t pixel = layout->pixel;
    *out++ = PAETH;
    for (size_t i = 0; i < pixel; i++)
        out[i] = (uint8_t)(row[i] - above[i]);
    for (size_t i = pixel; i < layout->row; i += WIDE) {
        const Shorts left = load(row + i - pixel), up = load(above + i);
        const Shorts corner = load(above + i - pixel);
        const Shorts from_left = absolute(up - corner), from_up = absolute(left - corner);
        const Shorts from_corner = absolute(left + up - 2 * corner);
        const Shorts is_up = from_up < from_left;
        const Shorts side = choose(is_up, up, left), from_side = choose(is_up, from_up, from_left);
        const Shorts nearest = choose(from_corner < from_side, corner, side);
        const Bytes rest = __builtin_convertvector(load(row + i) - nearest, Bytes);
        memcpy(out + i, &rest, WIDE);
    }
}

/* Bytes of a deflated band, and what the picture's checksum needs of it. */
typedef struct Piece {
    void *data;
    size_t size, filtered;
    uint32_t sum;
} Piece;

/* in row: of the picture, the band's first. returns what lies in the band's memory */
static Piece pack(const Layout *layout, Band *band, uint32_t row, uint32_t rows)
{
    const size_t wide = layout->row;
    for (size_t y = 0; y < rows; y++)
        filter_row(layout, band->rows + (y + 1) * wide, band->rows + y * wide,
                   band->filtered + y * (wide + 1));
    const size_t bytes = rows * (wide + 1);
    z_stream *stream = &band->deflate;
    deflateReset(stream);
    stream->next_in = band->filtered;
    stream->avail_in = (uInt)bytes;
    stream->next_out = band->packed;
    stream->avail_out = (uInt)band->room;
    deflate(stream, row + rows == layout->height ? Z_FINISH : Z_SYNC_FLUSH);
    GP_ASSERT(!stream->avail_in && stream->avail_out);
    return (Piece){ band->packed, band->room - stream->avail_out, bytes,
                    (uint32_t)adler32_z(1, band->filtered, bytes) };
}

/* --- chunks ----------------------------------------------------------------------------------- */

static void store_big(uint8_t bytes[4], uint32_t value)
{
    for (int i = 0; i < 4; i++)
        bytes[i] = (uint8_t)(value >> (24 - 8 * i));
}

static void put_number(GpBytes *bytes, uint32_t value)
{
    uint8_t big[4];
    store_big(big, value);
    gp_bytes_append(bytes, big, sizeof big);
}

static void put_chunk(GpBytes *bytes, const char *kind, const void *data, size_t size)
{
    put_number(bytes, (uint32_t)size);
    gp_bytes_append(bytes, kind, 4);
    gp_bytes_append(bytes, data, size);
    put_number(bytes, (uint32_t)crc32_z(crc32_z(0, (const Bytef *)kind, 4), data, size));
}

/* The picture's data are one zlib stream, in as many chunks as there are bands, and one before them
 * and one behind. */
static void put_head(GpBytes *bytes, const GpImage *image)
{
    static const uint8_t signature[8] = { 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n' };
    static const uint8_t colors[] = { 0, 0, 4, 2, 6 }; /* by channels */
    static const uint8_t zlib[2] = { 0x78, 0x5e };     /* a window of 32 KB; packed fast */
    uint8_t head[13] = { [8] = image->type == GP_IMAGE_U16 ? 16 : 8, colors[image->channels] };
    store_big(head, image->width);
    store_big(head + 4, image->height);
    gp_bytes_append(bytes, signature, sizeof signature);
    put_chunk(bytes, "IHDR", head, sizeof head);
    put_chunk(bytes, "IDAT", zlib, sizeof zlib);
}

/* in/out sum: Adler's, of all before */
static void put_piece(GpBytes *bytes, const Piece *piece, uint32_t *sum)
{
    put_chunk(bytes, "IDAT", piece->data, piece->size);
    *sum = (uint32_t)adler32_combine(*sum, piece->sum, (z_off_t)piece->filtered);
}

static void put_end(GpBytes *bytes, uint32_t sum)
{
    uint8_t end[4];
    store_big(end, sum);
    put_chunk(bytes, "IDAT", end, sizeof end);
    put_chunk(bytes, "IEND", "", 0);
}

static GpResult no_memory(const char *path, GpError *error)
{
    return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for the picture", path);
}

/* --- whole pictures --------------------------------------------------------------------------- */

typedef struct Encoding {
    const GpImage *image;
    Layout layout;
    Band *bands;   /* of each worker; zeroed: not yet begun */
    Piece *pieces; /* data NULL: there was no memory */
} Encoding;

/* The row above the first of all is one of zeros. */
static uint32_t load_rows(const Encoding *encoding, uint32_t first, Band *band)
{
    const GpImage *image = encoding->image;
    const Layout *layout = &encoding->layout;
    const uint32_t left = layout->height - first;
    const uint32_t rows = left < layout->rows ? left : layout->rows, above = first > 0;
    if (!above)
        memset(band->rows, 0, layout->row);
    gp_copy_samples(band->rows + (above ? 0 : layout->row),
                    (const uint8_t *)image->data + (first - above) * layout->row,
                    (rows + above) * layout->row / layout->sample, layout->sample, true);
    return rows;
}

static void encode_band(void *context, uint32_t item, int worker)
{
    const Encoding *encoding = context;
    const Layout *layout = &encoding->layout;
    Band *band = &encoding->bands[worker];
    Piece *piece = &encoding->pieces[item];
    if (!band->rows && !begin_band(layout, band))
        return;
    const uint32_t first = item * layout->rows;
    *piece = pack(layout, band, first, load_rows(encoding, first, band));
    void *packed = gp_alloc_unset(piece->size);
    if (packed)
        memcpy(packed, piece->data, piece->size);
    piece->data = packed;
}

static bool gather(const Encoding *encoding, uint32_t count, GpFile *file)
{
    GpBytes bytes = { .data = NULL };
    uint32_t sum = 1;
    put_head(&bytes, encoding->image);
    for (uint32_t i = 0; i < count; i++) {
        if (encoding->pieces[i].data)
            put_piece(&bytes, &encoding->pieces[i], &sum);
        else
            bytes.failed = true;
    }
    put_end(&bytes, sum);
    if (bytes.failed)
        gp_free(bytes.data);
    else
        *file = (GpFile){ .data = bytes.data, .size = bytes.size };
    return !bytes.failed;
}

GpResult gp_image_encode_png(const char *path, GpImageFormat format, const GpImage *image,
                             GpPool *pool, GpFile *file, GpError *error)
{
    (void)format;
    Encoding encoding = { .image = image, .layout = layout_of(image) };
    const uint32_t count = (image->height + encoding.layout.rows - 1) / encoding.layout.rows;
    const int threads = pool ? gp_pool_threads(pool) : 1;
    encoding.bands = gp_alloc((size_t)threads, sizeof *encoding.bands);
    encoding.pieces = gp_alloc(count, sizeof *encoding.pieces);
    bool made = false;
    if (encoding.bands && encoding.pieces) {
        if (pool)
            gp_pool_run(pool, count, encode_band, &encoding);
        for (uint32_t i = 0; !pool && i < count; i++)
            encode_band(&encoding, i, 0);
        made = gather(&encoding, count, file);
    }
    for (int i = 0; encoding.bands && i < threads; i++)
        end_band(&encoding.bands[i]);
    for (uint32_t i = 0; encoding.pieces && i < count; i++)
        gp_free(encoding.pieces[i].data);
    gp_free(encoding.bands);
    gp_free(encoding.pieces);
    return made ? GP_OK : no_memory(path, error);
}

/* --- row by row ------------------------------------------------------------------------------- */

struct GpPngRows {
    const char *path;
    Layout layout;
    GpFilePieces *file;
    GpBytes bytes; /* that wait to be written */
    Band band;
    uint32_t waiting; /* rows in the band */
    uint32_t packed;  /* rows that were */
    uint32_t sum;
};

static GpResult write_waiting(GpPngRows *rows, GpError *error)
{
    if (rows->bytes.failed)
        return no_memory(rows->path, error);
    const GpResult result = gp_file_add(rows->file, rows->bytes.data, rows->bytes.size, error);
    rows->bytes.size = 0;
    return result;
}

GpResult gp_png_begin(const char *path, const GpImage *image, GpPngRows **rows, GpError *error)
{
    GpPngRows *made = gp_alloc(1, sizeof *made);
    if (!made)
        return no_memory(path, error);
    *made = (GpPngRows){ .path = path, .layout = layout_of(image), .sum = 1 };
    const GpResult result = gp_file_begin(path, &made->file, error);
    if (result) {
        gp_free(made);
        *rows = NULL;
        return result;
    }
    *rows = made;
    if (!begin_band(&made->layout, &made->band))
        return no_memory(path, error);
    put_head(&made->bytes, image);
    return write_waiting(made, error);
}

/* The last row stays, above those of the next band. */
static GpResult write_band(GpPngRows *rows, GpError *error)
{
    const Layout *layout = &rows->layout;
    const Piece piece = pack(layout, &rows->band, rows->packed, rows->waiting);
    put_piece(&rows->bytes, &piece, &rows->sum);
    memcpy(rows->band.rows, rows->band.rows + rows->waiting * layout->row, layout->row);
    rows->packed += rows->waiting;
    rows->waiting = 0;
    return write_waiting(rows, error);
}

GpResult gp_png_add(GpPngRows *rows, const void *samples, uint32_t count, GpError *error)
{
    const Layout *layout = &rows->layout;
    const uint8_t *from = samples;
    GpResult result = GP_OK;
    for (; count && !result; count--, from += layout->row) {
        rows->waiting++;
        gp_copy_samples(rows->band.rows + rows->waiting * layout->row, from,
                        layout->row / layout->sample, layout->sample, true);
        if (rows->waiting == layout->rows || rows->packed + rows->waiting == layout->height)
            result = write_band(rows, error);
    }
    return result;
}

GpResult gp_png_end(GpPngRows **rows, bool whole, GpError *error)
{
    GpPngRows *ended = *rows;
    *rows = NULL;
    if (!ended)
        return GP_OK;
    GpResult result = GP_OK;
    if (whole) {
        put_end(&ended->bytes, ended->sum);
        result = write_waiting(ended, error);
    }
    const GpResult closed = gp_file_end(&ended->file, whole && !result, error);
    end_band(&ended->band);
    gp_free(ended->bytes.data);
    gp_free(ended);
    return result ? result : closed;
}
