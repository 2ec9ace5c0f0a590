#include "apps/depth_images/drawing/surface.h"

#include "apps/base/bounds.h"
#include "apps/depth_images/drawing/footprint.h"
#include "apps/depth_images/drawing/light.h"
#include "apps/depth_images/drawing/shares.h"
#include "apps/depth_images/drawing/surface_grid.h"
#include "apps/depth_images/drawing/view_planes.h"
#include "shaders_c/common/depth_only.h"
#include "shaders_c/warp/surface.h"

#include <math.h>
#include <string.h>

enum {
    LEAST_CELLS = 8,   /* of a level, across and down */
    BETWEEN = 3 * 200, /* indices */
};

static const double usual_tolerance = 0.25, usual_cut = 4;
static const float depth_slope = 2; /* of shadow maps: their texels' neighbours are read too */

/* --- levels ----------------------------------------------------------------------------------- */

static GpResult make_vertices(const SurfaceGrid *grid, SurfaceLevel *level, GpError *error)
{
    level->vertices = gp_alloc(level->mesh.vertex_count, sizeof *level->vertices);
    if (!level->vertices)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (uint32_t i = 0; i < level->mesh.vertex_count; i++) {
        SurfaceVertex *vertex = &level->vertices[i];
        const uint32_t point = level->mesh.points[i];
        memcpy(vertex->position, grid->position[point], sizeof vertex->position);
        memcpy(vertex->normal, grid->normal[point], sizeof vertex->normal);
        surface_grid_texcoord(grid, point, vertex->texcoord);
    }
    return GP_OK;
}

static GpResult make_level(const DepthImage *image, const float *normals, uint32_t step,
                           const SurfaceDetail *detail, double pixel, SurfaceLevel *level,
                           GpError *error)
{
    SurfaceGrid grid;
    GpResult result = surface_grid_open(image, normals, step, detail->cut, &grid, error);
    if (result)
        return result;
    uint32_t *needed = NULL;
    MergeGrid points = { .columns = grid.columns,
                         .rows = grid.rows,
                         .wraps = image->is_cylinder,
                         .position = (const float(*)[3])grid.position,
                         .normal = (const float(*)[3])grid.normal,
                         .cut = grid.cut };
    level->step = step;
    if (detail->own && shares_sum(image, detail->own, step, grid.columns, grid.rows, &needed))
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    points.needed = needed;
    if (!result)
        result = merge_grid(&points, detail->tolerance * pixel * step, &level->mesh, error);
    gp_free(needed);
    if (!result)
        result = make_vertices(&grid, level, error);
    surface_grid_close(&grid);
    return result;
}

static void find_ball(DepthSurface *surface)
{
    const SurfaceLevel *level = &surface->levels[0];
    const SurfaceVertex *vertices = level->vertices;
    double square = 0;
    if (!level->mesh.vertex_count)
        return;
    const Bounds box =
        bounds_of(vertices->position, sizeof *vertices, NULL, level->mesh.vertex_count);
    for (int k = 0; k < 3; k++)
        surface->center[k] = (box.low[k] + box.high[k]) / 2;
    for (uint32_t i = 0; i < level->mesh.vertex_count; i++) {
        double away[3];
        for (int k = 0; k < 3; k++)
            away[k] = (double)vertices[i].position[k] - surface->center[k];
        square = fmax(square, vector_dot(away, away));
    }
    surface->radius = sqrt(square);
}

GpResult surface_open(const DepthImage *image, const SurfaceDetail *detail, DepthSurface *surface,
                      GpError *error)
{
    const SurfaceDetail wanted = { detail && detail->tolerance > 0 ? detail->tolerance
                                                                   : usual_tolerance,
                                   detail && detail->cut != 0 ? detail->cut : usual_cut,
                                   detail ? detail->own : NULL };
    const DepthPixels *front = &image->front;
    DepthSurface made = { .is_cylinder = image->is_cylinder, .pixel = surface_grid_pixel(image) };
    float *found = NULL;
    GpResult result =
        front->normal ? GP_OK : surface_grid_normals(image, wanted.cut, &found, error);
    const float *normals = front->normal ? front->normal : found;
    if (!result)
        result = depth_textures_open(front, normals, &made.textures, error);
    for (uint32_t step = 1; !result && made.level_count < SURFACE_MAX_LEVELS; step *= 2) {
        if (step > 1 && (front->width / step < LEAST_CELLS || front->height / step < LEAST_CELLS))
            break;
        result = make_level(image, normals, step, &wanted, made.pixel,
                            &made.levels[made.level_count++], error);
    }
    gp_free(found);
    if (result) {
        surface_close(&made);
        return result;
    }
    find_ball(&made);
    *surface = made;
    return GP_OK;
}

void surface_close(DepthSurface *surface)
{
    depth_textures_close(&surface->textures);
    for (uint32_t i = 0; i < surface->level_count; i++) {
        merged_free(&surface->levels[i].mesh);
        gp_free(surface->levels[i].vertices);
    }
    *surface = (DepthSurface){ .level_count = 0 };
}

/* --- what a view sees ------------------------------------------------------------------------- */

uint32_t surface_step(const DepthSurface *surface, const WarpView *view)
{
    return footprint_step(surface->center, surface->radius, surface->pixel, view);
}

static const SurfaceLevel *level_for(const DepthSurface *surface, const SurfaceSetting *setting,
                                     const WarpView *view)
{
    const uint32_t step = setting->step ? setting->step : surface_step(surface, view);
    const SurfaceLevel *level = surface->levels, *last = level + surface->level_count - 1;
    while (level < last && level[1].step <= step)
        level++;
    return level;
}

/* --- draws ------------------------------------------------------------------------------------ */

/* What all draws of a surface have. */
typedef struct SurfaceDraws {
    GpDraw draw;
    const SurfaceLevel *level;
    Frame *frame;
    uint32_t triangles;
} SurfaceDraws;

static void draw_patches(SurfaceDraws *draws, uint32_t first, uint32_t end)
{
    const MergedMesh *mesh = &draws->level->mesh;
    const MergedPatch *from = &mesh->patches[first], *to = &mesh->patches[end - 1];
    GpGeometry geometry = draws->draw.geometry;
    geometry.indices = mesh->indices + from->first_index;
    geometry.index_count = to->first_index + to->index_count - from->first_index;
    GpDraw *draw = frame_draw(draws->frame, draws->draw.program, draws->draw.uniforms, &geometry);
    draw->state = draws->draw.state;
    memcpy(draw->textures, draws->draw.textures, sizeof draw->textures);
    draws->triangles += geometry.index_count / 3;
}

/* Neighbours that may be seen are one draw, with what lies between them where that is less than to
 * prepare another. */
static void draw_seen(SurfaceDraws *draws, const WarpView *view, bool both_sides)
{
    const MergedMesh *mesh = &draws->level->mesh;
    const ViewPlanes planes = view_planes(view);
    const bool is_parallel = !(view->camera.fovy > 0);
    double eye[3];
    uint32_t first = 0, end = 0, last = 0; /* patches that wait; the index behind them */
    memcpy(eye, view->camera.eye, sizeof eye);
    if (is_parallel) {
        vector_subtract(view->camera.eye, view->camera.at, eye);
        vector_normalize(eye);
    }
    for (uint32_t i = 0; i < mesh->patch_count; i++) {
        const MergedPatch *patch = &mesh->patches[i];
        if (!view_planes_may_see(&planes, patch->center, patch->radius) ||
            !(both_sides || merged_may_face(patch, eye, is_parallel)))
            continue;
        if (first < end && patch->first_index > last + BETWEEN) {
            draw_patches(draws, first, end);
            first = end;
        }
        first = first == end ? i : first;
        end = i + 1;
        last = patch->first_index + patch->index_count;
    }
    if (first < end)
        draw_patches(draws, first, end);
}

static GpGeometry geometry_of(const SurfaceLevel *level)
{
    const SurfaceVertex *vertices = level->vertices;
    const uint32_t stride = sizeof *vertices;
    return (GpGeometry){
        .vertex_count = level->mesh.vertex_count,
        .streams = { [GP_POSITION] = { vertices->position, stride, 3, GP_FLOAT32 },
                     [GP_TEXCOORD0] = { vertices->texcoord, stride, 2, GP_FLOAT32 } },
    };
}

static SurfaceUniforms uniforms_of(const SurfaceSetting *setting, const WarpView *view)
{
    SurfaceUniforms uniforms = { .mvp = { { 0 } } };
    camera_matrix(&view->camera, (double)view->width / view->height, uniforms.mvp);
    if (view->light)
        uniforms.light = warp_light_uniforms(view);
    if (setting->shadow)
        memcpy(uniforms.map, setting->shadow->map, sizeof uniforms.map);
    return uniforms;
}

/* A level that holds for all of the draw leaves pixels without neighbours to be shaded for its
 * sake. */
static GpSampler sampler_of(const DepthSurface *surface, const SurfaceSetting *setting,
                            const WarpView *view, const SurfaceLevel *level)
{
    GpSampler sampler = { .min = GP_LINEAR,
                          .mag = GP_LINEAR,
                          .address_u = surface->is_cylinder ? GP_WRAP : GP_CLAMP,
                          .address_v = GP_CLAMP };
    if (setting->is_distant)
        sampler.min_lod = (float)__builtin_ctz(surface_step(surface, view));
    else if (level->step > 1)
        sampler.mip = GP_MIP_POINT;
    return sampler;
}

/* in   view: lit from without end */
static SurfaceDistantUniforms distant_uniforms(const DepthSurface *surface,
                                               const SurfaceSetting *setting, const WarpView *view)
{
    const WarpLight *light = view->light;
    SurfaceDistantUniforms uniforms = { .specular = (float)WARP_SPECULAR,
                                        .shininess = (float)WARP_SHININESS };
    double way[3];
    camera_matrix(&view->camera, (double)view->width / view->height, uniforms.mvp);
    if (setting->shadow)
        memcpy(uniforms.map, setting->shadow->map, sizeof uniforms.map);
    vector_subtract(view->camera.eye, view->camera.fovy > 0 ? surface->center : view->camera.at,
                    way);
    vector_normalize(way);
    vector_add_scaled(way, 1, light->position, way);
    vector_normalize(way);
    for (int k = 0; k < 3; k++) {
        uniforms.half_way[k] = (float)way[k];
        uniforms.source[k] = (float)light->position[k];
        uniforms.color[k] = light->color[k];
        uniforms.ambient[k] = light->ambient[k];
    }
    return uniforms;
}

/* What shades it, and from what. */
static void set_program(const DepthSurface *surface, const SurfaceSetting *setting,
                        const WarpView *view, Frame *frame, GpDraw *draw)
{
    if (view->light && setting->is_distant) {
        const SurfaceDistantUniforms uniforms = distant_uniforms(surface, setting, view);
        draw->program =
            setting->shadow ? &surface_distant_shadowed_program : &surface_distant_program;
        draw->uniforms = frame_copy(frame, &uniforms, sizeof uniforms);
        return;
    }
    const SurfaceUniforms uniforms = uniforms_of(setting, view);
    draw->program = !view->light      ? &surface_program
                    : setting->shadow ? &surface_shadowed_program
                                      : &surface_lit_program;
    draw->uniforms = frame_copy(frame, &uniforms, sizeof uniforms);
}

uint32_t surface_draw(const DepthSurface *surface, const SurfaceSetting *setting,
                      const WarpView *view, bool has_depth, Frame *frame)
{
    const ViewPlanes planes = view_planes(view);
    if (!surface->level_count || !view_planes_may_see(&planes, surface->center, surface->radius))
        return 0;
    const SurfaceLevel *level = level_for(surface, setting, view);
    const GpSampler sampler = sampler_of(surface, setting, view, level);
    SurfaceDraws draws = { .level = level, .frame = frame };
    GpDraw *draw = &draws.draw;
    set_program(surface, setting, view, frame, draw);
    draw->geometry = geometry_of(level);
    draw->textures[0] = (GpTexture){ surface->textures.color, sampler };
    if (view->light)
        draw->textures[1] = (GpTexture){ surface->textures.normal, sampler };
    if (view->light && setting->shadow)
        draw->textures[2] = setting->shadow->texture;
    if (has_depth)
        draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    draw->state.raster.cull = setting->both_sides ? GP_CULL_NONE : GP_CULL_CW;
    draw_seen(&draws, view, setting->both_sides);
    return draws.triangles;
}

uint32_t surface_draw_depth(const DepthSurface *surface, const SurfaceSetting *setting,
                            const WarpView *view, Frame *frame)
{
    const ViewPlanes planes = view_planes(view);
    if (!surface->level_count || !view_planes_may_see(&planes, surface->center, surface->radius))
        return 0;
    SurfaceDraws draws = { .level = level_for(surface, setting, view), .frame = frame };
    DepthOnlyUniforms uniforms;
    camera_matrix(&view->camera, (double)view->width / view->height, uniforms.mvp);
    draws.draw.program = &depth_only_program;
    draws.draw.uniforms = frame_copy(frame, &uniforms, sizeof uniforms);
    draws.draw.geometry = geometry_of(draws.level);
    draws.draw.state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    draws.draw.state.raster.cull = setting->both_sides ? GP_CULL_NONE : GP_CULL_CW;
    draws.draw.state.raster.slope_depth_bias = depth_slope;
    draw_seen(&draws, view, setting->both_sides);
    return draws.triangles;
}

GpResult surface_add(const DepthSurface *surface, const SurfaceSetting *setting,
                     const WarpView *view, const WarpTarget *target, Frame *frame, GpError *error)
{
    static const float none[4] = { 0 };
    GpSurface *depth =
        target->depth ? target->depth : frame_surface(frame, GP_D32F, view->width, view->height, 1);
    GpPass *pass =
        frame_pass(frame, setting->name ? setting->name : "surface", target->color, depth, none);
    pass->color[0].clear = false;
    pass->depth.clear_depth = !target->depth;
    surface_draw(surface, setting, view, true, frame);
    return frame_result(frame, error);
}
