#include "apps/depth_images/rivals/prewarp.h"

enum { MOST_TIMES = 2 }; /* as many texels as pixels along a side */

/* A place of the box, and where it has to be on the plane. */
typedef struct Moved {
    double from[3], to[2];
    bool is_there;
} Moved;

/* --- where pixels go -------------------------------------------------------------------------- */

/* On the line through the eye, if that is before it. */
static bool project(const PrewarpInput *input, const double from[3], double w, double to[2])
{
    const double *eye = input->eye;
    const double away =
        eye[2] - input->plane * eye[3]; /* of the eye from the plane, below 0 before it */
    const double behind = w * (from[2] - input->plane);
    const double point[4] = { from[0] * w, from[1] * w, from[2] * w, w };
    const bool is_parallel = input->is_parallel;
    const double share = is_parallel ? -behind / away : away / (away - behind);
    double at[4];
    for (int k = 0; k < 4; k++)
        at[k] = is_parallel ? point[k] + share * eye[k] : eye[k] + share * (point[k] - eye[k]);
    to[0] = at[0] / at[3];
    to[1] = at[1] / at[3];
    return (is_parallel || share > 0) && isfinite(to[0]) && isfinite(to[1]);
}

static Moved move_pixel(const PrewarpInput *input, uint32_t x, uint32_t y)
{
    const DepthSlab *slab = input->slab;
    const DepthPixels *pixels = input->pixels;
    const float depth = pixels->depth[(size_t)y * pixels->width + x];
    const float z = slab_z(slab, depth);
    Moved moved = { .from = { ((x + 0.5) / pixels->width - slab->first[0]) / slab->side[0],
                              ((y + 0.5) / pixels->height - slab->first[1]) / slab->side[1],
                              (double)z } };
    moved.is_there =
        z <= 1 && project(input, moved.from, slab->is_parallel ? 1 : (double)depth, moved.to);
    return moved;
}

/* Depth images that are all pixels, moved. */
static Moved *move_pixels(const PrewarpInput *input)
{
    const DepthPixels *pixels = input->pixels;
    Moved *moved = gp_alloc((size_t)pixels->width * pixels->height, sizeof *moved);
    for (uint32_t y = 0; y < pixels->height && moved; y++)
        for (uint32_t x = 0; x < pixels->width; x++)
            moved[(size_t)y * pixels->width + x] = move_pixel(input, x, y);
    return moved;
}

/* The rectangle that they are on, no farther than the box's own side beyond it. */
static void find_rectangle(const PrewarpInput *input, const Moved *moved, Prewarped *made)
{
    const DepthPixels *pixels = input->pixels;
    const uint32_t size[2] = { pixels->width, pixels->height };
    for (int k = 0; k < 2; k++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t i = 0; i < (size_t)size[0] * size[1]; i++) {
            low = moved[i].is_there ? fmin(low, moved[i].to[k]) : low;
            high = moved[i].is_there ? fmax(high, moved[i].to[k]) : high;
        }
        const double texel = 1 / (input->slab->side[k] * size[k]);
        low = fmax(low, -1) - texel;
        high = fmin(high, 2) + texel;
        if (!(low < high))
            return;
        const double texels = fmin(ceil((high - low) / texel), MOST_TIMES * (double)size[k] + 2);
        made->first[k] = low;
        made->side[k] = high - low;
        *(k == 0 ? &made->width : &made->height) = (uint32_t)fmin(texels, GP_MAX_SIZE);
    }
}

/* --- lines ------------------------------------------------------------------------------------ */

/* Texels in a row or a column, and how places of the plane become theirs. */
typedef struct Line {
    const PrewarpInput *input;
    Moved *texel;
    uint32_t count;
    size_t stride;
    int axis;
    double first, per_side;
} Line;

static double place_on(const Line *line, const Moved *moved)
{
    return (moved->to[line->axis] - line->first) * line->per_side - 0.5;
}

/* Whether the eye, which sees the plane from before or from behind, sees one z before another. */
static bool is_nearer(const PrewarpInput *input, double z, double other)
{
    return input->eye[2] < input->plane * input->eye[3] ? z < other : z > other;
}

static void put(const Line *line, double at, const Moved *moved)
{
    if (!(at >= 0 && at < line->count))
        return;
    Moved *texel = &line->texel[(size_t)at * line->stride];
    if (!texel->is_there || is_nearer(line->input, moved->from[2], texel->from[2]))
        *texel = *moved;
}

static double depth_of(const DepthSlab *slab, double z)
{
    return slab->is_parallel ? slab->low + z * (slab->high - slab->low)
                             : 1 / (1 / slab->low + z * (1 / slab->high - 1 / slab->low));
}

static bool joins(const PrewarpInput *input, const Moved *a, const Moved *b)
{
    if (!a->is_there || !b->is_there)
        return false;
    const double depth[2] = { depth_of(input->slab, a->from[2]),
                              depth_of(input->slab, b->from[2]) };
    return input->cut < 0 ||
           fabs(depth[1] - depth[0]) <= input->cut * fmin(fabs(depth[0]), fabs(depth[1]));
}

/* Texels whose centres are from one place on to before the other. */
static void fill_between(const Line *line, const Moved *a, const Moved *b)
{
    const double from = place_on(line, a), to = place_on(line, b);
    const double low = fmax(ceil(fmin(from, to)), 0), high = fmin(fmax(from, to), line->count);
    for (double at = low; at < high; at++) {
        const double share = (at - from) / (to - from);
        Moved between = { .is_there = true };
        for (int k = 0; k < 3; k++)
            between.from[k] = a->from[k] + share * (b->from[k] - a->from[k]);
        for (int k = 0; k < 2; k++)
            between.to[k] = a->to[k] + share * (b->to[k] - a->to[k]);
        put(line, at, &between);
    }
}

/* Moves `count` neighbours along a line; one that has none that it joins is put where it is
 * nearest. */
static void warp_line(const Line *line, const Moved *moved, uint32_t count, size_t stride)
{
    bool joined = false;
    for (uint32_t i = 0; i < count; i++) {
        const Moved *here = moved + i * stride;
        const bool joins_next = i + 1 < count && joins(line->input, here, here + stride);
        if (joins_next)
            fill_between(line, here, here + stride);
        else if (here->is_there && !joined)
            put(line, floor(place_on(line, here) + 0.5), here);
        joined = joins_next;
    }
}

/* --- both passes ------------------------------------------------------------------------------ */

static void warp(const PrewarpInput *input, const Moved *moved, Moved *rows, Moved *columns,
                 const Prewarped *made)
{
    const uint32_t width = input->pixels->width, height = input->pixels->height;
    for (uint32_t y = 0; y < height; y++) {
        const Line row = { input,          rows + (size_t)y * made->width, made->width, 1, 0,
                           made->first[0], made->width / made->side[0] };
        warp_line(&row, moved + (size_t)y * width, width, 1);
    }
    for (uint32_t x = 0; x < made->width; x++) {
        const Line column = { input,
                              columns + x,
                              made->height,
                              made->width,
                              1,
                              made->first[1],
                              made->height / made->side[1] };
        warp_line(&column, rows + x, height, made->width);
    }
}

GpResult prewarp_make(const PrewarpInput *input, Prewarped *made)
{
    Prewarped done = { .width = 0 };
    Moved *moved = move_pixels(input), *rows = NULL, *columns = NULL;
    if (moved)
        find_rectangle(input, moved, &done);
    const size_t count = (size_t)done.width * done.height;
    if (moved && count > 0) {
        rows = gp_alloc((size_t)done.width * input->pixels->height, sizeof *rows);
        columns = gp_alloc(count, sizeof *columns);
        done.texel = gp_alloc(count, sizeof *done.texel);
    }
    const bool has_memory = moved && (count == 0 || (rows && columns && done.texel));
    if (has_memory && count > 0) {
        warp(input, moved, rows, columns, &done);
        for (size_t i = 0; i < count; i++)
            for (int k = 0; k < 4; k++)
                done.texel[i][k] = k < 3 ? (float)columns[i].from[k] : (float)columns[i].is_there;
    }
    gp_free(moved);
    gp_free(rows);
    gp_free(columns);
    if (!has_memory) {
        gp_free(done.texel);
        return GP_ERROR_MEMORY;
    }
    if (count == 0)
        done.width = done.height = 0;
    *made = done;
    return GP_OK;
}
