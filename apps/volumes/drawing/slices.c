#include "apps/volumes/drawing/slices.h"

#include "apps/base/stable_math.h"
#include "shaders_c/common/texel_copy.h"
#include "shaders_c/volume/sheet.h"
#include "shaders_c/volume/slices.h"

#include <math.h>
#include <string.h>

enum { CELL = 2 /* bricks along the sides of what is drawn or not */ };

/* --- what stays ------------------------------------------------------------------------------- */

GpResult slices_open(const Field *field, SlicesVolume *volume, GpError *error)
{
    SlicesVolume made = { .field = field };
    const GpResult result = bricks_make(field, &made.bricks, error);
    if (result)
        return result;
    made.shown = gp_alloc(bricks_total(&made.bricks) + 1, 1);
    if (!made.shown) {
        slices_close(&made);
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    }
    *volume = made;
    return GP_OK;
}

static void free_slices(SlicesVolume *volume, int axis)
{
    for (uint32_t i = 0; volume->slice[axis] && i < volume->field->size[axis]; i++)
        gp_surface_destroy(&volume->slice[axis][i]);
    gp_free(volume->slice[axis]);
    volume->slice[axis] = NULL;
}

void slices_close(SlicesVolume *volume)
{
    for (int axis = 0; axis < 3; axis++)
        free_slices(volume, axis);
    gp_free(volume->turned);
    gp_free(volume->shown);
    bricks_free(&volume->bricks);
    *volume = (SlicesVolume){ .field = NULL };
}

void slices_classify(SlicesVolume *volume, const Transfer *transfer)
{
    volume->transfer = *transfer;
    bricks_show(&volume->bricks, transfer, volume->shown);
}

/* Samples by y, z, x. */
static GpResult turn(SlicesVolume *volume, GpError *error)
{
    const Field *field = volume->field;
    const uint32_t *n = field->size;
    const uint8_t *from = field->value;
    volume->turned = gp_alloc(field_samples(field), 1);
    if (!volume->turned)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (size_t z = 0; z < n[2]; z++)
        for (size_t y = 0; y < n[1]; y++, from += n[0])
            for (size_t x = 0; x < n[0]; x++)
                volume->turned[(x * n[2] + z) * n[1] + y] = from[x];
    return GP_OK;
}

/* Axes along slices: rows of texels are u, columns v. */
static const int along[3][2] = { { 1, 2 }, { 0, 2 }, { 0, 1 } };

/* Slices are the field's own memory, but across x. */
static GpResult make_slices(SlicesVolume *volume, int axis, GpError *error)
{
    const Field *field = volume->field;
    const size_t nx = field->size[0], ny = field->size[1], nz = field->size[2];
    GpResult result = axis == 0 && !volume->turned ? turn(volume, error) : GP_OK;
    volume->slice[axis] = gp_alloc(field->size[axis], sizeof(GpSurface *));
    if (!result && !volume->slice[axis])
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    for (size_t i = 0; i < field->size[axis] && !result; i++) {
        uint8_t *const first[3] = { volume->turned ? volume->turned + i * ny * nz : NULL,
                                    field->value + i * nx, field->value + i * nx * ny };
        const size_t pitch[3] = { ny, nx * ny, nx };
        result = gp_surface_create(&(GpSurfaceDesc){ .format = GP_R8,
                                                     .width = field->size[along[axis][0]],
                                                     .height = field->size[along[axis][1]],
                                                     .name = "slice",
                                                     .memory = first[axis],
                                                     .pitch = pitch[axis] },
                                   &volume->slice[axis][i], error);
    }
    if (result)
        free_slices(volume, axis);
    return result;
}

/* --- a frame's planes ------------------------------------------------------------------------- */

/* Colour, and log2 of what a unit leaves: [value * PER_VALUE]. */
enum { PER_VALUE = 4, ENTRIES = (FIELD_VALUES - 1) * PER_VALUE + 1 };

static GpSurface *make_table(const Transfer *transfer, Frame *frame)
{
    const double ln2 = 0.6931471805599453, dark = 0x1p-24;
    GpSurface *table = frame_surface(frame, GP_A32B32G32R32F, ENTRIES, 1, 1);
    float *texel = (float *)(void *)table->level[0].texels;
    for (uint32_t i = 0; i < ENTRIES && texel; i++, texel += 4) {
        double rgba[4];
        transfer_at(transfer, (double)i / PER_VALUE, rgba);
        for (int c = 0; c < 3; c++)
            texel[c] = (float)rgba[c];
        texel[3] = (float)(stable_log(fmax(1 - rgba[3], dark)) / ln2);
    }
    return table;
}

/* Planes of a frame, and what they share. */
typedef struct Planes {
    const SlicesVolume *volume;
    const VolumeTarget *target;
    Frame *frame;
    int axis;
    uint32_t count;
    double thickness;    /* samples from plane to plane */
    double eye;          /* of the camera along the axis, in samples; parallel: far away */
    uint32_t cells[2];   /* along u and v */
    GpGeometry geometry; /* corners of all cells */
    GpSurface *table, *sum, *depth;
    VolumeSliceUniforms uniforms;
} Planes;

/* Whether anything shows in a cell of a layer of bricks. */
static bool cell_shows(const Planes *planes, uint32_t u, uint32_t v, uint32_t layer)
{
    const SlicesVolume *volume = planes->volume;
    const uint32_t *count = volume->bricks.count;
    const int *axes = along[planes->axis];
    uint32_t at[3];
    at[planes->axis] = layer;
    for (uint32_t j = CELL * v; j < CELL * (v + 1) && j < count[axes[1]]; j++)
        for (uint32_t i = CELL * u; i < CELL * (u + 1) && i < count[axes[0]]; i++) {
            at[axes[0]] = i;
            at[axes[1]] = j;
            if (volume->shown[((size_t)at[2] * count[1] + at[1]) * count[0] + at[0]])
                return true;
        }
    return false;
}

/* Corners of cells, which neighbours share, so that no pixel is drawn twice or left out between. */
static void find_corners(Planes *planes)
{
    const Field *field = planes->volume->field;
    const int *axes = along[planes->axis];
    const uint32_t side = CELL * BRICK_SIDE,
                   last[2] = { field->size[axes[0]] - 1, field->size[axes[1]] - 1 };
    for (int i = 0; i < 2; i++)
        planes->cells[i] = (last[i] + side - 1) / side;
    const uint32_t count = (planes->cells[0] + 1) * (planes->cells[1] + 1);
    float(*corners)[2] = frame_alloc(planes->frame, count, sizeof *corners);
    planes->geometry =
        (GpGeometry){ .vertex_count = count,
                      .streams = { [GP_POSITION] = { .data = corners, .components = 2 } } };
    for (uint32_t k = 0; k < count && corners; k++) {
        const uint32_t u = k % (planes->cells[0] + 1) * side, v = k / (planes->cells[0] + 1) * side;
        corners[k][0] = (float)(u < last[0] ? u : last[0]);
        corners[k][1] = (float)(v < last[1] ? v : last[1]);
    }
}

/* Two triangles of each cell of a layer that shows anything. */
static GpGeometry layer_of(const Planes *planes, uint32_t layer)
{
    const uint32_t across = planes->cells[0] + 1;
    uint32_t count = 0;
    GpGeometry geometry = planes->geometry;
    uint32_t *index =
        frame_alloc(planes->frame, (size_t)planes->cells[0] * planes->cells[1], 6 * sizeof *index);
    for (uint32_t v = 0; v < planes->cells[1] && index; v++)
        for (uint32_t u = 0; u < planes->cells[0]; u++) {
            const uint32_t first = v * across + u;
            const uint32_t quad[6] = { first,     first + 1,      first + across,
                                       first + 1, first + across, first + across + 1 };
            if (!cell_shows(planes, u, v, layer))
                continue;
            memcpy(index + count, quad, sizeof quad);
            count += 6;
        }
    geometry.indices = index;
    geometry.index_count = count;
    return geometry;
}

static void find_uniforms(const VolumeView *view, const CameraAxes *axes, Planes *planes)
{
    const Field *field = planes->volume->field;
    const double right = -0.3, up = 0.4, back = 1, length = sqrt(1.25);
    const int order[3] = { along[planes->axis][0], along[planes->axis][1], planes->axis };
    const bool parallel = view->camera.fovy <= 0;
    VolumeSliceUniforms *uniforms = &planes->uniforms;
    float to_clip[4][4];
    camera_matrix(&view->camera, (double)view->width / view->height, to_clip);
    for (int i = 0; i < 3; i++) {
        const int k = order[i];
        const double scale = field->scale[k];
        for (int row = 0; row < 4; row++) {
            uniforms->to_clip[row][i] = (float)((double)to_clip[row][k] * scale);
            uniforms->to_clip[row][3] = to_clip[row][3];
        }
        uniforms->scale[i] = parallel ? 0 : (float)scale;
        uniforms->eye[i] = (float)(parallel ? axes->forward[k] : view->camera.eye[k]);
        uniforms->per_scale[i] = (float)(1 / scale);
        uniforms->light[i] =
            (float)((axes->right[k] * right + axes->up[k] * up - axes->forward[k] * back) / length);
    }
    for (int i = 0; i < 2; i++)
        uniforms->texel[i] = 1 / (float)field->size[order[i]];
    uniforms->table[0] = (float)(ENTRIES - 1) / ENTRIES;
    uniforms->table[1] = 0.5f / ENTRIES;
    uniforms->thickness = (float)(planes->thickness * field->scale[planes->axis]);
    uniforms->ambient = 0.25f;
    uniforms->diffuse = 0.75f;
}

/* --- passes ----------------------------------------------------------------------------------- */

static const float nothing[4] = { 0 };

static GpDraw *draw_whole(const GpProgram *program, const GpSurface *local, Frame *frame)
{
    static const float corners[] = { -1, -1, 0, -1, 3, 0, 3, -1, 0 }; /* in front of all */
    const GpGeometry whole = {
        .vertex_count = 3, .streams = { [GP_POSITION] = { .data = corners, .components = 3 } }
    };
    GpDraw *draw = frame_draw(frame, program, NULL, &whole);
    draw->textures[0].surface = local;
    return draw;
}

/* Opaque pixels are marked in a depth buffer of the frame's own: that of the target stays as it
 * is. */
static void begin(Planes *planes)
{
    Frame *frame = planes->frame;
    frame_pass(frame, "slices-depth", NULL, planes->depth, nothing);
    if (planes->target->depth)
        draw_whole(&texel_depth_program, planes->target->depth, frame)->state.depth =
            (GpDepthState){ .test = GP_ALWAYS, .write = true };
}

static void draw_plane(const Planes *planes, const GpProgram *program, uint32_t number,
                       const GpGeometry *geometry)
{
    static const GpSampler linear = { .min = GP_LINEAR,
                                      .mag = GP_LINEAR,
                                      .address_u = GP_CLAMP,
                                      .address_v = GP_CLAMP },
                           points = { .address_u = GP_CLAMP, .address_v = GP_CLAMP };
    const SlicesVolume *volume = planes->volume;
    VolumeSliceUniforms uniforms = planes->uniforms;
    const double w = (number + 0.5) * planes->thickness, before = floor(w);
    uniforms.w = (float)w;
    uniforms.share = (float)(w - before);
    GpDraw *draw = frame_draw_copied(planes->frame, program, &uniforms, geometry);
    for (int i = 0; i < 2; i++)
        draw->textures[i] =
            (GpTexture){ volume->slice[planes->axis][(uint32_t)before + (uint32_t)i], linear };
    draw->textures[2] = (GpTexture){ planes->table, points };
    draw->state.depth.test = GP_LESS;
    draw->state.blend[0] = (GpBlend){ .op = GP_BLEND_ADD, .src = GP_INV_DEST_ALPHA, .dst = GP_ONE };
}

static void mark_opaque(const Planes *planes)
{
    frame_pass(planes->frame, "opaque", NULL, planes->depth, nothing)->depth.clear_depth = false;
    draw_whole(&sheets_opaque_program, planes->sum, planes->frame)->state.depth =
        (GpDepthState){ .test = GP_ALWAYS, .write = true };
}

static void put_over(const Planes *planes)
{
    frame_pass(planes->frame, "slices-over", planes->target->color, NULL, nothing)->color[0].clear =
        false;
    draw_whole(&sheets_over_program, planes->sum, planes->frame)->state.blend[0] =
        (GpBlend){ .op = GP_BLEND_ADD, .src = GP_ONE, .dst = GP_INV_SRC_ALPHA };
}

/* The next plane from the front; those before ends[0] and from ends[1] on are to come. No ray meets
 * planes on both sides of the eye, so those of each side are in order where all go by their
 * distance. */
static uint32_t from_front(const Planes *planes, uint32_t ends[2])
{
    const double low = (ends[0] - 0.5) * planes->thickness;
    const double high = (ends[1] + 0.5) * planes->thickness;
    if (ends[0] > 0 && (ends[1] == planes->count || planes->eye - low < high - planes->eye))
        return --ends[0];
    return ends[1]++;
}

/* Planes that nothing can be seen in are left out. */
static void draw_planes(Planes *planes, const VolumeView *view, uint32_t cull)
{
    const GpProgram *program = view->lit ? &volume_slice_lit_program : &volume_slice_program;
    const uint32_t layers = planes->volume->bricks.count[planes->axis];
    GpGeometry *geometry = frame_alloc(planes->frame, layers, sizeof *geometry);
    const double at = planes->eye / planes->thickness + 0.5;
    const uint32_t begin_at = (uint32_t)fmin(fmax(at, 0), planes->count);
    uint32_t ends[2] = { begin_at, begin_at }, drawn = 0;
    for (uint32_t layer = 0; layer < layers && geometry; layer++)
        geometry[layer] = layer_of(planes, layer);
    for (uint32_t i = 0; i < planes->count && geometry; i++) {
        const uint32_t number = from_front(planes, ends);
        const uint32_t layer = (uint32_t)((number + 0.5) * planes->thickness) / BRICK_SIDE;
        if (geometry[layer].index_count == 0)
            continue;
        if (drawn % cull == 0) {
            if (drawn > 0)
                mark_opaque(planes);
            GpPass *pass = frame_pass(planes->frame, "slices", planes->sum, planes->depth, nothing);
            pass->depth.clear_depth = false;
            pass->color[0].clear = drawn == 0;
        }
        draw_plane(planes, program, number, &geometry[layer]);
        drawn++;
    }
    if (drawn > 0)
        put_over(planes);
}

/* The axis nearest to the view's. */
static int axis_of(const CameraAxes *axes)
{
    int axis = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(axes->forward[i]) > fabs(axes->forward[axis]))
            axis = i;
    return axis;
}

GpResult slices_add(SlicesVolume *volume, const VolumeView *view, const SlicesSetting *setting,
                    const VolumeTarget *target, Frame *frame, GpError *error)
{
    const Field *field = volume->field;
    const CameraAxes axes = camera_axes(&view->camera, (double)view->width / view->height);
    const double spacing = setting->spacing > 0 ? setting->spacing : 1;
    Planes planes = { .volume = volume, .target = target, .frame = frame, .axis = axis_of(&axes) };
    if (bricks_total(&volume->bricks) == 0)
        return frame_result(frame, error);
    if (!volume->slice[planes.axis]) {
        const GpResult result = make_slices(volume, planes.axis, error);
        if (result)
            return result;
    }
    const double reach = field->size[planes.axis] - 1, far = 1e9;
    planes.count = (uint32_t)fmax(reach / spacing + 0.5, 1);
    planes.thickness = reach / planes.count;
    planes.eye = view->camera.eye[planes.axis] / field->scale[planes.axis];
    if (view->camera.fovy <= 0)
        planes.eye = axes.forward[planes.axis] > 0 ? -far : far;
    planes.table = make_table(&volume->transfer, frame);
    planes.sum = frame_surface(frame, GP_A32B32G32R32F, view->width, view->height, 1);
    planes.depth = frame_surface(frame, GP_D32F, view->width, view->height, 1);
    find_corners(&planes);
    find_uniforms(view, &axes, &planes);
    begin(&planes);
    draw_planes(&planes, view, setting->cull ? setting->cull : 16);
    return frame_result(frame, error);
}
