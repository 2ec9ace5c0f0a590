#include "apps/techniques/points/model.h"

#include "apps/scene/camera_file.h"
#include "apps/base/content.h"
#include "apps/base/machine.h"
#include "apps/base/model_color.h"
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
    snprintf(settings, sizeof settings,
             "subdivide %u sample %u sharp %g one-radius %d compress %d color %s",
             options->subdivide, options->sample, options->sharp, options->one_radius,
             (int)options->compress, options->color ? options->color : "");
    return cache_key(content_hash(input->path, 0), settings);
}

static Compressed *kept_form(PointsModel *model)
{
    return model->keeps ? &model->compressed[model->keeps - 1] : NULL;
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
    if (model->keeps ? !packed.compressed.words : !packed.patches.surfels) {
        packed_model_free(&packed);
        return false;
    }
    model->patches = packed.patches;
    if (model->keeps)
        *kept_form(model) = packed.compressed;
    model->file = packed.file;
    model->cache = NULL;
    return true;
}

/* A cache that cannot be written is worth a warning: the picture is the same. */
static void write_cache(PointsModel *model)
{
    PackedModel packed = { .patches = model->patches };
    GpError error;
    if (model->keeps)
        packed.compressed = *kept_form(model);
    if (model->cache && cache_write(model->cache, model->cache_key, &packed, &error))
        model->cache_fault = error;
    model->cache = NULL;
}

/* --- the view --------------------------------------------------------------------------------- */

enum { DEFAULT_SIDE = 1024 };

static float mean_leaf_radius(const Patches *patches)
{
    double sum = 0;
    for (uint32_t i = 0; i < patches->patch_count; i++) {
        const Patch *patch = &patches->patches[i];
        const PatchLevel *leaves = patch_levels(patches, patch) + patch->level_count - 1;
        sum += leaves->count * (double)leaves->mean_radius;
    }
    return (float)(sum / patches->leaf_count);
}

/* The box of the points' centres, but of discs that are larger than it one that they fill. Radii
 * are rounded up to a power of two, which is the same of points from a cache. */
static Bounds find_seen(const PointsModel *model)
{
    Bounds seen = model->bounds;
    int power;
    if (bounds_longest(&seen) >= (double)model->mean_radius)
        return seen;
    frexp((double)model->mean_radius, &power);
    for (int k = 0; k < 3; k++) {
        seen.low[k] -= ldexp(1, power);
        seen.high[k] += ldexp(1, power);
    }
    return seen;
}

static GpResult find_view(const TechniqueInput *input, const Bounds *bounds, SplatView *view,
                          GpError *error)
{
    const PointsOptions *options = input->setting;
    const bool sized = input->width > 0 && input->height > 0;
    *view = (SplatView){ .width = sized ? input->width : DEFAULT_SIDE,
                         .height = sized ? input->height : DEFAULT_SIDE };
    view->camera = orbit_camera(&options->orbit, bounds, (double)view->width / view->height,
                                bounds_longest(bounds) * 1e-3);
    GpResult result = model_waves(options->color, &view->waves, error);
    if (!result && options->camera)
        result = camera_read_file(options->camera, &view->camera, error);
    view->lit = !options->unlit && !(view->waves > 0);
    return result;
}

/* What a float's last place is worth at the model's farthest coordinate. */
static double find_step(const Bounds *bounds)
{
    const float most = (float)fmax(vector_extent(bounds->low), vector_extent(bounds->high));
    return (double)nextafterf(most, INFINITY) - (double)most;
}

/* --- opening ---------------------------------------------------------------------------------- */

/* One colour for all: of the setting, or where there are none. */
static void paint(const PointsOptions *options, PointsModel *model)
{
    Surfels *surfels = &model->surfels;
    model->color = options->color ? model_color(options->color) : NULL;
    if (!model->color && !surfels->had_colors)
        model->color = model_color("clay");
    for (uint32_t i = 0; i < surfels->count && model->color; i++)
        memcpy(surfels->surfels[i].color, model->color, sizeof surfels->surfels[i].color);
    surfels->had_colors = !model->color;
}

/* The model's own points, from the cache or from the input. */
static GpResult find_points(const TechniqueInput *input, PointsModel *model, GpError *error)
{
    if (read_cache(input, model)) {
        model->point_count = model->patches.leaf_count;
        model->bounds = model->patches.bounds;
        model->surfels.had_colors = model->patches.has_colors;
        model->mean_radius = mean_leaf_radius(&model->patches);
        return GP_OK;
    }
    const GpResult result = read_surfels(input, model, error);
    if (result)
        return result;
    model->point_count = model->surfels.count;
    model->bounds = surfels_bounds(&model->surfels);
    model->mean_radius = surfels_mean_radius(&model->surfels);
    return GP_OK;
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
    model->keeps = options->compress;
    GpResult result = find_points(input, model, error);
    const Bounds seen = result ? model->bounds : find_seen(model);
    if (!result)
        result = find_view(input, &seen, &model->view, error);
    if (result) {
        points_model_close(model);
        return result;
    }
    paint(options, model);
    model->step = find_step(&model->bounds);
    *made = model;
    return GP_OK;
}

/* --- levels, and what is kept ----------------------------------------------------------------- */

/* Patches, and their packed form, from all that the model still has. */
static GpResult build_structure(PointsModel *model, PointsCompress form, GpPool *pool,
                                GpError *error)
{
    GpResult result = GP_OK;
    if (!model->patches.surfels)
        result =
            patches_build(&model->surfels, NULL, pool, &model->listener, &model->patches, error);
    if (result || !form)
        return result;
    if (model->keeps)
        surfels_free(&model->surfels); /* before the words need room */
    if (patches_compress(&model->patches, (CompressForm)(form - 1), pool,
                         &model->compressed[form - 1]))
        return gp_fail(error, GP_ERROR_MEMORY, "no memory to compress %u points",
                       model->point_count);
    if (model->keeps) {
        gp_free(model->patches.surfels);
        model->patches.surfels = NULL;
    }
    return GP_OK;
}

GpResult points_model_structure(PointsModel *model, PointsCompress form, int threads,
                                GpError *error)
{
    GpPool *pool = NULL;
    if (form ? model->compressed[form - 1].words != NULL : model->patches.surfels != NULL)
        return GP_OK;
    if (model->keeps && model->keeps != form)
        return gp_fail(error, GP_ERROR_INVALID, "the points are kept in another form");
    GpResult result = gp_pool_create(threads, &pool, error);
    if (!result)
        result = build_structure(model, form, pool, error);
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
    PointsFacts facts;
    const bool is_cut = model->source.sharp > 0 || model->source.sample > 0;
    if (model->is_surface || !is_cut) /* what vertices look like in the file is the truth of them */
        return GP_OK;
    if (points_surface(&model->source, &model->mesh, &facts)) {
        gp_mesh_free(&model->mesh); /* to be read again */
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    }
    model->is_surface = true;
    return GP_OK;
}

GpResult points_model_truth(PointsModel *model, int threads, GpError *error)
{
    GpPool *pool = NULL;
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

double points_model_bytes(const PointsModel *model, const PointsOptions *options)
{
    const double clips = (double)model->surfels.clip_count * sizeof(SurfelClip);
    const Patches *patches = &model->patches;
    if (options->compress)
        return (double)compressed_bytes(patches, &model->compressed[options->compress - 1]);
    return points_needs_patches(options)
               ? (double)patches_bytes(patches) + (double)patches->surfel_count * sizeof(Surfel)
               : (double)model->surfels.count * sizeof(Surfel) + clips;
}

void points_model_close(void *made)
{
    PointsModel *model = made;
    mesh_picture_free(&model->truth);
    sequence_free(&model->sequence);
    surfels_free(&model->surfels);
    if (model->file.data) {
        if (model->keeps)
            *kept_form(model) = (Compressed){ .words = NULL };
        gp_file_free(&model->file);
    } else {
        patches_free(&model->patches);
    }
    for (int i = 0; i < COMPRESS_FORMS; i++)
        compressed_free(&model->compressed[i]);
    gp_mesh_free(&model->mesh);
    gp_free(model);
}
