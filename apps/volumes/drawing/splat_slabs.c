#include "apps/volumes/drawing/splat_slabs.h"

#include "apps/base/stable_math.h"
#include "apps/volumes/drawing/splat_filter.h"
#include "shaders_c/volume/splat_slab.h"

#include <math.h>
#include <string.h>

/* Slab i lies at depths [(first + i) thickness, (first + i + 1) thickness). */
typedef struct Slabs {
    Sheets *sheets;
    double deviation, reach, thickness; /* of kernels along the view; of slabs */
    int64_t first;
    uint32_t count;
    uint32_t *begin; /* of the voxels of each slab, and behind the last */
    Voxel *voxels;   /* the frame's */
    SplatCover *cover;
} Slabs;

static void place_of(const Voxel *voxel, double place[3])
{
    place[0] = voxel->place[0] + 256 * (voxel->place[3] >> 5);
    place[1] = voxel->place[1] + 256 * (voxel->place[3] >> 2 & 7);
    place[2] = voxel->place[2] + 256 * (voxel->place[3] & 3);
}

/* Number of the slab of a depth, counted from the eye. */
static int64_t slab_at(const Slabs *slabs, double depth)
{
    return (int64_t)floor(depth / slabs->thickness);
}

/* The slabs that a voxel reaches into; none where it is too near. */
static bool voxel_slabs(const Slabs *slabs, double depth, uint32_t *low, uint32_t *high)
{
    if (!(depth >= slabs->sheets->eye.near))
        return false;
    *low = (uint32_t)(slab_at(slabs, depth - slabs->reach) - slabs->first);
    *high = (uint32_t)(slab_at(slabs, depth + slabs->reach) - slabs->first);
    return true;
}

/* Those between the nearest and the farthest corner of the volume. */
static void find_slabs(Slabs *slabs)
{
    const VoxelEye *eye = &slabs->sheets->eye;
    const Field *field = slabs->sheets->splats->field;
    double nearest = HUGE_VAL, farthest = -HUGE_VAL;
    for (int corner = 0; corner < 8; corner++) {
        double place[3], at[3];
        for (int k = 0; k < 3; k++)
            place[k] = corner >> k & 1 ? field->size[k] - 1 : 0;
        voxel_eye_place(eye, place, at);
        nearest = fmin(nearest, at[2]);
        farthest = fmax(farthest, at[2]);
    }
    nearest = fmax(nearest, eye->near);
    farthest = fmax(farthest, eye->near);
    slabs->first = slab_at(slabs, nearest - slabs->reach) - 1;
    slabs->count = (uint32_t)(slab_at(slabs, farthest + slabs->reach) + 2 - slabs->first);
}

/* Calls `visit` with all voxels that are shown, and where they are before the eye. */
static void visit_voxels(Slabs *slabs,
                         void (*visit)(Slabs *slabs, const Voxel *voxel, const double at[3]))
{
    const Sheets *sheets = slabs->sheets;
    const VoxelRun *runs = sheets->splats->runs[sheets->eye.along];
    const uint32_t count = sheets->splats->run_of[sheets->eye.along][sheets->order->slices];
    for (uint32_t r = 0; r < count; r++)
        for (uint32_t i = 0; i < runs[r].count; i++) {
            const Voxel *voxel = &sheets->order->voxels[runs[r].first + i];
            double place[3], at[3];
            place_of(voxel, place);
            voxel_eye_place(&sheets->eye, place, at);
            visit(slabs, voxel, at);
        }
}

static void count_voxel(Slabs *slabs, const Voxel *voxel, const double at[3])
{
    uint32_t low, high;
    (void)voxel;
    if (voxel_slabs(slabs, at[2], &low, &high))
        for (uint32_t slab = low; slab <= high; slab++)
            slabs->begin[slab + 1]++;
}

static void put_voxel(Slabs *slabs, const Voxel *voxel, const double at[3])
{
    uint32_t low, high;
    double pixel[2];
    if (!voxel_slabs(slabs, at[2], &low, &high))
        return;
    const double reach = voxel_eye_project(&slabs->sheets->eye, at, pixel);
    for (uint32_t slab = low; slab <= high; slab++) {
        slabs->voxels[slabs->begin[slab]++] = *voxel;
        splat_cover_pixel(pixel, reach, &slabs->cover[slab]);
    }
}

static GpResult sort_voxels(Slabs *slabs, GpError *error)
{
    Frame *frame = slabs->sheets->frame;
    slabs->begin = frame_alloc(frame, slabs->count + 1, sizeof *slabs->begin);
    slabs->cover = frame_alloc(frame, slabs->count, sizeof *slabs->cover);
    for (uint32_t slab = 0; slab < slabs->count && slabs->cover; slab++)
        slabs->cover[slab] = splat_cover_make(slabs->sheets->view, frame);
    if (frame_result(frame, error))
        return GP_ERROR_MEMORY;
    visit_voxels(slabs, count_voxel);
    uint64_t total = 0; /* a voxel may be in hundreds of slabs */
    for (uint32_t slab = 1; slab <= slabs->count; slab++) {
        total += slabs->begin[slab];
        if (total > UINT32_MAX)
            return gp_fail(error, GP_ERROR_MEMORY, "out of memory: voxels in more than 2^32 slabs");
        slabs->begin[slab] = (uint32_t)total;
    }
    slabs->voxels = frame_alloc(frame, slabs->begin[slabs->count], sizeof *slabs->voxels);
    if (frame_result(frame, error))
        return GP_ERROR_MEMORY;
    visit_voxels(slabs, put_voxel);
    memmove(slabs->begin + 1, slabs->begin, slabs->count * sizeof *slabs->begin);
    slabs->begin[0] = 0; /* ends became beginnings */
    return GP_OK;
}

/* As the shader has it. */
static double logistic(double x)
{
    return 1 / (1 + stable_exp(-x * (1.5976 + 0.07056 * x * x)));
}

static void draw_slab(Slabs *slabs, uint32_t slab)
{
    static const GpProgram *const programs[] = {
        [VOXEL_EWA] = &voxel_slab_ewa_program,
        [VOXEL_RECONSTRUCTION] = &voxel_slab_reconstruction_program,
        [VOXEL_LOW_PASS] = &voxel_slab_low_pass_program,
    };
    Sheets *sheets = slabs->sheets;
    const double cut = sheets->setting->cut, low = logistic(-cut);
    const double begin = (double)(slabs->first + slab) * slabs->thickness,
                 end = (double)(slabs->first + slab + 1) * slabs->thickness;
    VoxelSlabUniforms uniforms = { .voxel = *sheets->uniforms,
                                   .begin = (float)(begin / slabs->deviation),
                                   .end = (float)(end / slabs->deviation),
                                   .per_deviation = (float)(1 / slabs->deviation),
                                   .low = (float)low,
                                   .per_whole = (float)(1 / (1 - 2 * low)) };
    const Voxel *first = slabs->voxels + slabs->begin[slab];
    const GpGeometry geometry = {
        .primitive = GP_POINTS,
        .vertex_count = slabs->begin[slab + 1] - slabs->begin[slab],
        .streams = { [GP_TEXCOORD0] = { &first->value, sizeof *first, 4, GP_UINT8 },
                     [GP_TEXCOORD1] = { first->place, sizeof *first, 4, GP_UINT8 } },
    };
    const VoxelFilter filter = splat_filter_of_depths(&sheets->eye, sheets->setting,
                                                      begin - slabs->reach, end + slabs->reach);
    GpDraw *draw = frame_draw_copied(sheets->frame, programs[filter], &uniforms, &geometry);
    draw->textures[0].surface = sheets->look;
    sheets_set_state(sheets, draw);
}

GpResult splat_slabs_add(Sheets *sheets, GpError *error)
{
    Slabs slabs = { .sheets = sheets, .thickness = splat_thickness(sheets->setting) };
    if (!sheets->uniforms)
        return frame_result(sheets->frame, error);
    slabs.deviation = sqrt((double)sheets->uniforms->spread[5]);
    slabs.reach = slabs.deviation * sheets->setting->cut;
    find_slabs(&slabs);
    const GpResult result = sort_voxels(&slabs, error);
    for (uint32_t slab = 0; slab < slabs.count && !result; slab++) {
        if (slabs.begin[slab] == slabs.begin[slab + 1])
            continue;
        sheets_begin(sheets);
        draw_slab(&slabs, slab);
        sheets_cover(sheets, &slabs.cover[slab]);
        sheets_end(sheets);
    }
    return result;
}
