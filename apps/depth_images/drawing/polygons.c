#include "apps/depth_images/drawing/polygons.h"

#include "apps/depth_images/drawing/light.h"
#include "shaders_c/warp/polygons.h"
#include "shaders_c/warp/polygons_waves.h"

static GpGeometry geometry_of(const Polygons *polygons)
{
    return (GpGeometry){
        .vertex_count = polygons->vertex_count,
        .indices = polygons->indices,
        .index_count = 3 * polygons->triangle_count,
        .streams = { [GP_POSITION] = { polygons->positions, 0, 3, GP_FLOAT32 },
                     [GP_NORMAL] = { polygons->normals, 0, 3, GP_FLOAT32 },
                     [GP_COLOR] = { polygons->colors, 0, 4, GP_FLOAT32 } },
    };
}

GpResult polygons_add(const Polygons *polygons, const WarpView *view, const WarpTarget *target,
                      Frame *frame, GpError *error)
{
    static const float nothing[4] = { 0 };
    const bool has_waves = polygons->waves > 0, is_lit = view->light && !has_waves;
    GpSurface *depth =
        target->depth ? target->depth : frame_surface(frame, GP_D32F, view->width, view->height, 1);
    GpPass *pass = frame_pass(frame, "polygons", target->color, depth, nothing);
    pass->color[0].clear = false;
    pass->depth.clear_depth = !target->depth;
    PolygonsUniforms uniforms = { .waves = (float)polygons->waves };
    camera_matrix(&view->camera, (double)view->width / view->height, uniforms.mvp);
    if (is_lit)
        uniforms.light = warp_light_uniforms(view);
    const GpProgram *program = has_waves ? &polygons_waves_program
                               : is_lit  ? &polygons_lit_program
                                         : &polygons_program;
    const GpGeometry geometry = geometry_of(polygons);
    if (polygons->triangle_count > 0)
        frame_draw_copied(frame, program, &uniforms, &geometry)->state.depth =
            (GpDepthState){ .test = GP_LESS, .write = true };
    return frame_result(frame, error);
}
