#include "apps/depth_images/drawing/walk_ground.h"

#include "apps/depth_images/drawing/view_planes.h"
#include "shaders_c/warp/ground.h"

#include <string.h>

enum { ROUND = 16 }; /* corners about an ellipse */

static const double grass_size = 3; /* of the ground's texture */

/* Shadows lie on the rest of the ground, which is so much deeper, and pixels of its slope. Nothing
 * stands there: about every object is its shadow. */
static const float deeper = 1e-6f, deeper_slope = 0.25f;

/* --- shadows ---------------------------------------------------------------------------------- */

WalkShadow walk_shadow(const WalkObject *object, const WarpLight *sun, double more)
{
    const double *up = sun->position, level = sqrt(up[0] * up[0] + up[2] * up[2]);
    WalkShadow shadow = { .across = object->radius + more };
    shadow.along = shadow.across / up[1];
    vector_add_scaled(object->center, -object->center[1] / up[1], up, shadow.center);
    vector_set(shadow.center, shadow.center[0], 0, shadow.center[2]);
    shadow.way[0] = level > 0 ? -up[0] / level : 1;
    shadow.way[1] = level > 0 ? -up[2] / level : 0;
    return shadow;
}

/* A polygon about the ellipse. */
static void go_round(const WalkShadow *shadow, float (*corners)[2])
{
    double sine, cosine, half[2];
    angle_sincos(180.0 / ROUND, &half[0], &half[1]);
    for (int i = 0; i < ROUND; i++) {
        angle_sincos(360.0 * i / ROUND, &sine, &cosine);
        const double along = shadow->along * cosine / half[1];
        const double across = shadow->across * sine / half[1];
        corners[i][0] =
            (float)(shadow->center[0] + along * shadow->way[0] - across * shadow->way[1]);
        corners[i][1] =
            (float)(shadow->center[2] + along * shadow->way[1] + across * shadow->way[0]);
    }
}

/* Fans, counter-clockwise from above or not: both sides are drawn. */
static void add_fan(uint32_t first, uint32_t *indices)
{
    for (uint32_t i = 0; i + 2 < ROUND; i++) {
        indices[3 * i] = first;
        indices[3 * i + 1] = first + i + 1;
        indices[3 * i + 2] = first + i + 2;
    }
}

/* Polygons about all shadows that may be seen. returns how many */
static uint32_t find_shadows(const Walk *walk, const WarpView *view, const WalkGround *ground,
                             float (*corners)[2], uint32_t *indices)
{
    const ViewPlanes planes = view_planes(view);
    uint32_t count = 0;
    for (uint32_t i = 0; i < walk->object_count; i++) {
        const WalkShadow shadow = walk_shadow(&walk->objects[i], ground->sun, ground->texel);
        if (!view_planes_may_see(&planes, shadow.center, shadow.along))
            continue;
        go_round(&shadow, corners + (size_t)count * ROUND);
        add_fan(count * ROUND, indices + (size_t)count * 3 * (ROUND - 2));
        count++;
    }
    return count;
}

/* --- draws ------------------------------------------------------------------------------------ */

static GroundUniforms uniforms_of(const WarpView *view, const WalkGround *ground)
{
    static const int columns[3] = { 0, 2, 3 };
    GroundUniforms uniforms = { .repeats = (float)(1 / grass_size) };
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3 && ground->map; i++)
            uniforms.map[k][i] = (float)ground->map[k][columns[i]];
        uniforms.ambient[k] = ground->sun->ambient[k];
        uniforms.direct[k] = ground->sun->color[k] * (float)ground->sun->position[1];
    }
    camera_matrix(&view->camera, (double)view->width / view->height, uniforms.mvp);
    return uniforms;
}

static GpDraw *draw_part(const Walk *walk, const GpProgram *program, const void *uniforms,
                         const float (*corners)[2], GpGeometry geometry, Frame *frame)
{
    /* one level: between two of such an even texture no seam is seen, and most of a picture is
     * ground */
    const GpSampler repeated = { .min = GP_LINEAR, .mag = GP_LINEAR, .mip = GP_MIP_POINT };
    geometry.streams[GP_POSITION] = (GpStream){ corners[0], sizeof *corners, 2, GP_FLOAT32 };
    GpDraw *draw = frame_draw(frame, program, uniforms, &geometry);
    draw->textures[0] = (GpTexture){ walk->grass, repeated };
    draw->state.depth = (GpDepthState){ .test = GP_LESS, .write = true };
    return draw;
}

static void draw_shadows(const Walk *walk, const WarpView *view, const WalkGround *ground,
                         const void *uniforms, Frame *frame)
{
    float(*corners)[2] = frame_alloc(frame, (size_t)walk->object_count * ROUND, sizeof *corners);
    uint32_t *indices =
        frame_alloc(frame, (size_t)walk->object_count * 3 * (ROUND - 2), sizeof *indices);
    if (!corners || !indices)
        return;
    const uint32_t count = find_shadows(walk, view, ground, corners, indices);
    if (!count)
        return;
    const GpGeometry geometry = { .vertex_count = count * ROUND,
                                  .indices = indices,
                                  .index_count = count * 3 * (ROUND - 2) };
    GpDraw *draw = draw_part(walk, &ground_shadowed_program, uniforms, (const float(*)[2])corners,
                             geometry, frame);
    draw->textures[1] = ground->texture;
}

void walk_ground_draw(const Walk *walk, const WarpView *view, const WalkGround *ground,
                      Frame *frame)
{
    static const uint16_t indices[6] = { 0, 1, 2, 2, 1, 3 };
    const GroundUniforms uniforms = uniforms_of(view, ground);
    const void *kept = frame_copy(frame, &uniforms, sizeof uniforms);
    const double reach = 5 * walk->half;
    float(*corners)[2] = frame_alloc(frame, 4, sizeof *corners);
    if (!corners)
        return;
    for (int i = 0; i < 4; i++) {
        corners[i][0] = (float)(i & 1 ? reach : -reach);
        corners[i][1] = (float)(i & 2 ? reach : -reach);
    }
    if (ground->map)
        draw_shadows(walk, view, ground, kept, frame);
    GpDraw *rest =
        draw_part(walk, &ground_program, kept, (const float(*)[2])corners,
                  (GpGeometry){ .vertex_count = 4, .indices16 = indices, .index_count = 6 }, frame);
    rest->state.raster.depth_bias = ground->map ? deeper : 0;
    rest->state.raster.slope_depth_bias = ground->map ? deeper_slope : 0;
}
