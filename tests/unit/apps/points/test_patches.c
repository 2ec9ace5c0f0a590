/* The tree, its patches and their levels. */
#define POOL_THREADS 2
#include "apps/points/patches.h"
#include "apps/points/summary.h"

#include "apps/base/vector.h"
#include "pipeline/io/file.h"
#include "pipeline/io/mesh/mesh_file.h"
#include "tests/support/groups/pool.h"
#include "tests/support/surfel_shapes.h"
#include "tests/support/unit.h"

enum { SPHERE, TORUS, DUST, THIN, SHAPES };

static void make_shape(int shape, uint32_t count, Surfels *surfels)
{
    if (shape == SPHERE)
        shape_sphere(surfels, count);
    else if (shape == DUST)
        shape_dust(surfels, count, 7);
    else
        shape_torus(surfels, count, shape == TORUS ? 0.3 : 0.001);
    assert_non_null(surfels->surfels);
}

static void widen(const float from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (double)from[i];
}

/* --- the tree --------------------------------------------------------------------------------- */

static void the_tree_is_complete(void **state)
{
    (void)state;
    for (uint32_t leaves = 1; leaves < 3000; leaves += leaves < 100 ? 1 : 37) {
        const int depth = tree_depth(leaves);
        assert_int_equal(depth < 0, leaves < 4);
        for (int d = 0; d <= depth; d++) {
            assert_int_equal(tree_bound(leaves, d, 0), 0);
            assert_int_equal(tree_bound(leaves, d, 1u << d), leaves);
            for (uint64_t node = 0; node < 1u << d; node++) {
                const uint32_t size = tree_bound(leaves, d, node + 1) - tree_bound(leaves, d, node);
                assert_in_range(size, leaves >> d, (leaves >> d) + 1);
                assert_int_equal(tree_bound(leaves, d, node), tree_bound(leaves, d + 1, 2 * node));
            }
        }
        if (depth >= 0)
            assert_in_range(leaves >> depth, 4, 7);
    }
    assert_int_equal(tree_bound(UINT32_MAX, 29, 1u << 29), UINT32_MAX);
}

/* The halves of a node lie on two sides of a plane square to the axis of their largest spread. */
static void halves_are_parted_by_a_plane(void **state)
{
    (void)state;
    for (int shape = 0; shape < SHAPES; shape++) {
        Surfels surfels;
        make_shape(shape, 3001, &surfels);
        uint32_t order[3001];
        assert_int_equal(tree_order(&surfels, pool, NULL, order), GP_OK);
        bool seen[3001] = { false };
        for (uint32_t i = 0; i < surfels.count; i++) {
            assert_false(seen[order[i]]);
            seen[order[i]] = true;
        }
        for (int depth = 0; depth < tree_depth(surfels.count); depth++)
            for (uint64_t node = 0; node < 1u << depth; node++) {
                const uint32_t begin = tree_bound(surfels.count, depth, node);
                const uint32_t middle = tree_bound(surfels.count, depth + 1, 2 * node + 1);
                const uint32_t end = tree_bound(surfels.count, depth, node + 1);
                Moments moments = { .count = 0 };
                for (uint32_t i = begin; i < end; i++)
                    moments_add(&moments, surfels.surfels[order[i]].position);
                const Symmetric covariance = moments_covariance(&moments);
                double axis[3], highest = -HUGE_VAL, lowest = HUGE_VAL, values[3], vectors[3][3];
                symmetric_long_axis(&covariance, axis);
                symmetric_eigen(&covariance, values, vectors);
                if (values[1] < 0.9 * values[0])
                    assert_true(fabs(vector_dot(axis, vectors[0])) > 0.99);
                for (uint32_t i = begin; i < end; i++) {
                    double at[3];
                    widen(surfels.surfels[order[i]].position, at);
                    const double along = vector_dot(axis, at);
                    if (i < middle)
                        highest = along > highest ? along : highest;
                    else
                        lowest = along < lowest ? along : lowest;
                }
                assert_true(highest <= lowest + 1e-6);
            }
        surfels_free(&surfels);
    }
}

static void equal_places_are_parted_by_number(void **state)
{
    (void)state;
    Surfels surfels;
    assert_int_equal(surfels_alloc(&surfels, 5000), GP_OK);
    uint32_t order[5000];
    assert_int_equal(tree_order(&surfels, pool, NULL, order), GP_OK);
    for (uint32_t i = 0; i < 5000; i++)
        assert_int_equal(order[i], i);
    surfels_free(&surfels);
}

/* --- eigenvectors ----------------------------------------------------------------------------- */

static void eigenvectors_make_the_matrix_again(void **state)
{
    (void)state;
    Random random = { 3 };
    for (int i = 0; i < 10000; i++) {
        Symmetric matrix;
        for (int k = 0; k < 6; k++)
            matrix.m[k] = i % 5 == 0 && k > 2 ? 0 : (double)random_float(&random, -1, 1);
        double values[3], v[3][3];
        symmetric_eigen(&matrix, values, v);
        assert_true(values[0] >= values[1] && values[1] >= values[2]);
        for (int k = 0; k < 6; k++) {
            const int row = k < 3 ? k : k == 3 ? 1 : 0, column = k < 3 ? k : k == 5 ? 1 : 2;
            double sum = 0;
            for (int e = 0; e < 3; e++)
                sum += values[e] * v[e][row] * v[e][column];
            assert_true(fabs(sum - matrix.m[k]) < 1e-14);
        }
        double across[3];
        vector_cross(v[0], v[1], across);
        assert_true(fabs(vector_dot(across, v[2]) - 1) < 1e-14);
    }
}

/* --- patches ---------------------------------------------------------------------------------- */

/* The leaves of node i of a level, as an interval of the patch's leaves. */
static void leaves_below(const Patches *patches, const Patch *patch, uint32_t level, uint32_t i,
                         uint32_t *begin, uint32_t *end)
{
    *begin = i;
    *end = i + 1;
    for (; level + 1 < patch->level_count; level++) {
        *begin = patch_child(patches, patch, level, *begin);
        *end = patch_child(patches, patch, level, *end);
    }
}

/* in the plane of a parent's disc, the leaf's disc is inside of it; and in the ball of its
 *      radius. */
/* A disc of more than the least share holds the discs of all its leaves; a wider one has the least:
 * the piece of surface is thin or uneven. */
static void assert_covers(const Surfel *parent, const Surfel *leaf)
{
    if (parent->share <= 0.45 * 255 + 0.5)
        return;
    double centre[3], from[3], normal[3], across[3];
    widen(parent->position, centre);
    widen(leaf->position, from);
    widen(parent->normal, normal);
    vector_subtract(from, centre, from);
    vector_add_scaled(from, -vector_dot(normal, from), normal, across);
    assert_true(sqrt(vector_dot(from, from)) + (double)leaf->radius <= (double)parent->radius);
    assert_true(sqrt(vector_dot(across, across)) + (double)leaf->radius <=
                (double)parent->radius * (1 + 1e-6));
}

static void check_node(const Patches *patches, const Patch *patch, uint32_t level, uint32_t i)
{
    const PatchLevel *levels = patch_levels(patches, patch);
    const Surfel *node = &patches->surfels[levels[level].first + i];
    const Surfel *leaves = &patches->surfels[levels[patch->level_count - 1].first];
    uint32_t begin, end;
    leaves_below(patches, patch, level, i, &begin, &end);
    assert_true(end > begin);
    double area = 0, normal[3] = { 0 }, own[3], place[3] = { 0 }, color[3] = { 0 };
    for (uint32_t k = begin; k < end; k++) {
        const double share = surfel_area(&leaves[k]);
        double to[3], at[3];
        assert_covers(node, &leaves[k]);
        widen(leaves[k].normal, to);
        widen(leaves[k].position, at);
        vector_add_scaled(normal, share, to, normal);
        vector_add_scaled(place, share, at, place);
        for (int c = 0; c < 3; c++)
            color[c] += share * leaves[k].color[c];
        area += share;
    }
    /* as near as the steps of a share allow */
    const double flat = sqrt(vector_dot(normal, normal)); /* as seen along the mean normal */
    const double shown = flat > area / 4 ? flat : area / 4;
    assert_true(node->share == surfel_share(shown, (double)node->radius));
    const double share = sqrt(shown / 6.283185307179586) / (double)node->radius * 255;
    assert_true(fabs(share - node->share) < 0.5001 || (node->share == 1 && share < 1));
    widen(node->normal, own);
    assert_true(fabs(vector_dot(own, own) - 1) < 1e-6);
    if (sqrt(vector_dot(normal, normal)) > 1e-3 * area) {
        vector_normalize(normal);
        assert_true(vector_dot(own, normal) > 1 - 1e-6);
    }
    for (int c = 0; c < 3; c++) {
        assert_true(fabs(place[c] / area - (double)node->position[c]) < 1e-6);
        assert_true(fabs(color[c] / area - node->color[c]) <= 0.5 + 1e-9);
    }
}

static int compare_surfels(const void *a, const void *b)
{
    return memcmp(a, b, sizeof(Surfel));
}

static void check_levels(const Patches *patches, const Patch *patch)
{
    const PatchLevel *levels = patch_levels(patches, patch);
    for (uint32_t l = 0; l < patch->level_count; l++) {
        double sum = 0;
        float least = HUGE_VALF, most = 0;
        if (l + 1 < patch->level_count) {
            assert_int_equal(levels[l].first + levels[l].count, levels[l + 1].first);
            assert_int_equal(patch_child(patches, patch, l, levels[l].count), levels[l + 1].count);
        }
        for (uint32_t i = 0; i < levels[l].count; i++) {
            const float radius = patches->surfels[levels[l].first + i].radius;
            if (l + 1 < patch->level_count)
                check_node(patches, patch, l, i);
            least = radius < least ? radius : least;
            most = radius > most ? radius : most;
            sum += (double)radius;
        }
        assert_true(least == levels[l].least_radius && most == levels[l].most_radius);
        assert_true(fabs(sum / levels[l].count - (double)levels[l].mean_radius) < 1e-6);
        double area[2] = { 0 }, mean[2] = { 0 };
        for (int k = 0; k < 2; k++) {
            const PatchLevel *level = k == 0 ? &levels[l] : &levels[patch->level_count - 1];
            for (uint32_t i = 0; i < level->count; i++) {
                const Surfel *surfel = &patches->surfels[level->first + i];
                area[k] += surfel_area(surfel);
                mean[k] += surfel_area(surfel) * (double)surfel_width(surfel);
            }
            mean[k] /= area[k];
        }
        const double blur = (double)levels[l].blur;
        const double square = fmax(mean[0] * mean[0] - mean[1] * mean[1], 0);
        assert_true(fabs(blur * blur - square) < 1e-6 * mean[0] * mean[0]);
    }
}

/* Boxes hold positions, cones normals, of every level. */
static void check_bounds(const Patches *patches, const Patch *patch)
{
    const PatchLevel *levels = patch_levels(patches, patch);
    double axis[3], centre[3], axes[3][3];
    widen(patch->cone.axis, axis);
    widen(patch->box.centre, centre);
    for (int i = 0; i < 3; i++)
        widen(patch->box.axes[i], axes[i]);
    for (uint32_t l = 0; l < patch->level_count; l++)
        for (uint32_t i = 0; i < levels[l].count; i++) {
            const Surfel *surfel = &patches->surfels[levels[l].first + i];
            double normal[3], from[3];
            widen(surfel->normal, normal);
            widen(surfel->position, from);
            vector_subtract(from, centre, from);
            assert_true(levels[l].cone_cosine >= patch->cone.cosine);
            assert_true(levels[l].cone_cosine <= 0 ||
                        vector_dot(axis, normal) >= (double)levels[l].cone_cosine);
            for (int k = 0; k < 3; k++)
                assert_true(fabs(vector_dot(axes[k], from)) <= (double)patch->box.half[k]);
        }
}

static void patches_hold_every_surfel_once_and_parents_stand_for_children(void **state)
{
    (void)state;
    const uint32_t counts[] = { 1, 2, 3, 4, 7, 8, 15, 31, 64, 1000, 5000, 20011 };
    const PatchLimits limits = { .most_leaves = 600, .least_leaves = 60 };
    for (int shape = 0; shape < SHAPES; shape++)
        for (size_t c = 0; c < GP_COUNT(counts); c++) {
            Surfels surfels;
            Patches patches;
            make_shape(shape, counts[c], &surfels);
            assert_int_equal(patches_build(&surfels, &limits, pool, NULL, &patches, NULL), GP_OK);
            assert_int_equal(patches.leaf_count, counts[c]);
            assert_true(patches.surfel_count <= counts[c] + (counts[c] + 2) / 3);
            Surfel *leaves = gp_alloc(counts[c], sizeof *leaves);
            uint32_t leaf_count = 0;
            for (uint32_t p = 0; p < patches.patch_count; p++) {
                const Patch *patch = &patches.patches[p];
                const PatchLevel *last = patch_levels(&patches, patch) + patch->level_count - 1;
                assert_in_range(last->count, 1, limits.most_leaves);
                assert_int_equal(leaf_count, tree_bound(counts[c], (int)patch->depth, patch->node));
                memcpy(leaves + leaf_count, patches.surfels + last->first,
                       last->count * sizeof *leaves);
                leaf_count += last->count;
                check_levels(&patches, patch);
                check_bounds(&patches, patch);
            }
            assert_int_equal(leaf_count, counts[c]);
            qsort(leaves, leaf_count, sizeof *leaves, compare_surfels);
            qsort(surfels.surfels, leaf_count, sizeof *leaves, compare_surfels);
            assert_memory_equal(leaves, surfels.surfels, leaf_count * sizeof *leaves);
            gp_free(leaves);
            patches_free(&patches);
            surfels_free(&surfels);
        }
}

/* Every range that begins at a node and ends where its first child stands shows each leaf once. */
static void windows_show_every_leaf_once(void **state)
{
    (void)state;
    Surfels surfels;
    Patches patches;
    const PatchLimits limits = { .most_leaves = 600, .least_leaves = 60 };
    shape_torus(&surfels, 3000, 0.3);
    assert_int_equal(patches_build(&surfels, &limits, pool, NULL, &patches, NULL), GP_OK);
    for (uint32_t p = 0; p < patches.patch_count; p++) {
        const Patch *patch = &patches.patches[p];
        const PatchLevel *levels = patch_levels(&patches, patch);
        for (uint32_t l = 0; l < patch->level_count; l++)
            for (uint32_t done = 0; done <= levels[l].count; done++) {
                if (done > 0 && l + 1 == patch->level_count)
                    break;
                const PatchWindow window = patch_window(&patches, patch, l, done);
                uint8_t shown[600] = { 0 };
                for (uint32_t i = window.first; i < window.first + window.count; i++) {
                    const bool is_child = i >= levels[l].first + levels[l].count;
                    const uint32_t level = l + is_child;
                    uint32_t begin, end;
                    leaves_below(&patches, patch, level, i - levels[level].first, &begin, &end);
                    for (uint32_t k = begin; k < end; k++)
                        shown[k]++;
                }
                for (uint32_t k = 0; k < levels[patch->level_count - 1].count; k++)
                    assert_int_equal(shown[k], 1);
            }
    }
    patches_free(&patches);
    surfels_free(&surfels);
}

/* Flat pieces stay whole, bent ones are split: a thin ring bends more than a ball. */
static void bent_surfaces_get_smaller_patches(void **state)
{
    (void)state;
    uint32_t counts[2];
    const PatchLimits limits = { .most_leaves = 1024, .least_leaves = 64 };
    for (int i = 0; i < 2; i++) {
        Surfels surfels;
        Patches patches;
        make_shape(i == 0 ? SPHERE : TORUS, 32768, &surfels);
        assert_int_equal(patches_build(&surfels, &limits, pool, NULL, &patches, NULL), GP_OK);
        counts[i] = patches.patch_count;
        patches_free(&patches);
        surfels_free(&surfels);
    }
    assert_int_equal(counts[0], 64); /* 512 leaves each: a node of 1024 is one too many */
    assert_true(counts[1] > counts[0]);
}

static bool are_equal(const Patches *a, const Patches *b)
{
    return a->surfel_count == b->surfel_count && a->patch_count == b->patch_count &&
           memcmp(a->surfels, b->surfels, a->surfel_count * sizeof *a->surfels) == 0 &&
           memcmp(a->patches, b->patches, a->patch_count * sizeof *a->patches) == 0 &&
           memcmp(a->levels, b->levels, a->level_count * sizeof *a->levels) == 0;
}

static void threads_make_the_same_bits(void **state)
{
    (void)state;
    Surfels surfels;
    Patches first, other;
    shape_torus(&surfels, 50000, 0.3);
    assert_int_equal(patches_build(&surfels, NULL, pool, NULL, &first, NULL), GP_OK);
    for (int threads = 1; threads <= 7; threads += 3) {
        GpPool *others;
        assert_int_equal(gp_pool_create(threads, &others, NULL), GP_OK);
        assert_int_equal(patches_build(&surfels, NULL, others, NULL, &other, NULL), GP_OK);
        assert_true(are_equal(&first, &other));
        gp_pool_destroy(&others);
        patches_free(&other);
    }
    surfels.surfels[17].position[1] += 0.5f;
    assert_int_equal(patches_build(&surfels, NULL, pool, NULL, &other, NULL), GP_OK);
    assert_false(are_equal(&first, &other));
    patches_free(&other);
    patches_free(&first);
    surfels_free(&surfels);
}

/* --- the bunny, and what is told -------------------------------------------------------------- */

typedef struct Heard {
    uint32_t words, last;
    const char *text;
    bool is_falling;
} Heard;

static void hear(const void *user, uint32_t done, uint32_t total, const char *text)
{
    Heard *heard = (Heard *)(uintptr_t)user;
    const bool is_same = heard->text && strcmp(text, heard->text) == 0;
    heard->is_falling |= (is_same && done < heard->last) || done > total;
    heard->words++;
    heard->last = done;
    heard->text = text;
}

static void progress_rises_to_its_end(void **state)
{
    (void)state;
    Surfels surfels;
    Patches patches;
    Heard heard = { 0 };
    const PointsListener listener = { hear, &heard };
    shape_sphere(&surfels, 100000);
    assert_int_equal(patches_build(&surfels, NULL, pool, &listener, &patches, NULL), GP_OK);
    assert_true(heard.words > 20 && heard.last > 0 && !heard.is_falling);
    patches_free(&patches);
    surfels_free(&surfels);
}

static void the_bunny_has_patches(void **state)
{
    (void)state;
    char path[512];
    GpMesh mesh;
    Surfels surfels;
    Patches patches;
    if (gp_data_find("meshes/bunny.ply", path, sizeof path, NULL)) {
        print_message("skipped: no meshes/bunny.ply\n");
        skip();
    }
    assert_int_equal(gp_mesh_read(path, 0, &mesh, NULL), GP_OK);
    assert_int_equal(surfels_alloc(&surfels, mesh.vertex_count), GP_OK);
    for (uint32_t i = 0; i < mesh.vertex_count; i++) {
        Surfel *surfel = &surfels.surfels[i];
        double normal[3];
        widen(mesh.normals + 3 * i, normal);
        vector_normalize(normal);
        *surfel = (Surfel){ .radius = 0.001f, .share = 100 };
        for (int k = 0; k < 3; k++) {
            surfel->position[k] = mesh.positions[3 * i + (uint32_t)k];
            surfel->normal[k] = (float)normal[k];
        }
    }
    assert_int_equal(patches_build(&surfels, NULL, pool, NULL, &patches, NULL), GP_OK);
    assert_in_range(patches.patch_count, 10, 70);
    for (uint32_t p = 0; p < patches.patch_count; p++) {
        check_levels(&patches, &patches.patches[p]);
        check_bounds(&patches, &patches.patches[p]);
    }
    patches_free(&patches);
    surfels_free(&surfels);
    gp_mesh_free(&mesh);
}

static void nothing_is_no_model(void **state)
{
    (void)state;
    Surfels none = { 0 };
    Patches patches = { 0 };
    GpError error;
    assert_int_equal(patches_build(&none, NULL, pool, NULL, &patches, &error), GP_ERROR_INVALID);
    assert_string_equal(error.text, "no points");
    patches_free(&patches);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_tree_is_complete),
        cmocka_unit_test(halves_are_parted_by_a_plane),
        cmocka_unit_test(equal_places_are_parted_by_number),
        cmocka_unit_test(eigenvectors_make_the_matrix_again),
        cmocka_unit_test(patches_hold_every_surfel_once_and_parents_stand_for_children),
        cmocka_unit_test(windows_show_every_leaf_once),
        cmocka_unit_test(bent_surfaces_get_smaller_patches),
        cmocka_unit_test(threads_make_the_same_bits),
        cmocka_unit_test(progress_rises_to_its_end),
        cmocka_unit_test(the_bunny_has_patches),
        cmocka_unit_test(nothing_is_no_model),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
