/* Models by name. */
#include "apps/scene/model.h"
#include "tests/support/unit.h"

static void a_builtin_is_the_same_as_mesh_and_as_shape(void **state)
{
    (void)state;
    GpMesh mesh;
    Shape shape;
    assert_int_equal(model_mesh("builtin:knot", &mesh, NULL), GP_OK);
    assert_int_equal(model_shape(NULL, "builtin:knot", false, &shape, NULL), GP_OK);
    assert_int_equal(mesh.vertex_count, shape.vertex_count);
    assert_int_equal(3 * mesh.triangle_count, shape.index_count);
    assert_memory_equal(mesh.indices, shape.indices, shape.index_count * sizeof *shape.indices);
    const size_t bytes = mesh.vertex_count * 3 * sizeof(float);
    assert_memory_equal(mesh.positions, shape.positions, bytes);
    assert_memory_equal(mesh.normals, shape.normals, bytes);
    assert_null(shape.colors); /* which is white */
    for (uint32_t i = 0; i < 4 * mesh.vertex_count; i++)
        assert_true(mesh.colors[i] == 1);
    gp_mesh_free(&mesh);
    shape_free(&shape);
}

static void what_is_not_there_is_refused(void **state)
{
    (void)state;
    GpMesh mesh;
    Shape shape;
    GpError error = { "" };
    assert_int_equal(model_mesh("builtin:cup", &mesh, &error), GP_ERROR_INVALID);
    assert_string_equal(error.text, "no builtin mesh 'cup'");
    assert_int_equal(model_shape(NULL, "builtin:teapot", true, &shape, &error), GP_ERROR_INVALID);
    assert_string_equal(error.text, "no builtin points 'teapot'");
    assert_int_equal(model_mesh("nowhere/x.ply", &mesh, &error), GP_ERROR_IO);
    assert_int_equal(model_shape(NULL, "nowhere/x.ply", false, &shape, &error), GP_ERROR_IO);
    assert_string_equal(model_after("builtin:cup", "builtin:"), "cup");
    assert_null(model_after("builtin", "builtin:"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_builtin_is_the_same_as_mesh_and_as_shape),
        cmocka_unit_test(what_is_not_there_is_refused),
    };
    return cmocka_run_group_tests_name("model", tests, NULL, NULL);
}
