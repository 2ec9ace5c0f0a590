/* Models kept in files: what is written is read, and nothing else. */
#include "apps/base/content.h"
#include "apps/points/cache.h"

#include "tests/support/surfel_shapes.h"
#include "tests/support/unit.h"

#include <unistd.h>

static GpPool *pool;
static PackedModel model;
static GpFile written; /* the cache's bytes */
static char path[] = "/tmp/test_cache.XXXXXX";

enum { KEY = 77 };

static void put(const void *data, size_t size)
{
    assert_int_equal(gp_file_write(path, data, size, NULL), GP_OK);
}

static int set_up(void **state)
{
    (void)state;
    Surfels surfels;
    const int handle = mkstemp(path);
    if (handle < 0 || gp_pool_create(2, &pool, NULL))
        return -1;
    close(handle);
    shape_torus(&surfels, 3000, 0.3);
    const PatchLimits limits = { .most_leaves = 600, .least_leaves = 60 };
    if (patches_build(&surfels, &limits, pool, NULL, &model.patches, NULL) ||
        patches_compress(&model.patches, COMPRESS_OURS, pool, &model.compressed))
        return -1;
    surfels_free(&surfels);
    return cache_write(path, KEY, &model, NULL) || gp_file_read(path, &written, NULL);
}

static int tear_down(void **state)
{
    (void)state;
    unlink(path);
    gp_file_free(&written);
    packed_model_free(&model);
    gp_pool_destroy(&pool);
    return 0;
}

static void assert_same(const PackedModel *a, const PackedModel *b)
{
    const Compressed *x = &a->compressed, *y = &b->compressed;
    assert_int_equal(a->patches.patch_count, b->patches.patch_count);
    assert_int_equal(a->patches.level_count, b->patches.level_count);
    assert_int_equal(a->patches.leaf_count, b->patches.leaf_count);
    assert_int_equal(a->patches.surfel_count, b->patches.surfel_count);
    assert_int_equal(a->patches.has_colors, b->patches.has_colors);
    assert_memory_equal(&a->patches.bounds, &b->patches.bounds, sizeof a->patches.bounds);
    assert_memory_equal(a->patches.patches, b->patches.patches,
                        a->patches.patch_count * sizeof(Patch));
    assert_memory_equal(a->patches.levels, b->patches.levels,
                        a->patches.level_count * sizeof(PatchLevel));
    assert_int_equal(x->form, y->form);
    assert_int_equal(x->surfel_count, y->surfel_count);
    assert_int_equal(!a->patches.surfels, !b->patches.surfels);
    assert_int_equal(!x->words, !y->words);
    if (a->patches.surfels)
        assert_memory_equal(a->patches.surfels, b->patches.surfels,
                            a->patches.surfel_count * sizeof(Surfel));
    if (x->words) {
        assert_memory_equal(x->words, y->words, (size_t)x->surfel_count * COMPRESSED_BYTES);
        assert_memory_equal(x->frames, y->frames, a->patches.patch_count * sizeof *x->frames);
    }
    assert_memory_equal(x->radii, y->radii, sizeof x->radii);
    assert_int_equal(!x->colors, !y->colors);
    if (x->colors)
        assert_memory_equal(x->colors, y->colors, (size_t)x->surfel_count * 3);
}

static void what_is_written_is_read(void **state)
{
    (void)state;
    for (int i = 0; i < 6; i++) {
        PackedModel made = { .patches = { .surfels = NULL } }, read;
        Surfels surfels;
        shape_torus(&surfels, i < 2 ? 3 : 9000, 0.3);
        surfels.had_colors = i % 2;
        assert_int_equal(patches_build(&surfels, NULL, pool, NULL, &made.patches, NULL), GP_OK);
        const CompressForm form = i == 2 ? COMPRESS_PRINTED : COMPRESS_OURS;
        if (i < 5) /* with surfels and words, words only, surfels only */
            assert_int_equal(patches_compress(&made.patches, form, pool, &made.compressed), GP_OK);
        if (i < 4) {
            gp_free(made.patches.surfels);
            made.patches.surfels = NULL;
        }
        assert_int_equal(cache_write(path, KEY, &made, NULL), GP_OK);
        assert_int_equal(cache_read(path, KEY, &read, NULL), GP_OK);
        assert_same(&made, &read);
        assert_int_equal((uintptr_t)read.compressed.words % 64, 0);
        assert_int_equal((uintptr_t)read.patches.surfels % 64, 0);
        packed_model_free(&read);
        assert_null(read.file.data);
        packed_model_free(&made);
        surfels_free(&surfels);
    }
}

static void assert_refused(uint64_t key, const char *reason)
{
    PackedModel none = { .patches = { .patch_count = 5 } };
    GpError error;
    assert_int_equal(cache_read(path, key, &none, &error), GP_ERROR_FORMAT);
    assert_int_equal(none.patches.patch_count, 5);
    assert_non_null(strstr(error.text, path));
    if (!strstr(error.text, reason))
        fail_msg("\"%s\" instead of \"%s\"", error.text, reason);
}

/* Each class of bytes: mark, version, sizes, key, length, hash, counts, and every section. */
static void every_changed_byte_is_seen(void **state)
{
    (void)state;
    char *copy = gp_alloc(written.size, 1);
    for (size_t at = 0; at < written.size; at += at < 256 ? 1 : 61) {
        memcpy(copy, written.data, written.size);
        copy[at] ^= 0x10;
        put(copy, written.size);
        assert_refused(KEY, at < 8    ? "not a cache of points"
                            : at < 16 ? "another version"
                            : at < 24 ? "another model or of other settings"
                            : at < 32 ? "" /* longer or shorter than it says */
                                      : "damaged");
    }
    gp_free(copy);
}

/* Put into a copy of the file, whose hash is made right again; the head has 120 bytes, its hash at
 * 32. */
static void forge(size_t at, const void *value, size_t size)
{
    enum { HEAD = 120, HASH = 32 };
    char *copy = gp_alloc(written.size, 1);
    memcpy(copy, written.data, written.size);
    memcpy(copy + at, value, size);
    memset(copy + HASH, 0, sizeof(uint64_t));
    const uint64_t hash =
        content_hash_bytes(copy + HEAD, written.size - HEAD, content_hash_bytes(copy, HEAD, 0));
    memcpy(copy + HASH, &hash, sizeof hash);
    put(copy, written.size);
    gp_free(copy);
}

/* A node below the leaves was shifted by less than nothing. */
static void forged_patches_are_refused(void **state)
{
    (void)state;
    const size_t first = 128; /* the first patch: behind the head, at a multiple of 64 */
    PackedModel read;
    forge(first, model.patches.patches, sizeof(Patch));
    assert_int_equal(cache_read(path, KEY, &read, NULL), GP_OK);
    packed_model_free(&read);
    for (uint32_t depth = 12; depth <= 40; depth++) {
        Patch patch = model.patches.patches[0];
        patch.depth = depth;
        forge(first, &patch, sizeof patch);
        assert_refused(KEY, "its parts do not fit together");
    }
}

/* Leaves without a patch that has them: what draws looks at the first. */
static void a_forged_cache_without_patches_is_refused(void **state)
{
    (void)state;
    enum { HEAD = 120, SIZE = 24, HASH = 32, COUNTS = 40, MOST = 2048 };
    char copy[MOST] = { 0 };
    for (uint64_t size = HEAD; size <= MOST; size++) { /* of one, sections fit */
        memcpy(copy, written.data, HEAD);
        memset(copy + HEAD, 0, sizeof copy - HEAD);
        memset(copy + COUNTS, 0, 3 * sizeof(uint32_t)); /* surfels, patches and levels */
        memcpy(copy + SIZE, &size, sizeof size);
        memset(copy + HASH, 0, sizeof(uint64_t));
        const uint64_t hash =
            content_hash_bytes(copy + HEAD, size - HEAD, content_hash_bytes(copy, HEAD, 0));
        memcpy(copy + HASH, &hash, sizeof hash);
        put(copy, size);
        assert_refused(KEY, "its parts do not fit together");
    }
}

static void every_length_but_the_right_one_is_refused(void **state)
{
    (void)state;
    for (size_t size = 0; size < written.size; size += size < 300 ? 1 : 997) {
        put(written.data, size);
        assert_refused(KEY, size < 120 /* the head */ ? "not a cache of points" : "truncated");
    }
    char *longer = gp_alloc(written.size + 1, 1);
    memcpy(longer, written.data, written.size);
    put(longer, written.size + 1);
    assert_refused(KEY, "damaged");
    gp_free(longer);
    put("", 0);
    assert_refused(KEY, "not a cache of points");
}

static void a_foreign_cache_is_refused_and_may_be_written_over(void **state)
{
    (void)state;
    PackedModel read;
    put(written.data, written.size);
    assert_refused(KEY + 1, "another model or of other settings");
    assert_int_equal(cache_write(path, KEY + 1, &model, NULL), GP_OK);
    assert_int_equal(cache_read(path, KEY + 1, &read, NULL), GP_OK);
    assert_same(&model, &read);
    packed_model_free(&read);
    GpError error;
    assert_int_equal(cache_read("/nowhere/at/all", KEY, &read, &error), GP_ERROR_IO);
    assert_int_equal(cache_write("/nowhere/at/all", KEY, &model, &error), GP_ERROR_IO);
}

static void keys_tell_inputs_and_settings_apart(void **state)
{
    (void)state;
    assert_true(cache_key(1, "subdivide 1") != cache_key(2, "subdivide 1"));
    assert_true(cache_key(1, "subdivide 1") != cache_key(1, "subdivide 2"));
    assert_true(cache_key(1, "subdivide 1") == cache_key(1, "subdivide 1"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read),
        cmocka_unit_test(every_changed_byte_is_seen),
        cmocka_unit_test(forged_patches_are_refused),
        cmocka_unit_test(a_forged_cache_without_patches_is_refused),
        cmocka_unit_test(every_length_but_the_right_one_is_refused),
        cmocka_unit_test(a_foreign_cache_is_refused_and_may_be_written_over),
        cmocka_unit_test(keys_tell_inputs_and_settings_apart),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
