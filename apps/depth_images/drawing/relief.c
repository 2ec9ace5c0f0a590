#include "apps/depth_images/drawing/relief.h"

#include "shaders_c/warp/relief.h"

enum { STEPS = 64, HALVINGS = 8, MOST = 255 };

/* More leaves fewer holes behind edges, and wronger colours there. */
static const double usual_thickness = 0.1;

/* z of a pixel; those at the picture's rim go on outside. */
static float z_at(const DepthSlab *slab, const DepthPixels *pixels, int64_t x, int64_t y)
{
    x = x < 0 ? 0 : x >= pixels->width ? pixels->width - 1 : x;
    y = y < 0 ? 0 : y >= pixels->height ? pixels->height - 1 : y;
    return slab_z(slab, pixels->depth[(size_t)y * pixels->width + (size_t)x]);
}

/* Cells between pixels that the box is on; the first is before the first pixel. */
static GpResult make_cells(const DepthPixels *pixels, Relief *relief, GpError *error)
{
    const DepthSlab *slab = &relief->slab;
    const double size[2] = { pixels->width, pixels->height };
    int64_t low[2], count[2];
    for (int k = 0; k < 2; k++) {
        const double first = slab->first[k] * size[k] - 0.5, side = slab->side[k] * size[k];
        low[k] = (int64_t)floor(first);
        count[k] = (int64_t)floor(first + side) - low[k] + 1;
        relief->first[k] = (float)(first - (double)low[k]);
        relief->cells[k] = (float)side;
    }
    const GpSurfaceDesc desc = { .format = GP_A32B32G32R32F,
                                 .width = (uint32_t)count[0],
                                 .height = (uint32_t)count[1] };
    const GpResult result = gp_surface_create(&desc, &relief->cells_z, error);
    for (int64_t y = 0; y < count[1] && !result; y++)
        for (int64_t x = 0; x < count[0]; x++) {
            float z[4];
            for (int corner = 0; corner < 4; corner++)
                z[corner] = z_at(slab, pixels, low[0] + x + corner % 2, low[1] + y + corner / 2);
            gp_texel_store(
                GP_A32B32G32R32F,
                gp_surface_texel(&relief->cells_z->level[0], 16, (uint32_t)x, (uint32_t)y), z, 0);
        }
    return result;
}

GpResult relief_open(const DepthImage *image, Relief *relief, GpError *error)
{
    Relief made = { .cells_z = NULL };
    GpResult result = slab_check(image, "relief mapping", error);
    if (!result && slab_find(&image->plane, &image->front, &made.slab)) {
        result = make_cells(&image->front, &made, error);
        if (!result)
            result = slab_textures_open(image, &made.textures, error);
    }
    if (result)
        relief_close(&made);
    else
        *relief = made;
    return result;
}

void relief_close(Relief *relief)
{
    gp_surface_destroy(&relief->cells_z);
    depth_textures_close(&relief->textures);
    *relief = (Relief){ .cells_z = NULL };
}

static float number_of(uint32_t asked, uint32_t meant)
{
    return (float)(asked == 0 ? meant : asked < MOST ? asked : MOST);
}

GpResult relief_add(const Relief *relief, const ReliefSetting *setting, const WarpView *view,
                    const WarpTarget *target, Frame *frame, GpError *error)
{
    static const GpSampler points = { .address_u = GP_CLAMP, .address_v = GP_CLAMP };
    GpState state = slab_pass(setting->name ? setting->name : "relief", target, frame);
    SlabRays rays;
    if (!relief->cells_z || !slab_rays(&relief->slab, view, frame, &rays))
        return frame_result(frame, error);
    const ReliefUniforms uniforms = {
        .slab = rays.uniforms,
        .first = { relief->first[0], relief->first[1] },
        .cells = { relief->cells[0], relief->cells[1] },
        .texel = { 1 / (float)relief->cells_z->width, 1 / (float)relief->cells_z->height },
        .steps = number_of(setting->steps, STEPS),
        .halvings = number_of(setting->halvings, HALVINGS),
        .thickness = (float)(setting->thickness > 0   ? setting->thickness
                             : setting->thickness < 0 ? (double)SLAB_NOTHING
                                                      : usual_thickness),
    };
    state.raster = rays.raster;
    GpDraw *draw = frame_draw_copied(frame, view->light ? &relief_lit_program : &relief_program,
                                     &uniforms, &rays.geometry);
    draw->state = state;
    draw->textures[0] = (GpTexture){ relief->cells_z, points };
    slab_textures(&relief->textures, draw);
    return frame_result(frame, error);
}
