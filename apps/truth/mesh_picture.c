#include "apps/truth/mesh_picture.h"

#include <math.h>
#include <string.h>

enum { BAND = 4 }; /* rows of pixels that are found together */

/* A corner before the eye: x right, y down, z forward; and its share of the triangle's corners. */
typedef struct Corner {
    double place[3], share[3];
} Corner;

/* What is nearest at a sample: a triangle, and the shares of its corners. */
typedef struct Seen {
    double share[3];
    uint32_t triangle;
} Seen;

typedef struct Run {
    const MeshPictureScene *scene;
    MeshPicture *picture;
    double axis[3][3], focal; /* focal: samples */
    uint32_t bands;
    uint32_t *first, *listed; /* triangles of band i: listed[first[i]] to listed[first[i + 1]] */
    float *rows;              /* [triangle][2]: lowest and highest row, in pixels; NaN: not seen */
    double *nearest;          /* [worker][band's samples]: 1/z, 0: nothing */
    Seen *seen;               /* [worker][band's samples]: where nearest is above 0 */
} Run;

static size_t band_samples(const Run *run)
{
    const size_t side = run->scene->samples;
    return run->scene->width * side * BAND * side;
}

/* --- corners ---------------------------------------------------------------------------------- */

static void corner_before_eye(const Run *run, uint32_t triangle, int which, Corner *corner)
{
    const MeshPictureScene *scene = run->scene;
    const uint32_t vertex = scene->indices[3 * (size_t)triangle + (uint32_t)which];
    const float *from =
        (const float *)(const void *)((const char *)scene->positions + vertex * scene->stride);
    double away[3];
    for (int k = 0; k < 3; k++)
        away[k] = (double)from[k] - scene->camera.eye[k];
    for (int k = 0; k < 3; k++) {
        corner->place[k] = vector_dot(run->axis[k], away);
        corner->share[k] = k == which;
    }
}

/* Where an edge meets the near plane. */
static Corner cut_corner(const Corner *a, const Corner *b, double near)
{
    const double t = (near - a->place[2]) / (b->place[2] - a->place[2]);
    Corner cut;
    for (int k = 0; k < 3; k++) {
        cut.place[k] = a->place[k] + t * (b->place[k] - a->place[k]);
        cut.share[k] = a->share[k] + t * (b->share[k] - a->share[k]);
    }
    cut.place[2] = near;
    return cut;
}

/* What of a triangle lies beyond the near plane: corners of a convex polygon, at most 4. */
static int clip_near(const Run *run, uint32_t triangle, Corner polygon[4])
{
    const double near = run->scene->camera.near;
    Corner corners[3];
    int count = 0;
    for (int i = 0; i < 3; i++)
        corner_before_eye(run, triangle, i, &corners[i]);
    for (int i = 0; i < 3; i++) {
        const Corner *a = &corners[i], *b = &corners[(i + 1) % 3];
        if (a->place[2] >= near)
            polygon[count++] = *a;
        if ((a->place[2] >= near) != (b->place[2] >= near))
            polygon[count++] = cut_corner(a, b, near);
    }
    return count;
}

/* Places in samples from the picture's top left; the third is 1/z. */
static void project(const Run *run, Corner *corner)
{
    const MeshPictureScene *scene = run->scene;
    const double per_z = 1 / corner->place[2];
    corner->place[0] = corner->place[0] * per_z * run->focal + scene->width * scene->samples / 2.0;
    corner->place[1] = corner->place[1] * per_z * run->focal + scene->height * scene->samples / 2.0;
    corner->place[2] = per_z;
}

/* --- bands ------------------------------------------------------------------------------------ */

static void find_rows(void *context, uint32_t item, int worker)
{
    const Run *run = context;
    const uint32_t end = (item + 1) * 4096 < run->scene->triangle_count
                             ? (item + 1) * 4096
                             : run->scene->triangle_count;
    (void)worker;
    for (uint32_t i = item * 4096; i < end; i++) {
        Corner polygon[4];
        const int count = clip_near(run, i, polygon);
        double low = (double)INFINITY, high = -(double)INFINITY;
        for (int k = 0; k < count; k++) {
            project(run, &polygon[k]);
            low = fmin(low, polygon[k].place[1]);
            high = fmax(high, polygon[k].place[1]);
        }
        run->rows[2 * (size_t)i] = (float)(low / run->scene->samples - 0.01);
        run->rows[2 * (size_t)i + 1] = (float)(high / run->scene->samples + 0.01);
    }
}

/* Bands that a triangle reaches, first to last; none: last below first. */
static void bands_of(const Run *run, uint32_t triangle, int64_t *first, int64_t *last)
{
    const float *rows = run->rows + 2 * (size_t)triangle;
    *first = 0;
    *last = -1;
    if (rows[0] <= rows[1] && rows[1] >= 0 && rows[0] < (float)run->scene->height) {
        *first = rows[0] < 0 ? 0 : (int64_t)(rows[0] / BAND);
        *last = rows[1] >= (float)run->scene->height ? run->bands - 1 : (int64_t)(rows[1] / BAND);
    }
}

/* errors GP_ERROR_MEMORY */
static GpResult list_triangles(Run *run)
{
    const uint32_t triangles = run->scene->triangle_count;
    int64_t first, last;
    for (uint32_t i = 0; i < triangles; i++)
        for (bands_of(run, i, &first, &last); first <= last; first++)
            run->first[first + 1]++;
    for (uint32_t band = 0; band < run->bands; band++)
        run->first[band + 1] += run->first[band];
    run->listed = gp_alloc(run->first[run->bands] + 1, sizeof *run->listed);
    uint32_t *next = gp_alloc(run->bands + 1, sizeof *next);
    if (run->listed && next) {
        memcpy(next, run->first, run->bands * sizeof *next);
        for (uint32_t i = 0; i < triangles; i++)
            for (bands_of(run, i, &first, &last); first <= last; first++)
                run->listed[next[first]++] = i;
    }
    const bool done = run->listed && next;
    gp_free(next);
    return done ? GP_OK : GP_ERROR_MEMORY;
}

/* --- samples ---------------------------------------------------------------------------------- */

/* The line from one corner to the next. */
typedef struct Edge {
    double x, y, dx, dy;
} Edge;

static Edge edge_between(const Corner *a, const Corner *b)
{
    return (Edge){ a->place[0], a->place[1], b->place[0] - a->place[0], b->place[1] - a->place[1] };
}

/* Twice the area of the triangle that the edge and a place make; negative where it turns the other
 * way. */
static inline double area_at(const Edge *edge, double x, double y)
{
    return edge->dx * (y - edge->y) - edge->dy * (x - edge->x);
}

/* A triangle of the projected polygon. Corner i's weight is what edge i has of the area. */
typedef struct Piece {
    const Corner *corner[3];
    Edge edge[3];
    double area, per_z[3]; /* of the corners */
    uint32_t triangle;
} Piece;

static Piece piece_of(uint32_t triangle, const Corner *a, const Corner *b, const Corner *c)
{
    Piece piece = { .corner = { a, b, c },
                    .edge = { edge_between(b, c), edge_between(c, a), edge_between(a, b) },
                    .per_z = { a->place[2], b->place[2], c->place[2] },
                    .triangle = triangle };
    piece.area = area_at(&piece.edge[2], c->place[0], c->place[1]);
    return piece;
}

static void see(const Piece *piece, const double weight[3], Seen *seen)
{
    double share[3] = { 0, 0, 0 }, sum = 0;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            share[k] += weight[i] * piece->per_z[i] * piece->corner[i]->share[k];
    for (int k = 0; k < 3; k++)
        sum += share[k];
    for (int k = 0; k < 3; k++)
        seen->share[k] = share[k] / sum;
    seen->triangle = piece->triangle;
}

/* Along a row of samples from x0 to x1. */
static void fill_row(const Piece *piece, double y, int64_t x0, int64_t x1, double *nearest,
                     Seen *seen)
{
    const Edge *edge = piece->edge;
    const double area = piece->area, turn = area < 0 ? -1 : 1;
    bool entered = false;
    for (int64_t x = x0; x <= x1; x++) {
        const double px = (double)x + 0.5;
        const double of[3] = { area_at(&edge[0], px, y), area_at(&edge[1], px, y),
                               area_at(&edge[2], px, y) };
        const bool inside = of[0] * turn >= 0 && of[1] * turn >= 0 && of[2] * turn >= 0;
        if (!inside && entered)
            return;
        entered = inside;
        if (!inside)
            continue;
        const double weight[3] = { of[0] / area, of[1] / area, of[2] / area };
        const double per_z =
            weight[0] * piece->per_z[0] + weight[1] * piece->per_z[1] + weight[2] * piece->per_z[2];
        if (per_z <= nearest[x])
            continue;
        nearest[x] = per_z;
        see(piece, weight, &seen[x]);
    }
}

/* The same of all its rows in the band. */
static void fill(const Run *run, uint32_t band, const Piece *piece, double *nearest, Seen *seen)
{
    const int64_t side = run->scene->samples;
    const int64_t width = (int64_t)run->scene->width * side, top = (int64_t)band * BAND * side;
    double low[2] = { (double)INFINITY, (double)INFINITY },
           high[2] = { -(double)INFINITY, -(double)INFINITY };
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], piece->corner[i]->place[k]);
            high[k] = fmax(high[k], piece->corner[i]->place[k]);
        }
    if (piece->area == 0 || high[0] < 0 || low[0] > (double)width)
        return;
    const int64_t x0 = (int64_t)fmax(floor(low[0] - 0.5), 0);
    const int64_t x1 = (int64_t)fmin(ceil(high[0]), (double)(width - 1));
    const int64_t y0 = (int64_t)fmax(floor(low[1] - 0.5), (double)top);
    const int64_t y1 = (int64_t)fmin(ceil(high[1]), (double)(top + BAND * side - 1));
    for (int64_t y = y0; y <= y1; y++)
        fill_row(piece, (double)y + 0.5, x0, x1, nearest + (y - top) * width,
                 seen + (y - top) * width);
}

/* Samples get their colours here, once it is known what each of them sees. */
static void average(const Run *run, uint32_t band, const double *nearest, const Seen *seen)
{
    const MeshPicture *picture = run->picture;
    const uint32_t side = picture->samples;
    for (uint32_t y = band * BAND; y < (band + 1) * BAND && y < picture->height; y++)
        for (uint32_t x = 0; x < picture->width; x++) {
            const size_t pixel = (size_t)y * picture->width + x;
            double sum[3] = { 0, 0, 0 };
            uint32_t covered = 0;
            for (uint32_t i = 0; i < side * side; i++) {
                const size_t row = (size_t)(y - band * BAND) * side + i / side;
                const size_t at = row * picture->width * side + (size_t)x * side + i % side;
                if (!(nearest[at] > 0))
                    continue;
                double color[3];
                covered++;
                run->scene->color(run->scene->context, seen[at].triangle, seen[at].share, color);
                for (size_t k = 0; k < 3; k++)
                    sum[k] += color[k];
            }
            picture->covered[pixel] = (uint8_t)covered;
            for (size_t k = 0; k < 3; k++)
                picture->color[3 * pixel + k] = covered ? sum[k] / covered : 0;
        }
}

static void find_band(void *context, uint32_t band, int worker)
{
    const Run *run = context;
    const size_t samples = band_samples(run);
    double *nearest = run->nearest + (uint32_t)worker * samples;
    Seen *seen = run->seen + (uint32_t)worker * samples;
    memset(nearest, 0, samples * sizeof *nearest);
    for (uint32_t i = run->first[band]; i < run->first[band + 1]; i++) {
        Corner polygon[4];
        const int count = clip_near(run, run->listed[i], polygon);
        for (int k = 0; k < count; k++)
            project(run, &polygon[k]);
        for (int k = 2; k < count; k++) {
            const Piece piece = piece_of(run->listed[i], &polygon[0], &polygon[k - 1], &polygon[k]);
            fill(run, band, &piece, nearest, seen);
        }
    }
    average(run, band, nearest, seen);
}

/* --- the whole -------------------------------------------------------------------------------- */

static GpResult make(Run *run, GpPool *pool)
{
    const MeshPictureScene *scene = run->scene;
    const size_t pixels = (size_t)scene->width * scene->height,
                 workers = (size_t)gp_pool_threads(pool);
    *run->picture = (MeshPicture){ .width = scene->width,
                                   .height = scene->height,
                                   .samples = scene->samples,
                                   .color = gp_alloc(pixels, 3 * sizeof(double)),
                                   .covered = gp_alloc(pixels, 1) };
    run->bands = (scene->height + BAND - 1) / BAND;
    run->first = gp_alloc(run->bands + 1, sizeof *run->first);
    run->rows = gp_alloc(scene->triangle_count + 1, 2 * sizeof *run->rows);
    run->nearest = gp_alloc_unset(workers * band_samples(run) * sizeof *run->nearest);
    run->seen = gp_alloc_unset(workers * band_samples(run) * sizeof *run->seen);
    if (!run->picture->color || !run->picture->covered || !run->first || !run->rows ||
        !run->nearest || !run->seen)
        return GP_ERROR_MEMORY;
    gp_pool_run(pool, (scene->triangle_count + 4095) / 4096, find_rows, run);
    GpResult result = list_triangles(run);
    if (!result)
        gp_pool_run(pool, run->bands, find_band, run);
    return result;
}

GpResult mesh_picture_make(const MeshPictureScene *scene, GpPool *pool, MeshPicture *picture)
{
    const CameraAxes axes = camera_axes(&scene->camera, (double)scene->width / scene->height);
    Run run = { .scene = scene,
                .picture = picture,
                .focal = scene->height * scene->samples / (2 * axes.half_height) };
    for (int k = 0; k < 3; k++) {
        run.axis[0][k] = axes.right[k];
        run.axis[1][k] = -axes.up[k];
        run.axis[2][k] = axes.forward[k];
    }
    GpResult result = make(&run, pool);
    gp_free(run.first);
    gp_free(run.listed);
    gp_free(run.rows);
    gp_free(run.nearest);
    gp_free(run.seen);
    if (result)
        mesh_picture_free(picture);
    return result;
}

void mesh_picture_free(MeshPicture *picture)
{
    gp_free(picture->color);
    gp_free(picture->covered);
    *picture = (MeshPicture){ .color = NULL };
}

bool mesh_picture_is_interior(const MeshPicture *picture, uint32_t x, uint32_t y)
{
    if (x == 0 || y == 0 || x + 1 >= picture->width || y + 1 >= picture->height)
        return false;
    for (uint32_t j = y - 1; j <= y + 1; j++)
        for (uint32_t i = x - 1; i <= x + 1; i++)
            if (picture->covered[(size_t)j * picture->width + i] <
                picture->samples * picture->samples)
                return false;
    return true;
}
