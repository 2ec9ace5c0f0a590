#include "apps/depth_images/drawing/edges.h"

#include "apps/base/vector.h"

static float flat_of(const DepthPlane *plane, float depth)
{
    const bool is_there = depth < DEPTH_NOTHING && (plane->is_parallel || depth > 0);
    return is_there ? (float)depth_flat(plane->is_parallel, (double)depth) : NAN;
}

typedef struct Image {
    const DepthPlane *plane;
    const DepthPixels *pixels;
} Image;

/* --- between pixels --------------------------------------------------------------------------- */

/* A row or a column of pixels. */
typedef struct Line {
    const float *flat;
    size_t stride;
    uint32_t count;
} Line;

static double at(const Line *line, uint32_t i)
{
    return (double)line->flat[i * line->stride];
}

/* Slope between pixel i and the next in texels; 0 where one of them is nothing, or outside. */
static double slope(const DepthLattice *lattice, const Line *line, uint32_t i)
{
    if (i >= line->count - 1) /* before the first, too */
        return 0;
    const double a = at(line, i), b = at(line, i + 1), near = lattice->is_parallel ? 1 : fmax(a, b);
    const double texels = depth_lattice_texels(lattice, near, b - a);
    return texels >= 0 ? texels : 0;
}

/* What rounding may add to a step between flat depths. */
static double flat_step(const DepthLattice *lattice, double flat)
{
    return lattice->is_parallel ? lattice->level : lattice->level * flat * flat;
}

/* Whether the way between two pixels goes along the surface at both of them, as normals have it:
 * beside a silhouette the jump to another surface may be no steeper than the slope before it. */
static bool lies_along(const Image *image, double cosine, size_t from, size_t to)
{
    const DepthPixels *pixels = image->pixels;
    const size_t at[2] = { from, to };
    double point[2][3], way[3];
    for (int i = 0; i < 2; i++)
        depth_plane_point(image->plane, pixels, (double)(at[i] % pixels->width) + 0.5,
                          (double)(at[i] / pixels->width) + 0.5, (double)pixels->depth[at[i]],
                          point[i]);
    vector_subtract(point[1], point[0], way);
    vector_normalize(way);
    for (int i = 0; i < 2; i++) {
        const float *normal = pixels->normal + 3 * at[i];
        if (fabs((double)normal[0] * way[0] + (double)normal[1] * way[1] +
                 (double)normal[2] * way[2]) > cosine)
            return false;
    }
    return true;
}

static bool is_one_surface(const DepthLattice *lattice, const EdgeSetting *setting,
                           const Image *image, const Line *line, uint32_t i)
{
    const double a = at(line, i), b = at(line, i + 1);
    if (!(a == a && b == b))
        return false;
    if (setting->rule == EDGES_NONE)
        return true;
    if (setting->rule == EDGES_RELATIVE) {
        const double share = setting->share > 0 ? setting->share : 0.02;
        const double za = depth_flat(lattice->is_parallel, a),
                     zb = depth_flat(lattice->is_parallel, b);
        return fabs(za - zb) <= share * fmin(za, zb);
    }
    const double spread = setting->spread > 0 ? setting->spread : 1.2;
    const double texels = setting->texels > 0 ? setting->texels : 4;
    const double sides = fmax(slope(lattice, line, i - 1), slope(lattice, line, i + 1));
    const double level = depth_lattice_texels(lattice, fmax(a, b), flat_step(lattice, fmax(a, b)));
    const double step = slope(lattice, line, i);
    const size_t from = (size_t)(line->flat - lattice->flat) + i * line->stride;
    if (step <= texels + level)
        return true;
    const bool asks = setting->along > 0 && image->pixels->normal;
    return step <= texels + level + spread * sides &&
           (!asks || lies_along(image, setting->along, from, from + line->stride));
}

/* --- pixels ----------------------------------------------------------------------------------- */

/* By its normal, where there is one. */
static bool is_away(const DepthPlane *plane, const DepthPixels *pixels, uint32_t x, uint32_t y)
{
    const size_t at = (size_t)y * pixels->width + x;
    double from[3], to[3], ray[3], towards = 0;
    depth_plane_point(plane, pixels, x + 0.5, y + 0.5, 0, from);
    depth_plane_point(plane, pixels, x + 0.5, y + 0.5, 1, to);
    vector_subtract(to, from, ray);
    for (size_t k = 0; k < 3; k++)
        towards += (double)pixels->normal[3 * at + k] * ray[k];
    return towards > 0;
}

static GpResult make_room(DepthLattice *lattice)
{
    const size_t count = (size_t)lattice->width * lattice->height;
    lattice->flat = gp_alloc(count, sizeof *lattice->flat);
    lattice->neighbour = gp_alloc(count, 1);
    lattice->away = gp_alloc(count, 1);
    const bool has_room = lattice->flat && lattice->neighbour && lattice->away;
    if (!has_room)
        depth_lattice_free(lattice);
    return has_room ? GP_OK : GP_ERROR_MEMORY;
}

double depth_level(const DepthPixels *pixels)
{
    const double fewest = 16; /* fewer levels than that are steps of what is shown */
    double least = HUGE_VAL, low = HUGE_VAL, high = -HUGE_VAL;
    for (size_t y = 0; y < pixels->height; y++)
        for (size_t x = 0; x < pixels->width; x++) {
            const float *depth = pixels->depth + y * pixels->width + x;
            if (!(depth[0] < DEPTH_NOTHING))
                continue;
            low = fmin(low, (double)depth[0]);
            high = fmax(high, (double)depth[0]);
            const double step = x > 0 ? fabs((double)depth[0] - (double)depth[-1]) : 0;
            if (step > 0)
                least = fmin(least, step);
        }
    return least * fewest <= high - low ? least : 0;
}

const char *depth_level_warning(const DepthPlane *plane, const DepthPixels *pixels)
{
    double nearest = HUGE_VAL;
    for (size_t i = 0; i < (size_t)pixels->width * pixels->height; i++)
        nearest = fmin(nearest, (double)pixels->depth[i]);
    const double texel = plane->width / pixels->width * (plane->is_parallel ? 1 : nearest);
    return depth_level(pixels) > texel
               ? "depths are in few bits: slopes are stairs of steps that are "
                 "wider than pixels"
               : NULL;
}

GpResult depth_lattice_make(const DepthPlane *plane, const DepthPixels *pixels,
                            const EdgeSetting *setting, DepthLattice *lattice)
{
    const uint32_t width = pixels->width, height = pixels->height;
    const Image image = { plane, pixels };
    DepthLattice made = { .width = width,
                          .height = height,
                          .image = { width, height },
                          .step = 1,
                          .is_parallel = plane->is_parallel,
                          .texel = plane->width / width,
                          .level = depth_level(pixels) };
    const GpResult result = make_room(&made);
    for (size_t i = 0; i < (size_t)width * height && !result; i++)
        made.flat[i] = flat_of(plane, pixels->depth[i]);
    for (uint32_t y = 0; y < height && !result; y++)
        for (uint32_t x = 0; x < width; x++) {
            const Line row = { made.flat + (size_t)y * width, 1, width },
                       column = { made.flat + x, width, height };
            const size_t i = (size_t)y * width + x;
            if (isnan(made.flat[i]))
                continue;
            if (x + 1 < width && is_one_surface(&made, setting, &image, &row, x))
                made.neighbour[i] |= EDGE_RIGHT;
            if (y + 1 < height && is_one_surface(&made, setting, &image, &column, y))
                made.neighbour[i] |= EDGE_DOWN;
            made.away[i] = pixels->normal && is_away(plane, pixels, x, y);
        }
    *lattice = made;
    return result;
}

/* --- fewer vertices --------------------------------------------------------------------------- */

static uint32_t vertices_of(uint32_t pixels, uint32_t step)
{
    return (pixels - 1 + step - 1) / step + 1;
}

/* Pixel of vertex i of a row or column. */
static uint32_t pixel_of(uint32_t i, uint32_t step, uint32_t count)
{
    return i * step < count - 1 ? i * step : count - 1;
}

/* Whether all pixels from one to another, of a row or column, are one surface. */
static bool is_joined(const DepthLattice *pixels, size_t from, size_t stride, uint32_t count,
                      EdgeNeighbour bit)
{
    for (uint32_t i = 0; i < count; i++)
        if (!(pixels->neighbour[from + i * stride] & bit))
            return false;
    return true;
}

GpResult depth_lattice_thin(const DepthLattice *pixels, uint32_t step, DepthLattice *lattice)
{
    DepthLattice made = *pixels;
    made.step = step;
    made.width = vertices_of(pixels->width, step);
    made.height = vertices_of(pixels->height, step);
    const GpResult result = make_room(&made);
    for (uint32_t y = 0; y < made.height && !result; y++)
        for (uint32_t x = 0; x < made.width; x++) {
            const uint32_t px = pixel_of(x, step, pixels->width),
                           py = pixel_of(y, step, pixels->height),
                           right = pixel_of(x + 1, step, pixels->width) - px,
                           down = pixel_of(y + 1, step, pixels->height) - py;
            const size_t i = (size_t)y * made.width + x, from = (size_t)py * pixels->width + px;
            made.flat[i] = pixels->flat[from];
            made.away[i] = pixels->away[from];
            if (right && is_joined(pixels, from, 1, right, EDGE_RIGHT))
                made.neighbour[i] |= EDGE_RIGHT;
            if (down && is_joined(pixels, from, pixels->width, down, EDGE_DOWN))
                made.neighbour[i] |= EDGE_DOWN;
        }
    *lattice = made;
    return result;
}

bool depth_lattice_is_whole(const DepthLattice *lattice, int64_t x, int64_t y)
{
    const int64_t width = lattice->width;
    if (x < 0 || y < 0 || x + 1 >= width || y + 1 >= lattice->height)
        return false;
    const uint8_t *here = lattice->neighbour + y * width + x;
    return here[0] == (EDGE_RIGHT | EDGE_DOWN) && (here[1] & EDGE_DOWN) &&
           (here[width] & EDGE_RIGHT);
}

double depth_lattice_place(const DepthLattice *lattice, int axis, double at)
{
    const double last = (axis ? lattice->height : lattice->width) - 1;
    const double most = lattice->image[axis], whole = floor(at);
    const double from = fmin(whole * lattice->step + 0.5, most - 0.5),
                 to = fmin((whole + 1) * lattice->step + 0.5, most - 0.5);
    return at < 0 ? 0 : at > last ? most : from + (at - whole) * (to - from);
}

void depth_lattice_free(DepthLattice *lattice)
{
    gp_free(lattice->flat);
    gp_free(lattice->neighbour);
    gp_free(lattice->away);
    *lattice = (DepthLattice){ .flat = NULL };
}
