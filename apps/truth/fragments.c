#include "apps/truth/fragments.h"

#include "apps/truth/seen_triangle.h"
#include "pipeline/base/grow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct Fragment {
    uint32_t x, triangle;
    double depth;
    double moved; /* by so much snapped corners may move the depth */
    double way;   /* along the line of sight, from the plane where light begins to be taken */
} Fragment;

/* What all rows share. */
typedef struct Work {
    const FragmentTruthScene *scene;
    FragmentTruth *truth;
    CameraAxes axes;
    SeenTriangle *seen;
    uint32_t *row_begin; /* [height + 1] in triangle */
    uint32_t *triangle;  /* those whose boxes reach into a row, row by row, rising */
    uint64_t *fragments; /* of each row */
    uint32_t *layers;
    bool *failed;
} Work;

/* --- a pixel ---------------------------------------------------------------------------------- */

/* Length of the line of sight through a place for each unit along the view. */
static double slant(const Work *work, const double centre[2])
{
    if (!(work->scene->camera.fovy > 0))
        return 1;
    const double x = (2 * centre[0] / work->scene->width - 1) * work->axes.half_width;
    const double y = (1 - 2 * centre[1] / work->scene->height) * work->axes.half_height;
    return sqrt(1 + x * x + y * y);
}

/* How far along the view a depth is. */
static double distance_of(const Camera *camera, double depth)
{
    const double length = camera->far - camera->near;
    return camera->fovy > 0 ? camera->far * camera->near / (camera->far - depth * length)
                            : camera->near + depth * length;
}

/* How far a triangle's plane is from the eye, or, of parallel rays, how far it goes along with a
 * step along them. out faces: whether its outer side is seen */
static double find_height(const Work *work, uint32_t triangle, bool *faces)
{
    const FragmentTruthScene *scene = work->scene;
    const uint32_t *index = scene->indices + 3 * (size_t)triangle;
    double corner[3][3], edge[2][3], normal[3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            corner[i][k] = (double)scene->positions[index[i]][k];
    vector_subtract(corner[1], corner[0], edge[0]);
    vector_subtract(corner[2], corner[0], edge[1]);
    vector_cross(edge[0], edge[1], normal);
    double toward[3];
    if (scene->camera.fovy > 0)
        vector_subtract(corner[0], scene->camera.eye, toward);
    else
        memcpy(toward, work->axes.forward, sizeof toward);
    const double height = vector_dot(normal, toward);
    *faces = height < 0;
    return fabs(height) / sqrt(vector_dot(normal, normal));
}

/* What a fragment adds, and what it lets through. */
static double find_source(const Work *work, const Fragment *fragment, double slanted, double add[3])
{
    const FragmentTruthScene *scene = work->scene;
    const float *color = scene->colors[fragment->triangle];
    double through = 1 - (double)color[3], own = 1;
    if (scene->is_glass) {
        bool faces;
        const double height = find_height(work, fragment->triangle, &faces);
        const double way = distance_of(&scene->camera, fragment->depth) * slanted;
        const double cosine = scene->camera.fovy > 0 ? height / way : height;
        const double fifth = pow(1 - fmin(cosine, 1), 5);
        through *= (1 - scene->reflected) * (1 - fifth);
        own = 1 - through;
        const double taken = exp(-scene->sigma * fragment->way);
        for (int k = 0; k < 3; k++)
            add[k] = (double)color[k] * own * (faces ? 1 : taken);
        return through * (faces ? 1 / taken : taken);
    }
    for (int k = 0; k < 3; k++)
        add[k] = (double)color[k] * (1 - through);
    return through;
}

static int compare(const void *left, const void *right)
{
    const Fragment *a = left, *b = right;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    if (a->depth != b->depth)
        return a->depth < b->depth ? -1 : 1;
    return a->triangle < b->triangle ? -1 : a->triangle > b->triangle;
}

static void blend(const Work *work, const Fragment *fragments, size_t count, double slanted,
                  double rgba[4])
{
    double left = 1;
    for (size_t i = 0; i < count; i++) {
        double add[3];
        const double through = find_source(work, &fragments[i], slanted, add);
        for (int k = 0; k < 3; k++)
            rgba[k] += left * add[k];
        left *= through;
    }
    rgba[3] = 1 - left;
}

/* --- rows ------------------------------------------------------------------------------------- */

typedef struct Row {
    Fragment *fragments;
    size_t count, room;
} Row;

static bool append(Row *row, const Fragment *fragment)
{
    Fragment *list = gp_grown(row->fragments, row->count, &row->room, sizeof *list, NULL);
    if (!list)
        return false;
    row->fragments = list;
    row->fragments[row->count++] = *fragment;
    return true;
}

static bool cross_row(const Work *work, uint32_t y, uint32_t triangle, Row *row)
{
    const FragmentTruthScene *scene = work->scene;
    const SeenTriangle *seen = &work->seen[triangle];
    const uint32_t first = (uint32_t)fmax(floor(seen->low[0] - 0.5), 0);
    const uint32_t end = (uint32_t)fmax(fmin(ceil(seen->high[0] + 0.5), scene->width), 0);
    for (uint32_t x = first; x < end; x++) {
        const double centre[2] = { x + 0.5, y + 0.5 };
        SeenAt at;
        seen_triangle_at(seen, centre, &at);
        if (at.is_near_edge)
            work->truth->is_edge[(size_t)y * scene->width + x] = 1;
        if (!at.is_covered)
            continue;
        const double along = distance_of(&scene->camera, at.depth);
        const Fragment fragment = { .x = x,
                                    .triangle = triangle,
                                    .depth = at.depth,
                                    .moved = at.moved,
                                    .way = (along - scene->begin) * slant(work, centre) };
        if (!append(row, &fragment))
            return false;
    }
    return true;
}

/* Whether snapping may make two fragments change places. Those of triangles with the same corners
 * move as one. */
static bool may_change_places(const Fragment *first, const Fragment *second)
{
    const double apart = second->depth - first->depth;
    return apart <= first->moved + second->moved && !(apart == 0 && first->moved == second->moved);
}

/* Where any two may, two that follow each other may. */
static bool has_crossing(const Fragment *fragments, size_t count)
{
    for (size_t i = 1; i < count; i++)
        if (may_change_places(&fragments[i - 1], &fragments[i]))
            return true;
    return false;
}

static void make_row(void *context, uint32_t y, int worker)
{
    const Work *work = context;
    const uint32_t width = work->scene->width;
    Row row = { .count = 0 };
    (void)worker;
    for (uint32_t i = work->row_begin[y]; i < work->row_begin[y + 1] && !work->failed[y]; i++)
        work->failed[y] = !cross_row(work, y, work->triangle[i], &row);
    if (!work->failed[y] && row.count > 0) {
        qsort(row.fragments, row.count, sizeof *row.fragments, compare);
        for (size_t i = 0, end; i < row.count; i = end) {
            const uint32_t x = row.fragments[i].x;
            for (end = i; end < row.count && row.fragments[end].x == x; end++)
                ;
            work->truth->is_crossing[(size_t)y * width + x] =
                has_crossing(row.fragments + i, end - i);
            blend(work, row.fragments + i, end - i, slant(work, (double[2]){ x + 0.5, y + 0.5 }),
                  work->truth->rgba + 4 * ((size_t)y * width + x));
            work->layers[y] = end - i > work->layers[y] ? (uint32_t)(end - i) : work->layers[y];
        }
    }
    work->fragments[y] = row.count;
    gp_free(row.fragments);
}

/* Rows that a triangle's box reaches into. */
static void rows_of(const Work *work, uint32_t triangle, uint32_t rows[2])
{
    const SeenTriangle *seen = &work->seen[triangle];
    rows[0] = (uint32_t)fmax(floor(seen->low[1] - 0.5), 0);
    rows[1] = (uint32_t)fmax(fmin(ceil(seen->high[1] + 0.5), work->scene->height), 0);
}

/* Sorts triangles into rows. */
static bool find_rows(Work *work)
{
    const uint32_t height = work->scene->height;
    const SeenView view = seen_view(&work->scene->camera, work->scene->width, height);
    uint32_t rows[2], *next = gp_alloc(height + 1, sizeof *next);
    if (!next)
        return false;
    for (uint32_t i = 0; i < work->scene->triangle_count; i++) {
        seen_triangle_make(&view, work->scene->positions, work->scene->indices + 3 * (size_t)i,
                           &work->seen[i]);
        rows_of(work, i, rows);
        for (uint32_t y = rows[0]; y < rows[1]; y++)
            work->row_begin[y + 1]++;
    }
    for (uint32_t y = 0; y < height; y++)
        next[y + 1] = work->row_begin[y + 1] += work->row_begin[y];
    work->triangle = gp_alloc(work->row_begin[height], sizeof *work->triangle);
    for (uint32_t i = 0; i < work->scene->triangle_count && work->triangle; i++) {
        rows_of(work, i, rows);
        for (uint32_t y = rows[0]; y < rows[1]; y++)
            work->triangle[next[y]++] = i;
    }
    gp_free(next);
    return work->triangle;
}

static void sum_up(const Work *work, FragmentTruth *truth)
{
    for (uint32_t y = 0; y < truth->height; y++) {
        truth->fragments += work->fragments[y];
        truth->layers = work->layers[y] > truth->layers ? work->layers[y] : truth->layers;
    }
}

GpResult fragment_truth_make(const FragmentTruthScene *scene, GpPool *pool, FragmentTruth *truth)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    FragmentTruth made = { .width = scene->width,
                           .height = scene->height,
                           .rgba = gp_alloc(pixels, 4 * sizeof *made.rgba),
                           .is_edge = gp_alloc(pixels, 1),
                           .is_crossing = gp_alloc(pixels, 1) };
    Work work = { .scene = scene,
                  .truth = &made,
                  .axes = camera_axes(&scene->camera, (double)scene->width / scene->height),
                  .seen = gp_alloc(scene->triangle_count, sizeof *work.seen),
                  .row_begin = gp_alloc(scene->height + 1, sizeof *work.row_begin),
                  .fragments = gp_alloc(scene->height, sizeof *work.fragments),
                  .layers = gp_alloc(scene->height, sizeof *work.layers),
                  .failed = gp_alloc(scene->height, sizeof *work.failed) };
    bool failed = !made.rgba || !made.is_edge || !made.is_crossing || !work.seen ||
                  !work.row_begin || !work.fragments || !work.layers || !work.failed ||
                  !find_rows(&work);
    if (!failed)
        gp_pool_run(pool, scene->height, make_row, &work);
    for (uint32_t y = 0; y < scene->height && !failed; y++)
        failed = work.failed[y];
    if (!failed)
        sum_up(&work, &made);
    gp_free(work.seen);
    gp_free(work.row_begin);
    gp_free(work.triangle);
    gp_free(work.fragments);
    gp_free(work.layers);
    gp_free(work.failed);
    if (failed)
        fragment_truth_free(&made);
    else
        *truth = made;
    return failed ? GP_ERROR_MEMORY : GP_OK;
}

void fragment_truth_free(FragmentTruth *truth)
{
    gp_free(truth->rgba);
    gp_free(truth->is_edge);
    gp_free(truth->is_crossing);
    *truth = (FragmentTruth){ .rgba = NULL };
}
