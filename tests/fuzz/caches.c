/* Caches: models and trees of points, convex pieces of meshes. The hash and the sizes in their
 * heads are made right, so that what is forged behind them is met. */
#include "apps/base/content.h"
#include "apps/fragments/pieces/pieces_cache.h"
#include "apps/points/cache.h"
#include "tests/fuzz/targets.h"
#include "tests/support/fragments/meshes.h"
#include "tests/support/surfel_shapes.h"

#include <string.h>

enum {
    KEY = 77,
    MOST = 16384,
    /* of cache.c's head: its bytes, and where the file's size and its hash are */
    POINTS_HEAD = 120,
    POINTS_SIZE = 24,
    POINTS_HASH = 32,
    PIECES_HEAD = 64, /* of pieces_cache.c's */
    PIECES_HASH = 24,
};

/* The bytes with the hash of a head that has 0 there, and of all behind it. */
static const uint8_t *with_hash(const uint8_t *data, size_t size, size_t head, size_t at)
{
    static uint8_t bytes[MOST];
    memcpy(bytes, data, size);
    if (size < head)
        return bytes;
    memset(bytes + at, 0, 8);
    const uint64_t hash =
        content_hash_bytes(bytes + head, size - head, content_hash_bytes(bytes, head, 0));
    memcpy(bytes + at, &hash, sizeof hash);
    return bytes;
}

/* --- points ----------------------------------------------------------------------------------- */

/* Reads all that a model refers to. */
static void use(const PackedModel *model)
{
    const Patches *patches = &model->patches;
    float sum = 0;
    for (uint32_t p = 0; p < patches->patch_count; p++) {
        const Patch *patch = &patches->patches[p];
        const PatchLevel *levels = patch_levels(patches, patch);
        for (uint32_t k = 0; k < patch->level_count; k++) {
            const uint32_t done = k + 1 < patch->level_count ? levels[k].count / 2 : 0;
            const PatchWindow window = patch_window(patches, patch, k, done);
            for (uint32_t i = window.first; i < window.first + window.count; i++) {
                if (model->patches.surfels)
                    sum += model->patches.surfels[i].radius;
                if (model->compressed.words)
                    sum += compressed_surfel(&model->compressed, p, i).radius;
            }
        }
    }
    fuzz_claim(sum != 0 || sum == 0 || sum != sum, "a sum is something");
}

static bool run_points(const uint8_t *data, size_t size)
{
    if (size < POINTS_HEAD || size > MOST)
        return false;
    static uint8_t sized[MOST];
    const uint64_t whole = size;
    memcpy(sized, data, size);
    memcpy(sized + POINTS_SIZE, &whole, sizeof whole);
    const uint8_t *bytes = with_hash(sized, size, POINTS_HEAD, POINTS_HASH);
    PackedModel model = { .file = { NULL, 0 } };
    GpError error = { "" };
    if (!fuzz_accepted(cache_read(fuzz_file(".points", bytes, size), KEY, &model, &error), &error))
        return false;
    use(&model);
    packed_model_free(&model);
    return true;
}

static void seeds_points(const FuzzSeeds *to)
{
    const PatchLimits limits = { .most_leaves = 40, .least_leaves = 8 };
    GpPool *pool;
    Surfels surfels;
    GpError error;
    fuzz_claim(gp_pool_create(1, &pool, &error) == GP_OK, "there are threads");
    shape_sphere(&surfels, 90);
    for (CompressForm form = 0; form < COMPRESS_FORMS; form++) {
        PackedModel model = { .file = { NULL, 0 } };
        const char *path = fuzz_path(".points");
        if (patches_build(&surfels, &limits, pool, NULL, &model.patches, &error) == GP_OK &&
            patches_compress(&model.patches, form, pool, &model.compressed) == GP_OK &&
            cache_write(path, KEY, &model, &error) == GP_OK)
            fuzz_seed_file(to, form == COMPRESS_OURS ? "ours" : "printed", path);
        packed_model_free(&model);
    }
    surfels_free(&surfels);
    gp_pool_destroy(&pool);
}

/* --- pieces ----------------------------------------------------------------------------------- */

static bool run_pieces(const uint8_t *data, size_t size)
{
    if (size > MOST)
        return false;
    const uint8_t *bytes = with_hash(data, size, PIECES_HEAD, PIECES_HASH);
    Pieces pieces = { .count = 0 };
    PiecesBlock block = { NULL, 0 };
    GpError error = { "" };
    const GpResult result =
        pieces_read(fuzz_file(".pieces", bytes, size), KEY, &pieces, &block, &error);
    if (!fuzz_accepted(result, &error))
        return false;
    for (uint32_t p = 0; p < pieces.count; p++)
        for (uint32_t i = pieces.first[p]; i < pieces.first[p + 1]; i++)
            fuzz_claim(pieces.piece_of[pieces.faces[i]] == p, "faces are of their piece");
    gp_free(block.bytes);
    pieces_free(&pieces);
    return true;
}

static void seeds_pieces(const FuzzSeeds *to)
{
    FragmentCase mesh = fragment_case(0);
    Pieces pieces;
    GpError error;
    const char *path = fuzz_path(".pieces");
    const PiecesBlock block = { (void *)(uintptr_t) "kept", 4 };
    if (pieces_make((const float(*)[3])mesh.positions, mesh.vertex_count, mesh.indices,
                    mesh.triangle_count, &(PiecesSetting){ 0 }, NULL, NULL, &pieces,
                    &error) == GP_OK &&
        pieces_write(path, KEY, &pieces, &block, &error) == GP_OK)
        fuzz_seed_file(to, "one", path);
    pieces_free(&pieces);
    fragment_case_free(&mesh);
}

const FuzzTarget fuzz_cache = { "cache", MOST, run_points, seeds_points, NULL };
const FuzzTarget fuzz_pieces = { "pieces", MOST, run_pieces, seeds_pieces, NULL };
