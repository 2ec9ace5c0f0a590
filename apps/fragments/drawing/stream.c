#include "apps/fragments/drawing/stream.h"

#include "apps/fragments/drawing/passes.h"
#include "shaders_c/common/depth_only.h"

#include <string.h>

typedef struct Stream {
    bool (*take)(void *context, const StreamFragment *fragment);
    void *context;
    bool failed;
} Stream;

static void tell(void *user, const GpTraceEvent *event)
{
    Stream *stream = user;
    if (event->kind != GP_TRACE_INTERPOLATE || stream->failed)
        return;
    const StreamFragment fragment = { event->primitive, (uint32_t)event->x, (uint32_t)event->y,
                                      event->interpolate.depth };
    stream->failed = !stream->take(stream->context, &fragment);
}

/* A pass that changes nothing. */
static void add_pass(const FragmentMesh *mesh, const FragmentView *view, Frame *frame)
{
    FragmentPasses passes = fragment_passes(mesh, view, NULL, NULL, frame);
    DepthOnlyUniforms uniforms;
    memcpy(uniforms.mvp, passes.uniforms.mvp, sizeof uniforms.mvp);
    passes.depth = fragment_surface(&passes, GP_D16);
    fragment_pass(&passes, "stream", NULL, 0);
    frame_draw_copied(frame, &depth_only_program, &uniforms, mesh->drawn)->state.depth.test =
        GP_NEVER;
}

GpResult fragment_stream(const FragmentMesh *mesh, const FragmentView *view,
                         bool (*take)(void *context, const StreamFragment *fragment), void *context,
                         GpError *error)
{
    Stream stream = { .take = take, .context = context };
    Frame frame = { .color = NULL };
    GpDevice *device = NULL;
    const GpDeviceDesc desc = { .executor = GP_EXECUTOR_REFERENCE,
                                .trace = { .event = tell, .user = &stream } };
    add_pass(mesh, view, &frame);
    GpResult result = frame_result(&frame, error);
    if (!result)
        result = gp_device_create(&desc, &device, error);
    if (!result)
        result = gp_device_run(device, &frame.list, error);
    if (!result && stream.failed)
        result = gp_fail(error, GP_ERROR_MEMORY, "no memory for the mesh's fragments");
    gp_device_destroy(&device);
    frame_free(&frame);
    return result;
}
