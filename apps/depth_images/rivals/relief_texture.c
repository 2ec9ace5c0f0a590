#include "apps/depth_images/rivals/relief_texture.h"

#include "apps/depth_images/rivals/prewarp.h"
#include "apps/depth_images/rivals/slab_quad.h"
#include "shaders_c/warp/relief_texture.h"

#include <string.h>

static const double usual_cut = 0.02;
static const double apart_texels =
    4; /* neighbours farther apart in the image are of two surfaces */

GpResult relief_texture_open(const DepthImage *image, ReliefTexture *made, GpError *error)
{
    ReliefTexture opened = { .pixels = image->front };
    GpResult result = slab_check(image, "relief texture mapping", error);
    if (!result && slab_find(&image->plane, &image->front, &opened.slab))
        result = slab_textures_open(image, &opened.textures, error);
    if (!result)
        *made = opened;
    return result;
}

void relief_texture_close(ReliefTexture *made)
{
    depth_textures_close(&made->textures);
    *made = (ReliefTexture){ .textures = { .color = NULL } };
}

/* The plane that is warped to: in the middle, or if the eye is near to that, at the end that is
 * farther from it. returns false: the eye looks along it */
static bool choose_plane(const DepthSlab *slab, const double eye[4], bool is_parallel,
                         double *plane)
{
    const double middle = eye[2] - 0.5 * eye[3], some = slab->is_parallel ? 0.75 : 0.75 * slab->low;
    *plane = is_parallel || fabs(middle) > some ? 0.5 : middle < 0 ? 1 : 0;
    return fabs(eye[2] - *plane * eye[3]) > 1e-9 * (fabs(eye[2]) + fabs(eye[3]));
}

static void find_rows(const DepthSlab *slab, const WarpView *view, ReliefTextureUniforms *uniforms)
{
    double box[4][4], world[4][4], eye[4][4], projection[4][4], both[4][4], clip[4][4];
    memcpy(box, slab->matrix, sizeof box);
    matrix_inverse(box, world);
    camera_view(&view->camera, eye);
    camera_projection(&view->camera, (double)view->width / view->height, projection);
    matrix_multiply(projection, eye, both);
    matrix_multiply(both, world, clip);
    matrix_round(world, uniforms->world);
    for (int k = 0; k < 4; k++) {
        uniforms->clip[0][k] = (float)clip[2][k];
        uniforms->clip[1][k] = (float)clip[3][k];
    }
}

static void set_texture(const ReliefTexture *made, const Prewarped *warped, Frame *frame,
                        GpDraw *draw)
{
    static const GpSampler points = { .address_u = GP_CLAMP, .address_v = GP_CLAMP }, linear = {
        .min = GP_LINEAR, .mag = GP_LINEAR, .address_u = GP_CLAMP, .address_v = GP_CLAMP
    };
    GpSurface *surface = frame_surface(frame, GP_A32B32G32R32F, warped->width, warped->height, 1);
    if (surface->level[0].texels)
        memcpy(surface->level[0].texels, warped->texel,
               (size_t)warped->width * warped->height * sizeof *warped->texel);
    slab_textures(&made->textures, draw);
    draw->textures[0] = (GpTexture){ surface, points };
    draw->textures[3] = (GpTexture){ surface, linear };
}

static void draw_warped(const ReliefTexture *made, const PrewarpInput *input,
                        const Prewarped *warped, const WarpView *view, const WarpTarget *target,
                        Frame *frame)
{
    ReliefTextureUniforms uniforms = { .slab = slab_uniforms(&made->slab, view) };
    const uint32_t size[2] = { made->pixels.width, made->pixels.height };
    GpGeometry quad;
    camera_matrix(&view->camera, (double)view->width / view->height, uniforms.mvp);
    find_rows(&made->slab, view, &uniforms);
    for (int k = 0; k < 2; k++) {
        uniforms.first[k] = (float)(-warped->first[k] / warped->side[k]);
        uniforms.per_side[k] = (float)(1 / warped->side[k]);
        uniforms.apart[k] = (float)(apart_texels / (made->slab.side[k] * size[k]));
    }
    if (!slab_quad(&made->slab, input->plane, warped->first, warped->side, frame, &quad))
        return;
    GpDraw *draw = frame_draw_copied(
        frame, view->light ? &relief_texture_lit_program : &relief_texture_program, &uniforms,
        &quad);
    draw->state.depth = slab_depth_state(target);
    set_texture(made, warped, frame, draw);
}

GpResult relief_texture_add(const ReliefTexture *made, const ReliefTextureSetting *setting,
                            const WarpView *view, const WarpTarget *target, Frame *frame,
                            GpError *error)
{
    PrewarpInput input = { .slab = &made->slab,
                           .pixels = &made->pixels,
                           .is_parallel = !(view->camera.fovy > 0),
                           .cut = setting->cut != 0 ? setting->cut : usual_cut };
    Prewarped warped = { .width = 0 };
    slab_pass(setting->name ? setting->name : "relief_texture", target, frame);
    if (!made->textures.color)
        return frame_result(frame, error);
    slab_eye(&made->slab, &view->camera, input.eye);
    if (!choose_plane(&made->slab, input.eye, input.is_parallel, &input.plane))
        return frame_result(frame, error);
    if (prewarp_make(&input, &warped))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    if (warped.width > 0)
        draw_warped(made, &input, &warped, view, target, frame);
    gp_free(warped.texel);
    return frame_result(frame, error);
}
