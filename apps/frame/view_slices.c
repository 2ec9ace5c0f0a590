#include "apps/frame/view_slices.h"

#include <math.h>

enum { MOST_PARTS = 16 };

/* Rays may be so much steeper than their shares of a slab were computed for: more than
 * interpolation rounds by. */
#define STEEPER 1.001

/* --- how many --------------------------------------------------------------------------------- */

/* Voxels that a ray moves along u or v while it moves by one along w; infinite where it does
 * not. */
static double steepness(const ViewSlices *slices, const double ray[3])
{
    const double u = fabs(ray[slices->axes[0]]), v = fabs(ray[slices->axes[1]]);
    const double w = ray[slices->axes[2]] * slices->toward;
    return w > 0 ? (u > v ? u : v) / w : (double)INFINITY;
}

/* The steepest ray of the picture is one of its corners'. */
static double steepest_of_picture(const ViewSlices *slices, const CameraAxes *axes)
{
    const bool perspective = slices->camera->fovy > 0;
    double most = 0;
    for (int corner = 0; corner < 4; corner++) {
        const double x = perspective ? (corner & 1 ? 1 : -1) * axes->half_width : 0;
        const double y = perspective ? (corner & 2 ? 1 : -1) * axes->half_height : 0;
        double ray[3];
        for (int k = 0; k < 3; k++)
            ray[k] = axes->forward[k] + x * axes->right[k] + y * axes->up[k];
        const double one = steepness(slices, ray);
        most = one > most ? one : most;
    }
    return most;
}

/* Of all rays that meet the range, it is one through a corner of it. */
static double steepest_of_box(const ViewSlices *slices)
{
    double most = 0;
    for (int corner = 0; corner < 8; corner++) {
        double ray[3];
        for (int k = 0; k < 3; k++)
            ray[k] = (corner >> k & 1 ? slices->range.end[k] : slices->range.low[k]) -
                     slices->camera->eye[k];
        const double one = steepness(slices, ray);
        most = one > most ? one : most;
    }
    return most;
}

GpResult view_slices_find(const VoxelRange *range, const Camera *camera, double aspect,
                          ViewSlices *slices, GpError *error)
{
    const CameraAxes axes = camera_axes(camera, aspect);
    ViewSlices found = { .range = *range, .camera = camera };
    int axis = 0;
    for (int k = 1; k < 3; k++)
        axis = fabs(axes.forward[k]) > fabs(axes.forward[axis]) ? k : axis;
    for (int k = 0; k < 3; k++)
        found.axes[k] = (axis + 1 + k) % 3;
    found.toward = axes.forward[axis] < 0 ? -1 : 1;

    double steepest = steepest_of_picture(&found, &axes);
    if (camera->fovy > 0 && steepest_of_box(&found) < steepest)
        steepest = steepest_of_box(&found);
    if (steepest * STEEPER > MOST_PARTS)
        return gp_fail(error, GP_ERROR_INVALID,
                       "the view is too wide for slices across one axis: fovy %g", camera->fovy);
    found.parts = steepest > 1 ? (uint32_t)ceil(steepest * STEEPER) : 1;
    *slices = found;
    return GP_OK;
}

/* --- quads ------------------------------------------------------------------------------------ */

typedef struct SliceVertex {
    float position[3]; /* u, v, w */
    float layer;
} SliceVertex;

/* Near side of the i-th slab from the side where rays enter, by w. */
static double near_side(const ViewSlices *slices, uint32_t i)
{
    const int axis = slices->axes[2];
    const double depth = (double)i / slices->parts;
    return slices->toward > 0 ? slices->range.low[axis] + depth : slices->range.end[axis] - depth;
}

static bool is_behind(const ViewSlices *slices, uint32_t i)
{
    const double way = near_side(slices, i) - slices->camera->eye[slices->axes[2]];
    return slices->camera->fovy > 0 && way * slices->toward <= 0;
}

static void put_quad(const ViewSlices *slices, uint32_t i, SliceVertex vertex[4])
{
    const uint32_t from_near = i / slices->parts;
    const VoxelRange *range = &slices->range;
    const int axis[3] = { slices->axes[0], slices->axes[1], slices->axes[2] };
    const uint32_t layer =
        slices->toward > 0 ? range->low[axis[2]] + from_near : range->end[axis[2]] - 1 - from_near;
    for (int corner = 0; corner < 4; corner++) {
        SliceVertex *v = &vertex[corner];
        for (int k = 0; k < 2; k++)
            v->position[k] =
                corner >> k & 1 ? (float)range->end[axis[k]] + 1 : (float)range->low[axis[k]] - 1;
        v->position[2] = (float)near_side(slices, i);
        v->layer = (float)layer;
    }
}

uint32_t view_slices_count(const ViewSlices *slices)
{
    const int axis = slices->axes[2];
    return (slices->range.end[axis] - slices->range.low[axis]) * slices->parts;
}

GpGeometry view_slices_quads(Frame *frame, const ViewSlices *slices, bool nearest_first)
{
    static const uint32_t triangles[6] = { 0, 1, 2, 2, 1, 3 };
    const uint32_t slabs = view_slices_count(slices);
    SliceVertex *vertices = frame_alloc(frame, 4 * (size_t)slabs, sizeof *vertices);
    uint32_t *indices = frame_alloc(frame, 6 * (size_t)slabs, sizeof *indices), quads = 0;
    if (!vertices || !indices)
        return (GpGeometry){ .vertex_count = 0 };
    for (uint32_t i = 0; i < slabs; i++) {
        const uint32_t slab = nearest_first ? i : slabs - 1 - i;
        if (is_behind(slices, slab))
            continue;
        put_quad(slices, slab, vertices + 4 * (size_t)quads);
        for (uint32_t k = 0; k < 6; k++)
            indices[6 * quads + k] = 4 * quads + triangles[k];
        quads++;
    }
    return (GpGeometry){
        .vertex_count = 4 * quads,
        .indices = indices,
        .index_count = 6 * quads,
        .streams = { [GP_POSITION] = { vertices->position, sizeof *vertices, 3, GP_FLOAT32 },
                     [GP_TEXCOORD0] = { &vertices->layer, sizeof *vertices, 1, GP_FLOAT32 } },
    };
}

SliceUniforms view_slices_uniforms(const ViewSlices *slices, double aspect)
{
    const Camera *camera = slices->camera;
    const CameraAxes axes = camera_axes(camera, aspect);
    SliceUniforms uniforms = { .thickness = (float)(slices->toward / slices->parts) };
    float to_clip[4][4];
    camera_matrix(camera, aspect, to_clip);
    for (int k = 0; k < 3; k++) {
        const int axis = slices->axes[k];
        uniforms.axes[axis][k] = 1;
        uniforms.eye[k] = (float)(camera->fovy > 0 ? camera->eye[axis] : -axes.forward[axis]);
        for (int row = 0; row < 4; row++)
            uniforms.to_clip[row][k] = to_clip[row][axis];
    }
    for (int row = 0; row < 4; row++)
        uniforms.to_clip[row][3] = to_clip[row][3];
    uniforms.eye[3] = camera->fovy > 0 ? 1 : 0;
    return uniforms;
}
