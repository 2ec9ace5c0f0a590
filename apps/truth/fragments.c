#include "apps/truth/fragments.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A triangle as the picture sees it: corners are (X, Y, Z, W), where (X / W, Y / W) is a place in pixels, y
 * down, Z / W its depth, 0 near, 1 far; W is 1 where rays are parallel. A place (x, y) is inside where
 * edge[i] . (x, y, 1) are of one sign; they are also the shares of the corners in it (Olano and Greer,
 * "Triangle scan conversion using 2D homogeneous coordinates", Graphics Hardware 1997). */
typedef struct Seen {
    double edge[3][3];
    double z[3], w[3];
    double low[2], high[2]; /* box, in pixels */
    bool is_before;         /* all corners are before the eye: edges end */
    double at[3][2];        /* then where they are */
} Seen;

typedef struct Fragment {
    uint32_t x, triangle;
    double depth,
        way; /* way: along the line of sight, from the plane where light begins to be taken */
} Fragment;

/* What all rows share. */
typedef struct Work {
    const FragmentTruthScene *scene;
    FragmentTruth *truth;
    CameraAxes axes;
    Seen *seen;
    uint32_t *row_begin; /* [height + 1] in triangle */
    uint32_t *triangle;  /* those whose boxes reach into a row, row by row, rising */
    uint64_t *fragments; /* of each row */
    uint32_t *layers;
    bool *failed;
} Work;

/* An edge is as near as snapped corners may bring it. */
#define NEAR (1.0 / 256)

/* --- triangles on the picture -------------------------------------------------------------------- */

static void find_corner(const Work *work, const float position[3], double corner[4])
{
    const FragmentTruthScene *scene = work->scene;
    const Camera *camera = &scene->camera;
    double from[3];
    for (int k = 0; k < 3; k++)
        from[k] = (double)position[k] - camera->eye[k];
    const bool is_parallel = !(camera->fovy > 0);
    const double along = vector_dot(from, work->axes.forward), w = is_parallel ? 1 : along;
    const double length = camera->far - camera->near;
    corner[0] = (vector_dot(from, work->axes.right) / work->axes.half_width + w) / 2 * scene->width;
    corner[1] = (w - vector_dot(from, work->axes.up) / work->axes.half_height) / 2 * scene->height;
    corner[2] = is_parallel ? (along - camera->near) / length
                            : camera->far / length * (along - camera->near);
    corner[3] = w;
}

/* Across two corners, the same but for the sign whichever comes first: they are put in an order that they
 * have in all triangles that share them. */
static void find_edge(const double a[4], const double b[4], bool turned, double edge[3])
{
    const double *from = turned ? b : a, *to = turned ? a : b, sign = turned ? -1 : 1;
    edge[0] = sign * (from[1] * to[3] - to[1] * from[3]);
    edge[1] = sign * (from[3] * to[0] - to[3] * from[0]);
    edge[2] = sign * (from[0] * to[1] - to[0] * from[1]);
}

static void find_box(const Work *work, const double corner[3][4], Seen *seen)
{
    const double size[2] = { work->scene->width, work->scene->height };
    seen->is_before = true;
    for (int i = 0; i < 3; i++)
        seen->is_before = seen->is_before && corner[i][3] > 0;
    for (int k = 0; k < 2; k++) {
        seen->low[k] = 0;
        seen->high[k] = size[k];
        if (!seen->is_before)
            continue;
        for (int i = 0; i < 3; i++)
            seen->at[i][k] = corner[i][k] / corner[i][3];
        const double low = fmin(seen->at[0][k], fmin(seen->at[1][k], seen->at[2][k]));
        const double high = fmax(seen->at[0][k], fmax(seen->at[1][k], seen->at[2][k]));
        seen->low[k] = fmin(fmax(low - NEAR, 0), size[k]);
        seen->high[k] = fmin(fmax(high + NEAR, 0), size[k]);
    }
}

static void see_triangle(const Work *work, uint32_t number)
{
    const uint32_t *index = work->scene->indices + 3 * (size_t)number;
    double corner[3][4];
    Seen *seen = &work->seen[number];
    for (int i = 0; i < 3; i++) {
        find_corner(work, work->scene->positions[index[i]], corner[i]);
        seen->z[i] = corner[i][2];
        seen->w[i] = corner[i][3];
    }
    for (int i = 0; i < 3; i++) {
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        const int order = memcmp(work->scene->positions[index[a]], work->scene->positions[index[b]],
                                 3 * sizeof(float));
        find_edge(corner[a], corner[b], order > 0, seen->edge[i]);
    }
    find_box(work, corner, seen);
}

/* --- a pixel and a triangle ---------------------------------------------------------------------- */

/* A centre on an edge is inside of the triangle for which the edge runs one way. */
static bool covers(const double at[3], const double edge[3][3])
{
    int positive = 0;
    for (int i = 0; i < 3; i++) {
        const double *e = edge[i];
        const bool runs = e[0] > 0 || (e[0] == 0 && e[1] > 0);
        positive += at[i] > 0 || (at[i] == 0 && runs);
    }
    return positive == 0 || positive == 3;
}

static double to_segment(const double p[2], const double a[2], const double b[2])
{
    const double along[2] = { b[0] - a[0], b[1] - a[1] }, from[2] = { p[0] - a[0], p[1] - a[1] };
    const double square = along[0] * along[0] + along[1] * along[1];
    const double share = (from[0] * along[0] + from[1] * along[1]) / square;
    const double t = square > 0 ? fmin(fmax(share, 0), 1) : 0;
    return hypot(from[0] - t * along[0], from[1] - t * along[1]);
}

static bool is_near_edge(const Seen *seen, const double centre[2], const double at[3])
{
    for (int i = 0; i < 3; i++) {
        const double *e = seen->edge[i];
        if (fabs(at[i]) > NEAR * hypot(e[0], e[1]))
            continue;
        if (!seen->is_before ||
            to_segment(centre, seen->at[(i + 1) % 3], seen->at[(i + 2) % 3]) <= NEAR)
            return true;
    }
    return false;
}

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

/* The fragment of a triangle at a place. False: it has none there. */
static bool find_fragment(const Work *work, const Seen *seen, const double centre[2],
                          const double at[3], Fragment *fragment)
{
    double z = 0, w = 0;
    if (!covers(at, seen->edge))
        return false;
    for (int i = 0; i < 3; i++) {
        z += at[i] * seen->z[i];
        w += at[i] * seen->w[i];
    }
    /* Shares of one sign: where that of w is another, the place is behind the eye. */
    const double sum = at[0] + at[1] + at[2];
    if (!(w * sum > 0) || !(z / w >= 0 && z / w <= 1))
        return false;
    const Camera *camera = &work->scene->camera;
    fragment->depth = z / w;
    fragment->way =
        (distance_of(camera, fragment->depth) - work->scene->begin) * slant(work, centre);
    return true;
}

/* --- a pixel ------------------------------------------------------------------------------------- */

/* How far a triangle's plane is from the eye, or, of parallel rays, how far it goes along with a step along
 * them. out faces: whether its outer side is seen */
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

/* --- rows ---------------------------------------------------------------------------------------- */

typedef struct Row {
    Fragment *fragments;
    size_t count, room;
} Row;

static bool append(Row *row, const Fragment *fragment)
{
    if (row->count == row->room) {
        const size_t room = row->room ? 2 * row->room : 4096;
        Fragment *more = realloc(row->fragments, room * sizeof *more);
        if (!more)
            return false;
        row->fragments = more;
        row->room = room;
    }
    row->fragments[row->count++] = *fragment;
    return true;
}

static bool cross_row(const Work *work, uint32_t y, uint32_t triangle, Row *row)
{
    const Seen *seen = &work->seen[triangle];
    const uint32_t first = (uint32_t)fmax(floor(seen->low[0] - 0.5), 0);
    const uint32_t end = (uint32_t)fmax(fmin(ceil(seen->high[0] + 0.5), work->scene->width), 0);
    for (uint32_t x = first; x < end; x++) {
        const double centre[2] = { x + 0.5, y + 0.5 };
        double at[3];
        for (int i = 0; i < 3; i++)
            at[i] = seen->edge[i][0] * centre[0] + seen->edge[i][1] * centre[1] + seen->edge[i][2];
        Fragment fragment = { .x = x, .triangle = triangle };
        if (is_near_edge(seen, centre, at))
            work->truth->is_edge[(size_t)y * work->scene->width + x] = 1;
        if (find_fragment(work, seen, centre, at, &fragment) && !append(row, &fragment))
            return false;
    }
    return true;
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
            blend(work, row.fragments + i, end - i, slant(work, (double[2]){ x + 0.5, y + 0.5 }),
                  work->truth->rgba + 4 * ((size_t)y * width + x));
            work->layers[y] = end - i > work->layers[y] ? (uint32_t)(end - i) : work->layers[y];
        }
    }
    work->fragments[y] = row.count;
    free(row.fragments);
}

/* Rows that a triangle's box reaches into. */
static void rows_of(const Work *work, uint32_t triangle, uint32_t rows[2])
{
    const Seen *seen = &work->seen[triangle];
    rows[0] = (uint32_t)fmax(floor(seen->low[1] - 0.5), 0);
    rows[1] = (uint32_t)fmax(fmin(ceil(seen->high[1] + 0.5), work->scene->height), 0);
}

/* Sorts triangles into rows. */
static bool find_rows(Work *work)
{
    const uint32_t height = work->scene->height;
    uint32_t rows[2], *next = gp_alloc(height + 1, sizeof *next);
    if (!next)
        return false;
    for (uint32_t i = 0; i < work->scene->triangle_count; i++) {
        see_triangle(work, i);
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
                           .is_edge = gp_alloc(pixels, 1) };
    Work work = { .scene = scene,
                  .truth = &made,
                  .axes = camera_axes(&scene->camera, (double)scene->width / scene->height),
                  .seen = gp_alloc(scene->triangle_count, sizeof *work.seen),
                  .row_begin = gp_alloc(scene->height + 1, sizeof *work.row_begin),
                  .fragments = gp_alloc(scene->height, sizeof *work.fragments),
                  .layers = gp_alloc(scene->height, sizeof *work.layers),
                  .failed = gp_alloc(scene->height, sizeof *work.failed) };
    bool failed = !made.rgba || !made.is_edge || !work.seen || !work.row_begin || !work.fragments ||
                  !work.layers || !work.failed || !find_rows(&work);
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
    *truth = (FragmentTruth){ .rgba = NULL };
}
