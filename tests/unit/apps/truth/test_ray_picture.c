/* Pictures by rays, against those by samples of projected triangles, which share no arithmetic with
 * them, and against what planes are by hand. */
#include "apps/truth/mesh_picture.h"
#include "apps/truth/ray_picture.h"
#include "tests/support/meshes/named_mesh.h"
#include "tests/support/unit.h"

#include <math.h>

enum { WIDTH = 90, HEIGHT = 70 };

static TruthScene *triangles_of(const GpMesh *mesh)
{
    TruthTriangle *triangles = gp_alloc(mesh->triangle_count, sizeof *triangles);
    TruthScene *scene = NULL;
    for (size_t i = 0; i < mesh->triangle_count; i++)
        for (size_t c = 0; c < 9; c++)
            triangles[i].corner[c / 3][c % 3] =
                (double)mesh->positions[3 * mesh->indices[3 * i + c / 3] + c % 3];
    assert_int_equal(truth_scene_create(triangles, mesh->triangle_count, &scene), GP_OK);
    gp_free(triangles);
    return scene;
}

static RayPicture cast(const GpMesh *mesh, const MeshPaint *paint, const Camera *camera)
{
    TruthScene *triangles = triangles_of(mesh);
    const RayPictureScene scene = { triangles, *camera, WIDTH, HEIGHT, mesh_paint_color, paint };
    RayPicture picture;
    GpPool *pool;
    assert_int_equal(gp_pool_create(2, &pool, NULL), GP_OK);
    assert_int_equal(ray_picture_make(&scene, pool, &picture), GP_OK);
    gp_pool_destroy(&pool);
    truth_scene_destroy(&triangles);
    return picture;
}

static const TruthLight light = { .eye = { 2, 1, 3, 1 },
                                  .source = { 0.6, 0.8, 0, 0 },
                                  .ambient = { 0.2, 0.1, 0.3 },
                                  .diffuse = { 0.5, 0.7, 0.6 },
                                  .specular = { 0.2, 0.2, 0.3 },
                                  .shininess = 20 };

/* Edges that pass through a centre may be told either way. */
static void rays_and_samples_at_centres_are_one_picture(void **state)
{
    (void)state;
    static const Camera camera = {
        .eye = { 2, 1, 3 }, .up = { 0, 1, 0 }, .fovy = 45, .near = 0.5, .far = 20
    };
    GpMesh mesh = named_mesh("builtin:knot");
    const MeshPaint paint = { .positions = mesh.positions,
                              .normals = mesh.normals,
                              .colors = mesh.colors,
                              .indices = mesh.indices,
                              .light = &light };
    RayPicture rays = cast(&mesh, &paint, &camera);
    const MeshPictureScene scene = { .positions = mesh.positions,
                                     .stride = 3 * sizeof(float),
                                     .indices = mesh.indices,
                                     .triangle_count = mesh.triangle_count,
                                     .camera = camera,
                                     .width = WIDTH,
                                     .height = HEIGHT,
                                     .samples = 1,
                                     .color = mesh_paint_color,
                                     .context = &paint };
    MeshPicture samples;
    GpPool *pool;
    assert_int_equal(gp_pool_create(1, &pool, NULL), GP_OK);
    assert_int_equal(mesh_picture_make(&scene, pool, &samples), GP_OK);
    gp_pool_destroy(&pool);
    int covered = 0, differ = 0;
    for (size_t at = 0; at < (size_t)WIDTH * HEIGHT; at++) {
        covered += isfinite(rays.depth[at]);
        bool same = isfinite(rays.depth[at]) == (samples.covered[at] == 1);
        for (size_t k = 0; k < 3; k++)
            same = same && fabs(rays.color[3 * at + k] - samples.color[3 * at + k]) < 1e-5;
        differ += !same;
    }
    print_message("# %d covered, %d differ\n", covered, differ);
    assert_true(covered > 500 && differ <= 2);
    mesh_picture_free(&samples);
    ray_picture_free(&rays);
    gp_mesh_free(&mesh);
}

/* A square at z = 0, side 2, of waves. */
static void check_square(const Camera *camera, double depth, int covered)
{
    GpMesh mesh = named_mesh("builtin:quad");
    const MeshPaint paint = { .positions = mesh.positions, .indices = mesh.indices, .waves = 2 };
    RayPicture rays = cast(&mesh, &paint, camera);
    int count = 0;
    for (size_t at = 0; at < (size_t)WIDTH * HEIGHT; at++) {
        if (!isfinite(rays.depth[at]))
            continue;
        count++;
        assert_true(fabs(rays.depth[at] - depth) < 1e-12);
        assert_true(fabs(rays.color[3 * at + 2] - 0.5) < 1e-12); /* sin(2 z) */
    }
    assert_int_equal(count, covered);
    ray_picture_free(&rays);
    gp_mesh_free(&mesh);
}

static void depth_is_along_the_view_and_ends_at_near_and_far(void **state)
{
    (void)state;
    Camera camera = { .eye = { 0, 0, 5 }, .up = { 0, 1, 0 }, .height = 3.5, .near = 1, .far = 10 };
    check_square(&camera, 5, 40 * 40);
    camera.near = 5.5;
    check_square(&camera, 5, 0);
    camera.near = 1, camera.far = 4.5;
    check_square(&camera, 5, 0);
    camera = (Camera){ .eye = { 0, 0, 2.5 }, .up = { 0, 1, 0 }, .fovy = 90, .near = 1, .far = 10 };
    check_square(&camera, 2.5, 28 * 28);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_and_samples_at_centres_are_one_picture),
        cmocka_unit_test(depth_is_along_the_view_and_ends_at_near_and_far),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
