/* Benchmark case of a walk: two hundred depth images under the sun and its shadows, all of them in
 * view. */
#include "apps/bench/cases.h"
#include "apps/techniques/warp/walk_models.h"

enum { WIDTH = 1920, HEIGHT = 1080, OBJECTS = 200, PIXELS = 512 };

typedef struct Case {
    Walk walk;
    WalkCounts counts;
} Case;

static void release(void *held)
{
    Case *made = held;
    walk_close(&made->walk);
    gp_free(made);
}

GpResult bench_build_walk(const BenchCase *bench, Frame *frame, GpError *error)
{
    const WalkOptions options = { .objects = OBJECTS, .pixels = PIXELS };
    GpDevice *device = NULL;
    Case *made = gp_alloc(1, sizeof *made);
    (void)bench;
    if (!made)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    frame->held = made;
    frame->release = release;
    GpResult result = gp_device_create(&(GpDeviceDesc){ .threads = 0 }, &device, error);
    if (!result)
        result = walk_open_models(device, &options, &made->walk, error);
    gp_device_destroy(&device);
    if (result)
        return result;
    const Camera camera = walk_camera(&made->walk, 0.4);
    return walk_add(&made->walk, &(WalkSetting){ .map = 0 }, &camera, WIDTH, HEIGHT, frame,
                    &made->counts, error);
}

void bench_tell_walk(const Frame *frame, double ms, int threads, bool measures, json_t *object)
{
    const Case *made = frame->held;
    (void)ms;
    (void)threads;
    (void)measures;
    json_object_set_new(object, "objects", json_integer(made->counts.objects));
    json_object_set_new(object, "triangles", json_integer(made->counts.triangles));
    json_object_set_new(object, "shadow_triangles", json_integer(made->counts.shadow_triangles));
}
