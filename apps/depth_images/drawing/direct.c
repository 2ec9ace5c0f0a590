#include "apps/depth_images/drawing/direct.h"

#include "apps/depth_images/drawing/light.h"
#include "apps/depth_images/drawing/plane.h"
#include "apps/depth_images/drawing/surface_grid.h"
#include "shaders_c/warp/direct.h"

#include <string.h>

/* --- what stays ------------------------------------------------------------------------------------- */

/* What is meant: without the second layer, and with it. */
static const EdgeSetting usual_edges[2] = { { .rule = EDGES_SLOPES },
                                            { .spread = 2.5, .texels = 2, .along = 0.3 } };
static const double usual_reach[2] = { 0.4, 0.5 };
static const GridEnds usual_ends[2] = { { .lean = 1 }, { .lean = 2, .most = 3.5 } };

static GpResult make_grids(const DepthPlane *plane, const DepthPixels *pixels, bool layers,
                           bool turned, WarpGrid grids[DIRECT_STEPS])
{
    DepthLattice lattice = { .flat = NULL };
    GridSetting setting = { .reach = usual_reach[layers],
                            .ends = usual_ends[layers],
                            .turned = turned };
    if (!pixels->width)
        return GP_OK;
    GpResult result = depth_lattice_make(plane, pixels, &usual_edges[layers], &lattice);
    for (uint32_t i = 0; i < DIRECT_STEPS && !result; i++) {
        setting.step = 1u << i;
        result = warp_grid_make(&lattice, &setting, &grids[i]);
    }
    depth_lattice_free(&lattice);
    return result;
}

static GpResult make_all_grids(const DepthImage *image, Direct *direct)
{
    const DepthPlane *plane = &image->plane;
    GpResult result = make_grids(plane, &image->front, false, false, direct->front);
    if (!result && image->behind.width)
        result = make_grids(plane, &image->front, true, false, direct->layers[0]);
    if (!result)
        result = make_grids(plane, &image->behind, true, true, direct->layers[1]);
    return result;
}

GpResult direct_open(const DepthImage *image, Direct *made, GpError *error)
{
    Direct direct = { .image = image, .pixel = surface_grid_pixel(image) };
    if (image->is_cylinder)
        return gp_fail(error, GP_ERROR_INVALID, "a cylinder is no planar depth image");
    plane_ball(image, direct.center, &direct.radius);
    if (make_all_grids(image, &direct)) {
        direct_close(&direct);
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    }
    const DepthPixels *layers[2] = { &image->front, &image->behind };
    GpResult result = GP_OK;
    for (int i = 0; i < 2 && !result; i++)
        if (layers[i]->width)
            result = depth_textures_open(layers[i], layers[i]->normal, &direct.textures[i], error);
    if (result)
        direct_close(&direct);
    else
        *made = direct;
    return result;
}

void direct_close(Direct *made)
{
    for (int i = 0; i < DIRECT_STEPS; i++) {
        warp_grid_free(&made->front[i]);
        warp_grid_free(&made->layers[0][i]);
        warp_grid_free(&made->layers[1][i]);
    }
    for (int i = 0; i < 2; i++)
        depth_textures_close(&made->textures[i]);
    *made = (Direct){ .image = NULL };
}

/* --- a frame ---------------------------------------------------------------------------------------- */

/* Grids are kept of steps that are powers of two; the largest that is no larger than what is asked. */
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
static GpResult make_grid(const Direct *made, const DirectSetting *setting, int layer,
                          uint32_t step, Frame *frame, WarpGrid *grid)
{
    const DepthImage *image = made->image;
    const EdgeSetting *edges =
        has_edges(&setting->edges) ? &setting->edges : &usual_edges[setting->layers];
    const GridSetting own = { .step = step,
                              .tolerance = setting->detail.heights ? -1 : setting->tolerance,
                              .reach = setting->reach > 0 ? setting->reach
                                                          : usual_reach[setting->layers],
                              .ends = usual_ends[setting->layers],
                              .turned = layer == 1 };
    DepthLattice lattice;
    WarpGrid whole;
    GpResult result =
        depth_lattice_make(&image->plane, layer ? &image->behind : &image->front, edges, &lattice);
    if (result)
        return result;
    result = warp_grid_make(&lattice, &own, &whole);
    depth_lattice_free(&lattice);
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

static GpResult find_grid(const Direct *made, const DirectSetting *setting, int layer,
                          uint32_t step, Frame *frame, WarpGrid *grid)
{
    if (!is_usual(setting))
        return make_grid(made, setting, layer, step, frame, grid);
    *grid = setting->layers ? made->layers[layer][kept_step(step)] : made->front[kept_step(step)];
    return GP_OK;
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

static GpDraw *draw_layer(const WarpGrid *grid, const DepthTextures *textures,
                          const DirectUniforms *uniforms, const WarpDetail *detail, bool is_lit,
                          bool is_far, Frame *frame)
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
    const bool has_detail = detail->heights != NULL;
    GpDraw *draw = frame_draw_copied(frame, programs[has_detail][is_lit], uniforms, &geometry);
    draw->textures[0] = (GpTexture){ textures->color, linear };
    if (is_lit)
        draw->textures[1] = (GpTexture){ textures->normal, linear };
    if (has_detail)
        draw->textures[WARP_DETAIL_SLOT] = warp_detail_texture(detail);
    draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    return draw;
}

GpResult direct_add(const Direct *made, const DirectSetting *given, const WarpView *view,
                    const WarpTarget *target, Frame *frame, GpError *error)
{
    static const float nothing[4] = { 0 };
    const DepthImage *image = made->image;
    DirectSetting own = *given;
    const DirectSetting *setting = &own;
    own.layers = own.layers && image->behind.width;
    const uint32_t footprint = plane_step(made->center, made->radius, made->pixel, view);
    const uint32_t step = setting->step ? setting->step : footprint;
    const DirectUniforms uniforms = find_uniforms(image, setting, step, view);
    GpSurface *depth =
        target->depth ? target->depth : frame_surface(frame, GP_D32F, view->width, view->height, 1);
    GpPass *pass =
        frame_pass(frame, setting->name ? setting->name : "direct", target->color, depth, nothing);
    pass->color[0].clear = false;
    pass->depth.clear_depth = !target->depth;
    for (int layer = 0; layer < 1 + setting->layers; layer++) {
        WarpGrid grid;
        const DepthTextures *textures = &made->textures[layer];
        const GpResult result = find_grid(made, setting, layer, step, frame, &grid);
        if (result)
            return gp_fail(error, result, "out of memory");
        if (!grid.index_count)
            continue;
        GpDraw *draw = draw_layer(&grid, textures, &uniforms, &setting->detail,
                                  view->light && textures->normal, footprint > 1, frame);
        if (setting->one_sided || (layer == 1 && image->behind.normal)) /* insides */
            draw->state.raster.cull = GP_CULL_CW;
    }
    return frame_result(frame, error);
}

const char *direct_warning(const DepthImage *image, const WarpView *view)
{
    DepthExtent extent;
    if (image->is_cylinder || !depth_extent(&image->front, &extent))
        return NULL;
    const char *warning = plane_warning(&image->plane, &extent, view);
    return warning ? warning : depth_level_warning(&image->plane, &image->front);
}
