#include "tests/support/sheets_case.h"

#include "apps/tech_voxel_parts.h"
#include "pipeline/io/file.h"
#include "pipeline/io/mesh.h"
#include "tests/support/unit.h"

#include <math.h>

/* --- models --------------------------------------------------------------------------------------- */

static void alloc_model(SheetsCase *given, uint32_t vertices, uint32_t triangles)
{
    given->positions = gp_alloc(vertices, 3 * sizeof(float));
    given->normals = gp_alloc(vertices, 3 * sizeof(float));
    given->colors = gp_alloc(vertices, 4 * sizeof(float));
    given->indices = gp_alloc(triangles, 3 * sizeof(uint32_t));
    given->triangles = gp_alloc(triangles, sizeof(TruthTriangle));
    given->model = (VoxelModel){ .positions = given->positions,
                                 .normals = given->normals,
                                 .colors = given->colors,
                                 .indices = given->indices,
                                 .vertex_count = vertices,
                                 .triangle_count = triangles };
}

static void to_voxels(const SheetsCase *given, uint32_t vertex, double place[3])
{
    const float *p = given->positions + 3 * (size_t)vertex;
    for (int k = 0; k < 3; k++) {
        const float *row = given->model.motion.to_voxels[k];
        place[k] = (double)row[0] * (double)p[0] + (double)row[1] * (double)p[1] +
                   (double)row[2] * (double)p[2] + (double)row[3];
    }
}

static void finish_model(SheetsCase *given)
{
    for (uint32_t i = 0; i < 3 * given->model.triangle_count; i++)
        to_voxels(given, given->indices[i], given->triangles[i / 3].corner[i % 3]);
    for (uint32_t i = 0; i < given->model.vertex_count; i++) {
        double place[3];
        to_voxels(given, i, place);
        for (int k = 0; k < 3; k++)
            given->colors[4 * (size_t)i + (size_t)k] = (float)(place[k] / given->size);
        given->colors[4 * (size_t)i + 3] = 1;
    }
}

/* A rotation about (1, 2, 3), after Rodrigues; without a library's sine, for the same bits anywhere. */
static void rotation(double turn, double m[3][3])
{
    const double cosine = (1 - turn * turn) / (1 + turn * turn),
                 sine = 2 * turn / (1 + turn * turn);
    const double axis[3] = { 1 / sqrt(14), 2 / sqrt(14), 3 / sqrt(14) };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[i][j] = (i == j ? cosine : 0) + (1 - cosine) * axis[i] * axis[j];
    for (int k = 0; k < 3; k++) {
        m[(k + 1) % 3][(k + 2) % 3] -= sine * axis[k];
        m[(k + 2) % 3][(k + 1) % 3] += sine * axis[k];
    }
}

/* What fits a volume turned every way: voxel_box, smaller, and turned about the volume's middle. */
static void turned_box(SheetsCase *given, double turn)
{
    double m[3][3], middle = given->size / 2.0, smaller = turn != 0 ? 1 / sqrt(3.0) : 1;
    VoxelBox box =
        voxel_box(given->positions, given->indices, 3 * given->model.triangle_count, given->size);
    rotation(turn, m);
    for (int i = 0; i < 3; i++) {
        double offset = middle;
        for (int j = 0; j < 3; j++) {
            given->model.motion.to_voxels[i][j] = (float)(m[i][j] * box.scale * smaller);
            offset += m[i][j] * smaller * (box.offset[j] - middle);
        }
        given->model.motion.to_voxels[i][3] = (float)offset;
    }
    given->model.motion.to_voxels[3][3] = 1;
}

SheetsCase sheets_case_shape(const char *name, uint32_t size, double turn)
{
    SheetsCase given = { .size = size };
    Shape shape;
    assert_int_equal(shape_create(name, &shape), GP_OK);
    alloc_model(&given, shape.vertex_count, shape.index_count / 3);
    memcpy(given.indices, shape.indices, shape.index_count * sizeof(uint32_t));
    for (uint32_t i = 0; i < shape.vertex_count; i++) {
        memcpy(given.positions + 3 * (size_t)i, shape.vertices[i].position, 3 * sizeof(float));
        memcpy(given.normals + 3 * (size_t)i, shape.vertices[i].normal, 3 * sizeof(float));
    }
    shape_free(&shape);
    turned_box(&given, turn);
    finish_model(&given);
    return given;
}

SheetsCase sheets_case_mesh(const char *name, uint32_t size)
{
    SheetsCase given = { .size = size };
    char path[400];
    GpError error = { "" };
    GpMesh mesh;
    if (gp_data_find(name, path, sizeof path, &error))
        skip();
    if (gp_mesh_read(path, GP_MESH_TRIANGLES, &mesh, &error))
        fail_msg("%s", error.text);
    alloc_model(&given, mesh.vertex_count, mesh.triangle_count);
    memcpy(given.positions, mesh.positions, mesh.vertex_count * 3 * sizeof(float));
    memcpy(given.indices, mesh.indices, mesh.triangle_count * 3 * sizeof(uint32_t));
    gp_mesh_free(&mesh);
    turned_box(&given, 0);
    finish_model(&given);
    return given;
}

SheetsCase sheets_case_triangles(const TruthTriangle *triangles, uint32_t count, uint32_t size)
{
    SheetsCase given = { .size = size };
    alloc_model(&given, 3 * count, count);
    for (uint32_t i = 0; i < 3 * count; i++) {
        given.indices[i] = i;
        for (int k = 0; k < 3; k++)
            given.positions[3 * i + (uint32_t)k] = (float)triangles[i / 3].corner[i % 3][k];
    }
    for (int k = 0; k < 4; k++)
        given.model.motion.to_voxels[k][k] = 1;
    finish_model(&given);
    return given;
}

void sheets_case_free(SheetsCase *given)
{
    gp_free(given->positions);
    gp_free(given->normals);
    gp_free(given->colors);
    gp_free(given->indices);
    gp_free(given->triangles);
    *given = (SheetsCase){ .size = 0 };
}

/* --- volumes -------------------------------------------------------------------------------------- */

Worksheet sheets_case_build(const SheetsCase *given, const VoxelSetting *setting, Work *work)
{
    uint32_t passes, draws;
    GpError error = { "" };
    if (worksheet_check(setting->size, setting->bits, &error))
        fail_msg("%s", error.text);
    *work = (Work){ .color = NULL };
    passes = 64 + 4 * setting->size;
    draws = 256 + 8 * setting->size;
    work_reserve(work, passes, draws);
    Worksheet sheet = worksheet_make(work, setting->size, setting->bits);
    voxel_sheets(&given->model, setting, work, &sheet);
    return sheet;
}

void sheets_case_run(const Work *work, const GpDeviceDesc *desc)
{
    GpError error = { "" };
    GpDevice *device = NULL;
    if (gp_device_create(desc, &device, &error) || gp_device_run(device, &work->list, &error))
        fail_msg("%s", error.text);
    gp_device_destroy(&device);
}

uint8_t *sheets_case_read(const Worksheet *sheet)
{
    uint8_t *voxels = gp_alloc(worksheet_bytes(sheet), 1);
    assert_non_null(voxels);
    worksheet_read(sheet, voxels);
    return voxels;
}

uint8_t *sheets_case_volume(const SheetsCase *given, const VoxelSetting *setting)
{
    Work work;
    Worksheet sheet = sheets_case_build(given, setting, &work);
    sheets_case_run(&work, &(GpDeviceDesc){ .threads = 2 });
    uint8_t *voxels = sheets_case_read(&sheet);
    work_free(&work);
    return voxels;
}

uint64_t sheets_case_beyond(const uint8_t *a, const uint8_t *b, uint32_t size)
{
    uint64_t count = 0;
    for (size_t i = 0; i < voxel_bytes(size); i++)
        count += (uint64_t)__builtin_popcount((unsigned)(a[i] & ~b[i]));
    return count;
}
