#include "apps/techniques/points/model.h"

#include "apps/scene/camera_file.h"
#include "apps/base/content.h"
#include "apps/base/machine.h"
#include "apps/base/vector.h"
#include "apps/scene/model.h"

#include <stdio.h>
#include <string.h>

/* --- surfels ---------------------------------------------------------------------------------- */

/* A builtin mesh is kept: it is the truth too. */
static GpResult open_builtin(PointsModel *model, PointsSource *source, GpPoints *points,
                             GpError *error)
{
    const char *set = model_after(model->path, "builtin:points/");
    const GpResult result =
        set ? model_points(set, points, error) : model_mesh(model->path, &model->mesh, error);
    source->points = set ? points : NULL;
    source->mesh = set ? NULL : &model->mesh;
    return result;
}

static GpResult read_surfels(const TechniqueInput *input, PointsModel *model, GpError *error)
{
    const PointsOptions *options = input->setting;
    PointsSource source = model->source;
    GpPoints points = { .count = 0 };
    GpPool *pool = NULL;
    GpResult result = GP_OK;
    if (model_after(input->path, "builtin:"))
        result = open_builtin(model, &source, &points, error);
    else
        source.path = model->path;
    if (!result)
        result = gp_pool_create(machine_processors(), &pool, error);
    if (!result)
        result = points_open(&source, pool, &model->surfels,
                             options->reports ? &model->facts : NULL, error);
    gp_pool_destroy(&pool);
    gp_points_free(&points);
    return result;
}

/* --- the cache -------------------------------------------------------------------------------- */

/* What surfels and patches are made by, besides the input. */
static uint64_t key_of(const TechniqueInput *input)
{
    const PointsOptions *options = input->setting;
    char settings[256];
    snprintf(settings, sizeof settings, "subdivide %u sample %u sharp %g one-radius %d color %s",
             options->subdivide, options->sample, options->sharp, options->one_radius,
             options->color ? options->color : "");
    return cache_key(content_hash(input->path, 0), settings);
}

/* The leaves of all patches. */
static GpResult take_leaves(const Patches *patches, Surfels *surfels)
{
    if (surfels_alloc(surfels, patches->leaf_count))
        return GP_ERROR_MEMORY;
    Surfel *to = surfels->surfels;
    for (uint32_t i = 0; i < patches->patch_count; i++) {
        const Patch *patch = &patches->patches[i];
        const PatchLevel *leaves = patch_levels(patches, patch) + patch->level_count - 1;
        memcpy(to, patches->surfels + leaves->first, leaves->count * sizeof *to);
        to += leaves->count;
    }
    surfels->had_colors = patches->has_colors;
    return GP_OK;
}

/* Whether the model came from its cache; where not, it is to be read and built. */
static bool read_cache(const TechniqueInput *input, PointsModel *model)
{
    const PointsOptions *options = input->setting;
    PackedModel packed;
    if (!options->cache)
        return false;
    model->cache = options->cache;
    model->cache_key = key_of(input);
    if (options->reports) /* tells of the input itself */
        return false;
    const GpResult result =
        cache_read(options->cache, model->cache_key, &packed, &model->cache_fault);
    if (result == GP_ERROR_IO) /* not there yet */
        model->cache_fault.text[0] = '\0';
    else if (result)
        strncat(model->cache_fault.text, ": built anew",
                sizeof model->cache_fault.text - strlen(model->cache_fault.text) - 1);
    if (result)
        return false;
    if (!packed.patches.surfels || take_leaves(&packed.patches, &model->surfels)) {
        packed_model_free(&packed);
        return false;
    }
    model->patches = packed.patches;
    model->file = packed.file;
    model->cache = NULL;
    return true;
}

/* A cache that cannot be written is worth a warning: the picture is the same. */
static void write_cache(PointsModel *model)
{
    const PackedModel packed = { .patches = model->patches };
    GpError error;
    if (model->cache && cache_write(model->cache, model->cache_key, &packed, &error))
        model->cache_fault = error;
    model->cache = NULL;
}

/* --- the view --------------------------------------------------------------------------------- */

enum { DEFAULT_SIDE = 1024 };

static Bounds surfels_bounds(const Surfels *surfels)
{
    return bounds_of(surfels->surfels->position, sizeof(Surfel), NULL, surfels->count);
}

static float find_mean_radius(const Surfels *surfels)
{
    double sum = 0;
    for (uint32_t i = 0; i < surfels->count; i++)
        sum += (double)surfels->surfels[i].radius;
    return (float)(sum / surfels->count);
}

static GpResult find_view(const TechniqueInput *input, const Surfels *surfels, SplatView *view,
                          GpError *error)
{
    const PointsOptions *options = input->setting;
    const bool sized = input->width > 0 && input->height > 0;
    *view = (SplatView){ .width = sized ? input->width : DEFAULT_SIDE,
                         .height = sized ? input->height : DEFAULT_SIDE };
    const Bounds bounds = surfels_bounds(surfels);
    view->camera = orbit_camera(&options->orbit, &bounds, (double)view->width / view->height,
                                bounds_longest(&bounds) * 1e-3);
    GpResult result = points_waves(options->color, &view->waves, error);
    if (!result && options->camera)
        result = camera_read_file(options->camera, &view->camera, error);
    view->lit = !options->unlit && !(view->waves > 0);
    return result;
}

/* What a float's last place is worth at the model's farthest coordinate. */
static double find_step(const Surfels *surfels)
{
    const Bounds bounds = surfels_bounds(surfels);
    const float most = (float)fmax(vector_extent(bounds.low), vector_extent(bounds.high));
    return (double)nextafterf(most, INFINITY) - (double)most;
}

/* --- opening ---------------------------------------------------------------------------------- */

static void paint(const PointsOptions *options, PointsModel *model)
{
    Surfels *surfels = &model->surfels;
    model->color = options->color ? points_color(options->color) : NULL;
    if (!model->color && !surfels->had_colors)
        model->color = points_color("clay");
    for (uint32_t i = 0; i < surfels->count && model->color; i++)
        memcpy(surfels->surfels[i].color, model->color, sizeof surfels->surfels[i].color);
}

GpResult points_model_open(const TechniqueInput *input, void **made, GpError *error)
{
    const PointsOptions *options = input->setting;
    PointsModel *model = gp_alloc(1, sizeof *model);
    if (!model)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    text_copy(model->path, sizeof model->path, input->path);
    model->source = (PointsSource){ .name = model->path,
                                    .subdivide = options->subdivide,
                                    .sample = options->sample,
                                    .sharp = options->sharp,
                                    .each_radius = !options->one_radius };
    model->listener = (PointsListener){ input->progress, input->user };
    const bool is_cached = read_cache(input, model);
    GpResult result = is_cached ? GP_OK : read_surfels(input, model, error);
    if (!result)
        result = find_view(input, &model->surfels, &model->view, error);
    if (result) {
        points_model_close(model);
        return result;
    }
    paint(options, model);
    model->mean_radius = find_mean_radius(&model->surfels);
    model->step = find_step(&model->surfels);
    *made = model;
    return GP_OK;
}

GpResult points_model_structure(PointsModel *model, int threads, GpError *error)
{
    GpPool *pool;
    if (model->patches.surfels)
        return GP_OK;
    GpResult result = gp_pool_create(threads, &pool, error);
    if (!result)
        result =
            patches_build(&model->surfels, NULL, pool, &model->listener, &model->patches, error);
    gp_pool_destroy(&pool);
    if (!result)
        write_cache(model);
    return result;
}

GpResult points_model_sequence(PointsModel *model, GpError *error)
{
    if (!model->sequence.nodes && sequence_build(&model->patches, &model->sequence))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    return GP_OK;
}

/* The triangles whose surface the points are: read again where only their points were kept. */
static GpResult read_triangles(PointsModel *model, GpError *error)
{
    GpError reason;
    if (model->mesh.triangle_count == 0 && model_mesh(model->path, &model->mesh, &reason))
        model->mesh.triangle_count = 0; /* a format of points */
    if (model->mesh.triangle_count == 0)
        return gp_fail(error, GP_ERROR_INVALID,
                       "the truth is the surface whose vertices the points are, and a file of "
                       "points has none");
    GpMesh surface;
    PointsFacts facts;
    const bool is_cut = model->source.sharp > 0 || model->source.sample > 0;
    if (model->is_surface || !is_cut) /* what vertices look like in the file is the truth of them */
        return GP_OK;
    if (points_surface(&model->source, &model->mesh, &surface, &facts))
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    gp_mesh_free(&model->mesh);
    model->mesh = surface;
    model->is_surface = true;
    return GP_OK;
}

GpResult points_model_truth(PointsModel *model, int threads, GpError *error)
{
    GpPool *pool;
    if (model->truth.color)
        return GP_OK;
    GpResult result = read_triangles(model, error);
    if (result)
        return result;
    result = gp_pool_create(threads, &pool, error);
    if (!result)
        result = points_truth_find(&model->mesh, model->color, &model->view, pool, &model->truth);
    gp_pool_destroy(&pool);
    return gp_fail(error, result, "out of memory");
}

uint64_t points_model_splats(const Frame *frame)
{
    /* the one before normalization, where there is one */
    const uint32_t count = frame->list.pass_count;
    const GpPass *pass = &frame->list.passes[count > 1 ? count - 2 : 0];
    uint64_t splats = 0;
    for (uint32_t i = 0; i < pass->draw_count; i++)
        splats += pass->draws[i].geometry.indices ? pass->draws[i].geometry.index_count / 6
                                                  : pass->draws[i].geometry.vertex_count;
    return splats;
}

double points_model_bytes(const PointsModel *model)
{
    const Patches *patches = &model->patches;
    return patches->surfels
               ? (double)patches_bytes(patches) + (double)patches->surfel_count * sizeof(Surfel)
               : (double)model->surfels.count * sizeof(Surfel);
}

void points_model_close(void *made)
{
    PointsModel *model = made;
    mesh_picture_free(&model->truth);
    sequence_free(&model->sequence);
    surfels_free(&model->surfels);
    if (model->file.data)
        gp_file_free(&model->file);
    else
        patches_free(&model->patches);
    gp_mesh_free(&model->mesh);
    gp_free(model);
}
