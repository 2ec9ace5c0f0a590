/* Convex pieces kept in files: what is written is read, and nothing else. */
#include "apps/fragments/pieces/pieces_cache.h"

#include "pipeline/io/file.h"
#include "tests/support/fragments/meshes.h"
#include "tests/support/unit.h"

#include <unistd.h>

enum { KEY = 77 };

static char path[] = "/tmp/test_pieces.XXXXXX";
static FragmentCase made;
static Pieces pieces;
static GpFile written;
static char bytes[] = "what others have made of them";
static const PiecesBlock kept = { bytes, sizeof bytes };

static int set_up(void **state)
{
    (void)state;
    const int handle = mkstemp(path);
    if (handle < 0)
        return -1;
    close(handle);
    made = fragment_case(0);
    return pieces_make((const float(*)[3])made.positions, made.vertex_count, made.indices,
                       made.triangle_count, &(PiecesSetting){ 0 }, NULL, NULL, &pieces, NULL) ||
           pieces_write(path, KEY, &pieces, &kept, NULL) || gp_file_read(path, &written, NULL);
}

static int tear_down(void **state)
{
    (void)state;
    gp_file_free(&written);
    pieces_free(&pieces);
    fragment_case_free(&made);
    return unlink(path);
}

static void what_is_written_is_read(void **state)
{
    (void)state;
    Pieces read;
    PiecesBlock block;
    assert_int_equal(gp_file_write(path, written.data, written.size, NULL), GP_OK);
    assert_int_equal(pieces_read(path, KEY, &read, &block, NULL), GP_OK);
    assert_int_equal(read.count, pieces.count);
    assert_int_equal(read.face_count, pieces.face_count);
    assert_memory_equal(read.piece_of, pieces.piece_of, pieces.face_count * sizeof(uint32_t));
    assert_memory_equal(read.faces, pieces.faces, pieces.face_count * sizeof(uint32_t));
    assert_memory_equal(read.first, pieces.first, (pieces.count + 1) * sizeof(uint32_t));
    assert_memory_equal(read.inward, pieces.inward, pieces.count);
    assert_int_equal(block.size, sizeof bytes);
    assert_memory_equal(block.bytes, bytes, sizeof bytes);
    gp_free(block.bytes);
    pieces_free(&read);
}

static void expect_refused(const char *reason)
{
    GpError error = { "" };
    Pieces read = { .count = 3 };
    PiecesBlock block = { NULL, 7 };
    assert_int_equal(pieces_read(path, KEY, &read, &block, &error), GP_ERROR_FORMAT);
    assert_non_null(strstr(error.text, reason));
    assert_int_equal(read.count, 3);
    assert_int_equal(block.size, 7);
}

static void other_files_are_refused(void **state)
{
    (void)state;
    Pieces read;
    PiecesBlock block;
    GpError error;
    assert_int_equal(gp_file_write(path, written.data, written.size, NULL), GP_OK);
    assert_int_equal(pieces_read(path, KEY + 1, &read, &block, &error), GP_ERROR_FORMAT);
    assert_non_null(strstr(error.text, "another mesh"));
    for (size_t at = 0; at < written.size; at += 97) {
        char was = written.data[at];
        written.data[at] ^= 4;
        assert_int_equal(gp_file_write(path, written.data, written.size, NULL), GP_OK);
        assert_int_equal(pieces_read(path, KEY, &read, &block, &error), GP_ERROR_FORMAT);
        written.data[at] = was;
    }
    assert_int_equal(gp_file_write(path, written.data, written.size - 1, NULL), GP_OK);
    expect_refused("damaged");
    assert_int_equal(gp_file_write(path, "gp", 2, NULL), GP_OK);
    expect_refused("not a cache");
}

/* A right hash over pieces that cannot be. */
static void forged_pieces_are_refused(void **state)
{
    (void)state;
    const uint32_t was = pieces.piece_of[5];
    pieces.piece_of[5] = pieces.count;
    assert_int_equal(pieces_write(path, KEY, &pieces, &kept, NULL), GP_OK);
    expect_refused("do not fit");
    pieces.piece_of[5] = was;
    pieces.inward[0] ^= 2;
    assert_int_equal(pieces_write(path, KEY, &pieces, &kept, NULL), GP_OK);
    expect_refused("do not fit");
    pieces.inward[0] ^= 2;
}

static void keys_tell_meshes_and_settings_apart(void **state)
{
    (void)state;
    static const PiecesSetting settings[] = {
        { 0 }, { .tolerance = 1e-3 }, { .outward = true }, { .merge = true }
    };
    float *const last_place = &made.positions[made.vertex_count - 1][2];
    uint32_t *const last_index = &made.indices[3 * made.triangle_count - 1];
    uint64_t keys[7];
    for (int i = 0; i < 7; i++) {
        *last_place += i == 5;
        *last_index ^= i == 6;
        keys[i] = pieces_key((const float(*)[3])made.positions, made.vertex_count, made.indices,
                             made.triangle_count - (i == 4), &settings[i < 4 ? i : 0]);
        for (int k = 0; k < i; k++)
            assert_true(keys[k] != keys[i]);
    }
    *last_place -= 1;
    *last_index ^= 1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read),
        cmocka_unit_test(other_files_are_refused),
        cmocka_unit_test(forged_pieces_are_refused),
        cmocka_unit_test(keys_tell_meshes_and_settings_apart),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
