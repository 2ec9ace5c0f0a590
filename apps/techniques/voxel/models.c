#include "apps/techniques/voxel/models.h"

#include "apps/base/text.h"
#include "apps/volumes/field.h"

#include <string.h>

/* --- opening ---------------------------------------------------------------------------------- */

/* Of a scan's longest side, where nothing else is said of the model inside. */
#define FIT_IN_SCAN 0.4

/* A mesh's vertices, where they are asked for. */
static void take_points(const VoxelOptions *options, VoxelScene *scene)
{
    if (options->takes_points && scene->input == VOXEL_MESH)
        scene->input = VOXEL_POINTS;
}

static GpResult open_all(const TechniqueInput *input, VoxelModels *models, GpError *error)
{
    const VoxelOptions *options = input->setting;
    GpResult result = voxel_scene_open(input->path, &models->scene, error);
    if (!result && options->with)
        result = voxel_scene_open(options->with, &models->second, error);
    if (!result && options->scan)
        result = field_read(options->scan, &models->scan, error);
    take_points(options, &models->scene);
    take_points(options, &models->second);
    return result;
}

/* Where the models lie, and what becomes of them. */
static void place(const TechniqueInput *input, VoxelModels *models)
{
    const VoxelOptions *options = input->setting;
    VoxelScene *scene = &models->scene;
    scene->twist = options->twist;
    scene->is_placed = options->box[0] > 0;
    scene->scale = options->box[0];
    memcpy(scene->offset, options->box + 1, sizeof scene->offset);
    text_copy(models->names[0], sizeof models->names[0], input->path);
    text_copy(models->names[1], sizeof models->names[1], options->with ? options->with : "");
    models->pair = (VoxelPair){ .scenes = { scene, options->with ? &models->second : NULL },
                                .names = { models->names[0], models->names[1] },
                                .place = options->place,
                                .combine = options->combine };
    if (options->scan && !scene->is_placed && !(options->place.fit > 0))
        models->pair.place.fit = FIT_IN_SCAN;
}

GpResult voxel_models_open(const TechniqueInput *input, void **scene, GpError *error)
{
    if (input->width || input->height)
        return gp_fail(error, GP_ERROR_INVALID, "a volume has no width and height, but --size N");
    VoxelModels *models = gp_alloc(1, sizeof *models);
    if (!models)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    GpResult result = open_all(input, models, error);
    if (result) {
        voxel_models_close(models);
        return result;
    }
    place(input, models);
    *scene = models;
    return GP_OK;
}

void voxel_models_close(void *scene)
{
    VoxelModels *models = scene;
    voxel_truths_free(&models->truths);
    voxel_scene_close(&models->scene);
    voxel_scene_close(&models->second);
    gp_volume_free(&models->scan);
    gp_free(models);
}

/* --- frames ----------------------------------------------------------------------------------- */

GpResult voxel_models_build(void *scene, const void *setting, GpDevice *device, Frame *frame,
                            GpError *error)
{
    const VoxelModels *models = scene;
    const VoxelOptions *options = setting;
    (void)device;
    VoxelMade made = { .setting = options->voxels };
    GpResult result = voxel_pair_build(&models->pair, &made.setting, frame, &made.pair, error);
    frame->color = made.pair.result.texels;
    frame->made = frame_copy(frame, &made, sizeof made);
    if (!result)
        result = frame_result(frame, error);
    if (result)
        frame_free(frame);
    return result;
}

void voxel_models_resolve(const void *scene, void *setting)
{
    VoxelOptions *options = setting;
    (void)scene;
    options->voxels = voxel_complete(&options->voxels);
}

GpResult voxel_models_show(void *scene, const void *setting, Frame *frame, GpError *error)
{
    const VoxelModels *models = scene;
    const VoxelMade *made = frame->made;
    VoxelPicture picture = ((const VoxelOptions *)setting)->picture;
    picture.shows_both = models->pair.scenes[1] && models->pair.combine == VOXEL_TOUCHING;
    picture.is_solid = made->setting.kind == VOXEL_SOLID;
    return voxel_picture_build(&picture, &made->pair, models->scan.data ? &models->scan : NULL,
                               frame, error);
}

GpResult voxel_models_volume(const Frame *frame, GpVolume *volume, GpError *error)
{
    static const GpVolumeType types[] = {
        [1] = GP_VOLUME_BITS, [8] = GP_VOLUME_U8, [16] = GP_VOLUME_U16
    };
    const VoxelMade *made = frame->made;
    const FlatTexture *texture = &made->pair.result;
    uint8_t *voxels = gp_alloc(flat_texture_bytes(texture), 1);
    if (!voxels)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    flat_texture_read(texture, voxels);
    *volume = (GpVolume){ .type = types[texture->bits], .data = voxels };
    const VoxelBox *box = &made->pair.boxes[0];
    for (int k = 0; k < 3; k++) {
        volume->dims[k] = texture->size;
        volume->spacing[k] = 1 / box->scale;
        volume->origin[k] = (0.5 - box->offset[k]) / box->scale;
    }
    return GP_OK;
}
