#include "apps/bench/floor.h"

#include "apps/bench/operations.h"

enum {
    MANY_TRIANGLES = 1000,
    FEW_FRAGMENTS = 4000000, /* the reference executor takes some seconds for them */
};

/* What all passes come to. */
typedef struct Work {
    double operations, triangles, fragments;
    double read, written; /* bytes */
} Work;

static double least(double a, double b)
{
    return a < b ? a : b;
}

/* --- bytes ------------------------------------------------------------------------------------ */

static double surface_bytes(const GpSurface *surface, uint32_t levels)
{
    double bytes = 0;
    for (uint32_t i = 0; i < levels; i++)
        bytes += (double)surface->level[i].width * surface->level[i].height *
                 gp_format_info(surface->format)->bytes;
    return bytes;
}

/* Targets are written once a pass, and read where they were not cleared. */
static void add_targets(const GpPass *pass, Work *work)
{
    for (int t = 0; t < GP_MAX_TARGETS && pass->color[t].surface; t++) {
        const double bytes = surface_bytes(pass->color[t].surface, 1);
        work->written += bytes;
        work->read += pass->color[t].clear ? 0 : bytes;
    }
    if (!pass->depth.surface)
        return;
    bool writes = pass->depth.clear_depth;
    for (uint32_t i = 0; i < pass->draw_count; i++)
        writes |= pass->draws[i].state.depth.write;
    const double bytes = surface_bytes(pass->depth.surface, 1);
    work->written += writes ? bytes : 0;
    work->read += pass->depth.clear_depth ? 0 : bytes;
}

static double geometry_bytes(const GpGeometry *geometry)
{
    double bytes = 4.0 * (geometry->indices ? geometry->index_count : 0) +
                   2.0 * (geometry->indices16 ? geometry->index_count : 0);
    for (int s = 0; s < GP_SEMANTICS; s++) {
        const GpStream *stream = &geometry->streams[s];
        if (stream->data)
            bytes += (double)stream->components * (double)gp_component_bytes(stream->type) *
                     least(geometry->vertex_count, gp_geometry_elements(geometry));
    }
    return bytes;
}

static double texture_bytes(const GpDraw *draw, double fragments)
{
    double bytes = 0;
    for (int slot = 0; slot < GP_MAX_SAMPLERS; slot++) {
        const GpSurface *surface = draw->textures[slot].surface;
        if (surface && draw->program->samplers >> slot & 1)
            bytes += least(surface_bytes(surface, surface->levels),
                           fragments * gp_format_info(surface->format)->bytes);
    }
    return bytes;
}

/* --- passes ----------------------------------------------------------------------------------- */

static GpCounters counted_since(const GpDevice *device, const GpCounters *before)
{
    const GpCounters *now = gp_device_counters(device);
    return (GpCounters){ .vertices = now->vertices - before->vertices,
                         .primitives = now->primitives - before->primitives,
                         .fragments_shaded = now->fragments_shaded - before->fragments_shaded,
                         .primitives_drawn = now->primitives_drawn - before->primitives_drawn };
}

/* Of shaders that differ the cheapest stands for all: a floor, not a guess. */
static void add_pass(const GpPass *pass, const GpCounters *counters, Work *work)
{
    DrawOperations cheapest = { .vertex = -1, .fragment = -1 };
    double most_texels = 0;
    bool triangles = false;
    const GpProgram *last = NULL;
    DrawOperations one = cheapest;
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        const GpDraw *draw = &pass->draws[i];
        if (draw->program != last) /* of thousands of small draws one stands for all in a row */
            one = draw_operations(pass, draw);
        const double texels = texture_bytes(draw, (double)counters->fragments_shaded);
        last = draw->program;
        triangles |= draw->geometry.primitive != GP_POINTS;
        work->read += geometry_bytes(&draw->geometry);
        most_texels = texels > most_texels ? texels : most_texels;
        if (cheapest.vertex < 0 || one.vertex < cheapest.vertex)
            cheapest.vertex = one.vertex;
        if (one.fragment > 0 && (cheapest.fragment < 0 || one.fragment < cheapest.fragment))
            cheapest.fragment = one.fragment;
    }
    work->read += most_texels;
    if (cheapest.vertex > 0)
        work->operations += cheapest.vertex * (double)counters->vertices;
    if (cheapest.fragment > 0)
        work->operations += cheapest.fragment * (double)counters->fragments_shaded;
    work->fragments += (double)counters->fragments_shaded;
    if (triangles)
        work->triangles += (double)counters->primitives;
    add_targets(pass, work);
}

static GpResult add_passes(GpDevice *device, const GpList *list, Work *work, GpError *error)
{
    for (uint32_t p = 0; p < list->pass_count; p++) {
        const GpCounters before = *gp_device_counters(device);
        const GpList alone = { .passes = &list->passes[p], .pass_count = 1 };
        const GpResult result = gp_device_run(device, &alone, error);
        if (result)
            return result;
        const GpCounters counters = counted_since(device, &before);
        add_pass(&list->passes[p], &counters, work);
    }
    return GP_OK;
}

static GpResult count_drawn(const GpList *list, Work *work, GpError *error)
{
    GpDevice *device = NULL;
    GpResult result =
        gp_device_create(&(GpDeviceDesc){ .executor = GP_EXECUTOR_REFERENCE }, &device, error);
    if (!result)
        result = gp_device_run(device, list, error);
    if (!result)
        work->triangles =
            least(work->triangles, (double)gp_device_counters(device)->primitives_drawn);
    gp_device_destroy(&device);
    return result;
}

GpResult bench_floor_find(GpDevice *device, const BenchRates *rates, const GpList *list,
                          BenchFloor *floor, GpError *error)
{
    Work work = { .operations = 0 };
    GpResult result = add_passes(device, list, &work, error);
    if (!result && work.triangles >= MANY_TRIANGLES && work.fragments <= FEW_FRAGMENTS)
        result = count_drawn(list, &work, error);
    *floor = (BenchFloor){ .operations_ms = work.operations / rates->operations,
                           .triangles_ms = work.triangles / rates->triangles };
    if (!result)
        result = bench_traffic_ms(gp_device_threads(device), (size_t)work.read,
                                  (size_t)work.written, &floor->traffic_ms, error);
    const double computed = floor->operations_ms + floor->triangles_ms;
    floor->ms = computed > floor->traffic_ms ? computed : floor->traffic_ms;
    return result;
}
