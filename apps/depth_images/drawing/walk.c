#include "apps/depth_images/drawing/walk.h"

#include "apps/base/bounds.h"
#include "apps/depth_images/drawing/light.h"
#include "apps/depth_images/drawing/shares.h"
#include "apps/depth_images/drawing/view_planes.h"
#include "apps/depth_images/drawing/walk_ground.h"

#include <stdlib.h>
#include <string.h>

enum { USUAL_MAP = 2048, GRASS = 64 };

static const double spacing = 4;                       /* between objects */
static const double least_size = 1.2, most_size = 2.4; /* of objects */

static const double half_as_many = 0.7071067811865476; /* pixels, on both sides of a picture */
static const double distant = 10; /* radii, from where an object is seen from one direction */

static const WarpLight sun = { .position = { 0.48, 0.8, 0.36 },
                               .directional = true,
                               .color = { 0.85f, 0.82f, 0.75f },
                               .ambient = { 0.22f, 0.25f, 0.3f } };

/* --- a field ---------------------------------------------------------------------------------- */

/* Knuth's linear congruential numbers, 0 to 1. */
static double next_random(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 40) * 0x1p-24;
}

/* About all balls of its images, which are smaller than what is about their boxes. */
static void find_ball(const Bounds *box, WalkModel *model)
{
    for (int k = 0; k < 3; k++)
        model->center[k] = (box->low[k] + box->high[k]) / 2;
    for (uint32_t i = 0; i < model->count; i++) {
        double away[3];
        const DepthSurface *surface = &model->surfaces[i];
        vector_subtract(surface->center, model->center, away);
        model->radius = fmax(model->radius, sqrt(vector_dot(away, away)) + surface->radius);
    }
}

static GpResult open_model(const DepthModel *from, WalkModel *model, GpError *error)
{
    Bounds box = bounds_of_nothing;
    for (uint32_t i = 0; i < from->count; i++) {
        DepthSurface *surface = &model->surfaces[i];
        uint8_t *share = NULL;
        if (shares_find(from, i, &share))
            return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
        const SurfaceDetail detail = { .tolerance = 0.7, .own = share };
        const GpResult result = surface_open(&from->images[i], &detail, surface, error);
        gp_free(share);
        if (result)
            return result;
        model->count++;
        const SurfaceLevel *level = &surface->levels[0];
        const Bounds own = bounds_of(level->vertices->position, sizeof *level->vertices, NULL,
                                     level->mesh.vertex_count);
        bounds_join(&box, &own);
    }
    if (!(box.low[0] <= box.high[0]))
        return gp_fail(error, GP_ERROR_INVALID, "a model of the walk shows nothing");
    for (int k = 0; k < 3; k++)
        model->base[k] = k == 1 ? box.low[k] : (box.low[k] + box.high[k]) / 2;
    model->size = bounds_longest(&box) > 0 ? bounds_longest(&box) : 1;
    find_ball(&box, model);
    return GP_OK;
}

static void place_ball(const WalkModel *model, WalkObject *object)
{
    double off[3];
    vector_subtract(model->center, model->base, off);
    const double turned[3] = { object->cosine * off[0] + object->sine * off[2], off[1],
                               object->cosine * off[2] - object->sine * off[0] };
    vector_add_scaled(object->foot, object->scale, turned, object->center);
    object->radius = object->scale * model->radius;
}

static void place_objects(Walk *walk)
{
    uint64_t seed = 20050817;
    uint32_t side = 1;
    while (side * side < walk->object_count)
        side++;
    walk->half = side * spacing / 2;
    for (uint32_t i = 0; i < walk->object_count; i++) {
        WalkObject *object = &walk->objects[i];
        object->model = i % walk->model_count;
        object->foot[0] = (i % side + 0.25 + 0.5 * next_random(&seed)) * spacing - walk->half;
        object->foot[2] = (i / side + 0.25 + 0.5 * next_random(&seed)) * spacing - walk->half;
        angle_sincos(360 * next_random(&seed), &object->sine, &object->cosine);
        object->scale = (least_size + (most_size - least_size) * next_random(&seed)) /
                        walk->models[object->model].size;
        place_ball(&walk->models[object->model], object);
    }
}

static GpResult make_ground(Walk *walk, GpError *error)
{
    uint64_t seed = 7;
    const GpSurfaceDesc desc = {
        .format = GP_A8R8G8B8, .width = GRASS, .height = GRASS, .levels = GP_MAX_LEVELS
    };
    const GpResult result = gp_surface_create(&desc, &walk->grass, error);
    if (result)
        return result;
    for (uint32_t i = 0; i < GRASS * GRASS; i++) {
        const double light = 0.75 + 0.25 * next_random(&seed);
        const uint8_t texel[4] = { (uint8_t)(60 * light), (uint8_t)(125 * light),
                                   (uint8_t)(95 * light), 255 };
        memcpy(gp_surface_texel(&walk->grass->level[0], 4, i % GRASS, i / GRASS), texel, 4);
    }
    gp_surface_build_mips(walk->grass);
    return GP_OK;
}

GpResult walk_open(const DepthModel *models, uint32_t model_count, uint32_t object_count,
                   Walk *walk, GpError *error)
{
    Walk made = { .models = gp_alloc(model_count, sizeof *made.models),
                  .objects = gp_alloc(object_count, sizeof *made.objects),
                  .model_count = model_count,
                  .object_count = object_count };
    GpResult result = made.models && made.objects
                          ? make_ground(&made, error)
                          : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (uint32_t i = 0; i < model_count && !result; i++)
        result = open_model(&models[i], &made.models[i], error);
    if (result) {
        walk_close(&made);
        return result;
    }
    place_objects(&made);
    *walk = made;
    return GP_OK;
}

void walk_close(Walk *walk)
{
    for (uint32_t i = 0; i < walk->model_count && walk->models; i++)
        for (uint32_t k = 0; k < DEPTH_MODEL_IMAGES; k++)
            surface_close(&walk->models[i].surfaces[k]);
    gp_surface_destroy(&walk->grass);
    gp_free(walk->models);
    gp_free(walk->objects);
    *walk = (Walk){ .models = NULL };
}

Camera walk_camera(const Walk *walk, double share)
{
    Camera camera = { .up = { 0, 1, 0 }, .fovy = 50, .near = 0.3, .far = 6 * walk->half };
    double sine, cosine;
    angle_sincos(360 * share, &sine, &cosine);
    const double rise = (1 - cosine) / 2, away = walk->half * (0.45 + 0.75 * rise);
    vector_set(camera.eye, away * cosine, 1.7 + 0.75 * walk->half * rise, away * sine);
    const double ahead[3] = { camera.eye[0] - 3 * sine - 0.5 * cosine, 1.4,
                              camera.eye[2] + 3 * cosine - 0.5 * sine };
    for (int k = 0; k < 3; k++)
        camera.at[k] = ahead[k] * (1 - rise);
    return camera;
}

/* --- views of objects ------------------------------------------------------------------------- */

/* A direction of the world in an object's own space. */
static void turn_back(const WalkObject *object, const double world[3], double own[3])
{
    const double x = world[0], z = world[2];
    own[0] = object->cosine * x - object->sine * z;
    own[1] = world[1];
    own[2] = object->sine * x + object->cosine * z;
}

static void place_back(const Walk *walk, const WalkObject *object, const double world[3],
                       double own[3])
{
    double way[3], turned[3];
    vector_subtract(world, object->foot, way);
    turn_back(object, way, turned);
    vector_add_scaled(walk->models[object->model].base, 1 / object->scale, turned, own);
}

/* How a view of the world looks from an object's own space. in light: room, borrowed by the view */
static WarpView own_view(const Walk *walk, const WalkObject *object, const WarpView *view,
                         WarpLight *light)
{
    WarpView own = *view;
    place_back(walk, object, view->camera.eye, own.camera.eye);
    place_back(walk, object, view->camera.at, own.camera.at);
    turn_back(object, view->camera.up, own.camera.up);
    own.camera.height /= object->scale;
    own.camera.near /= object->scale;
    own.camera.far /= object->scale;
    if (view->light) {
        *light = *view->light;
        turn_back(object, view->light->position, light->position);
        own.light = light;
    }
    return own;
}

/* Own space to world. */
static void object_matrix(const Walk *walk, const WalkObject *object, double matrix[4][4])
{
    const double *base = walk->models[object->model].base, s = object->scale;
    const double turn[3][3] = { { object->cosine, 0, object->sine },
                                { 0, 1, 0 },
                                { -object->sine, 0, object->cosine } };
    matrix_identity(matrix);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            matrix[k][i] = s * turn[k][i];
        matrix[k][3] = object->foot[k] - s * vector_dot(turn[k], base);
    }
}

/* --- shadows ---------------------------------------------------------------------------------- */

/* All of the field, from the sun. */
static WarpView sun_view(const Walk *walk, uint32_t map)
{
    const double reach = walk->half * 1.45 + most_size;
    WarpView view = { .camera = { .up = { 0, 1, 0 }, .height = 2 * reach, .near = 1 },
                      .width = map,
                      .height = map };
    vector_add_scaled(view.camera.eye, 2 * reach, sun.position, view.camera.eye);
    view.camera.far = 4 * reach;
    return view;
}

/* World to the map: u, v and a depth a little before the surface's own. */
static void map_matrix(const WarpView *view, double map[4][4])
{
    double to_map[4][4] = {
        { 0.5, 0, 0, 0.5 }, { 0, -0.5, 0, 0.5 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 }
    };
    double eye[4][4], projection[4][4], clip[4][4];
    camera_view(&view->camera, eye);
    camera_projection(&view->camera, 1, projection);
    matrix_multiply(projection, eye, clip);
    matrix_multiply(to_map, clip, map);
    map[2][3] -= view->camera.height / view->width / (view->camera.far - view->camera.near);
}

static GpTexture map_texture(const GpSurface *map)
{
    return (GpTexture){ map,
                        { .min = GP_LINEAR,
                          .mag = GP_LINEAR,
                          .address_u = GP_BORDER,
                          .address_v = GP_BORDER,
                          .border = { 1 },
                          .compare = true } };
}

/* Twice as coarse as a picture: the map is filtered. */
static uint32_t draw_coarsely(const DepthSurface *surface, const WarpView *view, Frame *frame)
{
    const SurfaceSetting setting = { .step = 2 * surface_step(surface, view) };
    return surface_draw_depth(surface, &setting, view, frame);
}

/* Objects whose shadows may be seen, on others or on the ground. */
static uint32_t draw_map(const Walk *walk, const WarpView *view, const ViewPlanes *seen,
                         GpSurface *map, Frame *frame)
{
    uint32_t triangles = 0;
    frame_pass(frame, "map", NULL, map, NULL);
    for (uint32_t i = 0; i < walk->object_count; i++) {
        const WalkObject *object = &walk->objects[i];
        const WalkModel *model = &walk->models[object->model];
        const WalkShadow shadow = walk_shadow(object, &sun, 0);
        if (!view_planes_may_see_way(seen, object->center, shadow.center, shadow.across))
            continue;
        const WarpView own = own_view(walk, object, view, NULL);
        for (uint32_t k = 0; k < model->count; k++)
            triangles += draw_coarsely(&model->surfaces[k], &own, frame);
    }
    return triangles;
}

/* --- the picture ------------------------------------------------------------------------------ */

typedef struct Ordered {
    double away;
    uint32_t object;
} Ordered;

static int by_distance(const void *a, const void *b)
{
    const Ordered *one = a, *other = b;
    return one->away != other->away ? (one->away > other->away) - (one->away < other->away)
                                    : (one->object > other->object) - (one->object < other->object);
}

/* Objects, the nearest first. */
static Ordered *order_objects(const Walk *walk, const Camera *camera, Frame *frame)
{
    Ordered *order = frame_alloc(frame, walk->object_count, sizeof *order);
    for (uint32_t i = 0; i < walk->object_count && order; i++) {
        double way[3];
        vector_subtract(walk->objects[i].foot, camera->eye, way);
        order[i] = (Ordered){ vector_dot(way, way), i };
    }
    if (order)
        qsort(order, walk->object_count, sizeof *order, by_distance);
    return order;
}

/* The power of two above the footprint, instead of the nearest: vertices are one to two pixels
 * apart. Silhouettes decide how far a picture is off, so a third fewer triangles lose but 0.4
 * dB. */
static uint32_t step_of(const DepthSurface *surface, const WarpView *view)
{
    WarpView smaller = *view;
    smaller.width = (uint32_t)fmax(view->width * half_as_many, 1);
    smaller.height = (uint32_t)fmax(view->height * half_as_many, 1);
    return surface_step(surface, &smaller);
}

static bool is_distant(const WalkObject *object, const Camera *camera)
{
    double way[3];
    vector_subtract(object->center, camera->eye, way);
    return vector_dot(way, way) > distant * distant * object->radius * object->radius;
}

/* One object, with the way from its own space to the light's map. returns triangles */
static uint32_t draw_object(const Walk *walk, const WalkObject *object, const WalkSetting *setting,
                            const WarpView *view, double map[4][4], SurfaceShadow *shadow,
                            Frame *frame)
{
    const WalkModel *model = &walk->models[object->model];
    WarpLight light;
    const WarpView own = own_view(walk, object, view, &light);
    double place[4][4], product[4][4];
    uint32_t triangles = 0;
    object_matrix(walk, object, place);
    matrix_multiply(map, place, product);
    float rounded[4][4];
    matrix_round(product, rounded);
    memcpy(shadow->map, rounded, sizeof shadow->map);
    for (uint32_t i = 0; i < model->count; i++) {
        const DepthSurface *surface = &model->surfaces[i];
        const SurfaceSetting drawn = { .step =
                                           setting->step ? setting->step : step_of(surface, &own),
                                       .shadow = setting->no_shadows ? NULL : shadow,
                                       .is_distant = is_distant(object, &view->camera) };
        triangles += surface_draw(surface, &drawn, &own, true, frame);
    }
    return triangles;
}

GpResult walk_add(const Walk *walk, const WalkSetting *setting, const Camera *camera,
                  uint32_t width, uint32_t height, Frame *frame, WalkCounts *counts, GpError *error)
{
    static const float sky[4] = { 0.56f, 0.7f, 0.88f, 1 };
    const WarpView view = { *camera, width, height, &sun };
    const WarpView from_sun = sun_view(walk, setting->map ? setting->map : USUAL_MAP);
    const ViewPlanes seen = view_planes(&view);
    const Ordered *order = order_objects(walk, camera, frame);
    WalkCounts drawn = { .objects = 0 };
    SurfaceShadow shadow = { .texture = { NULL, { .min = GP_POINT } } };
    double map[4][4];
    map_matrix(&from_sun, map);
    if (!setting->no_shadows) {
        GpSurface *surface = frame_surface(frame, GP_D32F, from_sun.width, from_sun.height, 1);
        drawn.shadow_triangles = draw_map(walk, &from_sun, &seen, surface, frame);
        shadow.texture = map_texture(surface);
    }
    frame->color = frame_surface(frame, GP_A8R8G8B8, width, height, 1);
    frame->depth = frame_surface(frame, GP_D32F, width, height, 1);
    frame_pass(frame, "walk", frame->color, frame->depth, sky);
    for (uint32_t i = 0; i < walk->object_count && order; i++) {
        const uint32_t triangles =
            draw_object(walk, &walk->objects[order[i].object], setting, &view, map, &shadow, frame);
        drawn.objects += triangles > 0;
        drawn.triangles += triangles;
    }
    walk_ground_draw(walk, &view,
                     &(WalkGround){ .sun = &sun,
                                    .map = setting->no_shadows ? NULL : map,
                                    .texture = shadow.texture,
                                    .texel = 2 * from_sun.camera.height / from_sun.width },
                     frame);
    if (counts)
        *counts = drawn;
    return frame_result(frame, error);
}
