/* Meshes, points and pictures from files, as scenes hold them. */
#include "apps/scene/loader.h"

#include "pipeline/io/image/image.h"
#include "pipeline/io/mesh/mesh.h"

#include <string.h>

/* Files have v = 0 at the bottom of a picture, scenes at the top. */
static void copy_vertex(const GpMesh *mesh, uint32_t i, ShapeVertex *vertex)
{
    memcpy(vertex->position, mesh->positions + 3 * (size_t)i, sizeof vertex->position);
    memcpy(vertex->normal, mesh->normals + 3 * (size_t)i, sizeof vertex->normal);
    if (mesh->colors)
        memcpy(vertex->color, mesh->colors + 4 * (size_t)i, sizeof vertex->color);
    if (mesh->texcoords) {
        vertex->texcoord[0] = mesh->texcoords[2 * (size_t)i];
        vertex->texcoord[1] = 1 - mesh->texcoords[2 * (size_t)i + 1];
    }
}

static GpResult load(const char *path, bool points, Shape *shape, GpError *error)
{
    GpMesh mesh = { 0 };
    GpResult result = gp_mesh_read(path, points ? GP_MESH_ALLOW_POINTS : 0, &mesh, error);
    if (result)
        return result;
    uint32_t indices = points ? 0 : 3 * mesh.triangle_count;
    result = shape_alloc(shape, mesh.vertex_count, indices);
    if (result) {
        gp_mesh_free(&mesh);
        return gp_fail(error, result, "%.200s: no memory", path);
    }
    for (uint32_t i = 0; i < mesh.vertex_count; i++)
        copy_vertex(&mesh, i, &shape->vertices[i]);
    if (indices)
        memcpy(shape->indices, mesh.indices, indices * sizeof *mesh.indices);
    gp_mesh_free(&mesh);
    return GP_OK;
}

GpResult scene_load_mesh(const char *path, Shape *shape, GpError *error)
{
    return load(path, false, shape, error);
}

GpResult scene_load_points(const char *path, Shape *shape, GpError *error)
{
    return load(path, true, shape, error);
}

/* --- pictures -------------------------------------------------------------------------------- */

/* The format that loses nothing; grey and missing alpha are filled in. */
static GpFormat surface_format(const GpImage *image, bool srgb)
{
    if (image->type == GP_IMAGE_U8)
        return srgb ? GP_A8R8G8B8_SRGB : GP_A8R8G8B8;
    return image->type == GP_IMAGE_F16 ? GP_A16B16G16R16F : GP_A32B32G32R32F;
}

static float sample(const GpImage *image, size_t at)
{
    switch (image->type) {
    case GP_IMAGE_U8:
        return gp_float_from_unorm(((const uint8_t *)image->data)[at], 8);
    case GP_IMAGE_U16:
        return gp_float_from_unorm(((const uint16_t *)image->data)[at], 16);
    case GP_IMAGE_F16:
        return gp_float_from_half(((const uint16_t *)image->data)[at]);
    default:
        return ((const float *)image->data)[at];
    }
}

/* One pixel as it is stored, so that bytes stay the bytes they are in sRGB too. */
static void copy_pixel(const GpImage *image, size_t pixel, GpSurface *surface, uint8_t *texel)
{
    size_t first = pixel * image->channels;
    bool grey = image->channels < 3, alpha = image->channels % 2 == 0;
    float rgba[4];
    for (size_t c = 0; c < 3; c++)
        rgba[c] = sample(image, first + (grey ? 0 : c));
    rgba[3] = alpha ? sample(image, first + image->channels - 1) : 1;
    GpFormat stored = surface->format == GP_A8R8G8B8_SRGB ? GP_A8R8G8B8 : surface->format;
    gp_texel_store(stored, texel, rgba, 0);
}

GpResult scene_load_image(const char *path, bool srgb, bool mips, GpSurface **surface,
                          GpError *error)
{
    GpImage image = { 0 };
    GpSurface *made = NULL;
    GpResult result = gp_image_read(path, &image, error);
    if (result)
        return result;
    GpSurfaceDesc desc = { .format = surface_format(&image, srgb),
                           .width = image.width,
                           .height = image.height,
                           .levels = mips ? GP_MAX_LEVELS : 1,
                           .name = "picture" };
    result = gp_surface_create(&desc, &made, error);
    for (uint32_t y = 0; y < image.height && !result; y++)
        for (uint32_t x = 0; x < image.width; x++)
            copy_pixel(
                &image, (size_t)y * image.width + x, made,
                gp_surface_texel(&made->level[0], gp_format_info(made->format)->bytes, x, y));
    gp_image_free(&image);
    if (result)
        return result;
    if (mips)
        gp_surface_build_mips(made);
    *surface = made;
    return GP_OK;
}
