#include "apps/depth_images/depth_file.h"

#include "pipeline/io/file.h"
#include "pipeline/io/image/layers_file.h"

#include <stdio.h>

_Static_assert((int)DEPTH_TEXT <= (int)GP_LAYER_TEXT, "a place fits into a layer's text");
_Static_assert((int)DEPTH_MODEL_IMAGES <= (int)GP_LAYERS, "a model's images fit into a file");

static const char attribute[] = "depthImage";

/* Channels of a layer of pixels, in the order of their samples. */
enum { COLOR = 0, DEPTH = 3, NORMAL = 4, CHANNELS = 7 };
static const char *const names[2][CHANNELS] = {
    { "R", "G", "B", "Z", "N.X", "N.Y", "N.Z" },
    { "behind.R", "behind.G", "behind.B", "behind.Z", "behind.N.X", "behind.N.Y", "behind.N.Z" },
};

/* One channel of pixels: its first float, and how far it is to the next pixel's; NULL: not
 * there. */
static float *channel_of(const DepthPixels *pixels, int channel, size_t *step)
{
    *step = channel == DEPTH ? 1 : 3;
    return channel == DEPTH  ? pixels->depth
           : channel < DEPTH ? pixels->color + channel
           : pixels->normal  ? pixels->normal + (channel - NORMAL)
                             : NULL;
}

bool depth_file_is_readable(const char *path)
{
    return gp_file_has_extension(path, "exr");
}

/* --- writing ---------------------------------------------------------------------------------- */

static void add_channels(const DepthPixels *pixels, const char *const name[CHANNELS],
                         GpLayer *layer)
{
    for (int c = 0; pixels->width > 0 && c < (pixels->normal ? CHANNELS : NORMAL); c++)
        snprintf(layer->channel[layer->channel_count++], GP_LAYER_NAME, "%s", name[c]);
}

static void put_samples(const DepthPixels *pixels, GpLayer *layer, uint32_t first)
{
    for (int c = 0; pixels->width > 0 && c < CHANNELS; c++) {
        size_t step;
        const float *from = channel_of(pixels, c, &step);
        float *to = layer->samples + first + c;
        for (size_t i = 0; from && i < (size_t)layer->width * layer->height; i++)
            to[i * layer->channel_count] = from[i * step];
    }
}

static GpResult layer_of(const DepthImage *image, GpLayer *layer)
{
    layer->width = image->front.width;
    layer->height = image->front.height;
    depth_place_write(image, layer->text);
    add_channels(&image->front, names[0], layer);
    const uint32_t behind = layer->channel_count;
    add_channels(&image->behind, names[1], layer);
    layer->samples = gp_alloc((size_t)layer->width * layer->height,
                              layer->channel_count * sizeof *layer->samples);
    if (!layer->samples)
        return GP_ERROR_MEMORY;
    put_samples(&image->front, layer, 0);
    put_samples(&image->behind, layer, behind);
    return GP_OK;
}

GpResult depth_file_write(const char *path, const DepthModel *model, GpError *error)
{
    GP_ASSERT(model->count > 0 && model->count <= DEPTH_MODEL_IMAGES);
    GpLayers *layers = gp_alloc(1, sizeof *layers);
    GpResult result = layers ? GP_OK : GP_ERROR_MEMORY;
    for (uint32_t i = 0; result == GP_OK && i < model->count; i++) {
        layers->count++;
        result = layer_of(&model->images[i], &layers->layer[i]);
    }
    if (result == GP_OK)
        result = gp_layers_write(path, attribute, layers, error);
    else
        gp_fail(error, result, "%s: no memory for its pixels", path);
    if (layers)
        gp_layers_free(layers);
    gp_free(layers);
    return result;
}

/* --- reading ---------------------------------------------------------------------------------- */

/* Whether all of some channels are there, or none; `some` is one that is not beside one that is. */
static bool find_channels(const GpLayer *layer, const char *const name[], int count, int at[],
                          const char **missing)
{
    int found = 0;
    *missing = NULL;
    for (int c = 0; c < count; c++) {
        at[c] = gp_layer_channel(layer, name[c]);
        found += at[c] >= 0;
        *missing = at[c] < 0 ? name[c] : *missing;
    }
    if (found == 0)
        *missing = NULL;
    return found == count;
}

/* What is wrong with a pixel; NULL: nothing. */
static const char *fault_of(const DepthPixels *pixels, size_t i)
{
    if (!(pixels->depth[i] >= 0)) /* NaN too */
        return "a depth from 0 on, or infinite";
    double length = 0;
    for (size_t k = 3 * i; k < 3 * i + 3; k++) {
        if (!isfinite(pixels->color[k]))
            return "colours that are finite";
        const double n = pixels->normal ? (double)pixels->normal[k] : 0;
        length += n * n;
    }
    return length <= 1.01 ? NULL : "normals of length 1";
}

/* One layer of pixels. out pixels: of width 0 where it is not there */
static GpResult take_pixels(const char *place, const GpLayer *layer,
                            const char *const name[CHANNELS], DepthPixels *pixels, GpError *error)
{
    int at[CHANNELS];
    const char *missing, *other;
    const bool is_there = find_channels(layer, name, NORMAL, at, &missing);
    const bool has_normals = find_channels(layer, name + NORMAL, 3, at + NORMAL, &other);
    missing = missing || !is_there ? missing : other;
    if (missing || (!is_there && has_normals))
        return gp_fail(error, GP_ERROR_FORMAT, "%s: no channel %s", place,
                       missing ? missing : name[DEPTH]);
    if (!is_there)
        return GP_OK;
    if (depth_pixels_make(layer->width, layer->height, has_normals, pixels) != GP_OK)
        return gp_fail(error, GP_ERROR_MEMORY, "%s: no memory for %ux%u pixels", place,
                       layer->width, layer->height);
    for (int c = 0; c < (has_normals ? CHANNELS : NORMAL); c++) {
        size_t step;
        float *to = channel_of(pixels, c, &step);
        for (size_t i = 0; i < (size_t)layer->width * layer->height; i++)
            to[i * step] = layer->samples[i * layer->channel_count + (size_t)at[c]];
    }
    for (size_t i = 0; i < (size_t)layer->width * layer->height; i++) {
        const char *fault = fault_of(pixels, i);
        if (fault)
            return gp_fail(error, GP_ERROR_FORMAT, "%s: pixel (%zu, %zu) of %s: expected %s", place,
                           i % layer->width, i / layer->width, name[DEPTH], fault);
    }
    return GP_OK;
}

static GpResult take_image(const char *path, const GpLayers *layers, uint32_t part,
                           DepthImage *image, GpError *error)
{
    const GpLayer *layer = &layers->layer[part];
    char place[400];
    snprintf(place, sizeof place, layers->count > 1 ? "%.300s: part %u" : "%.300s", path, part);
    GpError reason = { "" };
    if (!layer->text[0])
        return gp_fail(error, GP_ERROR_FORMAT, "%s: not a depth image: no attribute %s", place,
                       attribute);
    if (depth_place_read(layer->text, image, &reason) != GP_OK)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: attribute %s: %s", place, attribute,
                       reason.text);
    if (image->is_cylinder && part > 0)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: a cylinder, expected a plane behind part 0",
                       place);
    GpResult result = take_pixels(place, layer, names[0], &image->front, error);
    if (result == GP_OK && image->front.width == 0)
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: no channel Z", place);
    return result == GP_OK ? take_pixels(place, layer, names[1], &image->behind, error) : result;
}

GpResult depth_file_read(const char *path, DepthModel *model, GpError *error)
{
    DepthModel read = { 0 };
    GpLayers *layers = gp_alloc(1, sizeof *layers);
    GpResult result = layers ? gp_layers_read(path, attribute, layers, error)
                             : gp_fail(error, GP_ERROR_MEMORY, "%s: no memory", path);
    if (result == GP_OK && layers->count > DEPTH_MODEL_IMAGES)
        result = gp_fail(error, GP_ERROR_FORMAT, "%s: %u parts; a depth image has at most %d", path,
                         layers->count, DEPTH_MODEL_IMAGES);
    for (uint32_t i = 0; result == GP_OK && i < layers->count; i++) {
        read.count++;
        result = take_image(path, layers, i, &read.images[i], error);
    }
    if (layers)
        gp_layers_free(layers);
    gp_free(layers);
    if (result == GP_OK)
        *model = read;
    else
        depth_model_free(&read);
    return result;
}
