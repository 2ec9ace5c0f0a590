/* What a light's map sees under each fit, against the vertices and points of scenes. */
#include "apps/techniques/shadow/light_fit.h"
#include "apps/scene/bounds.h"
#include "tests/support/scene_text.h"

#include <math.h>
#include <stdio.h>

/* --- scenes ----------------------------------------------------------------------------------- */

static const char sun[] = "{ \"direction\": [-0.75, 1, 0.25] }";
static const char spot[] = "{ \"position\": [-20, 30, -10], \"at\": [0, 0, -16], "
                           "\"shadow\": { \"fovy\": 90 } }";

/* A long floor with blocks in two rows that go away from the eye. */
static Scene load(const char *light, const char *camera)
{
    char text[4096];
    size_t used = (size_t)snprintf(
        text, sizeof text,
        "{ \"size\": [64, 48], \"camera\": %s, \"lights\": [ %s ], \"objects\": [", camera, light);
    for (int i = 0; i < 12; i++)
        used += (size_t)snprintf(text + used, sizeof text - used,
                                 "{ \"mesh\": \"builtin:cube\", \"transform\": { \"scale\": "
                                 "[0.4, 1, 0.4], \"translate\": [%d, 1, %d] } }, ",
                                 i % 2 ? 2 : -2, -5 * (i / 2));
    snprintf(text + used, sizeof text - used,
             "{ \"name\": \"floor\", \"mesh\": \"builtin:plane\", \"transform\": "
             "{ \"scale\": [9, 1, 30], \"translate\": [0, 0, -20] } } ] }");
    return load_scene(text);
}

static Scene avenue(const char *light)
{
    return load(light, "{ \"eye\": [0.3, 1.9, 5], \"at\": [0, 0.9, -8], \"fovy\": 48, "
                       "\"near\": 0.5, \"far\": 120 }");
}

static const GpDraw *object(const Scene *scene, uint32_t i)
{
    assert_true(i < scene->list.passes[0].draw_count);
    return &scene->list.passes[0].draws[i];
}

static void project(double clip[4][4], const double point[3], double out[4])
{
    for (int i = 0; i < 4; i++)
        out[i] = vector_dot(clip[i], point) + clip[i][3];
}

static bool is_on_map(const double clip[4], double slack)
{
    double w = clip[3] * (1 + slack);
    return clip[3] > 0 && fabs(clip[0]) <= w && fabs(clip[1]) <= w;
}

static bool has_depth(const double clip[4])
{
    return clip[2] >= 0 && clip[2] <= clip[3];
}

/* The view of the first light's map. */
static LightView fit_light(const Scene *scene, LightFit fit)
{
    Frame frame = { .color = NULL };
    const SceneCasters casters = scene_casters(scene, &scene->lights[0], &frame);
    const LightView view = light_fit(&casters, 0, fit);
    frame_free(&frame);
    return view;
}

/* Where the floor lies in the shadow of a point. */
static void shade_floor(const SceneLight *light, const double point[3], double floor[3])
{
    for (int k = 0; k < 3; k++) {
        double way = light->directional ? light->position[k] : light->position[k] - point[k];
        double rise = light->directional ? light->position[1] : light->position[1] - point[1];
        floor[k] = point[k] - way * point[1] / rise;
    }
}

static bool eye_sees(const Scene *scene, const double point[3])
{
    double view[4][4], projection[4][4], eye[4][4], clip[4];
    camera_view(&scene->camera, view);
    camera_projection(&scene->camera, 64.0 / 48, projection);
    matrix_multiply(projection, view, eye);
    project(eye, point, clip);
    return is_on_map(clip, 0) && has_depth(clip);
}

/* --- the casters ------------------------------------------------------------------------------ */

static void casters_are_on_the_map_and_fill_it(const char *light)
{
    Scene scene = avenue(light);
    LightView view = fit_light(&scene, LIGHT_FIT_CASTERS);
    double reach = 0;
    for (uint32_t i = 0; i < 12; i++)
        for (uint32_t j = 0; j < object(&scene, i)->geometry.vertex_count; j++) {
            double point[3], clip[4];
            draw_position(object(&scene, i), j, point);
            project(view.clip, point, clip);
            assert_true(is_on_map(clip, 0) && has_depth(clip));
            reach = fmax(reach, fmax(fabs(clip[0]), fabs(clip[1])) / clip[3]);
        }
    assert_true(reach > 0.97);
    scene_free(&scene);
}

static void casters_fit_holds_all_casters(void **state)
{
    (void)state;
    casters_are_on_the_map_and_fill_it(sun);
    casters_are_on_the_map_and_fill_it(spot);
}

/* --- the eye ---------------------------------------------------------------------------------- */

/* Every shaded point of the floor that the eye sees is on its map, and at the same place, less
 * deep, is what shades it. */
static void what_is_seen_stays_on_the_map(const char *source)
{
    Scene scene = avenue(source);
    const SceneLight *light = &scene.lights[0];
    LightView casters = fit_light(&scene, LIGHT_FIT_CASTERS);
    LightView eye = fit_light(&scene, LIGHT_FIT_EYE);
    assert_memory_not_equal(casters.clip, eye.clip, sizeof eye.clip);
    int seen = 0;
    for (int i = 0; i < 12 * 1000; i++) {
        int block = i / 1000;
        double caster[3] = { (block % 2 ? 2 : -2) + 0.4 * ((i % 10) / 4.5 - 1),
                             1 + 0.99 * ((i / 10 % 10) / 4.5 - 1),
                             -5 * (block / 2) + 0.4 * ((i / 100 % 10) / 4.5 - 1) };
        double floor[3], deep[4], above[4];
        shade_floor(light, caster, floor);
        project(eye.clip, floor, deep);
        project(eye.clip, caster, above);
        if (!eye_sees(&scene, floor))
            continue;
        seen++;
        assert_true(is_on_map(deep, 0) && has_depth(deep));
        assert_true(is_on_map(above, 0) && has_depth(above));
        for (int k = 0; k < 2; k++)
            assert_true(fabs(above[k] / above[3] - deep[k] / deep[3]) < 1e-9);
        assert_true(above[2] / above[3] < deep[2] / deep[3]);
    }
    assert_true(seen > 1000);
    scene_free(&scene);
}

static void eye_fit_keeps_what_is_seen(void **state)
{
    (void)state;
    what_is_seen_stays_on_the_map(sun);
    what_is_seen_stays_on_the_map(spot);
}

/* Of the map, what a small square of the floor gets; negative where it is turned over. */
static double density(LightView *view, double z)
{
    double corner[3][4];
    for (int i = 0; i < 3; i++) {
        project(view->clip, (double[3]){ i == 1 ? 0.01 : 0, 0, z - (i == 2 ? 0.01 : 0) },
                corner[i]);
        corner[i][0] /= corner[i][3];
        corner[i][1] /= corner[i][3];
    }
    double ax = corner[1][0] - corner[0][0], ay = corner[1][1] - corner[0][1];
    double bx = corner[2][0] - corner[0][0], by = corner[2][1] - corner[0][1];
    return ax * by - ay * bx;
}

static void eye_fit_gives_more_to_what_is_near(void **state)
{
    (void)state;
    const char *const lights[] = { sun, spot };
    for (int i = 0; i < 2; i++) {
        Scene scene = avenue(lights[i]);
        LightView casters = fit_light(&scene, LIGHT_FIT_CASTERS);
        LightView eye = fit_light(&scene, LIGHT_FIT_EYE);
        double near = density(&eye, -2) / density(&casters, -2);
        double far = density(&eye, -24) / density(&casters, -24);
        assert_true(near > 3); /* positive too: triangles turn as they did */
        assert_true(far > 0 && near > 4 * far);
        scene_free(&scene);
    }
}

static void eye_along_the_light_leaves_the_map_alone(void **state)
{
    (void)state;
    static const char along[] = "{ \"eye\": [-15, 20, -5], \"at\": [0, 0, -10], \"fovy\": 48, "
                                "\"near\": 0.5, \"far\": 120 }";
    static const char against[] = "{ \"eye\": [0, -0.5, -10], \"at\": [-15, 19.5, -5], "
                                  "\"fovy\": 48, \"near\": 0.5, \"far\": 120 }";
    const char *const cameras[] = { along, against };
    for (int i = 0; i < 2; i++) {
        Scene scene = load(sun, cameras[i]);
        LightView casters = fit_light(&scene, LIGHT_FIT_CASTERS);
        LightView eye = fit_light(&scene, LIGHT_FIT_EYE);
        assert_memory_equal(&casters, &eye, sizeof eye);
        scene_free(&scene);
    }
}

static void eye_that_sees_nothing_leaves_the_map_alone(void **state)
{
    (void)state;
    Scene scene = load(sun, "{ \"eye\": [0, 2, 90], \"at\": [0, 2, 91], \"fovy\": 48, "
                            "\"near\": 0.5, \"far\": 120 }");
    LightView casters = fit_light(&scene, LIGHT_FIT_CASTERS);
    LightView eye = fit_light(&scene, LIGHT_FIT_EYE);
    assert_memory_equal(&casters, &eye, sizeof eye);
    scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(casters_fit_holds_all_casters),
        cmocka_unit_test(eye_fit_keeps_what_is_seen),
        cmocka_unit_test(eye_fit_gives_more_to_what_is_near),
        cmocka_unit_test(eye_along_the_light_leaves_the_map_alone),
        cmocka_unit_test(eye_that_sees_nothing_leaves_the_map_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
