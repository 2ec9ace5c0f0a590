/* What parts convex pieces: facts of single pairs, and of all pairs of small meshes. */
#include "apps/fragments/order/graph.h"
#include "apps/fragments/order/parting.h"

#include "tests/support/fragments/meshes.h"
#include "tests/support/unit.h"

#include <float.h>
#include <math.h>

typedef struct Made {
    FragmentCase mesh_case;
    FragmentMesh mesh;
    Pieces pieces;
    OrderMesh order;
    Partings partings;
} Made;

static void make(int number, Made *made)
{
    made->mesh_case = fragment_case(number);
    made->mesh = fragment_case_mesh(&made->mesh_case);
    assert_int_equal(pieces_make(made->mesh.positions, made->mesh.vertex_count, made->mesh.indices,
                                 made->mesh.triangle_count, &(PiecesSetting){ 0 }, NULL, NULL,
                                 &made->pieces, NULL),
                     GP_OK);
    assert_int_equal(order_mesh_make(&made->mesh, &made->pieces, &made->order, NULL), GP_OK);
    assert_int_equal(partings_make(&made->order, NULL, NULL, &made->partings, NULL), GP_OK);
}

static void unmake(Made *made)
{
    partings_free(&made->partings);
    order_mesh_free(&made->order);
    pieces_free(&made->pieces);
    fragment_case_free(&made->mesh_case);
}

/* How far a face's corners are in front of a plane. */
static void ends_of(const Made *made, uint32_t face, const double plane[4], double ends[2])
{
    ends[0] = DBL_MAX;
    ends[1] = -DBL_MAX;
    for (uint32_t c = 0; c < 3; c++) {
        const float *at = made->mesh.positions[made->mesh.indices[3 * face + c]];
        const double in_front = plane[0] * (double)at[0] + plane[1] * (double)at[1] +
                                plane[2] * (double)at[2] - plane[3];
        ends[0] = fmin(ends[0], in_front);
        ends[1] = fmax(ends[1], in_front);
    }
}

/* Those that are left of two pieces are on their sides of the plane; of those that have left for
 * the slab of two, each is of one of them. */
static void planes_have_what_is_left_of_pieces_on_their_sides(void **state)
{
    (void)state;
    for (int number = 0; number < FRAGMENT_CASES; number++) {
        Made made;
        uint32_t left = 0, beyond = 0;
        make(number, &made);
        for (uint32_t i = 0; i < made.partings.count; i++) {
            const Parting *parting = &made.partings.list[i];
            for (uint32_t f = 0; f < made.mesh.triangle_count && parting->kind != PARTING_NESTED;
                 f++) {
                const uint32_t piece = made.pieces.piece_of[f];
                double ends[2];
                if ((piece != parting->low && piece != parting->high) ||
                    made.partings.slab_of[f] != NO_SLAB)
                    continue;
                ends_of(&made, f, parting->plane, ends);
                beyond += piece == parting->low ? ends[1] > 1e-9 : ends[0] < -1e-9;
                left++;
            }
        }
        if (beyond > 0)
            fail_msg("%s: %u of %u faces are beyond planes", made.mesh_case.name, beyond, left);
        unmake(&made);
    }
}

static void faces_leave_to_slabs_of_their_own_pieces(void **state)
{
    (void)state;
    Made made;
    uint32_t left = 0;
    make(0, &made);
    for (uint32_t i = 0; i < made.partings.count; i++)
        for (uint32_t f = 0; f < made.mesh.triangle_count; f++) {
            const Parting *parting = &made.partings.list[i];
            if (parting->slab == NO_SLAB || made.partings.slab_of[f] != parting->slab)
                continue;
            assert_true(made.pieces.piece_of[f] == parting->low ||
                        made.pieces.piece_of[f] == parting->high);
            left++;
        }
    assert_true(left > 0);
    for (uint32_t f = 0; f < made.mesh.triangle_count; f++)
        left -= made.partings.slab_of[f] != NO_SLAB;
    assert_int_equal(left, 0);
    unmake(&made);
}

/* Four balls in each other, the outer first; seven sheets about an axis. */
static void balls_are_nested_and_sheets_have_planes(void **state)
{
    (void)state;
    Made made;
    make(2, &made);
    assert_int_equal(made.partings.count, 6);
    for (uint32_t i = 0; i < 6; i++) {
        const Parting *parting = &made.partings.list[i];
        const PieceSpan *outer = &made.order.spans[parting->low];
        assert_int_equal(parting->kind, PARTING_NESTED);
        assert_true(outer->high[0] > made.order.spans[parting->high].high[0]);
        assert_ptr_equal(parting_of(&made.partings, parting->low, parting->high), parting);
        assert_ptr_equal(parting_of(&made.partings, parting->high, parting->low), parting);
    }
    unmake(&made);
    make(5, &made);
    assert_int_equal(made.partings.slab_count, 0);
    unmake(&made);
}

static void what_is_packed_is_the_same_again(void **state)
{
    (void)state;
    Made made;
    PiecesBlock block;
    Partings again = { .count = 0 };
    make(0, &made);
    assert_int_equal(partings_pack(&made.partings, &block), GP_OK);
    assert_int_equal(partings_unpack(&block, &made.pieces, &again), GP_OK);
    assert_int_equal(again.count, made.partings.count);
    assert_memory_equal(again.list, made.partings.list, again.count * sizeof *again.list);
    assert_memory_equal(again.slab_of, made.partings.slab_of,
                        again.face_count * sizeof *again.slab_of);
    partings_free(&again);
    const PiecesBlock shorter = { block.bytes, block.size - 1 };
    assert_int_equal(partings_unpack(&shorter, &made.pieces, &again), GP_ERROR_FORMAT);
    uint32_t *last = (uint32_t *)(void *)((char *)block.bytes + block.size - sizeof *last);
    *last = made.partings.slab_count;
    assert_int_equal(partings_unpack(&block, &made.pieces, &again), GP_ERROR_FORMAT);
    assert_int_equal(again.count, 0);
    gp_free(block.bytes);
    unmake(&made);
}

/* 0 before 1 before 2, which are in a circle with 3; 4 before 0. */
static void circles_are_cut_at_the_first_of_them(void **state)
{
    (void)state;
    static const uint32_t edges[][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 1 }, { 4, 0 } };
    static const uint32_t nodes[5] = { 2, 3, 1, 0, 4 }, expected[5] = { 4, 0, 2, 3, 1 };
    Pairs pairs = { .pair = NULL };
    Graph graph;
    uint32_t sequence[5], cuts;
    for (size_t i = 0; i < GP_COUNT(edges); i++)
        pairs_add(&pairs, edges[i][0], edges[i][1]);
    assert_int_equal(graph_make(5, &pairs, &graph), GP_OK);
    assert_int_equal(graph_sequence(&graph, nodes, sequence, &cuts), GP_OK);
    assert_memory_equal(sequence, expected, sizeof expected);
    assert_int_equal(cuts, 1);
    pairs_free(&pairs);
    graph_free(&graph);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes_have_what_is_left_of_pieces_on_their_sides),
        cmocka_unit_test(faces_leave_to_slabs_of_their_own_pieces),
        cmocka_unit_test(balls_are_nested_and_sheets_have_planes),
        cmocka_unit_test(what_is_packed_is_the_same_again),
        cmocka_unit_test(circles_are_cut_at_the_first_of_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
