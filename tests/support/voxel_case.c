#include "tests/support/voxel_case.h"

#include "apps/shapes.h"
#include "pipeline/io/file.h"
#include "pipeline/io/mesh.h"
#include "tests/support/unit.h"

/* --- drawing -------------------------------------------------------------------------------------- */

/* The first is compared with. */
static const GpDeviceDesc devices[] = {
    { .threads = 2 },
    { .executor = GP_EXECUTOR_REFERENCE },
    { .threads = 1, .isa = "lanes4" },
    { .threads = 3, .isa = "lanes8" },
    { .threads = 3, .isa = "lanes16" },
};

/* Of all that was drawn. */
static uint64_t hash_targets(const Work *work)
{
    uint64_t hash = 0;
    for (int i = 0; i < work->surface_count; i++)
        hash = hash * 3 + gp_surface_hash(work->surfaces[i]);
    return hash;
}

void voxel_draw(VoxelDraw *draw, const void *context, uint32_t size, bool everywhere, uint8_t *bits)
{
    Work work = { .color = NULL };
    GpError error = { "" };
    uint32_t passes, draws;
    tech_voxel_room(&(VoxelSetting){ .size = size }, &passes, &draws);
    work_reserve(&work, passes, draws);
    Worksheet sheet = worksheet_make(&work, size, 1);
    draw(context, &work, &sheet);
    uint64_t first = 0;
    for (size_t i = 0; i < (everywhere ? GP_COUNT(devices) : 1); i++) {
        GpDevice *device = NULL;
        if (gp_device_create(&devices[i], &device, &error) == GP_ERROR_UNSUPPORTED)
            continue; /* a processor, or a build, without this width */
        if (gp_device_run(device, &work.list, &error))
            fail_msg("%s", error.text);
        uint64_t hash = hash_targets(&work);
        if (i == 0)
            first = hash;
        else if (hash != first)
            fail_msg("device %zu draws other bits", i);
        gp_device_destroy(&device);
    }
    worksheet_read(&sheet, bits);
    assert_int_equal(worksheet_count(&sheet), voxel_count(bits, size)); /* none beyond its end */
    work_free(&work);
}

/* --- models --------------------------------------------------------------------------------------- */

VoxelCase voxel_case_of(float *positions, uint32_t vertex_count, uint32_t *indices,
                        uint32_t triangle_count, uint32_t size, const VoxelBox *given)
{
    VoxelCase c = { .positions = positions,
                    .indices = indices,
                    .vertex_count = vertex_count,
                    .triangle_count = triangle_count,
                    .size = size,
                    .triangles = gp_alloc(triangle_count, sizeof *c.triangles) };
    const VoxelBox box = given ? *given : voxel_box(positions, indices, 3 * triangle_count, size);
    VoxelSpace space = { size, box.scale, { box.offset[0], box.offset[1], box.offset[2] } };
    voxel_triangles(positions, indices, triangle_count, &space, c.triangles);
    c.model = (VoxelModel){ .positions = positions,
                            .indices = indices,
                            .vertex_count = vertex_count,
                            .triangle_count = triangle_count,
                            .motion = voxel_still(&box) };
    return c;
}

static void turn_positions(float *positions, uint32_t count, const double turn[9])
{
    for (float *p = positions; p < positions + 3 * (size_t)count; p += 3) {
        const double x = (double)p[0], y = (double)p[1], z = (double)p[2];
        for (int k = 0; k < 3; k++)
            p[k] = (float)(turn[3 * k] * x + turn[3 * k + 1] * y + turn[3 * k + 2] * z);
    }
}

/* Either way the arrays are the caller's. */
static void read_model(const char *name, GpMesh *mesh)
{
    GpError error = { "" };
    char path[400];
    if (strchr(name, '.')) {
        if (gp_data_find(name, path, sizeof path, &error))
            skip();
        if (gp_mesh_read(path, GP_MESH_TRIANGLES, mesh, &error))
            fail_msg("%s", error.text);
        return;
    }
    Shape shape;
    assert_int_equal(shape_create(name, &shape), GP_OK);
    *mesh = (GpMesh){ .vertex_count = shape.vertex_count,
                      .triangle_count = shape.index_count / 3,
                      .positions = gp_alloc(shape.vertex_count, 3 * sizeof(float)),
                      .indices = gp_alloc(shape.index_count, sizeof(uint32_t)) };
    for (uint32_t i = 0; i < shape.vertex_count; i++)
        memcpy(mesh->positions + 3 * i, shape.vertices[i].position, 3 * sizeof(float));
    memcpy(mesh->indices, shape.indices, shape.index_count * sizeof(uint32_t));
    shape_free(&shape);
}

VoxelCase voxel_case_open(const char *name, const double turn[9], uint32_t size)
{
    GpMesh mesh = { .positions = NULL };
    read_model(name, &mesh);
    if (turn)
        turn_positions(mesh.positions, mesh.vertex_count, turn);
    VoxelCase c = voxel_case_of(mesh.positions, mesh.vertex_count, mesh.indices,
                                mesh.triangle_count, size, NULL);
    mesh.positions = NULL;
    mesh.indices = NULL;
    gp_mesh_free(&mesh);
    return c;
}

void voxel_case_free(VoxelCase *c)
{
    gp_free(c->positions);
    gp_free(c->indices);
    gp_free(c->triangles);
    *c = (VoxelCase){ .positions = NULL };
}

typedef struct Build {
    const VoxelModel *model;
    const VoxelSetting *setting;
} Build;

static void build(const void *context, Work *work, const Worksheet *sheet)
{
    const Build *b = context;
    GpError error = { "" };
    if (tech_voxel_draw(b->model, b->setting, work, sheet, &error))
        fail_msg("%s", error.text);
}

void voxel_case_draw(const VoxelCase *c, const VoxelSetting *setting, bool everywhere,
                     uint8_t *bits)
{
    const Build both = { &c->model, setting };
    voxel_draw(build, &both, c->size, everywhere, bits);
}

uint64_t voxel_count_without(const uint8_t *a, const uint8_t *b, uint32_t size)
{
    uint64_t count = 0;
    for (size_t i = 0; i < voxel_bytes(size); i++)
        count += (uint64_t)__builtin_popcount(a[i] & ~b[i] & 0xff);
    return count;
}
