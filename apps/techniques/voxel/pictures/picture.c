#include "apps/techniques/voxel/pictures/picture.h"

#include "apps/techniques/voxel/pictures/scan.h"

#include <math.h>
#include <string.h>

const VoxelPicture voxel_picture_defaults = {
    .width = 512, .height = 512, .azimuth = 30, .elevation = 20, .zoom = 1
};

/* --- scans ------------------------------------------------------------------------------------ */

enum { VALUES = 256 };

static double sample(const GpVolume *scan, size_t i)
{
    switch (scan->type) {
    case GP_VOLUME_BITS:
        return ((const uint8_t *)scan->data)[i / 8] >> i % 8 & 1;
    case GP_VOLUME_U8:
        return ((const uint8_t *)scan->data)[i];
    case GP_VOLUME_U16:
        return ((const uint16_t *)scan->data)[i];
    case GP_VOLUME_I16:
        return ((const int16_t *)scan->data)[i];
    case GP_VOLUME_F32:
        return (double)((const float *)scan->data)[i];
    }
    return 0;
}

/* Samples as bytes, from the least to the greatest; what is no number becomes 0. The caller frees
 * them. */
static uint8_t *make_bytes(const GpVolume *scan)
{
    const size_t count = (size_t)scan->dims[0] * scan->dims[1] * scan->dims[2];
    uint8_t *bytes = gp_alloc(count, 1);
    double least = (double)INFINITY, most = -least;
    for (size_t i = 0; i < count; i++) {
        const double value = sample(scan, i);
        least = isfinite(value) && value < least ? value : least;
        most = isfinite(value) && value > most ? value : most;
    }
    const double scale = most > least ? (VALUES - 1) / (most - least) : 0;
    for (size_t i = 0; bytes && i < count; i++) {
        const double value = sample(scan, i);
        bytes[i] = isfinite(value) ? (uint8_t)((value - least) * scale + 0.5) : 0;
    }
    return bytes;
}

/* How much light a voxel takes, as a share of what it lets through: twice as many voxels on the same
 * way take half of it each, nearly. */
static double opacity_of(double density)
{
    return density / (1 + density);
}

/* A point of a transfer ramp; its last number is a density for a volume of RAMP_SIZE. */
typedef struct Stop {
    double value, rgba[4];
} Stop;

/* Nothing, skin, flesh, bone: as bytes of a scan by X-rays have them, and other scans roughly. */
static const Stop stops[] = {
    { 0, { 0.9, 0.6, 0.4, 0 } },       { 48, { 0.9, 0.6, 0.4, 0 } },
    { 70, { 0.9, 0.6, 0.45, 0.03 } },  { 110, { 0.85, 0.5, 0.4, 0.02 } },
    { 140, { 0.95, 0.9, 0.8, 0.12 } }, { 255, { 1, 0.98, 0.92, 0.3 } },
};

enum { RAMP_SIZE = 128 };

static const uint8_t *make_ramp(Frame *frame, uint32_t size)
{
    uint8_t *ramp = frame_alloc(frame, VALUES, 4);
    size_t stop = 0;
    for (int i = 0; i < VALUES; i++) {
        while (stop + 2 < GP_COUNT(stops) && stops[stop + 1].value < i)
            stop++;
        const Stop *a = &stops[stop], *b = a + 1;
        const double t = (i - a->value) / (b->value - a->value);
        double rgba[4];
        for (int c = 0; c < 4; c++)
            rgba[c] = a->rgba[c] + t * (b->rgba[c] - a->rgba[c]);
        rgba[3] = opacity_of(rgba[3] * RAMP_SIZE / size);
        for (int c = 0; c < 4; c++)
            ramp[4 * i + c] = (uint8_t)(rgba[c] * 255 + 0.5);
    }
    return ramp;
}

static GpResult add_scan(const GpVolume *scan, uint32_t size, Frame *frame, VoxelView *view,
                         GpError *error)
{
    if (size > VOXEL_SCAN_MAX_SIZE)
        return gp_fail(error, GP_ERROR_INVALID, "--scan: a volume of at most %d voxels a side",
                       VOXEL_SCAN_MAX_SIZE);
    GpResult result = flat_texture_check(size, 8, error);
    if (result)
        return result;
    uint8_t *bytes = make_bytes(scan);
    if (!bytes)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    double spacing[3], longest = 0;
    for (int k = 0; k < 3; k++)
        longest = fmax(longest, scan->dims[k] * scan->spacing[k]);
    for (int k = 0; k < 3; k++)
        spacing[k] = scan->spacing[k] * size / longest;
    const FlatTexture sheet = voxel_scan(frame, bytes, scan->dims, spacing, size);
    gp_free(bytes);
    FlatTexture *slopes = frame_alloc(frame, 1, sizeof *slopes);
    *slopes = voxel_scan_slopes(frame, &sheet);
    view->scan = slopes;
    view->transfer = make_ramp(frame, size);
    return GP_OK;
}

/* --- the picture ------------------------------------------------------------------------------ */

/* Of a solid that fills its volume, at any size. */
#define SOLID_DENSITY 3.0

/* Opacity of a model in a scan: what is around it lights up too. */
#define IN_SCAN 0.35f

/* Axes that point right, up and to the front, right-handed, for each VoxelUp. */
static const double turns[][3][3] = {
    [VOXEL_UP_Y] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    [VOXEL_UP_Z] = { { 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 } },
    [VOXEL_UP_X] = { { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, -1 } },
    [VOXEL_DOWN_Y] = { { 1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } },
    [VOXEL_DOWN_Z] = { { 1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } },
};

/* Of the way between a box and the picture's border. */
#define BORDER 1.05
#define ANGLE  30.0 /* of view, before it is zoomed */

/* The camera's own axes: to the right, up, and towards the eye. */
static void find_axes(const VoxelPicture *picture, double axes[3][3])
{
    const double(*turn)[3] = turns[picture->up];
    double sine[2], cosine[2];
    angle_sincos(picture->azimuth, &sine[0], &cosine[0]);
    angle_sincos(picture->elevation, &sine[1], &cosine[1]);
    const double own[3][3] = { { cosine[0], 0, -sine[0] },
                               { -sine[0] * sine[1], cosine[1], -cosine[0] * sine[1] },
                               { sine[0] * cosine[1], sine[1], cosine[0] * cosine[1] } };
    for (int a = 0; a < 3; a++)
        for (int k = 0; k < 3; k++)
            axes[a][k] = own[a][0] * turn[0][k] + own[a][1] * turn[1][k] + own[a][2] * turn[2][k];
}

/* The angle of view at which a picture is larger by a factor, by bisection: the C library's arc tangent
 * has other bits elsewhere. */
static double zoom_angle(double angle, double zoom)
{
    double sine, cosine, low = 0, high = 180;
    angle_sincos(angle / 2, &sine, &cosine);
    const double tangent = sine / cosine / zoom;
    while (high - low > 1e-9) {
        const double middle = (low + high) / 2;
        angle_sincos(middle / 2, &sine, &cosine);
        *(sine < tangent * cosine ? &low : &high) = middle;
    }
    return low;
}

/* Looks at the middle of a range, from just so far that every corner is in the picture. */
static Camera place_camera(const VoxelPicture *picture, const VoxelRange *range)
{
    double axes[3][3], half[3], sine, cosine, distance = 0, radius = 0;
    find_axes(picture, axes);
    angle_sincos(ANGLE / 2, &sine, &cosine);
    const double aspect = (double)picture->width / picture->height;
    const double wide = BORDER * cosine / sine / aspect, high = BORDER * cosine / sine;
    for (int k = 0; k < 3; k++) {
        half[k] = (range->end[k] - (double)range->low[k]) / 2;
        radius += half[k];
    }
    for (int corner = 0; corner < 8; corner++) {
        double at[3];
        for (int k = 0; k < 3; k++)
            at[k] = corner >> k & 1 ? half[k] : -half[k];
        const double toward = vector_dot(at, axes[2]);
        distance = fmax(distance, toward + wide * fabs(vector_dot(at, axes[0])));
        distance = fmax(distance, toward + high * fabs(vector_dot(at, axes[1])));
    }
    Camera camera = { .fovy = zoom_angle(ANGLE, picture->zoom),
                      .near = fmax(distance - radius, 1),
                      .far = distance + radius };
    for (int k = 0; k < 3; k++) {
        camera.at[k] = range->low[k] + half[k];
        camera.eye[k] = camera.at[k] + distance * axes[2][k];
        camera.up[k] = axes[1][k];
    }
    return camera;
}

GpResult voxel_picture_build(const VoxelPicture *picture, const VoxelPairMade *made,
                             const GpVolume *scan, Frame *frame, GpError *error)
{
    const uint32_t size = made->result.size;
    if (made->result.bits != 1)
        return gp_fail(error, GP_ERROR_INVALID, "a picture is of one bit a voxel, not %u",
                       made->result.bits);
    VoxelView view = voxel_view_defaults;
    view.mode = picture->look;
    view.shading = picture->shading;
    view.range = made->range;
    if (picture->is_solid)
        view.paint.opacity = view.second_paint.opacity = (float)opacity_of(SOLID_DENSITY / size);
    if (picture->shows_both) {
        view.second = &made->sheets[1];
        view.range = made->around;
    }
    if (scan) {
        GpResult result = add_scan(scan, size, frame, &view, error);
        if (result)
            return result;
        view.paint = view.second_paint; /* not the colour of bones */
        view.paint.opacity = IN_SCAN;
    }
    const bool anywhere = scan || voxel_range_is_empty(&view.range);
    const VoxelRange seen = anywhere ? voxel_range_whole(size) : view.range;
    view.camera = place_camera(picture, &seen);
    return voxel_view_build(picture->shows_both ? &made->sheets[0] : &made->result, &view,
                            picture->width, picture->height, frame, error);
}
