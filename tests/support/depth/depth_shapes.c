#include "tests/support/depth/depth_shapes.h"

#include "apps/base/bounds.h"
#include "pipeline/io/mesh/mesh.h"
#include "tests/support/depth/view_rays.h"
#include "tests/support/meshes/named_mesh.h"
#include "tests/support/unit.h"

#include <math.h>

/* --- shapes ----------------------------------------------------------------------------------- */

static void make_triangles(DepthShape *shape)
{
    TruthTriangle *triangles = gp_alloc(shape->triangle_count, sizeof *triangles);
    for (uint32_t i = 0; i < 3 * shape->triangle_count; i++)
        for (int k = 0; k < 3; k++)
            triangles[i / 3].corner[i % 3][k] =
                (double)shape->positions[3 * shape->indices[i] + (uint32_t)k];
    assert_int_equal(truth_scene_create(triangles, shape->triangle_count, &shape->triangles),
                     GP_OK);
    gp_free(triangles);
}

/* A little outside of its box. */
static void find_cylinder(DepthShape *shape, double waves)
{
    const Bounds box = bounds_of(shape->positions, 3 * sizeof(float), NULL, shape->vertex_count);
    double square = 0;
    for (int k = 0; k < 3; k++)
        shape->center[k] = (box.low[k] + box.high[k]) / 2;
    for (uint32_t i = 0; i < shape->vertex_count; i++) {
        const double x = (double)shape->positions[3 * i] - shape->center[0];
        const double z = (double)shape->positions[3 * i + 2] - shape->center[2];
        square = fmax(square, x * x + z * z);
    }
    shape->radius = 1.02 * sqrt(square);
    shape->half_height = 1.02 * (box.high[1] - box.low[1]) / 2;
    shape->paint = (MeshPaint){ .positions = shape->positions,
                                .indices = shape->indices,
                                .waves = waves / bounds_longest(&box) };
}

DepthShape depth_shape_open(const char *name, double waves, double degrees)
{
    GpMesh mesh = named_mesh(name);
    DepthShape shape = { .triangles = NULL };
    double turn[4][4];
    matrix_rotation((double[3]){ 1, 0, 0 }, degrees, turn);
    shape.vertex_count = mesh.vertex_count;
    shape.triangle_count = mesh.triangle_count;
    shape.positions = gp_alloc(shape.vertex_count, 3 * sizeof(float));
    shape.indices = gp_alloc(shape.triangle_count, 3 * sizeof(uint32_t));
    memcpy(shape.indices, mesh.indices, shape.triangle_count * 3 * sizeof(uint32_t));
    for (uint32_t i = 0; i < shape.vertex_count; i++) {
        double p[3];
        for (int k = 0; k < 3; k++)
            p[k] = (double)mesh.positions[3 * i + (uint32_t)k];
        for (int k = 0; k < 3; k++)
            shape.positions[3 * i + (uint32_t)k] = (float)vector_dot(turn[k], p);
    }
    gp_mesh_free(&mesh);
    make_triangles(&shape);
    find_cylinder(&shape, waves);
    return shape;
}

DepthShape depth_shape_vase(void)
{
    enum { AROUND = 96, ROWS = 64 };
    DepthShape shape = { .vertex_count = AROUND * ROWS, .triangle_count = AROUND * (ROWS - 1) * 2 };
    shape.positions = gp_alloc(shape.vertex_count, 3 * sizeof(float));
    shape.indices = gp_alloc(shape.triangle_count, 3 * sizeof(uint32_t));
    for (uint32_t y = 0, n = 0; y < ROWS; y++)
        for (uint32_t x = 0; x < AROUND; x++) {
            float *position = &shape.positions[3 * (y * AROUND + x)];
            double sine, cosine, wave, bump, unused;
            angle_sincos(360.0 * x / AROUND, &sine, &cosine);
            angle_sincos(270.0 * y / ROWS, &wave, &unused);
            angle_sincos(8 * 360.0 * x / AROUND + 900.0 * y / ROWS, &bump, &unused);
            const double radius = 0.6 + 0.25 * wave + 0.04 * bump;
            position[0] = (float)(radius * cosine);
            position[1] = (float)(1 - 2.0 * y / (ROWS - 1));
            position[2] = (float)(-radius * sine);
            const uint32_t right = y * AROUND + (x + 1) % AROUND, at = y * AROUND + x;
            const uint32_t two[6] = { at, at + AROUND, right, right, at + AROUND, right + AROUND };
            for (int i = 0; i < 6 && y + 1 < ROWS; i++)
                shape.indices[n++] = two[i];
        }
    make_triangles(&shape);
    find_cylinder(&shape, 20);
    return shape;
}

DepthShape depth_shape_piece(const DepthShape *shape, int quarter)
{
    DepthShape piece = { .vertex_count = 0 };
    const double size = shape->paint.waves;
    piece.positions = gp_alloc(9 * shape->triangle_count, sizeof(float));
    piece.indices = gp_alloc(3 * shape->triangle_count, sizeof(uint32_t));
    for (uint32_t i = 0; i < shape->triangle_count; i++) {
        const TruthTriangle *triangle = truth_scene_triangle(shape->triangles, i);
        const double(*c)[3] = triangle->corner;
        const bool right = c[0][0] + c[1][0] + c[2][0] > 3 * shape->center[0];
        const bool above = c[0][1] + c[1][1] + c[2][1] > 3 * shape->center[1];
        for (uint32_t n = 0; n < 3 && 2 * above + right == quarter; n++) {
            for (int k = 0; k < 3; k++)
                piece.positions[3 * piece.vertex_count + (uint32_t)k] = (float)c[n][k];
            piece.indices[piece.vertex_count] = piece.vertex_count;
            piece.vertex_count++;
        }
    }
    piece.triangle_count = piece.vertex_count / 3;
    make_triangles(&piece);
    find_cylinder(&piece, 1);
    piece.paint.waves = size;
    return piece;
}

void depth_shape_close(DepthShape *shape)
{
    truth_scene_destroy(&shape->triangles);
    gp_free(shape->positions);
    gp_free(shape->indices);
    *shape = (DepthShape){ .triangles = NULL };
}

/* --- capture ---------------------------------------------------------------------------------- */

static void flat_normal(const TruthTriangle *triangle, const double towards[3], float normal[3])
{
    double side[2][3], n[3];
    vector_subtract(triangle->corner[1], triangle->corner[0], side[0]);
    vector_subtract(triangle->corner[2], triangle->corner[0], side[1]);
    vector_cross(side[0], side[1], n);
    vector_normalize(n);
    const double turn = vector_dot(n, towards) < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++)
        normal[k] = (float)(turn * n[k]);
}

/* What the ray of each pixel, from depth 0 to 1 and on to `most`, meets first. */
static void capture(const DepthShape *shape, DepthImage *image, double most)
{
    DepthPixels *pixels = &image->front;
    for (uint32_t i = 0; i < pixels->width * pixels->height; i++) {
        const double x = i % pixels->width + 0.5, y = i / pixels->width + 0.5;
        double from[3], to[3], color[3];
        TruthHit hit;
        if (image->is_cylinder) {
            depth_cylinder_point(&image->cylinder, pixels, x, y, 0, from);
            depth_cylinder_point(&image->cylinder, pixels, x, y, 1, to);
        } else {
            depth_plane_point(&image->plane, pixels, x, y, 0, from);
            depth_plane_point(&image->plane, pixels, x, y, 1, to);
        }
        vector_subtract(to, from, to);
        if (!truth_first_hit(shape->triangles, from, to, &hit) || hit.t > most)
            continue;
        pixels->depth[i] = (float)hit.t;
        mesh_paint_color(&shape->paint, hit.triangle, hit.share, color);
        for (int k = 0; k < 3; k++)
            pixels->color[3 * i + (uint32_t)k] = (float)color[k];
        vector_set(to, -to[0], -to[1], -to[2]);
        if (pixels->normal)
            flat_normal(truth_scene_triangle(shape->triangles, hit.triangle), to,
                        &pixels->normal[3 * i]);
    }
}

static DepthPlane cap_of(const DepthShape *shape, double up)
{
    const double r = shape->radius;
    DepthPlane plane = { .is_parallel = true,
                         .right = { 1, 0, 0 },
                         .up = { 0, 0, -up },
                         .forward = { 0, -up, 0 },
                         .left = -r,
                         .bottom = -r,
                         .width = 2 * r,
                         .height = 2 * r };
    vector_add_scaled(shape->center, up * shape->half_height, (double[3]){ 0, 1, 0 }, plane.eye);
    return plane;
}

DepthModel depth_shape_capture(const DepthShape *shape, uint32_t width, uint32_t height,
                               uint32_t caps, bool normals)
{
    DepthModel model = { .count = caps ? 3 : 1 };
    DepthImage *wall = &model.images[0];
    wall->is_cylinder = true;
    wall->cylinder = (DepthCylinder){ .axis = { 0, 1, 0 },
                                      .zero = { 1, 0, 0 },
                                      .radius = shape->radius,
                                      .height = 2 * shape->half_height };
    memcpy(wall->cylinder.center, shape->center, sizeof shape->center);
    assert_int_equal(depth_pixels_make(width, height, normals, &wall->front), GP_OK);
    capture(shape, wall, shape->radius);
    for (uint32_t i = 1; i < model.count; i++) {
        model.images[i].plane = cap_of(shape, i == 1 ? 1 : -1);
        assert_int_equal(depth_pixels_make(caps, caps, normals, &model.images[i].front), GP_OK);
        capture(shape, &model.images[i], HUGE_VAL);
    }
    return model;
}

/* --- the truth -------------------------------------------------------------------------------- */

RayPicture depth_shape_truth(const DepthShape *shape, const Camera *camera, uint32_t width,
                             uint32_t height)
{
    const RayPictureScene scene = { .triangles = shape->triangles,
                                    .camera = *camera,
                                    .width = width,
                                    .height = height,
                                    .color = mesh_paint_color,
                                    .context = &shape->paint };
    RayPicture picture;
    GpPool *pool = NULL;
    assert_int_equal(gp_pool_create(1, &pool, NULL), GP_OK);
    assert_int_equal(ray_picture_make(&scene, pool, &picture), GP_OK);
    gp_pool_destroy(&pool);
    return picture;
}

DepthCompared depth_compare(const RayPicture *truth, const Camera *camera, const GpSurface *color,
                            const GpSurface *depth)
{
    const uint32_t count = truth->width * truth->height;
    float(*rgba)[4] = gp_alloc(count, sizeof *rgba), (*z)[4] = gp_alloc(count, sizeof *z);
    DepthCompared compared = { .psnr = 0 };
    double square = 0, away = 0;
    uint32_t both = 0;
    assert_int_equal(gp_surface_read_floats(color, 0, NULL, &rgba[0][0], NULL), GP_OK);
    assert_int_equal(gp_surface_read_floats(depth, 0, NULL, &z[0][0], NULL), GP_OK);
    for (uint32_t i = 0; i < count; i++) {
        const bool there = isfinite(truth->depth[i]), drawn = z[i][0] < 1;
        compared.covered += there;
        compared.missing += there && !drawn;
        compared.extra += drawn && !there;
        if (!there || !drawn)
            continue;
        both++;
        away += fabs(view_distance(camera, (double)z[i][0]) - truth->depth[i]);
        for (int k = 0; k < 3; k++) {
            const double off = (double)rgba[i][k] - truth->color[3 * i + (uint32_t)k];
            square += off * off;
        }
    }
    compared.psnr = both ? 10 * log10(3.0 * both / square) : 0;
    compared.depth = both ? away / both : 0;
    gp_free(rgba);
    gp_free(z);
    return compared;
}
