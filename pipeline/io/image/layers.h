/* Pictures of any named channels, several in a file: EXR files of one or more parts.
 *
 * Samples are floats, bit for bit those of the file (halves become floats), NaN and infinities too.
 * What they mean is told by the channels' names and by one attribute, a text, of each part.
 */
#ifndef GP_IO_LAYERS_H
#define GP_IO_LAYERS_H

#include "pipeline/base/base.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { GP_LAYERS = 8, GP_LAYER_CHANNELS = 16, GP_LAYER_NAME = 32, GP_LAYER_TEXT = 1024 };

/* Row 0 is the top one. Sample c of pixel (x, y) is number (y * width + x) * channel_count + c. */
typedef struct GpLayer {
    uint32_t width, height, channel_count;
    char channel[GP_LAYER_CHANNELS][GP_LAYER_NAME]; /* "R", "N.X"; in the order of the samples */
    char text[GP_LAYER_TEXT];                       /* of the attribute; "": it has none */
    float *samples;
} GpLayer;

typedef struct GpLayers {
    uint32_t count; /* parts of the file */
    GpLayer layer[GP_LAYERS];
} GpLayers;

/* Channel of a name; -1: there is none. */
int gp_layer_channel(const GpLayer *layer, const char *name);

void gp_layers_free(GpLayers *layers); /* a zeroed one is fine */

#ifdef __cplusplus
}
#endif

#endif
