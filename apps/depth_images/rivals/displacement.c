#include "apps/depth_images/rivals/displacement.h"

#include "apps/base/vector.h"
#include "apps/depth_images/rivals/distance_field.h"
#include "apps/depth_images/rivals/slab_quad.h"
#include "shaders_c/warp/displacement.h"

enum { SIZE = 128, LEAST_SIZE = 8, MOST_SIZE = 512, STEPS = 64, MOST_STEPS = 255 };

/* Codes of distances go so many samples far, so that they are fine near the surface. */
static const double reach_samples = 64;
/* The field leads so near to the surface: it is known at samples only, and where pixels are many to
 * a sample, of the nearest of them. */
static const double near_samples = 0.75;

/* --- the field -------------------------------------------------------------------------------- */

/* Sides of the box, and samples along them. */
static void find_sizes(uint32_t longest, Displacement *made)
{
    slab_metric(&made->slab, made->metric);
    const double most = vector_extent(made->metric);
    made->sample = 0;
    for (int k = 0; k < 3; k++) {
        made->metric[k] /= most;
        const double samples = ceil(made->metric[k] * longest);
        made->size[k] = samples < 2 ? 2 : (uint32_t)samples;
        made->sample = fmax(made->sample, made->metric[k] / (made->size[k] - 1));
    }
}

/* z of the nearest of the pixels about a sample. */
static float column_of(const Displacement *made, const DepthPixels *pixels, uint32_t x, uint32_t y)
{
    const uint32_t at[2] = { x, y }, size[2] = { pixels->width, pixels->height };
    uint32_t low[2], high[2];
    for (int k = 0; k < 2; k++) {
        const double side = made->slab.side[k] * size[k], apart = side / (made->size[k] - 1);
        const double place = made->slab.first[k] * size[k] + at[k] * apart;
        const double half = fmax(apart, 1) / 2;
        const double from = fmax(floor(place - half), 0), to = fmin(ceil(place + half), size[k]);
        low[k] = (uint32_t)fmin(from, size[k] - 1.0);
        high[k] = (uint32_t)fmax(to, low[k] + 1.0);
    }
    float nearest = SLAB_NOTHING;
    for (uint32_t j = low[1]; j < high[1]; j++)
        for (uint32_t i = low[0]; i < high[0]; i++) {
            const float z = slab_z(&made->slab, pixels->depth[(size_t)j * pixels->width + i]);
            nearest = z < nearest ? z : nearest;
        }
    return nearest;
}

static GpResult make_field(const DepthPixels *pixels, Displacement *made, GpError *error)
{
    const uint32_t *size = made->size;
    float *z = gp_alloc((size_t)size[0] * size[1], sizeof *z);
    uint8_t *codes = gp_alloc((size_t)size[0] * size[1] * size[2], 1);
    const DistanceColumns columns = {
        .z = z,
        .thickness = (double)depth_cells_uniforms(&made->cells, made->thickness).thickness,
        .size = { size[0], size[1], size[2] },
        .metric = { made->metric[0], made->metric[1], made->metric[2] },
    };
    for (uint32_t i = 0; i < size[0] * size[1] && z; i++)
        z[i] = column_of(made, pixels, i % size[0], i / size[0]);
    GpResult result = z && codes
                          ? distance_field_make(&columns, reach_samples * made->sample, codes)
                          : GP_ERROR_MEMORY;
    if (result)
        gp_fail(error, result, "out of memory");
    else
        result = volume_atlas_make(codes, size, &made->field, error);
    gp_free(z);
    gp_free(codes);
    return result;
}

/* --- drawing ---------------------------------------------------------------------------------- */

GpResult displacement_open_sized(const DepthImage *image, const DisplacementField *field,
                                 Displacement *displacement, GpError *error)
{
    const uint32_t asked = field && field->size ? field->size : SIZE;
    Displacement made = { .thickness = field ? field->thickness : 0 };
    GpResult result = slab_check(image, "displacement", error);
    if (!result && slab_find(&image->plane, &image->front, &made.slab)) {
        find_sizes(asked < LEAST_SIZE ? LEAST_SIZE : asked > MOST_SIZE ? MOST_SIZE : asked, &made);
        result = depth_cells_open(&made.slab, &image->front, &made.cells, error);
        if (!result)
            result = slab_textures_open(image, &made.textures, error);
        if (!result)
            result = make_field(&image->front, &made, error);
    }
    if (result)
        displacement_close(&made);
    else
        *displacement = made;
    return result;
}

GpResult displacement_open(const DepthImage *image, Displacement *displacement, GpError *error)
{
    return displacement_open_sized(image, NULL, displacement, error);
}

void displacement_close(Displacement *displacement)
{
    depth_cells_close(&displacement->cells);
    depth_textures_close(&displacement->textures);
    volume_atlas_free(&displacement->field);
    *displacement = (Displacement){ .thickness = 0 };
}

GpResult displacement_add(const Displacement *displacement, const DisplacementSetting *setting,
                          const WarpView *view, const WarpTarget *target, Frame *frame,
                          GpError *error)
{
    static const GpSampler linear = {
        .min = GP_LINEAR, .mag = GP_LINEAR, .address_u = GP_CLAMP, .address_v = GP_CLAMP
    };
    SlabRays rays;
    slab_pass(setting->name ? setting->name : "displacement", target, frame);
    if (!displacement->cells.z || !slab_rays(&displacement->slab, view, frame, &rays))
        return frame_result(frame, error);
    const uint32_t steps = setting->steps ? setting->steps : STEPS;
    DisplacementUniforms uniforms = {
        .slab = rays.uniforms,
        .cells = depth_cells_uniforms(&displacement->cells, displacement->thickness),
        .field = volume_atlas_patches(&displacement->field, displacement->size),
        .reach = (float)(reach_samples * displacement->sample),
        .near = (float)(near_samples * displacement->sample),
        .steps = (float)(steps < MOST_STEPS ? steps : MOST_STEPS),
    };
    for (int k = 0; k < 3; k++) {
        uniforms.last[k] = (float)(displacement->size[k] - 1);
        uniforms.metric[k] = (float)displacement->metric[k];
    }
    GpDraw *draw =
        frame_draw_copied(frame, view->light ? &displacement_lit_program : &displacement_program,
                          &uniforms, &rays.geometry);
    draw->state = slab_state(&rays, target);
    slab_textures(&displacement->textures, draw);
    depth_cells_texture(&displacement->cells, draw);
    draw->textures[3] = (GpTexture){ displacement->field.surface, linear };
    return frame_result(frame, error);
}
