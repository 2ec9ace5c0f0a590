#include "apps/techniques/shadow/light_view.h"
#include "apps/scene/bounds.h"

#include <math.h>
#include <string.h>

static Camera aim(const Scene *scene, const SceneLight *light, int face)
{
    static const double faces[6][2][3] = {
        { { 1, 0, 0 }, { 0, 1, 0 } },  { { -1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 0 }, { 0, 0, -1 } },
        { { 0, -1, 0 }, { 0, 0, 1 } }, { { 0, 0, 1 }, { 0, 1, 0 } },  { { 0, 0, -1 }, { 0, 1, 0 } },
    };
    const SceneShadow *shadow = &light->shadow;
    Camera camera = { .fovy = shadow->fovy, .near = shadow->near, .far = shadow->far };
    if (light_shines_around(light)) {
        camera.fovy = 90;
        for (int k = 0; k < 3; k++) {
            camera.eye[k] = light->position[k];
            camera.at[k] = light->position[k] + faces[face][0][k];
            camera.up[k] = faces[face][1][k];
        }
        return camera;
    }
    memcpy(camera.up, shadow->up, sizeof camera.up);
    memcpy(camera.at, light->at, sizeof camera.at);
    memcpy(camera.eye, light->position, sizeof camera.eye);
    if (!light->directional) {
        camera.fovy = shadow->fovy > 0 ? shadow->fovy : light->cone > 0 ? 2 * light->cone : 90;
        return camera;
    }
    /* A wall of rays over the ball around the scene's box. */
    Bounds box = scene_bounds(scene);
    double size[3];
    vector_subtract(box.high, box.low, size);
    double radius = 0.5 * sqrt(vector_dot(size, size)) * 1.001;
    camera.fovy = 0;
    camera.height = shadow->height > 0 ? shadow->height : 2 * radius;
    for (int k = 0; k < 3; k++) {
        camera.at[k] = light->aims ? light->at[k] : 0.5 * (box.low[k] + box.high[k]);
        camera.eye[k] = camera.at[k] + 2 * radius * light->position[k];
    }
    return camera;
}

/* An up that is not along the view. */
static void straighten(Camera *camera)
{
    double forward[3], right[3];
    vector_subtract(camera->at, camera->eye, forward);
    vector_cross(forward, camera->up, right);
    if (vector_dot(right, right) >
        1e-12 * vector_dot(forward, forward) * vector_dot(camera->up, camera->up))
        return;
    double x = fabs(forward[0]) < fabs(forward[1]);
    memcpy(camera->up, (double[3]){ x, 1 - x, 0 }, sizeof camera->up);
}

static double distance_of(const GpDraw *draw, uint32_t vertex, double view[4][4])
{
    double position[3];
    draw_position(draw, vertex, position);
    return -(vector_dot(view[2], position) + view[2][3]);
}

/* Distances along the view of all vertices; of those behind the light they are below 0. */
static void find_depths(const SceneCasters *casters, double view[4][4], double *nearest,
                        double *farthest)
{
    const GpPass *pass = &casters->scene->list.passes[0];
    *nearest = HUGE_VAL;
    *farthest = 0;
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        const GpDraw *draw = &pass->draws[i];
        CasterVertices vertices = caster_vertices(casters, i);
        for (uint32_t j = 0; j < draw->geometry.vertex_count; j++)
            *farthest = fmax(*farthest, distance_of(draw, j, view));
        for (uint32_t j; caster_next_vertex(&vertices, &j);)
            *nearest = fmin(*nearest, distance_of(draw, j, view));
    }
}

/* One range for all faces of a cube map: nothing is farther along a face's view than away. */
static void find_reach(const Scene *scene, const SceneLight *light, Camera *camera)
{
    const Bounds box = scene_bounds(scene);
    double farthest = 0;
    if (camera->far > 0)
        return;
    for (int k = 0; k < 3 && box.low[0] <= box.high[0]; k++)
        farthest = fmax(farthest, fmax(fabs(box.low[k] - light->position[k]),
                                       fabs(box.high[k] - light->position[k])));
    camera->far = farthest > 0 ? farthest * 1.001 : 1;
    camera->near = camera->far * 1e-3;
}

bool light_shines_around(const SceneLight *light)
{
    return !light->directional && !light->aims;
}

LightView light_view(const SceneCasters *casters, int face, bool tight)
{
    const Scene *scene = casters->scene;
    const SceneLight *light = casters->light;
    Camera camera = aim(scene, light, face);
    straighten(&camera);
    double to_eye[4][4], projection[4][4];
    camera_view(&camera, to_eye);
    if (light_shines_around(light))
        find_reach(scene, light, &camera);
    else if (tight || !(camera.far > 0)) {
        double nearest, farthest;
        find_depths(casters, to_eye, &nearest, &farthest);
        camera.far = farthest > 0 ? farthest * 1.001 : 1;
        camera.near = fmin(fmax(nearest * 0.999, camera.far * 1e-3), camera.far * 0.999);
    }
    LightView view = { .parallel = light->directional, .near = camera.near, .far = camera.far };
    view.width = view.parallel ? camera.height : 2 * camera_axes(&camera, 1).half_height;
    camera_projection(&camera, 1, projection);
    matrix_multiply(projection, to_eye, view.clip);
    return view;
}
