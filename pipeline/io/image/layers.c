#include "pipeline/io/image/layers.h"

#include <string.h>

int gp_layer_channel(const GpLayer *layer, const char *name)
{
    for (uint32_t c = 0; c < layer->channel_count; c++)
        if (strcmp(layer->channel[c], name) == 0)
            return (int)c;
    return -1;
}

void gp_layers_free(GpLayers *layers)
{
    for (uint32_t i = 0; i < layers->count; i++)
        gp_free(layers->layer[i].samples);
    memset(layers, 0, sizeof *layers);
}
