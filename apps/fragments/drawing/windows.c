#include "apps/fragments/drawing/windows.h"

#include "apps/fragments/drawing/stream.h"

typedef struct Windows {
    const uint32_t *indices;
    uint32_t fragments, triangles; /* of a window; those that have begun */
    uint64_t number;
    float *windows;
} Windows;

/* Triangles without fragments are in the window of those before them. */
static bool count(void *context, const StreamFragment *fragment)
{
    Windows *windows = context;
    for (; windows->triangles <= fragment->triangle; windows->triangles++)
        windows->windows[windows->indices[3 * (size_t)windows->triangles]] =
            (float)(windows->number / windows->fragments);
    windows->number++;
    return true;
}

GpResult fragment_windows(const FragmentMesh *mesh, const FragmentView *view, uint32_t fragments,
                          float *windows, GpError *error)
{
    Windows counted = { .indices = mesh->drawn->indices,
                        .fragments = fragments,
                        .windows = windows };
    return fragment_stream(mesh, view, count, &counted, error);
}
