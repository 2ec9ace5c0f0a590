/* Models and volumes by name. */
#include "apps/scene/model.h"
#include "apps/scene/volume.h"
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
    for (uint32_t i = 0; i < mesh.vertex_count; i++) {
        const ShapeVertex *vertex = &shape.vertices[i];
        assert_memory_equal(mesh.positions + 3 * i, vertex->position, sizeof vertex->position);
        assert_memory_equal(mesh.normals + 3 * i, vertex->normal, sizeof vertex->normal);
        assert_memory_equal(mesh.colors + 4 * i, vertex->color, sizeof vertex->color);
    }
    gp_mesh_free(&mesh);
    shape_free(&shape);
}

static void what_is_not_there_is_refused(void **state)
{
    (void)state;
    GpMesh mesh;
    Shape shape;
    GpVolume volume;
    GpError error = { "" };
    assert_int_equal(model_mesh("builtin:cup", &mesh, &error), GP_ERROR_INVALID);
    assert_string_equal(error.text, "no builtin mesh 'cup'");
    assert_int_equal(model_shape(NULL, "builtin:teapot", true, &shape, &error), GP_ERROR_INVALID);
    assert_string_equal(error.text, "no builtin points 'teapot'");
    assert_int_equal(model_mesh("nowhere/x.ply", &mesh, &error), GP_ERROR_IO);
    assert_int_equal(model_shape(NULL, "nowhere/x.ply", false, &shape, &error), GP_ERROR_IO);
    assert_int_equal(volume_open("nowhere/x.nrrd", &volume, &error), GP_ERROR_IO);
    assert_string_equal(model_after("builtin:cup", "builtin:"), "cup");
    assert_null(model_after("builtin", "builtin:"));
}

static void bytes_go_from_the_least_to_the_greatest(void **state)
{
    (void)state;
    int16_t samples[] = { -100, 155, 0, 27 };
    float floats[] = { 1, __builtin_nanf(""), 3, 2 };
    uint8_t bits[] = { 0x06 };
    const struct {
        GpVolumeType type;
        void *data;
        uint8_t expected[4];
    } cases[] = {
        { GP_VOLUME_I16, samples, { 0, 255, 100, 127 } },
        { GP_VOLUME_F32, floats, { 0, 0, 255, 128 } },
        { GP_VOLUME_BITS, bits, { 0, 255, 255, 0 } },
    };
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        const GpVolume volume = { .dims = { 2, 2, 1 },
                                  .type = cases[i].type,
                                  .spacing = { 1, 1, 1 },
                                  .data = cases[i].data };
        uint8_t *bytes = volume_bytes(&volume);
        assert_memory_equal(bytes, cases[i].expected, 4);
        gp_free(bytes);
    }
}

/* Twice as many voxels on the same way take half of the light each, so that as much is left. */
static void opacity_goes_by_the_way_through_a_voxel(void **state)
{
    (void)state;
    static const VolumeStop stops[] = { { 0, { 0, 0, 0, 0 } },
                                        { 100, { 1, 0.5, 0, 64 } },
                                        { 255, { 1, 1, 1, 64 } } };
    uint8_t table[VOLUME_VALUES][4], finer[VOLUME_VALUES][4];
    volume_transfer(stops, GP_COUNT(stops), 64, table);
    volume_transfer(stops, GP_COUNT(stops), 128, finer);
    assert_memory_equal(table[0], ((uint8_t[4]){ 0, 0, 0, 0 }), 4);
    assert_memory_equal(table[100], ((uint8_t[4]){ 255, 128, 0, 128 }), 4);
    assert_memory_equal(table[255], ((uint8_t[4]){ 255, 255, 255, 128 }), 4);
    assert_int_equal(finer[100][3], 85);
    for (int i = 1; i < VOLUME_VALUES; i++)
        assert_true(table[i][3] >= table[i - 1][3] && table[i][3] >= finer[i][3]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_builtin_is_the_same_as_mesh_and_as_shape),
        cmocka_unit_test(what_is_not_there_is_refused),
        cmocka_unit_test(bytes_go_from_the_least_to_the_greatest),
        cmocka_unit_test(opacity_goes_by_the_way_through_a_voxel),
    };
    return cmocka_run_group_tests_name("model", tests, NULL, NULL);
}
