/* Volumes put together: flat textures against the same operations on plain arrays of voxels. */
#include "apps/techniques/voxel/volume/combine.h"
#include "tests/support/devices.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

/* Odd sizes: slabs that are not full, patches that end inside tiles. */
static const uint32_t sizes[] = { 8, 33, 45, 64 };

enum { MOST_BYTES = 64 * 64 * 64 };

static uint8_t voxels_a[MOST_BYTES], voxels_b[MOST_BYTES], voxels_result[MOST_BYTES];

static void fill_flat(const FlatTexture *flat, Random *random)
{
    const GpLevel *level = &flat->texels->level[0];
    for (size_t i = 0; i < level->pitch * level->height; i++)
        level->texels[i] = (uint8_t)random_bits(random);
}

static uint8_t combine_bytes(uint8_t a, uint8_t b, VoxelCombine operation, uint32_t bits)
{
    const uint8_t rest = (uint8_t)~b;
    if (bits == 1)
        return operation == VOXEL_UNION          ? a | b
               : operation == VOXEL_INTERSECTION ? a & b
                                                 : a & rest;
    const uint8_t least = operation == VOXEL_DIFFERENCE ? rest : b;
    return operation == VOXEL_UNION ? (a > b ? a : b) : (a < least ? a : least);
}

typedef struct Case {
    uint32_t size, bits;
    VoxelCombine operation;
    bool in_place;
} Case;

static void check_case(const Case *c)
{
    Random random = { 77 + c->size };
    Frame frame = { .color = NULL };
    const FlatTexture a = flat_texture_make(&frame, c->size, c->bits);
    const FlatTexture b = flat_texture_make(&frame, c->size, c->bits);
    const FlatTexture other = flat_texture_make(&frame, c->size, c->bits);
    const FlatTexture *result = c->in_place ? &a : &other;
    fill_flat(&a, &random);
    fill_flat(&b, &random);
    flat_texture_read(&a, voxels_a);
    flat_texture_read(&b, voxels_b);
    voxel_combine(&frame, &a, &b, c->operation, result);
    run_everywhere(&frame);
    const size_t bytes = flat_texture_bytes(&a), whole = bytes - (c->bits == 1);
    flat_texture_read(result, voxels_result);
    for (size_t i = 0; i < whole; i++) /* of bits the last byte may not be full */
        assert_int_equal(voxels_result[i],
                         combine_bytes(voxels_a[i], voxels_b[i], c->operation, c->bits));
    flat_texture_read(&b, voxels_result); /* operands stay */
    assert_memory_equal(voxels_result, voxels_b, bytes);
    frame_free(&frame);
}

static void volumes_combine_as_their_voxels_do(void **state)
{
    (void)state;
    for (size_t s = 0; s < GP_COUNT(sizes); s++)
        for (int way = 0; way < 12; way++) {
            const Case c = { sizes[s], way & 1 ? 8 : 1, (VoxelCombine)(way / 4), (way & 2) != 0 };
            check_case(&c);
        }
}

/* a and not (b or c), where b is drawn by the list before it is an operand. */
static void operands_may_be_results_of_the_same_list(void **state)
{
    (void)state;
    enum { SIZE = 45 };
    static uint8_t voxels_c[MOST_BYTES];
    Random random = { 31 };
    Frame frame = { .color = NULL };
    const FlatTexture a = flat_texture_make(&frame, SIZE, 1),
                      b = flat_texture_make(&frame, SIZE, 1);
    const FlatTexture c = flat_texture_make(&frame, SIZE, 1),
                      result = flat_texture_make(&frame, SIZE, 1);
    fill_flat(&a, &random);
    fill_flat(&b, &random);
    fill_flat(&c, &random);
    flat_texture_read(&a, voxels_a);
    flat_texture_read(&b, voxels_b);
    flat_texture_read(&c, voxels_c);
    voxel_combine(&frame, &b, &c, VOXEL_UNION, &b);
    voxel_combine(&frame, &a, &b, VOXEL_DIFFERENCE, &result);
    run_everywhere(&frame);
    flat_texture_read(&result, voxels_result);
    for (size_t i = 0; i + 1 < flat_texture_bytes(&a); i++)
        assert_int_equal(voxels_result[i], voxels_a[i] & (uint8_t) ~(voxels_b[i] | voxels_c[i]));
    frame_free(&frame);
}

/* --- collision -------------------------------------------------------------------------------- */

static bool is_inside(const VoxelRange *range, uint32_t x, uint32_t y, uint32_t z)
{
    return x >= range->low[0] && x < range->end[0] && y >= range->low[1] && y < range->end[1] &&
           z >= range->low[2] && z < range->end[2];
}

/* The same of voxels that share texels with some inside. */
static bool is_drawn(const VoxelRange *range, uint32_t x, uint32_t y, uint32_t z)
{
    VoxelRange whole = *range;
    whole.low[2] = range->low[2] / 32 * 32;
    whole.end[2] = (range->end[2] + 31) / 32 * 32;
    return !voxel_range_is_empty(range) && is_inside(&whole, x, y, z);
}

/* Inside the range both, outside what was there; and the count is that of the voxels inside. */
static void check_collision(uint32_t size, const VoxelRange *range, bool in_place)
{
    Random random = { 5 + size };
    Frame frame = { .color = NULL };
    const FlatTexture a = flat_texture_make(&frame, size, 1),
                      b = flat_texture_make(&frame, size, 1);
    const FlatTexture other = flat_texture_make(&frame, size, 1);
    const FlatTexture *result = in_place ? &a : &other;
    fill_flat(&a, &random);
    fill_flat(&b, &random);
    flat_texture_read(&a, voxels_a);
    flat_texture_read(&b, voxels_b);
    voxel_collide(&frame, &a, &b, range, result);
    run_everywhere(&frame);
    uint64_t both = 0;
    flat_texture_read(result, voxels_result);
    for (uint32_t z = 0; z < size; z++)
        for (uint32_t y = 0; y < size; y++)
            for (uint32_t x = 0; x < size; x++) {
                const bool meet =
                    voxel_at(voxels_a, size, x, y, z) && voxel_at(voxels_b, size, x, y, z);
                const bool before = in_place && voxel_at(voxels_a, size, x, y, z);
                both += meet && is_inside(range, x, y, z);
                assert_int_equal(voxel_at(voxels_result, size, x, y, z),
                                 is_drawn(range, x, y, z) ? meet : before);
            }
    assert_int_equal(voxel_count_range(result, range), both);
    frame_free(&frame);
}

static void collisions_are_found_inside_the_range(void **state)
{
    (void)state;
    static const struct {
        uint32_t size;
        VoxelRange range;
    } cases[] = {
        { 33, { { 0, 0, 0 }, { 33, 33, 33 } } },   { 64, { { 5, 17, 30 }, { 41, 18, 35 } } },
        { 45, { { 44, 0, 32 }, { 45, 45, 45 } } }, { 64, { { 0, 3, 1 }, { 64, 64, 2 } } },
        { 64, { { 7, 7, 7 }, { 40, 7, 9 } } }, /* empty */
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        for (int in_place = 0; in_place < 2; in_place++)
            check_collision(cases[i].size, &cases[i].range, in_place);
}

static void ranges_hold_their_models(void **state)
{
    (void)state;
    /* turned by a right angle about z, twice as large, moved */
    float to_voxels[4][4] = {
        { 0, -2, 0, 20 }, { 2, 0, 0, 3.5f }, { 0, 0, 2, -4 }, { 0, 0, 0, 1 }
    };
    const double low[3] = { 1.25, -1.75, 0 }, high[3] = { 4.3, 2.2, 50 };
    const VoxelRange range = voxel_range(low, high, to_voxels, 64);
    const VoxelRange expected = { { 15, 5, 0 }, { 24, 13, 64 } };
    assert_memory_equal(&range, &expected, sizeof range);
    const VoxelRange other = { { 20, 0, 60 }, { 64, 8, 64 } },
                     apart = { { 30, 0, 0 }, { 64, 8, 64 } };
    const VoxelRange common = voxel_range_common(&range, &other);
    const VoxelRange both = { { 20, 5, 60 }, { 24, 8, 64 } };
    assert_memory_equal(&common, &both, sizeof common);
    const VoxelRange none = voxel_range_common(&range, &apart);
    assert_true(voxel_range_is_empty(&none) && !voxel_range_is_empty(&common));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(volumes_combine_as_their_voxels_do),
        cmocka_unit_test(operands_may_be_results_of_the_same_list),
        cmocka_unit_test(collisions_are_found_inside_the_range),
        cmocka_unit_test(ranges_hold_their_models),
    };
    return cmocka_run_group_tests_name("voxel combine", tests, NULL, NULL);
}
