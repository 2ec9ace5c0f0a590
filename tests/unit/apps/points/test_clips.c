/* Surfels on creases end at the edges of their side. */
#include "apps/points/clips.h"
#include "apps/points/open.h"
#include "tests/support/groups/pool.h"
#include "tests/support/meshes/named_mesh.h"
#include "tests/support/unit.h"

#include <math.h>
#include <string.h>

static Surfels open_mesh(const GpMesh *mesh, uint32_t subdivide)
{
    const PointsSource source = { .mesh = mesh, .sharp = 40, .subdivide = subdivide };
    Surfels surfels;
    GpError error;
    if (points_open(&source, pool, &surfels, NULL, &error) != GP_OK)
        fail_msg("%s", error.text);
    return surfels;
}

static float dot(const float a[3], const float b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Sides of the cube that a place lies on. */
static int count_faces(const float place[3])
{
    int faces = 0;
    for (int k = 0; k < 3; k++)
        faces += fabsf(place[k]) == 1;
    return faces;
}

/* Two ways in at a corner, one along an edge, none inside: all square to lines that end the
 * face. */
static void a_cube_is_clipped_where_its_faces_end(void **state)
{
    (void)state;
    GpMesh mesh = named_mesh("builtin:cube");
    Surfels surfels = open_mesh(&mesh, 2);
    assert_int_equal(surfels.count, 6 * 25);
    assert_int_equal(surfels.clip_count, 6 * 16);
    const uint32_t first = surfels.count - surfels.clip_count;
    for (uint32_t i = 0; i < surfels.count; i++) {
        const Surfel *surfel = &surfels.surfels[i];
        const int faces = count_faces(surfel->position);
        assert_int_equal(faces > 1, i >= first);
        if (i < first)
            continue;
        const SurfelClip *clip = &surfels.clips[i - first];
        assert_true(clip->inward[0][3] == 1);
        assert_true(fabs((double)clip->inward[1][3] - (faces == 3 ? 2 : sqrt(2))) < 1e-3);
        assert_true(faces == 3 || dot(clip->inward[0], clip->inward[1]) > 0.999F);
        assert_true(faces == 2 || fabsf(dot(clip->inward[0], clip->inward[1])) < 1e-6F);
        for (int k = 0; k < 2; k++) {
            assert_true(fabsf(dot(clip->inward[k], surfel->normal)) < 1e-6F);
            assert_true(fabsf(dot(clip->inward[k], surfel->position) + 1) < 1e-6F);
        }
    }
    surfels_free(&surfels);
    gp_mesh_free(&mesh);
}

/* A prism over an L: at the inner corner of either end a surfel is more than half of its disc. */
static void an_inner_corner_is_clipped_by_either_line(void **state)
{
    (void)state;
    static const float corners[6][2] = {
        { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 }
    };
    float positions[36], normals[36];
    uint32_t indices[60], count = 0;
    for (int v = 0; v < 12; v++) {
        positions[3 * v] = corners[v % 6][0];
        positions[3 * v + 1] = corners[v % 6][1];
        positions[3 * v + 2] = v < 6 ? 1 : 0;
    }
    for (uint32_t i = 1; i < 5; i++) { /* the ends, as fans */
        const uint32_t ends[6] = { 0, i, i + 1, 6, 7 + i, 6 + i };
        memcpy(indices + count, ends, sizeof ends);
        count += 6;
    }
    for (uint32_t i = 0; i < 6; i++) { /* the walls */
        const uint32_t j = (i + 1) % 6, walls[6] = { i, 6 + i, 6 + j, i, 6 + j, j };
        memcpy(indices + count, walls, sizeof walls);
        count += 6;
    }
    memset(normals, 0, sizeof normals);
    const GpMesh mesh = { .positions = positions,
                          .normals = normals,
                          .indices = indices,
                          .vertex_count = 12,
                          .triangle_count = count / 3 };
    Surfels surfels = open_mesh(&mesh, 0);
    assert_int_equal(surfels.clip_count, 36);
    int inner = 0;
    for (uint32_t i = 0; i < 36; i++) {
        const Surfel *surfel = &surfels.surfels[i];
        const SurfelClip *clip = &surfels.clips[i];
        const bool is_inner =
            surfel->position[0] == 1 && surfel->position[1] == 1 && fabsf(surfel->normal[2]) == 1;
        inner += is_inner;
        assert_true(clip->inward[0][3] == (is_inner ? -1 : 1));
        assert_true(fabs((double)clip->inward[1][3] - (is_inner ? sqrt(4.0 / 3) : 2)) < 1e-3);
    }
    assert_int_equal(inner, 2);
    surfels_free(&surfels);
}

static void smooth_meshes_have_no_clips(void **state)
{
    (void)state;
    GpMesh mesh = named_mesh("builtin:torus");
    Surfels surfels = open_mesh(&mesh, 0);
    assert_int_equal(surfels.clip_count, 0);
    surfels_free(&surfels);
    gp_mesh_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cube_is_clipped_where_its_faces_end),
        cmocka_unit_test(an_inner_corner_is_clipped_by_either_line),
        cmocka_unit_test(smooth_meshes_have_no_clips),
    };
    return cmocka_run_group_tests(tests, pool_set_up, pool_tear_down);
}
