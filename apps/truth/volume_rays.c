#include "apps/truth/volume_rays.h"

#include <math.h>
#include <string.h>

enum { BRICK = 8 }; /* cells a side */

/* A ray ends where less than this of what is behind it would be seen. */
static const double dark = 1e-7;

typedef struct Run {
    VolumeEye eye;
    const VolumeScene *scene;
    VolumePicture *picture;
    double steps; /* in a length of 1, at least */
    /* From each value up to which one nothing can be seen; below the value itself: it can be. */
    int unseen_to[VOLUME_VALUES];
    uint32_t cells[3], bricks[3];
    uint8_t *is_empty; /* of bricks [z][y][x] */
} Run;

/* --- what can be seen ------------------------------------------------------------------------- */

/* The greatest opacity between two values: a stop's, or that of an end. */
static double most_opacity(const VolumeScene *scene, double low, double high)
{
    double a[4], b[4];
    volume_classify(scene, low, a);
    volume_classify(scene, high, b);
    double most = fmax(a[3], b[3]);
    for (uint32_t i = 0; i < scene->stop_count; i++)
        if (scene->stops[i].value > low && scene->stops[i].value < high)
            most = fmax(most, scene->stops[i].rgba[3]);
    return most;
}

static void find_unseen(Run *run)
{
    for (int i = VOLUME_VALUES - 1; i >= 0; i--) {
        const int next = i + 1 < VOLUME_VALUES ? i + 1 : i;
        const bool is_last = next == i || most_opacity(run->scene, i, next) > 0;
        if (most_opacity(run->scene, i, i) > 0)
            run->unseen_to[i] = i - 1;
        else
            run->unseen_to[i] = is_last ? i : run->unseen_to[next];
    }
}

static const uint8_t *sample_at(const VolumeScene *scene, const int cell[3])
{
    return scene->value + ((size_t)cell[2] * scene->size[1] + (size_t)cell[1]) * scene->size[0] +
           cell[0];
}

/* The steps from a cell's first corner to the next along each axis; none where there is one
 * sample. */
static void corner_steps(const VolumeScene *scene, size_t step[3])
{
    step[0] = scene->size[0] > 1;
    step[1] = scene->size[1] > 1 ? scene->size[0] : 0;
    step[2] = scene->size[2] > 1 ? (size_t)scene->size[0] * scene->size[1] : 0;
}

typedef struct Corners {
    double value[8]; /* bit k: at the far end of axis k */
    uint8_t least, most;
} Corners;

static Corners corners_of(const VolumeScene *scene, const int cell[3])
{
    size_t step[3];
    const uint8_t *first = sample_at(scene, cell);
    Corners corners = { .least = 255 };
    corner_steps(scene, step);
    for (int i = 0; i < 8; i++) {
        const uint8_t value =
            first[(i & 1 ? step[0] : 0) + (i & 2 ? step[1] : 0) + (i & 4 ? step[2] : 0)];
        corners.value[i] = value;
        corners.least = value < corners.least ? value : corners.least;
        corners.most = value > corners.most ? value : corners.most;
    }
    return corners;
}

static void find_brick(void *context, uint32_t brick, int worker)
{
    Run *run = context;
    const VolumeScene *scene = run->scene;
    uint32_t low[3], high[3], rest = brick;
    uint8_t least = 255, most = 0;
    (void)worker;
    for (int k = 0; k < 3; k++) {
        low[k] = rest % run->bricks[k] * BRICK;
        high[k] = low[k] + BRICK < scene->size[k] - 1 ? low[k] + BRICK : scene->size[k] - 1;
        rest /= run->bricks[k];
    }
    for (uint32_t z = low[2]; z <= high[2]; z++)
        for (uint32_t y = low[1]; y <= high[1]; y++)
            for (uint32_t x = low[0]; x <= high[0]; x++) {
                const uint8_t value = *sample_at(scene, (int[3]){ (int)x, (int)y, (int)z });
                least = value < least ? value : least;
                most = value > most ? value : most;
            }
    run->is_empty[brick] = most <= run->unseen_to[least];
}

/* --- light along a ray ------------------------------------------------------------------------ */

typedef struct Light {
    double rgb[3], through; /* through: what comes from behind, as a share */
} Light;

/* At a place of a cell, 0..1 along each axis. */
static double interpolate(const Corners *corners, const double at[3])
{
    const double *v = corners->value;
    double row[4];
    for (int i = 0; i < 4; i++)
        row[i] = v[2 * i] + at[0] * (v[2 * i + 1] - v[2 * i]);
    const double near = row[0] + at[1] * (row[1] - row[0]),
                 far = row[2] + at[1] * (row[3] - row[2]);
    return near + at[2] * (far - near);
}

/* A ray in a cell. */
typedef struct Inside {
    const Run *run;
    const VolumeRay *ray;
    const int *cell;
    Corners corners;
} Inside;

static double value_at(const Inside *inside, double t)
{
    double at[3];
    for (int k = 0; k < 3; k++)
        at[k] = fmin(fmax(inside->ray->begin[k] + t * inside->ray->way[k] - inside->cell[k], 0), 1);
    return interpolate(&inside->corners, at);
}

/* Light of a part of the ray in which no stop lies, from its two points of Gauss: what is sent out
 * and taken is spread over it evenly. */
static void add_part(const Inside *inside, double from, double to, Light *light)
{
    static const double gauss[2] = { 0.21132486540518713, 0.78867513459481287 };
    double sent[3] = { 0, 0, 0 }, taken = 0;
    for (int g = 0; g < 2; g++) {
        double rgba[4];
        volume_classify(inside->run->scene, value_at(inside, from + gauss[g] * (to - from)), rgba);
        if (!(rgba[3] > 0))
            continue;
        const double extinction = volume_extinction(rgba[3]) * (to - from) / 2;
        taken += extinction;
        for (int c = 0; c < 3; c++)
            sent[c] += extinction * rgba[c];
    }
    if (!(taken > 0))
        return;
    const double left = exp(-taken), share = taken > 1e-9 ? (1 - left) / taken : 1;
    for (int c = 0; c < 3; c++)
        light->rgb[c] += light->through * share * sent[c];
    light->through *= left;
}

/* The stop that is met first on the way from one value to another; NULL: none. */
static const VolumeStop *next_stop(const VolumeScene *scene, double from, double to)
{
    const VolumeStop *first = scene->stops, *end = first + scene->stop_count;
    const VolumeStop *found = NULL;
    for (const VolumeStop *stop = first; stop < end; stop++) {
        if (from < to && stop->value > from && stop->value < to)
            return stop;
        if (from > to && stop->value < from && stop->value > to)
            found = stop;
    }
    return found;
}

/* A short step, in parts between stops: its values are nearly straight. */
static void add_step(const Inside *inside, double from, double to, double low, double high,
                     Light *light)
{
    const double length = to - from;
    double at = from, value = low;
    const VolumeStop *stop;
    while ((stop = next_stop(inside->run->scene, value, high))) {
        const double next = from + length * (stop->value - low) / (high - low);
        add_part(inside, at, next, light);
        at = next;
        value = stop->value;
    }
    add_part(inside, at, to, light);
}

static void add_cell(const Inside *inside, double from, double to, Light *light)
{
    const double steps = ceil((to - from) * inside->run->steps), length = (to - from) / steps;
    double value = value_at(inside, from);
    for (double i = 0; i < steps && light->through > dark; i++) {
        const double next = value_at(inside, from + (i + 1) * length);
        add_step(inside, from + i * length, from + (i + 1) * length, value, next, light);
        value = next;
    }
}

/* Where a ray leaves a box of cells; axis: through which side. */
static double leave(const VolumeRay *ray, const int low[3], const int high[3], int *axis)
{
    double first = (double)INFINITY;
    *axis = 0;
    for (int k = 0; k < 3; k++) {
        if (ray->way[k] == 0)
            continue;
        const double t = ((ray->way[k] > 0 ? high[k] : low[k]) - ray->begin[k]) / ray->way[k];
        if (t < first) {
            first = t;
            *axis = k;
        }
    }
    return first;
}

/* The cell of a place of the ray. */
static void find_cell(const Run *run, const VolumeRay *ray, double t, int cell[3])
{
    for (int k = 0; k < 3; k++) {
        const double at = floor(ray->begin[k] + t * ray->way[k]);
        cell[k] = (int)fmin(fmax(at, 0), run->cells[k] - 1.0);
    }
}

/* The same of a place behind the one that `cell` was found for: what is rounded never turns back,
 * or two axes whose walls are met at once would take each other back for ever. */
static void find_next_cell(const Run *run, const VolumeRay *ray, double t, int cell[3])
{
    int found[3];
    find_cell(run, ray, t, found);
    for (int k = 0; k < 3; k++)
        if (ray->way[k] > 0 ? found[k] > cell[k] : found[k] < cell[k])
            cell[k] = found[k];
}

static bool brick_is_empty(const Run *run, const int cell[3], int low[3], int high[3])
{
    size_t brick = 0;
    for (int k = 2; k >= 0; k--) {
        low[k] = cell[k] / BRICK * BRICK;
        high[k] = low[k] + BRICK;
        brick = brick * run->bricks[k] + (size_t)(cell[k] / BRICK);
    }
    return run->is_empty[brick];
}

static Light light_of(const Run *run, const VolumeRay *ray)
{
    Light light = { .through = 1 };
    int cell[3], low[3], high[3], axis;
    double t = ray->low;
    find_cell(run, ray, t, cell);
    while (t < ray->high && light.through > dark) {
        const bool is_empty = brick_is_empty(run, cell, low, high);
        if (!is_empty) {
            for (int k = 0; k < 3; k++)
                high[k] = (low[k] = cell[k]) + 1;
        }
        const double next = fmin(leave(ray, low, high, &axis), ray->high);
        if (!is_empty && next > t) {
            const Inside inside = { run, ray, cell, corners_of(run->scene, cell) };
            if (inside.corners.most > run->unseen_to[inside.corners.least])
                add_cell(&inside, t, next, &light);
        }
        t = fmax(t, next);
        if (is_empty)
            find_next_cell(run, ray, t, cell);
        cell[axis] = ray->way[axis] > 0 ? high[axis] : low[axis] - 1;
        if (cell[axis] < 0 || cell[axis] >= (int)run->cells[axis])
            break;
    }
    return light;
}

static void draw_row(void *context, uint32_t y, int worker)
{
    const Run *run = context;
    const VolumePicture *picture = run->picture;
    (void)worker;
    for (uint32_t x = 0; x < picture->width; x++) {
        const VolumeRay ray = volume_ray(&run->eye, x + 0.5, y + 0.5, 0);
        const Light light = light_of(run, &ray);
        double *rgba = picture->rgba + 4 * ((size_t)y * picture->width + x);
        memcpy(rgba, light.rgb, sizeof light.rgb);
        rgba[3] = 1 - light.through;
    }
}

GpResult volume_rays_picture(const VolumeScene *scene, uint32_t fineness, GpPool *pool,
                             VolumePicture *picture)
{
    VolumePicture made;
    const double most = volume_extinction(most_opacity(scene, 0, VOLUME_VALUES - 1));
    Run run = { .eye = volume_eye(scene),
                .scene = scene,
                .picture = &made,
                .steps = 4.0 * fineness * fmin(fmax(most, 1), 8) };
    uint32_t bricks = 1;
    for (int k = 0; k < 3; k++) {
        run.cells[k] = scene->size[k] > 1 ? scene->size[k] - 1 : 1;
        run.bricks[k] = (run.cells[k] + BRICK - 1) / BRICK;
        bricks *= run.bricks[k];
    }
    find_unseen(&run);
    run.is_empty = gp_alloc(bricks, 1);
    if (!run.is_empty || volume_picture_create(scene->width, scene->height, &made)) {
        gp_free(run.is_empty);
        return GP_ERROR_MEMORY;
    }
    gp_pool_run(pool, bricks, find_brick, &run);
    gp_pool_run(pool, scene->height, draw_row, &run);
    gp_free(run.is_empty);
    *picture = made;
    return GP_OK;
}
