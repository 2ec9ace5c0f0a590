/* Convex pieces: every face in one, none in front of another's plane, exactly; what meshes keep
 * them from. */
#include "apps/fragments/pieces/pieces.h"
#include "apps/fragments/pieces/side.h"

#include "tests/support/fragments/meshes.h"
#include "tests/support/unit.h"

typedef __int128 Wide;

/* The determinant of integers, exactly. */
static int integer_side(const int32_t p[4][3])
{
    int64_t d[3][3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            d[i][k] = (int64_t)p[i + 1][k] - p[0][k];
    Wide sum = 0;
    for (int k = 0; k < 3; k++) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        sum += ((Wide)d[0][a] * d[1][b] - (Wide)d[0][b] * d[1][a]) * d[2][k];
    }
    return (sum > 0) - (sum < 0);
}

/* Whole numbers of 24 bits, nearly or wholly in one plane: doubles alone cannot tell. */
static void sides_of_planes_are_exact(void **state)
{
    (void)state;
    Random random = { 3 };
    int seen[3] = { 0 };
    for (int n = 0; n < 20000; n++) {
        int32_t p[4][3];
        float f[4][3];
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++)
                p[i][k] = 2 * random_int(&random, -(1 << 22), 1 << 22);
        for (int k = 0; k < 3; k++)
            p[3][k] = p[0][k] + (p[1][k] - p[0][k]) / 2 + (p[2][k] - p[0][k]) / 2 +
                      (n % 2 ? 0 : random_int(&random, -1, 1));
        for (int i = 0; i < 12; i++)
            f[i / 3][i % 3] = (float)p[i / 3][i % 3];
        const int side = side_of_plane(f[0], f[1], f[2], f[3]);
        assert_int_equal(side, integer_side(p));
        seen[side + 1]++;
    }
    assert_true(seen[0] > 1000 && seen[1] > 1000 && seen[2] > 1000);
}

static Pieces pieces_of(const FragmentCase *made, const PiecesSetting *setting)
{
    Pieces pieces;
    GpError error = { "" };
    if (pieces_make((const float(*)[3])made->positions, made->vertex_count, made->indices,
                    made->triangle_count, setting, NULL, NULL, &pieces, &error))
        fail_msg("%s: %s", made->name, error.text);
    return pieces;
}

static const float *corner(const FragmentCase *made, uint32_t face, uint32_t c)
{
    return made->positions[made->indices[3 * face + c]];
}

/* Corners of a piece in front of its planes. */
static uint32_t count_in_front(const FragmentCase *made, const Pieces *pieces, uint32_t piece)
{
    uint32_t count = 0;
    for (uint32_t i = pieces->first[piece]; i < pieces->first[piece + 1]; i++)
        for (uint32_t k = pieces->first[piece]; k < pieces->first[piece + 1]; k++)
            for (uint32_t c = 0; c < 3; c++) {
                const uint32_t face = pieces->faces[i];
                const int side =
                    side_of_plane(corner(made, face, 0), corner(made, face, 1),
                                  corner(made, face, 2), corner(made, pieces->faces[k], c));
                count += pieces->inward[piece] ? side < 0 : side > 0;
            }
    return count;
}

static void every_face_is_in_one_convex_piece(void **state)
{
    (void)state;
    for (int number = 0; number < FRAGMENT_CASES; number++)
        for (int merge = 0; merge < 2; merge++) {
            FragmentCase made = fragment_case(number);
            Pieces pieces = pieces_of(&made, &(PiecesSetting){ .merge = merge });
            bool *seen = gp_alloc(made.triangle_count, 1);
            for (uint32_t p = 0; p < pieces.count; p++) {
                assert_true(pieces.first[p] < pieces.first[p + 1]);
                assert_int_equal(count_in_front(&made, &pieces, p), 0);
                for (uint32_t i = pieces.first[p]; i < pieces.first[p + 1]; i++) {
                    assert_false(seen[pieces.faces[i]]);
                    assert_int_equal(pieces.piece_of[pieces.faces[i]], p);
                    seen[pieces.faces[i]] = true;
                }
            }
            assert_int_equal(pieces.first[pieces.count], made.triangle_count);
            gp_free(seen);
            pieces_free(&pieces);
            fragment_case_free(&made);
        }
}

/* A roof whose ridge is sunk a little: two sheets of 2 x 1, seen from above. */
static FragmentCase sunk_roof(float depth)
{
    FragmentCase made = { .name = "roof", .vertex_count = 6, .triangle_count = 4 };
    const float at[6][3] = { { -1, 0, 0 }, { 0, 0, -depth }, { 1, 0, 0 },
                             { -1, 1, 0 }, { 0, 1, -depth }, { 1, 1, 0 } };
    const uint32_t index[12] = { 0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4 };
    made.positions = gp_alloc(6, sizeof *made.positions);
    made.indices = gp_alloc(12, sizeof *made.indices);
    memcpy(made.positions, at, sizeof at);
    memcpy(made.indices, index, sizeof index);
    return made;
}

static void dents_are_pieces_that_are_turned_over(void **state)
{
    (void)state;
    FragmentCase made = sunk_roof(0.01f);
    Pieces outward = pieces_of(&made, &(PiecesSetting){ .outward = true });
    Pieces both = pieces_of(&made, &(PiecesSetting){ 0 });
    assert_int_equal(outward.count, 2);
    assert_int_equal(both.count, 1);
    assert_true(both.inward[0] && count_in_front(&made, &both, 0) == 0);
    pieces_free(&outward);
    pieces_free(&both);
    fragment_case_free(&made);
}

/* What a tolerance is for, and what it costs: the piece that it lets through is crossed four times
 * by a line along it, so that two of its layers are lost. */
static void tolerance_lets_concave_pieces_through(void **state)
{
    (void)state;
    FragmentCase made = sunk_roof(0.01f);
    Pieces exact = pieces_of(&made, &(PiecesSetting){ .outward = true, .tolerance = 0.004 });
    Pieces loose = pieces_of(&made, &(PiecesSetting){ .outward = true, .tolerance = 0.02 });
    assert_int_equal(exact.count, 2);
    assert_int_equal(loose.count, 1);
    assert_true(count_in_front(&made, &loose, 0) > 0);
    pieces_free(&exact);
    pieces_free(&loose);
    fragment_case_free(&made);
}

/* The floats' last bit is enough. */
static void convexity_is_exact(void **state)
{
    (void)state;
    for (int sunk = 0; sunk < 2; sunk++) {
        FragmentCase made = sunk_roof(0);
        for (uint32_t i = 0; i < made.vertex_count; i++)
            made.positions[i][2] = 1; /* flat */
        if (sunk)
            made.positions[1][2] = made.positions[4][2] = 1 - 0x1p-24f;
        Pieces pieces = pieces_of(&made, &(PiecesSetting){ .outward = true });
        assert_int_equal(pieces.count, sunk ? 2 : 1);
        pieces_free(&pieces);
        fragment_case_free(&made);
    }
}

static void merging_lowers_the_number(void **state)
{
    (void)state;
    FragmentCase made = fragment_case(0);
    Pieces plain = pieces_of(&made, &(PiecesSetting){ 0 });
    Pieces merged = pieces_of(&made, &(PiecesSetting){ .merge = true });
    assert_true(merged.count < plain.count);
    pieces_free(&plain);
    pieces_free(&merged);
    fragment_case_free(&made);
}

/* Faces in one plane that lie on each other are two layers, which no piece has on one side. */
static void twins_are_not_of_one_piece(void **state)
{
    (void)state;
    FragmentCase made = fragment_case(FRAGMENT_CASES - 1);
    assert_string_equal(made.name, "twins");
    for (int turned = 0; turned < 2; turned++) {
        if (turned) /* the second sheet as the first */
            memcpy(made.indices + 6, made.indices, 6 * sizeof *made.indices);
        Pieces pieces = pieces_of(&made, &(PiecesSetting){ .merge = true });
        for (uint32_t i = 0; i < 2; i++)
            for (uint32_t k = 2; k < 4; k++)
                assert_int_not_equal(pieces.piece_of[i], pieces.piece_of[k]);
        pieces_free(&pieces);
    }
    fragment_case_free(&made);
}

static void faults_are_told(void **state)
{
    (void)state;
    static const struct {
        uint32_t index[9];
        uint32_t faces;
        const char *faults;
    } meshes[] = {
        { { 0, 1, 2 }, 1, "3 boundary edges" },
        { { 0, 1, 1 }, 1, "1 face without area" },
        { { 0, 1, 2, 0, 1, 3 }, 2, "4 boundary edges, 1 edge at which a face is turned over" },
        { { 0, 1, 2, 1, 0, 3, 0, 1, 4 }, 3, "6 boundary edges, 1 non-manifold edge" },
    };
    static const float at[5][3] = { { 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, -1, 0 } };
    for (size_t i = 0; i < GP_COUNT(meshes); i++) {
        Pieces pieces;
        char text[200];
        assert_int_equal(pieces_make(at, 5, meshes[i].index, meshes[i].faces, &(PiecesSetting){ 0 },
                                     NULL, NULL, &pieces, NULL),
                         GP_OK);
        pieces_faults(&pieces, text, sizeof text);
        assert_string_equal(text, meshes[i].faults);
        pieces_free(&pieces);
    }
}

static bool stop_at_half(void *context, double share)
{
    *(double *)context = share;
    return share < 0.5;
}

static void work_can_be_stopped(void **state)
{
    (void)state;
    FragmentCase made = fragment_case(0);
    Pieces pieces = { .count = 7 };
    double share = 0;
    assert_int_equal(pieces_make((const float(*)[3])made.positions, made.vertex_count, made.indices,
                                 made.triangle_count, &(PiecesSetting){ 0 }, stop_at_half, &share,
                                 &pieces, NULL),
                     GP_ERROR_INVALID);
    assert_true(share >= 0.5);
    assert_int_equal(pieces.count, 7);
    fragment_case_free(&made);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sides_of_planes_are_exact),
        cmocka_unit_test(every_face_is_in_one_convex_piece),
        cmocka_unit_test(dents_are_pieces_that_are_turned_over),
        cmocka_unit_test(tolerance_lets_concave_pieces_through),
        cmocka_unit_test(convexity_is_exact),
        cmocka_unit_test(merging_lowers_the_number),
        cmocka_unit_test(twins_are_not_of_one_piece),
        cmocka_unit_test(faults_are_told),
        cmocka_unit_test(work_can_be_stopped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
