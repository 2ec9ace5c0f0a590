/* Meshes show their outside, however their triangles turn in the file; open ones stay as they
 * are. */
#include "apps/points/orient.h"

#include "apps/base/bounds.h"
#include "apps/base/vector.h"
#include "apps/points/subdivide.h"
#include "tests/support/meshes/named_mesh.h"
#include "tests/support/unit.h"

#include <string.h>
#include <unistd.h>

static void turn_triangle(GpMesh *mesh, size_t t)
{
    const uint32_t second = mesh->indices[3 * t + 1];
    mesh->indices[3 * t + 1] = mesh->indices[3 * t + 2];
    mesh->indices[3 * t + 2] = second;
}

static uint32_t orient(GpMesh *mesh)
{
    uint32_t turned;
    assert_int_equal(mesh_orient(mesh, &turned), GP_OK);
    return turned;
}

static GpMesh copy_of(const GpMesh *mesh)
{
    GpMesh copy;
    assert_int_equal(mesh_copy(mesh, &copy), GP_OK);
    return copy;
}

static void assert_same(const char *name, const GpMesh *a, const GpMesh *b)
{
    assert_int_equal(a->triangle_count, b->triangle_count);
    for (size_t t = 0; t < a->triangle_count; t++) {
        const uint32_t *x = a->indices + 3 * t, *y = b->indices + 3 * t;
        if (x[0] != y[0] || x[1] != y[1])
            fail_msg("%s: triangle %zu turns the other way", name, t);
    }
    for (size_t i = 0; i < 3 * (size_t)a->vertex_count; i++)
        if (a->normals[i] != b->normals[i])
            fail_msg("%s: normal %zu is %g, not %g", name, i / 3, (double)a->normals[i],
                     (double)b->normals[i]);
}

/* Whole, or every third triangle; with the file's normals, turned or not, or with made ones. */
static void closed_meshes_are_turned_outwards(void **state)
{
    (void)state;
    static const char *const names[] = { "builtin:ball", "builtin:cube", "builtin:knot",
                                         "builtin:cylinder" };
    for (size_t n = 0; n < GP_COUNT(names); n++)
        for (int round = 0; round < 6; round++) {
            GpMesh mesh = referenced_mesh(names[n]);
            mesh.had_normals = round % 3 < 2;
            if (!mesh.had_normals)
                assert_int_equal(gp_mesh_normals(&mesh, true), GP_OK);
            GpMesh expected = copy_of(&mesh);
            assert_int_equal(orient(&mesh), 0);
            assert_same(names[n], &mesh, &expected);
            for (size_t t = 0; t < mesh.triangle_count; t++)
                if (round < 3 || t % 3 == 0)
                    turn_triangle(&mesh, t);
            for (size_t i = 0; i < 3 * (size_t)mesh.vertex_count && round % 3 != 1; i++)
                mesh.normals[i] = -mesh.normals[i]; /* as a file turned inside out has them */
            assert_int_equal(orient(&mesh), round < 3);
            assert_same(names[n], &mesh, &expected);
            gp_mesh_free(&mesh);
            gp_mesh_free(&expected);
        }
}

static void open_meshes_stay_as_they_are(void **state)
{
    (void)state;
    static const char *const names[] = { "builtin:plane", "builtin:disc", "builtin:teapot",
                                         "../shared/data/meshes/bunny.ply" };
    for (size_t n = 0; n < GP_COUNT(names); n++) {
        if (names[n][0] == '.' && access(names[n], R_OK) != 0) {
            print_message("skipped: %s is not there\n", names[n]);
            continue;
        }
        GpMesh mesh = referenced_mesh(names[n]), before = copy_of(&mesh);
        assert_int_equal(orient(&mesh), 0);
        assert_same(names[n], &mesh, &before);
        gp_mesh_free(&mesh);
        gp_mesh_free(&before);
    }
    /* A bowl, though its volume has a sign: which of its sides is meant is not known. */
    GpMesh bowl = referenced_mesh("builtin:ball");
    uint32_t kept = 0;
    for (size_t t = 0; t < bowl.triangle_count; t++) {
        const uint32_t *corner = bowl.indices + 3 * t;
        bool is_low = true;
        for (int i = 0; i < 3; i++)
            is_low &= bowl.positions[3 * (size_t)corner[i] + 1] < 1e-6F;
        if (is_low) {
            memmove(bowl.indices + 3 * (size_t)kept, corner, 3 * sizeof *corner);
            turn_triangle(&bowl, kept++);
        }
    }
    bowl.triangle_count = kept;
    bowl.had_normals = false;
    GpMesh before = copy_of(&bowl), mesh = copy_of(&bowl);
    assert_int_equal(orient(&mesh), 0);
    assert_same("a bowl", &mesh, &before);
    gp_mesh_free(&bowl);
    gp_mesh_free(&before);
    gp_mesh_free(&mesh);
}

static void corners_from(const GpMesh *mesh, size_t triangle, const double place[3],
                         double corner[3][3])
{
    for (size_t i = 0; i < 9; i++)
        corner[i / 3][i % 3] =
            (double)mesh->positions[3 * mesh->indices[3 * triangle + i / 3] + i % 3] - place[i % 3];
}

/* Six times the volume as it is from a place. */
static double volume_from(const GpMesh *mesh, const double place[3])
{
    double volume = 0;
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        double corner[3][3], cross[3];
        corners_from(mesh, t, place, corner);
        vector_cross(corner[1], corner[2], cross);
        volume += vector_dot(corner[0], cross);
    }
    return volume;
}

/* The length of the sum of triangles' area vectors, of the sum of their lengths. */
static double openness_of(const GpMesh *mesh)
{
    static const double origin[3];
    double sum[3] = { 0 }, area = 0;
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        double corner[3][3], side[2][3], cross[3];
        corners_from(mesh, t, origin, corner);
        for (int i = 0; i < 2; i++)
            vector_subtract(corner[1 + i], corner[0], side[i]);
        vector_cross(side[0], side[1], cross);
        vector_add_scaled(sum, 1, cross, sum);
        area += sqrt(vector_dot(cross, cross));
    }
    return sqrt(vector_dot(sum, sum)) / area;
}

/* Leaves out triangles that are not wholly below a height, and turns the others inside out. */
static void cut_and_turn(GpMesh *mesh, float height)
{
    uint32_t kept = 0;
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        const uint32_t *corner = mesh->indices + 3 * t;
        bool is_low = true;
        for (size_t i = 0; i < 3; i++)
            is_low &= mesh->positions[3 * (size_t)corner[i] + 1] < height;
        if (!is_low)
            continue;
        memmove(mesh->indices + 3 * (size_t)kept, corner, 3 * sizeof *corner);
        turn_triangle(mesh, kept++);
    }
    mesh->triangle_count = kept;
    assert_int_equal(mesh_keep_referenced(mesh), GP_OK);
    mesh->had_normals = false;
}

/* A ball that is wrung, so that some of it is inside out, the more the nearer its waist is to the
 * middle; and has a hole. Where that is small and cannot decide, outside is known. */
static void nearly_closed_meshes_are_turned_where_their_volume_has_one_sign(void **state)
{
    (void)state;
    static const float waists[] = { -9, -1, -0.1F, -0.06F, -0.04F, -0.02F, -0.002F, 0.002F, 0.3F };
    int turned = 0, open = 0, unclear = 0;
    GpMesh coarse = referenced_mesh("builtin:ball"), finer, ball;
    assert_int_equal(mesh_subdivide(&coarse, &finer), GP_OK);
    assert_int_equal(mesh_subdivide(&finer, &ball), GP_OK);
    gp_mesh_free(&coarse);
    gp_mesh_free(&finer);
    for (size_t n = 0; n < GP_COUNT(waists); n++)
        for (float height = 0.9F; height < 1; height += 0.004F) {
            GpMesh mesh = copy_of(&ball);
            for (size_t v = 0; v < mesh.vertex_count; v++)
                mesh.positions[3 * v] *= mesh.positions[3 * v + 1] - waists[n];
            cut_and_turn(&mesh, height);
            const Bounds box =
                bounds_of(mesh.positions, 3 * sizeof(float), NULL, mesh.vertex_count);
            int inwards = 0, outwards = 0;
            for (int corner = 0; corner < 8; corner++) {
                double place[3];
                for (int k = 0; k < 3; k++)
                    place[k] = (double)(corner >> k & 1 ? box.high[k] : box.low[k]);
                const double volume = volume_from(&mesh, place);
                inwards += volume < 0;
                outwards += volume > 0;
            }
            const bool is_closed = openness_of(&mesh) <= 0.02;
            assert_int_equal(orient(&mesh), is_closed && inwards == 8);
            turned += is_closed && inwards == 8;
            unclear += is_closed && inwards < 8 && outwards < 8;
            open += !is_closed;
            gp_mesh_free(&mesh);
        }
    gp_mesh_free(&ball);
    print_message("# %d turned, %d open, %d unclear\n", turned, open, unclear);
    assert_true(turned > 5 && open > 5 && unclear > 5);
}

/* A ball, and one of half its size: inside, with the triangles of a cavity, or beside. */
static GpMesh two_balls(float aside)
{
    GpMesh ball = referenced_mesh("builtin:ball");
    const size_t vertices = ball.vertex_count, indices = 3 * (size_t)ball.triangle_count;
    GpMesh two = { .positions = gp_alloc(6 * vertices, sizeof(float)),
                   .normals = gp_alloc(6 * vertices, sizeof(float)),
                   .indices = gp_alloc(2 * indices, sizeof(uint32_t)),
                   .vertex_count = (uint32_t)(2 * vertices),
                   .triangle_count = 2 * ball.triangle_count };
    for (size_t i = 0; i < 3 * vertices; i++) {
        two.positions[i] = ball.positions[i];
        two.positions[3 * vertices + i] = 0.5F * ball.positions[i] + (i % 3 == 0 ? aside : 0);
    }
    for (size_t i = 0; i < indices; i++) {
        two.indices[i] = ball.indices[i];
        two.indices[indices + i] = ball.indices[i] + (uint32_t)vertices;
    }
    for (size_t t = ball.triangle_count; t < two.triangle_count; t++)
        turn_triangle(&two, t);
    assert_int_equal(gp_mesh_normals(&two, true), GP_OK);
    gp_mesh_free(&ball);
    return two;
}

static void cavities_turn_with_what_is_around_them(void **state)
{
    (void)state;
    GpMesh mesh = two_balls(0), before = copy_of(&mesh);
    assert_int_equal(orient(&mesh), 0);
    assert_same("a cavity", &mesh, &before);
    for (size_t t = 0; t < mesh.triangle_count; t++)
        turn_triangle(&mesh, t);
    assert_int_equal(orient(&mesh), 2);
    assert_same("a cavity, turned", &mesh, &before);
    gp_mesh_free(&mesh);
    gp_mesh_free(&before);
    mesh = two_balls(5);
    assert_int_equal(orient(&mesh), 1);
    gp_mesh_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_meshes_are_turned_outwards),
        cmocka_unit_test(open_meshes_stay_as_they_are),
        cmocka_unit_test(nearly_closed_meshes_are_turned_where_their_volume_has_one_sign),
        cmocka_unit_test(cavities_turn_with_what_is_around_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
