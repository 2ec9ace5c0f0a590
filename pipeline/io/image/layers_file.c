#include "pipeline/io/image/layers_file.h"

#include "pipeline/io/image/image_codec.h"

static GpResult check_path(const char *path, GpError *error)
{
    return gp_file_has_extension(path, "exr")
               ? GP_OK
               : gp_fail(error, GP_ERROR_INVALID, "%s: expected a name that ends with .exr", path);
}

GpResult gp_layers_read(const char *path, const char *attribute, GpLayers *layers, GpError *error)
{
    GpImageSource source = { .path = path, .error = error, .format = GP_IMAGE_EXR };
    GpResult result = check_path(path, error);
    if (result == GP_OK)
        result = gp_file_read(path, &source.file, error);
    if (result != GP_OK)
        return result;
    result = gp_image_check_exr_parts(&source);
    if (result == GP_OK)
        result = gp_image_decode_layers(&source, attribute, layers);
    gp_file_free(&source.file);
    return result;
}

GpResult gp_layers_write(const char *path, const char *attribute, const GpLayers *layers,
                         GpError *error)
{
    GP_ASSERT(layers->count > 0 && layers->count <= GP_LAYERS);
    GpFile file = { .data = NULL };
    GpResult result = check_path(path, error);
    for (uint32_t i = 0; result == GP_OK && i < layers->count; i++) {
        const GpLayer *layer = &layers->layer[i];
        GP_ASSERT(layer->channel_count > 0 && layer->channel_count <= GP_LAYER_CHANNELS);
        if (layer->width == 0 || layer->height == 0 || layer->width > GP_IMAGE_SIDE_MAX ||
            layer->height > GP_IMAGE_SIDE_MAX)
            result = gp_fail(error, GP_ERROR_INVALID, "%s: a picture of %ux%u; sides are 1 to %d",
                             path, layer->width, layer->height, GP_IMAGE_SIDE_MAX);
    }
    if (result == GP_OK)
        result = gp_image_encode_layers(path, attribute, layers, &file, error);
    if (result == GP_OK)
        result = gp_file_write(path, file.data, file.size, error);
    gp_file_free(&file);
    return result;
}
