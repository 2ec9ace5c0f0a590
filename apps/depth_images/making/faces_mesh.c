#include "apps/depth_images/making/faces_mesh.h"

#include "apps/depth_images/making/capture_box.h"

#include <string.h>

static GpResult make_room(const DepthModel *box, GpMesh *mesh)
{
    size_t pixels = 0;
    for (uint32_t i = 0; i < box->count; i++)
        pixels += (size_t)box->images[i].front.width * box->images[i].front.height;
    mesh->positions = gp_alloc(pixels, 3 * sizeof(float));
    mesh->normals = gp_alloc(pixels, 3 * sizeof(float));
    mesh->colors = gp_alloc(pixels, 4 * sizeof(float));
    mesh->indices = gp_alloc(6 * pixels, sizeof *mesh->indices);
    return mesh->positions && mesh->normals && mesh->colors && mesh->indices ? GP_OK
                                                                             : GP_ERROR_MEMORY;
}

/* Every pixel of a face is a vertex; those that show nothing are in no triangle. */
static void add_vertices(const DepthImage *face, GpMesh *mesh)
{
    const DepthPixels *pixels = &face->front;
    for (size_t i = 0; i < (size_t)pixels->width * pixels->height; i++) {
        const size_t v = mesh->vertex_count++;
        double point[3] = { 0 };
        if (isfinite(pixels->depth[i]))
            depth_plane_point(&face->plane, pixels, (double)(i % pixels->width) + 0.5,
                              (double)(i / pixels->width) + 0.5, (double)pixels->depth[i], point);
        for (size_t k = 0; k < 3; k++) {
            mesh->positions[3 * v + k] = (float)point[k];
            mesh->normals[3 * v + k] = pixels->normal[3 * i + k];
            mesh->colors[4 * v + k] = pixels->color[3 * i + k];
        }
        mesh->colors[4 * v + 3] = 1;
    }
}

static void add_triangle(const DepthPixels *pixels, uint32_t base, double step,
                         const uint32_t corner[3], GpMesh *mesh)
{
    for (int i = 0; i < 3; i++) {
        const double a = (double)pixels->depth[corner[i]];
        const double b = (double)pixels->depth[corner[(i + 1) % 3]];
        if (!(fabs(a - b) < step)) /* nothing beside something, or nothing, too */
            return;
    }
    uint32_t *index = mesh->indices + 3 * (size_t)mesh->triangle_count++;
    for (int i = 0; i < 3; i++)
        index[i] = base + corner[i];
}

static void add_face(const DepthImage *face, GpMesh *mesh)
{
    const DepthPixels *pixels = &face->front;
    const uint32_t base = mesh->vertex_count, w = pixels->width;
    const double step = 2 * face->plane.width / w;
    add_vertices(face, mesh);
    for (uint32_t y = 0; y + 1 < pixels->height; y++)
        for (uint32_t x = 0; x + 1 < w; x++) {
            const uint32_t at = y * w + x;
            add_triangle(pixels, base, step, (const uint32_t[3]){ at, at + w, at + 1 }, mesh);
            add_triangle(pixels, base, step, (const uint32_t[3]){ at + 1, at + w, at + w + 1 },
                         mesh);
        }
}

GpResult faces_mesh(GpDevice *device, const CaptureSource *source, uint32_t side, GpMesh *mesh,
                    GpError *error)
{
    DepthModel box;
    GpMesh made = { NULL };
    GpResult result = capture_box(device, source, side, false, &box, error);
    if (result != GP_OK)
        return result;
    if (make_room(&box, &made) != GP_OK)
        result = gp_fail(error, GP_ERROR_MEMORY, "no memory for a mesh of six faces");
    for (uint32_t i = 0; result == GP_OK && i < box.count; i++)
        add_face(&box.images[i], &made);
    depth_model_free(&box);
    if (result == GP_OK && made.triangle_count == 0)
        result = gp_fail(error, GP_ERROR_INVALID, "six faces of %u pixels see no surface", side);
    if (result == GP_OK)
        *mesh = made;
    else
        gp_mesh_free(&made);
    return result;
}
