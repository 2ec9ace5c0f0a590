#include "apps/depth_images/drawing/direct.h"

#include "apps/depth_images/drawing/light.h"
#include "apps/depth_images/drawing/plane.h"
#include "apps/depth_images/drawing/surface_grid.h"
#include "shaders_c/warp/direct.h"

#include <string.h>

/* --- what stays ------------------------------------------------------------------------------- */

/* What is meant: without the second layer, and with it. */
static const EdgeSetting usual_edges[2] = { { .rule = EDGES_SLOPES },
                                            { .spread = 2.5, .texels = 2, .along = 0.3 } };
static const double usual_reach[2] = { 0.4, 0.5 };
static const GridEnds usual_ends[2] = { { .lean = 1 }, { .lean = 2, .most = 3.5 } };

GpResult direct_open(const DepthImage *image, Direct *made, GpError *error)
{
    Direct direct = { .image = image, .pixel = surface_grid_pixel(image) };
    if (image->is_cylinder)
        return gp_fail(error, GP_ERROR_INVALID, "a cylinder is no planar depth image");
    plane_ball(image, direct.center, &direct.radius);
    *made = direct;
    return GP_OK;
}

void direct_close(Direct *made)
{
    for (int layer = 0; layer < DIRECT_LAYERS; layer++)
        for (int i = 0; i < DIRECT_STEPS; i++)
            warp_grid_free(&made->grids[layer][i]);
    for (int i = 0; i < 4; i++)
        depth_textures_close(&made->textures[i / 2][i % 2]);
    *made = (Direct){ .image = NULL };
}

static const DepthPixels *pixels_of(const Direct *made, DirectLayer layer)
{
    return layer == DIRECT_BEHIND ? &made->image->behind : &made->image->front;
}

static GpResult build_grid(const Direct *made, DirectLayer layer, const EdgeSetting *edges,
                           const GridSetting *setting, WarpGrid *grid)
{
    DepthLattice lattice;
    GpResult result =
        depth_lattice_make(&made->image->plane, pixels_of(made, layer), edges, &lattice);
    if (result)
        return result;
    result = warp_grid_make(&lattice, setting, grid);
    depth_lattice_free(&lattice);
    return result;
}

static GpResult keep_grid(Direct *made, DirectLayer layer, int step)
{
    const int layers = layer != DIRECT_ALONE;
    const GridSetting setting = { .step = 1u << step,
                                  .reach = usual_reach[layers],
                                  .ends = usual_ends[layers],
                                  .turned = layer == DIRECT_BEHIND };
    GpResult result = GP_OK;
    if (!made->has_grid[layer][step])
        result = build_grid(made, layer, &usual_edges[layers], &setting, &made->grids[layer][step]);
    made->has_grid[layer][step] = !result;
    return result;
}

/* kept: of the layer, of one level or of all */
static GpResult keep_textures(const DepthPixels *pixels, bool is_lit, uint32_t levels,
                              DepthTextures *kept, GpError *error)
{
    GpResult result = GP_OK;
    if (!kept->color)
        result = depth_color_texture(pixels, levels, &kept->color, error);
    if (!result && is_lit && !kept->normal)
        result = depth_normal_texture(pixels, pixels->normal, levels, &kept->normal, error);
    return result;
}

/* --- a frame ---------------------------------------------------------------------------------- */

/* Grids are kept of steps that are powers of two; the largest that is no larger than what is
 * asked. */
static int kept_step(uint32_t step)
{
    int i = 0;
    while (i + 1 < DIRECT_STEPS && 2u << i <= step)
        i++;
    return i;
}

static bool has_edges(const EdgeSetting *edges)
{
    return edges->rule || edges->share > 0 || edges->spread > 0 || edges->texels > 0 ||
           edges->along > 0;
}

static bool is_usual(const DirectSetting *setting)
{
    return setting->tolerance == 0 && setting->reach == 0 && !has_edges(&setting->edges) &&
           !setting->detail.heights && !setting->step;
}

/* A layer's grid for this frame alone. */
static GpResult make_grid(const Direct *made, const DirectSetting *setting, DirectLayer layer,
                          uint32_t step, Frame *frame, WarpGrid *grid)
{
    const EdgeSetting *edges =
        has_edges(&setting->edges) ? &setting->edges : &usual_edges[setting->layers];
    const GridSetting own = { .step = step,
                              .tolerance = setting->detail.heights ? -1 : setting->tolerance,
                              .reach = setting->reach > 0 ? setting->reach
                                                          : usual_reach[setting->layers],
                              .ends = usual_ends[setting->layers],
                              .turned = layer == DIRECT_BEHIND };
    WarpGrid whole;
    const GpResult result = build_grid(made, layer, edges, &own, &whole);
    if (result)
        return result;
    *grid = whole;
    grid->vertices =
        (void *)frame_copy(frame, whole.vertices, whole.vertex_count * sizeof *whole.vertices);
    grid->indices =
        (void *)frame_copy(frame, whole.indices, whole.index_count * sizeof *whole.indices);
    warp_grid_free(&whole);
    return frame_result(frame, NULL);
}

static GpResult find_grid(Direct *made, const DirectSetting *setting, DirectLayer layer,
                          uint32_t step, Frame *frame, WarpGrid *grid)
{
    if (!is_usual(setting))
        return make_grid(made, setting, layer, step, frame, grid);
    const GpResult result = keep_grid(made, layer, kept_step(step));
    *grid = made->grids[layer][kept_step(step)];
    return result;
}

static DirectUniforms find_uniforms(const DepthImage *image, const DirectSetting *setting,
                                    uint32_t step, const WarpView *view)
{
    const bool is_parallel = image->plane.is_parallel;
    DirectUniforms uniforms = { .spread = { is_parallel ? 0 : 1, is_parallel ? 1 : 0 } };
    double to_world[4][4], to_clip[4][4], product[4][4];
    float world[4][4];
    plane_to_world(&image->plane, &image->front, to_world);
    view_to_clip(view, to_clip);
    matrix_multiply(to_clip, to_world, product);
    matrix_round(product, uniforms.to_clip);
    matrix_round(to_world, world);
    memcpy(uniforms.to_world, world, sizeof uniforms.to_world);
    uniforms.detail = warp_detail_uniforms(&setting->detail, &image->front, step);
    if (view->light)
        uniforms.light = warp_light_uniforms(view);
    return uniforms;
}

static GpDraw *draw_grid(const WarpGrid *grid, GpSurface *color, GpSurface *normal,
                         const DirectUniforms *uniforms, const WarpDetail *detail, bool is_far,
                         Frame *frame)
{
    static const GpProgram *const programs[2][2] = { { &direct_program, &direct_lit_program },
                                                     { &direct_detail_program,
                                                       &direct_detail_lit_program } };
    const GpSampler linear = { .min = GP_LINEAR,
                               .mag = GP_LINEAR,
                               .mip = is_far ? GP_MIP_LINEAR : GP_MIP_NONE,
                               .address_u = GP_CLAMP,
                               .address_v = GP_CLAMP };
    const uint32_t stride = sizeof(GridVertex);
    const GpGeometry geometry = {
        .vertex_count = grid->vertex_count,
        .indices = grid->indices,
        .index_count = grid->index_count,
        .streams = { [GP_POSITION] = { &grid->vertices->x, stride, 3, GP_FLOAT32 },
                     [GP_TEXCOORD0] = { &grid->vertices->u, stride, 2, GP_FLOAT32 } }
    };
    const bool has_detail = detail->heights != NULL, is_lit = normal != NULL;
    GpDraw *draw = frame_draw_copied(frame, programs[has_detail][is_lit], uniforms, &geometry);
    draw->textures[0] = (GpTexture){ color, linear };
    if (is_lit)
        draw->textures[1] = (GpTexture){ normal, linear };
    if (has_detail)
        draw->textures[WARP_DETAIL_SLOT] = warp_detail_texture(detail);
    draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    return draw;
}

static GpResult add_layer(Direct *made, const DirectSetting *setting, const WarpView *view,
                          DirectLayer layer, uint32_t footprint, Frame *frame, GpError *error)
{
    const DepthPixels *pixels = pixels_of(made, layer);
    const bool is_behind = layer == DIRECT_BEHIND, is_far = footprint > 1,
               is_lit = view->light && pixels->normal;
    const uint32_t step = setting->step ? setting->step : footprint;
    DepthTextures *textures = &made->textures[is_behind][is_far];
    WarpGrid grid;
    GpResult result = find_grid(made, setting, layer, step, frame, &grid);
    if (result)
        return gp_fail(error, result, "out of memory");
    if (!grid.index_count)
        return GP_OK;
    result = keep_textures(pixels, is_lit, is_far ? GP_MAX_LEVELS : 1, textures, error);
    if (result)
        return result;
    const DirectUniforms uniforms = find_uniforms(made->image, setting, step, view);
    GpDraw *draw = draw_grid(&grid, textures->color, is_lit ? textures->normal : NULL, &uniforms,
                             &setting->detail, is_far, frame);
    if (setting->one_sided || (is_behind && pixels->normal)) /* insides */
        draw->state.raster.cull = GP_CULL_CW;
    return GP_OK;
}

GpResult direct_add(Direct *made, const DirectSetting *given, const WarpView *view,
                    const WarpTarget *target, Frame *frame, GpError *error)
{
    static const float nothing[4] = { 0 };
    DirectSetting setting = *given;
    setting.layers = setting.layers && made->image->behind.width;
    const uint32_t footprint = plane_step(made->center, made->radius, made->pixel, view);
    GpSurface *depth =
        target->depth ? target->depth : frame_surface(frame, GP_D32F, view->width, view->height, 1);
    GpPass *pass =
        frame_pass(frame, setting.name ? setting.name : "direct", target->color, depth, nothing);
    pass->color[0].clear = false;
    pass->depth.clear_depth = !target->depth;
    GpResult result = add_layer(made, &setting, view, setting.layers ? DIRECT_BEFORE : DIRECT_ALONE,
                                footprint, frame, error);
    if (!result && setting.layers)
        result = add_layer(made, &setting, view, DIRECT_BEHIND, footprint, frame, error);
    return result ? result : frame_result(frame, error);
}

const char *direct_warning(const DepthImage *image, const WarpView *view)
{
    DepthExtent extent;
    if (image->is_cylinder || !depth_extent(&image->front, &extent))
        return NULL;
    const char *warning = plane_warning(&image->plane, &extent, view);
    return warning ? warning : depth_level_warning(&image->plane, &image->front);
}
