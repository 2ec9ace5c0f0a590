#include "apps/depth_images/rivals/dmesh.h"

#include "apps/depth_images/drawing/light.h"
#include "apps/depth_images/rivals/slab.h"
#include "pipeline/io/mesh/simplify.h"
#include "shaders_c/warp/surface.h"

#include <string.h>

static const double usual_cut = 0.02;

/* --- triangles -------------------------------------------------------------------------------- */

/* Whether three pixels are one surface. */
static bool joins(const DepthImage *image, const uint32_t pixel[3], double cut)
{
    double nearest = HUGE_VAL, farthest = 0;
    for (int k = 0; k < 3; k++) {
        const double depth = (double)image->front.depth[pixel[k]];
        if (!isfinite(depth) || (!image->plane.is_parallel && depth <= 0))
            return false;
        nearest = fmin(nearest, depth);
        farthest = fmax(farthest, depth);
    }
    return cut < 0 || farthest - nearest <= cut * nearest;
}

/* Two to a cell of four pixels, by numbers of pixels. returns how many */
static uint32_t find_triangles(const DepthImage *image, double cut, uint32_t *indices)
{
    const uint32_t width = image->front.width, height = image->front.height;
    uint32_t count = 0;
    for (uint32_t y = 0; y + 1 < height; y++)
        for (uint32_t x = 0; x + 1 < width; x++) {
            const uint32_t at = y * width + x;
            const uint32_t halves[2][3] = { { at, at + width, at + 1 },
                                            { at + 1, at + width, at + width + 1 } };
            for (int half = 0; half < 2; half++) {
                if (!joins(image, halves[half], cut))
                    continue;
                if (indices)
                    memcpy(indices + 3 * (size_t)count, halves[half], sizeof halves[half]);
                count++;
            }
        }
    return count;
}

/* Numbers pixels that triangles have, and makes vertices of them.
 * in/out dmesh: its indices are pixels, and become vertices */
static GpResult find_vertices(const DepthImage *image, Dmesh *dmesh)
{
    const DepthPixels *pixels = &image->front;
    const size_t count = (size_t)pixels->width * pixels->height;
    uint32_t *number = gp_alloc(count, sizeof *number); /* and 1; 0: none */
    if (!number)
        return GP_ERROR_MEMORY;
    for (size_t i = 0; i < 3 * (size_t)dmesh->triangle_count; i++)
        number[dmesh->indices[i]] = 1;
    for (size_t i = 0; i < count; i++)
        if (number[i])
            number[i] = ++dmesh->vertex_count;
    for (size_t i = 0; i < 3 * (size_t)dmesh->triangle_count; i++)
        dmesh->indices[i] = number[dmesh->indices[i]] - 1;
    dmesh->positions = gp_alloc(dmesh->vertex_count, sizeof *dmesh->positions);
    dmesh->texcoords = gp_alloc(dmesh->vertex_count, sizeof *dmesh->texcoords);
    const bool has_memory = dmesh->positions && dmesh->texcoords;
    for (size_t i = 0; i < count && has_memory; i++) {
        if (!number[i])
            continue;
        const double x = (double)(i % pixels->width) + 0.5, y = (double)(i / pixels->width) + 0.5;
        double point[3];
        depth_plane_point(&image->plane, pixels, x, y, (double)pixels->depth[i], point);
        for (int k = 0; k < 3; k++)
            dmesh->positions[number[i] - 1][k] = (float)point[k];
        dmesh->texcoords[number[i] - 1][0] = (float)(x / pixels->width);
        dmesh->texcoords[number[i] - 1][1] = (float)(y / pixels->height);
    }
    gp_free(number);
    return has_memory ? GP_OK : GP_ERROR_MEMORY;
}

/* --- simplified ------------------------------------------------------------------------------- */

/* Keeps of the vertices those that are left, in their order. */
static GpResult simplify(const DmeshDetail *detail, Dmesh *dmesh, GpError *error)
{
    const GpSimplifyInput input = {
        .positions = &dmesh->positions[0][0],
        .indices = dmesh->indices,
        .vertex_count = dmesh->vertex_count,
        .triangle_count = dmesh->triangle_count,
        .least_triangles = (uint32_t)(fmin(detail->share, 1) * dmesh->triangle_count),
    };
    GpSimplified left;
    const GpResult result = gp_mesh_simplify(&input, &left, error);
    if (result)
        return result;
    for (uint32_t i = 0; i < left.vertex_count; i++) {
        const uint32_t from = left.vertices[i];
        memmove(dmesh->positions[i], dmesh->positions[from], sizeof dmesh->positions[i]);
        memmove(dmesh->texcoords[i], dmesh->texcoords[from], sizeof dmesh->texcoords[i]);
    }
    memcpy(dmesh->indices, left.indices, (size_t)left.triangle_count * 3 * sizeof *left.indices);
    dmesh->vertex_count = left.vertex_count;
    dmesh->triangle_count = left.triangle_count;
    gp_simplified_free(&left);
    return GP_OK;
}

/* --- meshes ----------------------------------------------------------------------------------- */

static GpResult make_mesh(const DepthImage *image, const DmeshDetail *detail, Dmesh *dmesh,
                          GpError *error)
{
    const double cut = detail->cut != 0 ? detail->cut : usual_cut;
    dmesh->triangle_count = find_triangles(image, cut, NULL);
    if (dmesh->triangle_count == 0)
        return GP_OK;
    dmesh->indices = gp_alloc(dmesh->triangle_count, 3 * sizeof *dmesh->indices);
    if (!dmesh->indices)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    find_triangles(image, cut, dmesh->indices);
    if (find_vertices(image, dmesh))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    return detail->share > 0 ? simplify(detail, dmesh, error) : GP_OK;
}

GpResult dmesh_open_detailed(const DepthImage *image, const DmeshDetail *detail, Dmesh *dmesh,
                             GpError *error)
{
    static const DmeshDetail usual = { 0 };
    Dmesh made = { .positions = NULL };
    GpResult result = slab_check(image, "a depth mesh", error);
    if (!result)
        result = make_mesh(image, detail ? detail : &usual, &made, error);
    if (!result && made.triangle_count > 0)
        result = slab_textures_open(image, &made.textures, error);
    if (result)
        dmesh_close(&made);
    else
        *dmesh = made;
    return result;
}

GpResult dmesh_open(const DepthImage *image, Dmesh *dmesh, GpError *error)
{
    return dmesh_open_detailed(image, NULL, dmesh, error);
}

void dmesh_close(Dmesh *dmesh)
{
    gp_free(dmesh->positions);
    gp_free(dmesh->texcoords);
    gp_free(dmesh->indices);
    depth_textures_close(&dmesh->textures);
    *dmesh = (Dmesh){ .positions = NULL };
}

GpResult dmesh_add(const Dmesh *dmesh, const DmeshSetting *setting, const WarpView *view,
                   const WarpTarget *target, Frame *frame, GpError *error)
{
    static const GpSampler linear = {
        .min = GP_LINEAR, .mag = GP_LINEAR, .address_u = GP_CLAMP, .address_v = GP_CLAMP
    };
    static const float nothing[4] = { 0 };
    GpSurface *depth =
        target->depth ? target->depth : frame_surface(frame, GP_D32F, view->width, view->height, 1);
    GpPass *pass =
        frame_pass(frame, setting->name ? setting->name : "dmesh", target->color, depth, nothing);
    pass->color[0].clear = false;
    pass->depth.clear_depth = !target->depth;
    if (dmesh->triangle_count == 0)
        return frame_result(frame, error);
    const GpGeometry geometry = {
        .vertex_count = dmesh->vertex_count,
        .indices = dmesh->indices,
        .index_count = 3 * dmesh->triangle_count,
        .streams = { [GP_POSITION] = { dmesh->positions, 0, 3, GP_FLOAT32 },
                     [GP_TEXCOORD0] = { dmesh->texcoords, 0, 2, GP_FLOAT32 } },
    };
    SurfaceUniforms uniforms = { .mvp = { { 0 } } };
    camera_matrix(&view->camera, (double)view->width / view->height, uniforms.mvp);
    if (view->light)
        uniforms.light = warp_light_uniforms(view);
    GpDraw *draw = frame_draw_copied(frame, view->light ? &surface_lit_program : &surface_program,
                                     &uniforms, &geometry);
    draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    draw->textures[0] = (GpTexture){ dmesh->textures.color, linear };
    if (view->light)
        draw->textures[1] = (GpTexture){ dmesh->textures.normal, linear };
    return frame_result(frame, error);
}
