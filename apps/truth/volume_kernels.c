#include "apps/truth/volume_kernels.h"

#include <math.h>
#include <string.h>

/* Beyond so many deviations the pixel's filter is left out: 1e-5 of it. */
static const double reach = 4.5;
/* A ray ends where less than this of what is behind it would be seen. */
static const double dark = 1e-7;

enum { TILE = 8 };

typedef double Density[4]; /* light sent out: red, green, blue; extinction */

typedef struct Run {
    VolumeEye eye;
    const VolumeScene *scene;
    const VolumeKernels *kernels;
    Density of_value[VOLUME_VALUES]; /* at the middle of a kernel */
    double step;
    int reach;            /* slices on each side of a place that kernels come from */
    size_t bins;          /* of a ray, at most */
    Density *bin;         /* [threads][bins] */
    VolumePicture *fine;  /* a pixel for each ray */
    uint32_t border;      /* of pixels around the picture */
    VolumePicture *whole; /* the result */
    double *weight;       /* of the filter: [2 * taps + rays - 1] */
    uint32_t taps;        /* fine pixels on each side of a pixel */
    uint32_t tiles[3];
    uint8_t *is_seen; /* [z][y][x]: a sample of a tile, or of one beside it, can be seen */
} Run;

double volume_kernel_height(double deviation, double cut)
{
    /* 4 pi times the integral of r^2 exp(-r^2 / (2 s^2)) from 0 to cut */
    const double s2 = deviation * deviation, edge = exp(-0.5 * cut * cut / s2);
    const double inside =
        sqrt(M_PI / 2) * deviation * erf(cut / (deviation * M_SQRT2)) - cut * edge;
    return 1 / (4 * M_PI * s2 * inside);
}

/* --- where there is something ----------------------------------------------------------------- */

static size_t tile_at(const Run *run, const int tile[3])
{
    return ((size_t)tile[2] * run->tiles[1] + (size_t)tile[1]) * run->tiles[0] + (size_t)tile[0];
}

/* Marks the tiles that a kernel of a visible sample may reach. */
static void mark(Run *run, const int sample[3])
{
    int low[3], high[3], at[3];
    for (int k = 0; k < 3; k++) {
        low[k] = (sample[k] < run->reach ? 0 : sample[k] - run->reach) / TILE;
        high[k] = (sample[k] + run->reach) / TILE;
        high[k] = high[k] < (int)run->tiles[k] ? high[k] : (int)run->tiles[k] - 1;
    }
    for (at[2] = low[2]; at[2] <= high[2]; at[2]++)
        for (at[1] = low[1]; at[1] <= high[1]; at[1]++)
            for (at[0] = low[0]; at[0] <= high[0]; at[0]++)
                run->is_seen[tile_at(run, at)] = 1;
}

static void find_seen(Run *run)
{
    const VolumeScene *scene = run->scene;
    const uint8_t *value = scene->value;
    int at[3];
    for (at[2] = 0; at[2] < (int)scene->size[2]; at[2]++)
        for (at[1] = 0; at[1] < (int)scene->size[1]; at[1]++)
            for (at[0] = 0; at[0] < (int)scene->size[0]; at[0]++, value++)
                if (run->of_value[*value][3] > 0)
                    mark(run, at);
}

/* --- a ray ------------------------------------------------------------------------------------ */

/* A ray while it is walked, slice by slice across its main axis. */
typedef struct Walk {
    const Run *run;
    VolumeRay ray;
    double narrow;      /* of kernels: half the inverse of the variance */
    double change;      /* of the ratio of a profile's neighbours from bin to bin */
    double square;      /* of the length of ray.way */
    int main, other[2]; /* axes */
    double half[2];     /* how far kernels lie beside the ray in a slice, along the others */
    Density *bin;
    size_t bins, done; /* done: bins that are part of the light already */
    double rgb[3], through;
} Walk;

/* Adds a kernel's profile along the ray: a Gaussian again, whose values at even steps are
 * products. */
static void add_kernel(Walk *walk, const int sample[3], const double *density)
{
    const VolumeKernels *kernels = walk->run->kernels;
    double away[3];
    for (int k = 0; k < 3; k++)
        away[k] = sample[k] - walk->ray.begin[k];
    const double middle = vector_dot(away, walk->ray.way) / walk->square;
    const double beside = vector_dot(away, away) - middle * middle * walk->square;
    const double left = kernels->cut * kernels->cut - beside;
    if (!(left > 0))
        return;
    const double half = sqrt(left / walk->square), step = walk->run->step;
    const double first = ceil((middle - half - walk->ray.low) / step - 0.5),
                 last = floor((middle + half - walk->ray.low) / step - 0.5);
    const double from = fmax(first, 0), to = fmin(last, (double)walk->bins - 1);
    const double at = walk->ray.low + (from + 0.5) * step - middle;
    const double narrow = walk->narrow, along = narrow * walk->square, change = walk->change;
    double height = exp(-narrow * fmax(beside, 0) - along * at * at);
    double factor = exp(-along * step * (2 * at + step));
    for (double i = from; i <= to; i++) {
        double *bin = walk->bin[(size_t)i];
        for (int c = 0; c < 4; c++)
            bin[c] += height * density[c];
        height *= factor;
        factor *= change;
    }
}

/* Composites the bins before one: no more is added to them. */
static void finish(Walk *walk, double before)
{
    const size_t end = before < 0 ? 0 : before < (double)walk->bins ? (size_t)before : walk->bins;
    const double step = walk->run->step;
    for (; walk->done < end && walk->through > dark; walk->done++) {
        const double *bin = walk->bin[walk->done];
        const double taken = bin[3] * step;
        if (!(taken > 0))
            continue;
        const double left = exp(-taken), share = taken > 1e-9 ? (1 - left) / taken : 1;
        for (int c = 0; c < 3; c++)
            walk->rgb[c] += walk->through * share * bin[c] * step;
        walk->through *= left;
    }
}

/* Samples of a slice beside the ray. */
static void add_slice(Walk *walk, int slice)
{
    const Run *run = walk->run;
    const VolumeRay *ray = &walk->ray;
    const int main = walk->main, u = walk->other[0], v = walk->other[1];
    const uint32_t *size = run->scene->size;
    const double t = (slice - ray->begin[main]) / ray->way[main];
    int low[2], high[2], at[3];
    for (int i = 0; i < 2; i++) {
        const double place = ray->begin[walk->other[i]] + t * ray->way[walk->other[i]];
        const double last = size[walk->other[i]] - 1.0;
        low[i] = (int)fmin(fmax(ceil(place - walk->half[i]), 0), last + 1);
        high[i] = (int)fmax(fmin(floor(place + walk->half[i]), last), -1);
        at[walk->other[i]] = (int)fmin(fmax(place, 0), last) / TILE;
    }
    at[main] = slice / TILE;
    if (!run->is_seen[tile_at(run, at)])
        return;
    at[main] = slice;
    for (at[v] = low[1]; at[v] <= high[1]; at[v]++)
        for (at[u] = low[0]; at[u] <= high[0]; at[u]++) {
            const size_t i = ((size_t)at[2] * size[1] + (size_t)at[1]) * size[0] + (size_t)at[0];
            const double *density = run->of_value[run->scene->value[i]];
            if (density[3] > 0)
                add_kernel(walk, at, density);
        }
}

/* The slices of the ray, from near to far. */
static void walk_slices(Walk *walk)
{
    const Run *run = walk->run;
    const VolumeRay *ray = &walk->ray;
    const int main = walk->main, last = (int)run->scene->size[main] - 1;
    const double a = ray->begin[main] + ray->low * ray->way[main],
                 b = ray->begin[main] + ray->high * ray->way[main], cut = run->kernels->cut;
    const int low = (int)fmax(ceil(fmin(a, b) - cut), 0),
              high = (int)fmin(floor(fmax(a, b) + cut), last);
    const bool rises = ray->way[main] > 0;
    const double bins_a_slice = 1 / (fabs(ray->way[main]) * run->step);
    for (int i = 0; i <= high - low && walk->through > dark; i++) {
        const int slice = rises ? low + i : high - i;
        /* kernels of this slice and all behind it begin there */
        finish(walk, ((rises ? slice - a : a - slice) - cut) * bins_a_slice);
        add_slice(walk, slice);
    }
    finish(walk, (double)walk->bins);
}

static void draw_ray(const Run *run, double x, double y, Density *bin, double rgba[4])
{
    const VolumeKernels *kernels = run->kernels;
    Walk walk = {
        .run = run, .ray = volume_ray(&run->eye, x, y, kernels->cut), .bin = bin, .through = 1
    };
    const VolumeRay *ray = &walk.ray;
    if (ray->high > ray->low) {
        for (int k = 1; k < 3; k++)
            walk.main = fabs(ray->way[k]) > fabs(ray->way[walk.main]) ? k : walk.main;
        walk.square = vector_dot(ray->way, ray->way);
        walk.narrow = 0.5 / (kernels->deviation * kernels->deviation);
        walk.change = exp(-2 * walk.narrow * walk.square * run->step * run->step);
        for (int i = 0; i < 2; i++) {
            walk.other[i] = (walk.main + 1 + i) % 3;
            /* a sphere's shadow along the ray on the slice */
            const double slope = ray->way[walk.other[i]] / ray->way[walk.main];
            walk.half[i] = kernels->cut * sqrt(1 + slope * slope);
        }
        walk.bins = (size_t)ceil((ray->high - ray->low) / run->step);
        memset(bin, 0, walk.bins * sizeof *bin);
        walk_slices(&walk);
    }
    memcpy(rgba, walk.rgb, sizeof walk.rgb);
    rgba[3] = 1 - walk.through;
}

/* --- the picture ------------------------------------------------------------------------------ */

static void draw_row(void *context, uint32_t y, int worker)
{
    const Run *run = context;
    const double rays = run->kernels->rays, border = run->border;
    for (uint32_t x = 0; x < run->fine->width; x++)
        draw_ray(run, (x + 0.5) / rays - border, (y + 0.5) / rays - border,
                 run->bin + (size_t)worker * run->bins,
                 run->fine->rgba + 4 * ((size_t)y * run->fine->width + x));
}

/* Weights of the fine pixels in a row around a pixel, sum 1. */
static void find_weights(Run *run)
{
    const double rays = run->kernels->rays, low_pass = run->kernels->low_pass;
    const uint32_t count = 2 * run->taps + run->kernels->rays;
    double sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        const double away = (i + 0.5 - count / 2.0) / rays;
        run->weight[i] =
            low_pass > 0 ? exp(-0.5 * away * away / (low_pass * low_pass)) : count == 1;
        sum += run->weight[i];
    }
    for (uint32_t i = 0; i < count; i++)
        run->weight[i] /= sum;
}

static void filter_row(void *context, uint32_t y, int worker)
{
    const Run *run = context;
    const uint32_t rays = run->kernels->rays, count = 2 * run->taps + rays;
    const size_t width = run->fine->width, first = (size_t)run->border * rays - run->taps;
    (void)worker;
    for (uint32_t x = 0; x < run->whole->width; x++) {
        double sum[4] = { 0, 0, 0, 0 };
        for (uint32_t j = 0; j < count; j++)
            for (uint32_t i = 0; i < count; i++) {
                const double weight = run->weight[i] * run->weight[j];
                const double *from =
                    run->fine->rgba + 4 * ((y * rays + first + j) * width + x * rays + first + i);
                for (int c = 0; c < 4; c++)
                    sum[c] += weight * from[c];
            }
        memcpy(run->whole->rgba + 4 * ((size_t)y * run->whole->width + x), sum, sizeof sum);
    }
}

/* Sizes, and what each value adds. */
static void set_up(const VolumeScene *scene, const VolumeKernels *kernels, Run *run)
{
    const double height = volume_kernel_height(kernels->deviation, kernels->cut);
    double diagonal = 0;
    for (int i = 0; i < VOLUME_VALUES; i++) {
        double rgba[4];
        volume_classify(scene, i, rgba);
        run->of_value[i][3] = height * volume_extinction(rgba[3]);
        for (int c = 0; c < 3; c++)
            run->of_value[i][c] = rgba[c] * run->of_value[i][3];
    }
    for (int k = 0; k < 3; k++) {
        const double side = (scene->size[k] + 2 * kernels->cut) * scene->scale[k];
        diagonal += side * side;
        run->tiles[k] = (scene->size[k] + TILE - 1) / TILE;
    }
    run->bins = (size_t)(sqrt(diagonal) / run->step) + 2;
    run->reach = (int)ceil(M_SQRT2 * kernels->cut) + 1; /* slopes along a main axis are at most 1 */
}

GpResult volume_kernels_picture(const VolumeScene *scene, const VolumeKernels *kernels,
                                GpPool *pool, VolumePicture *picture)
{
    const bool is_filtered = kernels->low_pass > 0;
    const VolumeKernels used = { .deviation = kernels->deviation,
                                 .cut = kernels->cut,
                                 .low_pass = kernels->low_pass,
                                 .rays = is_filtered ? kernels->rays : 1 };
    VolumePicture fine = { .width = 0 }, whole = { .width = 0 };
    Run run = { .eye = volume_eye(scene),
                .scene = scene,
                .kernels = &used,
                .step = 0.4 / (kernels->fineness ? kernels->fineness : 1),
                .fine = &fine,
                .whole = &whole };
    set_up(scene, &used, &run);
    run.border = (uint32_t)ceil(reach * used.low_pass);
    run.taps = (uint32_t)ceil(reach * used.low_pass * used.rays);
    run.bin = gp_alloc((size_t)gp_pool_threads(pool) * run.bins, sizeof *run.bin);
    run.weight = gp_alloc(2 * run.taps + used.rays, sizeof *run.weight);
    run.is_seen = gp_alloc((size_t)run.tiles[0] * run.tiles[1] * run.tiles[2], 1);
    GpResult result = run.bin && run.weight && run.is_seen ? GP_OK : GP_ERROR_MEMORY;
    if (!result)
        result = volume_picture_create((scene->width + 2 * run.border) * used.rays,
                                       (scene->height + 2 * run.border) * used.rays, &fine);
    if (!result)
        result = volume_picture_create(scene->width, scene->height, &whole);
    if (!result) {
        find_weights(&run);
        find_seen(&run);
        gp_pool_run(pool, fine.height, draw_row, &run);
        gp_pool_run(pool, whole.height, filter_row, &run);
        *picture = whole;
    }
    volume_picture_free(&fine);
    gp_free(run.bin);
    gp_free(run.weight);
    gp_free(run.is_seen);
    return result;
}
