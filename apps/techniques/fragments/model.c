#include "apps/techniques/fragments/model.h"

#include "apps/base/text.h"
#include "apps/fragments/spheres.h"
#include "apps/scene/camera_file.h"
#include "apps/scene/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEFAULT_SIDE = 512, DEFAULT_LAYERS = 16 };

/* --- the mesh --------------------------------------------------------------------------------- */

/* An even number from 2 or more on, behind a colon; 0: there is none. Moves on behind it. */
static uint32_t read_even(const char **text, uint32_t usual, uint32_t least, uint32_t most)
{
    if (**text == '\0')
        return usual;
    char *end = NULL;
    const unsigned long number = **text == ':' ? strtoul(*text + 1, &end, 10) : 0;
    if (!end || end == *text + 1 || number < least || number > most || number % 2)
        return 0;
    *text = end;
    return (uint32_t)number;
}

/* What "builtin:spheres:N:C" asks for, layers and columns; no layers: it is another name. */
static GpResult find_spheres(const char *path, uint32_t *layers, uint32_t *columns, GpError *error)
{
    const char *count = model_after(path, "builtin:spheres");
    *layers = 0;
    if (!count || (*count != '\0' && *count != ':'))
        return GP_OK;
    *layers = read_even(&count, DEFAULT_LAYERS, 2, SPHERES_MOST);
    if (*layers == 0)
        return gp_fail(error, GP_ERROR_INVALID,
                       "%s: expected an even number of layers, 2 to %d, behind the colon", path,
                       SPHERES_MOST);
    *columns = read_even(&count, SPHERE_COLUMNS, 4, SPHERE_COLUMNS);
    if (*columns == 0 || *count)
        return gp_fail(error, GP_ERROR_INVALID,
                       "%s: expected an even number of columns, 4 to %d, behind the second colon",
                       path, SPHERE_COLUMNS);
    return GP_OK;
}

/* The size of a triangle's normal along each axis. */
static void color_by_normal(const GpMesh *file, const uint32_t corner[3], float color[3])
{
    double normal[3];
    fragment_normal(file->positions, corner, normal);
    for (int k = 0; k < 3; k++)
        color[k] = (float)fabs(normal[k]);
}

/* The mean of the corners' colours; a grey where the file has none. */
static void color_by_file(const GpMesh *file, const uint32_t corner[3], float color[3])
{
    for (int k = 0; k < 3; k++) {
        double sum = 0;
        for (int i = 0; i < 3; i++)
            sum += file->colors ? (double)file->colors[4 * (size_t)corner[i] + (size_t)k] : 0.8;
        color[k] = (float)fmin(fmax(sum / 3, 0), 1);
    }
}

static GpResult make_mesh(const FragmentOptions *options, FragmentModel *model, GpError *error)
{
    const GpMesh *file = &model->file;
    model->colors = gp_alloc(file->triangle_count, sizeof *model->colors);
    if (!model->colors)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for %u triangles", file->triangle_count);
    for (uint32_t i = 0; i < file->triangle_count; i++) {
        const uint32_t *corner = file->indices + 3 * (size_t)i;
        if (options->color == FRAGMENT_MATERIAL)
            color_by_file(file, corner, model->colors[i]);
        else
            color_by_normal(file, corner, model->colors[i]);
        model->colors[i][3] = (float)options->alpha;
    }
    model->mesh = (FragmentMesh){ .positions = (const float(*)[3])(const void *)file->positions,
                                  .vertex_count = file->vertex_count,
                                  .indices = file->indices,
                                  .triangle_count = file->triangle_count,
                                  .colors = (const float(*)[4])model->colors };
    const GpResult result =
        fragment_geometry_make(&model->mesh, options->sigma > 0, &model->geometry, error);
    model->mesh.drawn = &model->geometry.drawn;
    model->mesh.backwards = &model->geometry.backwards;
    return result;
}

/* --- the view --------------------------------------------------------------------------------- */

/* Along the view, of the nearest vertex, but not before the near plane. */
static double nearest_of(const GpMesh *file, const Camera *camera)
{
    const CameraAxes axes = camera_axes(camera, 1);
    double nearest = camera->far;
    for (uint32_t i = 0; i < file->vertex_count; i++) {
        double from[3];
        for (size_t k = 0; k < 3; k++)
            from[k] = (double)file->positions[3 * (size_t)i + k] - camera->eye[k];
        nearest = fmin(nearest, vector_dot(from, axes.forward));
    }
    return fmax(nearest, camera->near);
}

static bool is_default(const Orbit *orbit)
{
    const Orbit *usual = &fragment_option_defaults.orbit;
    return orbit->azimuth == usual->azimuth && orbit->elevation == usual->elevation &&
           orbit->up == usual->up && orbit->zoom == usual->zoom;
}

/* Spheres are seen along their columns, unless another place is asked for. */
static GpResult find_view(const TechniqueInput *input, uint32_t spheres, FragmentModel *model,
                          GpError *error)
{
    const FragmentOptions *options = input->setting;
    const GpMesh *file = &model->file;
    const bool sized = input->width > 0 && input->height > 0;
    FragmentView *view = &model->view;
    *view = (FragmentView){ .width = sized ? input->width : DEFAULT_SIDE,
                            .height = sized ? input->height : DEFAULT_SIDE,
                            .glass = { .is_on = options->sigma > 0,
                                       .sigma = options->sigma,
                                       .is_as_printed = options->is_as_printed } };
    if (spheres && is_default(&options->orbit))
        view->camera = spheres_camera(spheres);
    else {
        const Bounds bounds =
            bounds_of(file->positions, 3 * sizeof(float), file->indices, 3 * file->triangle_count);
        view->camera = orbit_camera(&options->orbit, &bounds, (double)view->width / view->height,
                                    bounds_longest(&bounds) * 1e-3);
    }
    const GpResult result =
        options->camera ? camera_read_file(options->camera, &view->camera, error) : GP_OK;
    view->glass.begin = nearest_of(file, &view->camera);
    return result;
}

GpResult fragment_model_open(const TechniqueInput *input, void **made, GpError *error)
{
    uint32_t spheres, columns;
    FragmentModel *model = gp_alloc(1, sizeof *model);
    if (!model)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    model->progress = input->progress;
    model->user = input->user;
    GpResult result = find_spheres(input->path, &spheres, &columns, error);
    if (!result && spheres && spheres_make(spheres, columns, &model->file))
        result = gp_fail(error, GP_ERROR_MEMORY, "%s: no memory", input->path);
    else if (!result && !spheres)
        result = model_mesh(input->path, &model->file, error);
    if (!result && model->file.triangle_count == 0)
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: has no triangles", input->path);
    if (!result)
        result = make_mesh(input->setting, model, error);
    if (!result)
        result = find_view(input, spheres, model, error);
    if (result) {
        fragment_model_close(model);
        return result;
    }
    *made = model;
    return GP_OK;
}

void fragment_model_close(void *made)
{
    FragmentModel *model = made;
    fragment_truth_free(&model->truth);
    convex_close(&model->convex);
    gp_free(model->facts);
    fragment_geometry_free(&model->geometry);
    gp_free(model->colors);
    gp_mesh_free(&model->file);
    gp_free(model);
}

/* --- what is known of the view ---------------------------------------------------------------- */

void fragment_model_look(FragmentModel *model, const Camera *camera)
{
    model->view.camera = *camera;
    model->view.glass.begin = nearest_of(&model->file, camera);
    model->count = (FragmentCount){ .layers = 0 };
    fragment_truth_free(&model->truth);
}

static bool tell_pieces(void *context, double share)
{
    const FragmentModel *model = context;
    const uint32_t total = model->mesh.triangle_count, done = (uint32_t)(share * total);
    if (model->progress)
        model->progress(model->user, done < total ? done : total - 1, total,
                        "triangles in convex pieces");
    return true;
}

GpResult fragment_model_convex(FragmentModel *model, const FragmentOptions *options, GpError *error)
{
    const PiecesSetting pieces = { .tolerance = options->tolerance,
                                   .outward = options->pieces == FRAGMENT_PIECES_OUTWARD,
                                   .merge = options->pieces == FRAGMENT_PIECES_MERGED };
    const ConvexSetting wanted = { .pieces = pieces,
                                   .has_partings = options->order == CONVEX_ORDER_GRID,
                                   .cache = options->cache,
                                   .progress = tell_pieces,
                                   .context = model };
    const PiecesSetting *made = &model->made.pieces;
    if (model->convex.pieces && pieces.tolerance == made->tolerance &&
        pieces.outward == made->outward && pieces.merge == made->merge &&
        (model->convex.partings || !wanted.has_partings))
        return GP_OK;
    convex_close(&model->convex);
    model->made = wanted;
    if (!model->facts)
        model->facts = gp_alloc(1, sizeof *model->facts);
    if (!model->facts)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    const GpResult result =
        convex_open(&model->mesh, &wanted, &model->convex, &model->cache_fault, error);
    if (!result && model->progress)
        model->progress(model->user, model->mesh.triangle_count, model->mesh.triangle_count, "");
    return result;
}

GpResult fragment_model_count(FragmentModel *model, GpDevice *device, GpError *error)
{
    return model->count.layers > 0
               ? GP_OK
               : fragment_count(&model->mesh, &model->view, NULL, device, &model->count, error);
}

GpResult fragment_model_truth(FragmentModel *model, int threads, GpError *error)
{
    const FragmentView *view = &model->view;
    const FragmentTruthScene scene = {
        .positions = model->mesh.positions,
        .indices = model->mesh.indices,
        .triangle_count = model->mesh.triangle_count,
        .colors = model->mesh.colors,
        .camera = view->camera,
        .width = view->width,
        .height = view->height,
        .is_glass = view->glass.is_on,
        .sigma = view->glass.sigma,
        .reflected = view->glass.is_as_printed ? 0 : FRAGMENT_REFLECTED,
        .begin = view->glass.begin,
    };
    GpPool *pool;
    if (model->truth.rgba)
        return GP_OK;
    GpResult result = gp_pool_create(threads, &pool, error);
    if (result)
        return result;
    result = fragment_truth_make(&scene, pool, &model->truth);
    gp_pool_destroy(&pool);
    return result ? gp_fail(error, result, "no memory for the truth") : GP_OK;
}
