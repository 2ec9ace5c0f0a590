/* Small triangles, the bulk of any mesh: set up GP_LANES at a time, then filled one by one. */
#include "pipeline/fast/lanes/route.h"

#include "pipeline/compare.h"

/* Largest extent, in sub-pixels, at which edges fit into 32 bits with room for helper pixels. */
enum { FITS = 1 << 14 };

/* GP_LANES triangles set up side by side; arrays, because they are then taken one by one. */
typedef struct Batch {
    _Alignas(64) int32_t x0[GP_LANES], y0[GP_LANES], x1[GP_LANES], y1[GP_LANES]; /* in the tile */
    int32_t edge[3][GP_LANES];                     /* exact, at the centre of (x0, y0) */
    int32_t inside[3][GP_LANES];                   /* in 256ths, negative outside */
    int32_t right[3][GP_LANES], down[3][GP_LANES]; /* of `inside`, a pixel further */
    double base[GP_LANES], step[2][GP_LANES];
    float inverse_area[GP_LANES], ratio[2][GP_LANES], face[GP_LANES];
    uint32_t number[3][GP_LANES]; /* vertices, first_vertex apart */
    unsigned drawn, alone, tiny;  /* bits: in this tile; too large; a box of at most 4x4 */
} Batch;

GP_INLINE itg least(itg a, itg b)
{
    return itg_select((itg)(a < b), a, b);
}

GP_INLINE itg most(itg a, itg b)
{
    return itg_select((itg)(a > b), a, b);
}

static void fetch_numbers(const FastDraw *d, const uint32_t *primitives, uint32_t count,
                          Batch *batch)
{
    const GpGeometry *geometry = &d->draw->geometry;
    GP_UNROLL
    for (uint32_t lane = 0; lane < GP_LANES; lane++) {
        uint32_t at = 3 * (primitives[lane < count ? lane : 0] - d->first_primitive);
        for (uint32_t k = 0; k < 3; k++)
            batch->number[k][lane] =
                (geometry->indices ? geometry->indices[at + k] : at + k) - d->first_vertex;
    }
}

/* Depth of the three corners, as gp_setup_triangle: in binary64, from binary32 values. */
static void set_depth(const FastDraw *d, const flt z[3], itg area2, const itg a[3], const itg b[3],
                      Batch *batch)
{
    dbl z0 = __builtin_convertvector(z[0], dbl), area = dbl_from_itg(area2);
    dbl step1 = (__builtin_convertvector(z[1], dbl) - z0) / area;
    dbl step2 = (__builtin_convertvector(z[2], dbl) - z0) / area;
    const GpRasterState *raster = &d->draw->state.raster;
    if (d->needs.depth_bias)
        GP_UNROLL
    for (int lane = 0; lane < GP_LANES; lane++) {
        double by_x = (double)a[1][lane] * step1[lane] + (double)a[2][lane] * step2[lane];
        double by_y = (double)b[1][lane] * step1[lane] + (double)b[2][lane] * step2[lane];
        by_x = (by_x < 0 ? -by_x : by_x) * GP_SUBPIXELS;
        by_y = (by_y < 0 ? -by_y : by_y) * GP_SUBPIXELS;
        double offset = (double)raster->depth_bias;
        if (raster->slope_depth_bias != 0)
            offset += (by_x > by_y ? by_x : by_y) * (double)raster->slope_depth_bias;
        z0[lane] += offset;
    }
    else z0 = z0 + 0.0; /* what adding an offset of 0 does */
    __builtin_memcpy(batch->base, &z0, sizeof z0);
    __builtin_memcpy(batch->step[0], &step1, sizeof step1);
    __builtin_memcpy(batch->step[1], &step2, sizeof step2);
}

static void set_up(const Tile *tile, const uint32_t *primitives, uint32_t count, Batch *batch)
{
    const FastDraw *d = tile->draw;
    itg p[3][4];
    fetch_numbers(d, primitives, count, batch);
    for (int k = 0; k < 3; k++) {
        const void *record[GP_LANES];
        GP_UNROLL
        for (int lane = 0; lane < GP_LANES; lane++)
            record[lane] = &d->positions[batch->number[k][lane]];
        lanes_load4(record, p[k]);
        p[k][0] -= tile->x0 * GP_SUBPIXELS + GP_SUBPIXELS / 2;
        p[k][1] -= tile->y0 * GP_SUBPIXELS + GP_SUBPIXELS / 2;
    }
    itg low_x = least(p[0][0], least(p[1][0], p[2][0]));
    itg high_x = most(p[0][0], most(p[1][0], p[2][0]));
    itg low_y = least(p[0][1], least(p[1][1], p[2][1]));
    itg high_y = most(p[0][1], most(p[1][1], p[2][1]));
    const unsigned wanted = (unsigned)((1u << count) - 1);
    batch->alone = wanted & msk_bits((itg)(high_x - low_x >= FITS) | (itg)(high_y - low_y >= FITS));

    GpRect rect = FAST(tile_rect)(tile, d);
    itg x0 = most((low_x + (GP_SUBPIXELS - 1)) >> GP_SUBPIXEL_BITS, itg_set(rect.x0 - tile->x0));
    itg y0 = most((low_y + (GP_SUBPIXELS - 1)) >> GP_SUBPIXEL_BITS, itg_set(rect.y0 - tile->y0));
    itg x1 = least(high_x >> GP_SUBPIXEL_BITS, itg_set(rect.x1 - 1 - tile->x0));
    itg y1 = least(high_y >> GP_SUBPIXEL_BITS, itg_set(rect.y1 - 1 - tile->y0));
    batch->drawn = wanted & ~batch->alone & msk_bits((itg)(x0 <= x1) & (itg)(y0 <= y1));
    batch->tiny = msk_bits((itg)(x1 - x0 < 4) & (itg)(y1 - y0 < 4));

    /* corners 1 and 2 change places where the triangle turns the other way */
    itg area2 =
        cross_lanes(p[1][0] - p[0][0], p[2][1] - p[0][1], p[2][0] - p[0][0], p[1][1] - p[0][1]);
    msk front = (msk)(area2 > 0);
    for (int i = 0; i < 4; i++) {
        itg one = p[1][i], two = p[2][i];
        p[1][i] = itg_select(front, one, two);
        p[2][i] = itg_select(front, two, one);
    }
    itg number1, number2;
    __builtin_memcpy(&number1, batch->number[1], sizeof number1);
    __builtin_memcpy(&number2, batch->number[2], sizeof number2);
    itg first = itg_select(front, number1, number2), second = itg_select(front, number2, number1);
    __builtin_memcpy(batch->number[1], &first, sizeof first);
    __builtin_memcpy(batch->number[2], &second, sizeof second);
    area2 = itg_select(front, area2, (itg) - (utg)area2);

    itg a[3], b[3];
    for (int i = 0; i < 3; i++) {
        const itg *from = p[(i + 1) % 3], *to = p[(i + 2) % 3];
        itg dx = to[0] - from[0], dy = to[1] - from[1];
        itg edge = cross_lanes(dx, y0 * GP_SUBPIXELS - from[1], dy, x0 * GP_SUBPIXELS - from[0]);
        msk accepts_zero = (msk)(dy < 0) | ((msk)(dy == 0) & (msk)(dx > 0));
        itg inside = (itg)((utg)edge + (utg)~accepts_zero) >> GP_SUBPIXEL_BITS; /* ~mask: 0 or -1 */
        a[i] = -dy;
        b[i] = dx;
        __builtin_memcpy(batch->edge[i], &edge, sizeof edge);
        __builtin_memcpy(batch->inside[i], &inside, sizeof inside);
        __builtin_memcpy(batch->right[i], &a[i], sizeof a[i]);
        __builtin_memcpy(batch->down[i], &b[i], sizeof b[i]);
    }
    if (d->wants_depth)
        set_depth(d, (flt[3]){ (flt)p[0][2], (flt)p[1][2], (flt)p[2][2] }, area2, a, b, batch);
    if (d->route != FAST_DEPTH_ONLY) {
        flt inverse_area = 1.0f / flt_from_itg(area2);
        flt ratio1 = (flt)p[1][3] / (flt)p[0][3], ratio2 = (flt)p[2][3] / (flt)p[0][3];
        __builtin_memcpy(batch->inverse_area, &inverse_area, sizeof inverse_area);
        __builtin_memcpy(batch->ratio[0], &ratio1, sizeof ratio1);
        __builtin_memcpy(batch->ratio[1], &ratio2, sizeof ratio2);
    }
    flt face = flt_select(front, flt_set(1), flt_set(-1));
    __builtin_memcpy(batch->face, &face, sizeof face);
    __builtin_memcpy(batch->x0, &x0, sizeof x0);
    __builtin_memcpy(batch->y0, &y0, sizeof y0);
    __builtin_memcpy(batch->x1, &x1, sizeof x1);
    __builtin_memcpy(batch->y1, &y1, sizeof y1);
}

static void write_record(const FastDraw *d, const Batch *batch, uint32_t lane, FastRecord *record)
{
    int32_t c[3], x0 = batch->x0[lane], y0 = batch->y0[lane];
    for (int i = 1; i < 3; i++)
        c[i] = (int32_t)((uint32_t)batch->edge[i][lane] -
                         (uint32_t)GP_SUBPIXELS * ((uint32_t)(batch->right[i][lane] * x0) +
                                                   (uint32_t)(batch->down[i][lane] * y0)));
    record->c1 = c[1];
    record->a1 = batch->right[1][lane] * GP_SUBPIXELS;
    record->b1 = batch->down[1][lane] * GP_SUBPIXELS;
    record->c2 = c[2];
    record->a2 = batch->right[2][lane] * GP_SUBPIXELS;
    record->b2 = batch->down[2][lane] * GP_SUBPIXELS;
    record->inverse_area = batch->inverse_area[lane];
    record->ratio1 = batch->ratio[0][lane];
    record->ratio2 = batch->ratio[1][lane];
    record->face = batch->face[lane];
    record->kind = FAST_SMALL;
    for (int k = 0; k < 3; k++)
        record->corner[k] = d->varyings + (size_t)batch->number[k][lane] * d->stride;
}

/* Bits of the pixels of a 4x4 box, by rows, that are covered: for all triangles at once. */
static itg cover_tiny(const Batch *batch)
{
    utg row[3], right[3], down[3]; /* of lanes that are not tiny they may wrap */
    itg covered_bits = itg_set(0);
    for (int i = 0; i < 3; i++) {
        __builtin_memcpy(&row[i], batch->inside[i], sizeof row[i]);
        __builtin_memcpy(&right[i], batch->right[i], sizeof right[i]);
        __builtin_memcpy(&down[i], batch->down[i], sizeof down[i]);
    }
    itg x0, y0, x1, y1;
    __builtin_memcpy(&x0, batch->x0, sizeof x0);
    __builtin_memcpy(&y0, batch->y0, sizeof y0);
    __builtin_memcpy(&x1, batch->x1, sizeof x1);
    __builtin_memcpy(&y1, batch->y1, sizeof y1);
    itg width = x1 - x0, height = y1 - y0; /* one less than the number of pixels */
    for (int y = 0; y < 4; y++) {
        utg e0 = row[0], e1 = row[1], e2 = row[2];
        for (int x = 0; x < 4; x++) {
            itg out = (itg)(e0 | e1 | e2) | (width - x) | (height - y);
            covered_bits |= (itg)((utg)~out >> 31) << (4 * y + x);
            e0 += right[0];
            e1 += right[1];
            e2 += right[2];
        }
        for (int i = 0; i < 3; i++)
            row[i] += down[i];
    }
    return covered_bits;
}

static uint32_t depth_code(GpFormat format, float z)
{
    if (format == GP_D32F)
        return gp_float_bits(z + 0.0f);
    return (uint32_t)((double)z * (format == GP_D16 ? 65535.0 : 16777215.0) + 0.5);
}

GP_INLINE float tiny_depth(const FastDraw *d, const Batch *batch, uint32_t lane, int32_t x,
                           int32_t y)
{
    double e1 = batch->edge[1][lane] +
                GP_SUBPIXELS * (batch->right[1][lane] * x + batch->down[1][lane] * y);
    double e2 = batch->edge[2][lane] +
                GP_SUBPIXELS * (batch->right[2][lane] * x + batch->down[2][lane] * y);
    float z = (float)(batch->base[lane] + (e1 * batch->step[0][lane] + e2 * batch->step[1][lane]));
    z = z < d->viewport.min_depth ? d->viewport.min_depth : z;
    return z > d->viewport.max_depth ? d->viewport.max_depth : z;
}

/* A triangle of a few pixels, with nothing but a depth test: pixel by pixel. */
static void fill_tiny(Tile *tile, const Batch *batch, uint32_t lane, unsigned pixels)
{
    const FastDraw *d = tile->draw;
    const GpDepthState *depth = &d->draw->state.depth;
    const uint32_t at = fast_at(batch->x0[lane], batch->y0[lane]), number = tile->record_count;
    bool seen = false;
    while (pixels) {
        int32_t x = __builtin_ctz(pixels) & 3, y = __builtin_ctz(pixels) >> 2;
        uint32_t pixel = at + fast_at(x, y);
        pixels &= pixels - 1;
        if (d->wants_depth) {
            uint32_t code = depth_code(tile->depth_format, tiny_depth(d, batch, lane, x, y));
            if (!gp_compare_codes(depth->test, code, tile->depth[pixel]))
                continue;
            if (depth->write)
                tile->depth[pixel] = code;
        }
        if (d->route == FAST_VISIBLE) {
            tile->seen[pixel] = number;
            seen = true;
        }
    }
    if (seen)
        write_record(d, batch, lane, &tile->records[tile->record_count++]);
}

/* Any small triangle: rows of lanes, as fill_covered. */
static void fill_small(Tile *tile, const Batch *batch, uint32_t lane)
{
    const FastDraw *d = tile->draw;
    Filler filler = { .tile = tile, .d = d, .front = batch->face[lane] > 0 };
    const int32_t x0 = batch->x0[lane], y0 = batch->y0[lane];
    const int32_t x1 = batch->x1[lane], y1 = batch->y1[lane];
    if (d->route != FAST_DEPTH_ONLY) {
        filler.number = tile->record_count++;
        write_record(d, batch, lane, &tile->records[filler.number]);
    }
    const itg lanes = lane_numbers();
    const flt low = flt_set(d->viewport.min_depth), high = flt_set(d->viewport.max_depth);
    for (int32_t y = y0; y <= y1; y++)
        for (int32_t x = x0; x <= x1; x += GP_LANES) {
            itg out = x1 - x - lanes;
            for (int i = 0; i < 3; i++)
                out |= batch->inside[i][lane] + batch->down[i][lane] * (y - y0) +
                       (lanes + (x - x0)) * batch->right[i][lane];
            unsigned live = msk_bits((itg)(out >= 0));
            if (!live)
                continue;
            flt z = low;
            if (d->wants_depth) {
                itg e[2];
                for (int i = 0; i < 2; i++)
                    e[i] = batch->edge[i + 1][lane] +
                           GP_SUBPIXELS * (batch->down[i + 1][lane] * (y - y0) +
                                           (lanes + (x - x0)) * batch->right[i + 1][lane]);
                dbl exact = batch->base[lane] + (dbl_from_itg(e[0]) * batch->step[0][lane] +
                                                 dbl_from_itg(e[1]) * batch->step[1][lane]);
                z = __builtin_convertvector(exact, flt);
                z = flt_select((msk)(z < low), low, z);
                z = flt_select((msk)(z > high), high, z);
            }
            FAST(route_lanes)(&filler, x, y, live, z);
        }
}

static void fill_alone(Tile *tile, const Batch *batch, uint32_t lane)
{
    const FastDraw *d = tile->draw;
    GpScreenVertex corner[3];
    GpTriangle triangle;
    GpRect rect = FAST(tile_rect)(tile, d);
    /* the batch may have exchanged corners 1 and 2; the facing tells how to put them back */
    bool front = batch->face[lane] > 0;
    FAST(corner_of)(d, batch->number[0][lane] + d->first_vertex, &corner[0]);
    FAST(corner_of)(d, batch->number[front ? 1 : 2][lane] + d->first_vertex, &corner[1]);
    FAST(corner_of)(d, batch->number[front ? 2 : 1][lane] + d->first_vertex, &corner[2]);
    if (gp_setup_triangle(corner, &d->draw->state.raster, &rect, &triangle) == GP_SETUP_DRAWN)
        FAST(fill_triangle)(tile, &triangle);
}

void FAST(fill_batch)(Tile *tile, const uint32_t *primitives, uint32_t count)
{
    const FastDraw *d = tile->draw;
    Batch batch;
    set_up(tile, primitives, count, &batch);
    /* what needs quads or looks at every pixel's clip distance takes the long way */
    if (d->needs.clip_planes || (d->route == FAST_ORDERED && d->needs.quads)) {
        batch.alone |= batch.drawn;
        batch.drawn = 0;
    }
    bool simple = d->route != FAST_ORDERED && !d->needs.stencil;
    itg pixels = itg_set(0);
    if (simple && (batch.tiny & batch.drawn))
        pixels = cover_tiny(&batch);
    for (unsigned left = batch.drawn | batch.alone; left; left &= left - 1) {
        uint32_t lane = (uint32_t)__builtin_ctz(left);
        FAST(reserve_records)(tile, 1);
        if (batch.alone >> lane & 1)
            fill_alone(tile, &batch, lane);
        else if (simple && (batch.tiny >> lane & 1))
            fill_tiny(tile, &batch, lane, (unsigned)pixels[lane]);
        else
            fill_small(tile, &batch, lane);
    }
}
