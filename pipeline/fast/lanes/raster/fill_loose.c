/* Triangles of a few pixels that are shaded in order, without depth: their pixels, loose, side by side
 * in mixes. A pixel is at most once in a mix, so that what blends with it comes in a later one. */
#include "pipeline/fast/lanes/raster/batch.h"
#include "pipeline/fast/lanes/shade/patch.h"

/* The mix at the end of the queue. */
typedef struct Loose {
    Tile *tile;
    FastPatch *patch; /* NULL: none yet */
    FastMix *mix;
    int count;
    itg at; /* as the mix's own, which is written lane by lane */
} Loose;

/* The last mix may have room; the triangles of a mix face one way. */
static Loose last_mix(Tile *tile)
{
    Loose loose = { .tile = tile };
    FastPatch *last = tile->patch_count ? &tile->patches[tile->patch_count - 1] : NULL;
    if (!last || !last->mixed)
        return loose;
    loose.patch = last;
    loose.mix = &tile->mixes[tile->patch_count - 1];
    loose.count = __builtin_popcount(last->live);
    loose.at = loose.mix->at;
    return loose;
}

/* What is left over at the end repeats a live triangle, outside the tile. */
static void begin_mix(Loose *loose, uint32_t record)
{
    Tile *tile = loose->tile;
    loose->patch = FAST(new_patch)(tile);
    *loose->patch =
        (FastPatch){ .record = record, .y = FAST_TILE, .wide = GP_LANES, .mixed = true };
    loose->mix = &tile->mixes[loose->patch - tile->patches];
    loose->count = 0;
    loose->at = itg_set((int32_t)fast_at(0, FAST_TILE));
    *loose->mix = (FastMix){ .record = itg_set((int32_t)record), .at = loose->at, .packed = true };
}

GP_INLINE void add_pixel(Loose *loose, uint32_t record, int32_t x, int32_t y)
{
    const int32_t at = (int32_t)fast_at(x, y);
    if (!loose->patch || loose->count == GP_LANES || msk_any(loose->at == at))
        begin_mix(loose, record);
    FastMix *mix = loose->mix;
    const int lane = loose->count++;
    loose->at = itg_select((msk)(lane_numbers() == lane), itg_set(at), loose->at);
    ((int32_t *)&mix->record)[lane] = (int32_t)record;
    ((int32_t *)&mix->x)[lane] = x;
    ((int32_t *)&mix->y)[lane] = y;
    ((int32_t *)&mix->at)[lane] = at;
    mix->live = loose->patch->live = (1u << loose->count) - 1;
}

void FAST(fill_loose)(const Filler *f, const Batch *b, unsigned lanes)
{
    Tile *tile = f->tile;
    Loose loose = last_mix(tile);
    for (unsigned left = lanes & msk_bits((msk)(b->covered != 0)); left; left &= left - 1) {
        const uint32_t lane = (uint32_t)__builtin_ctz(left), number = tile->record_count++;
        FAST(write_record)(f->d, b, lane, &tile->records[number]);
        if (loose.patch && tile->records[loose.patch->record].face != tile->records[number].face)
            loose.patch = NULL;
        for (uint32_t pixels = (uint32_t)b->covered[lane]; pixels; pixels &= pixels - 1) {
            const int32_t bit = __builtin_ctz(pixels);
            add_pixel(&loose, number, b->x[lane] + (bit & 3), b->y[lane] + (bit >> 2));
        }
    }
}
