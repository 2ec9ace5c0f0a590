#include "pipeline/resources/surface_memory.h"

/* Levels from the given size down to 1x1. */
static uint32_t full_chain(uint32_t width, uint32_t height)
{
    uint32_t longer = width > height ? width : height;
    uint32_t levels = 1;
    for (; longer > 1; longer /= 2)
        levels++;
    return levels;
}

uint32_t gp_surface_levels(const GpSurfaceDesc *desc)
{
    const uint32_t most = full_chain(desc->width, desc->height);
    return desc->levels == 0 ? 1 : desc->levels < most ? desc->levels : most;
}

uint32_t gp_surface_level_side(uint32_t side, uint32_t level)
{
    return side >> level > 0 ? side >> level : 1;
}

uint64_t gp_surface_bytes(const GpSurfaceDesc *desc)
{
    const GpRect *window = &desc->window;
    uint64_t texels = 0;
    if (!gp_rect_is_empty(*window))
        return (uint64_t)(window->x1 - window->x0) * (uint64_t)(window->y1 - window->y0) *
               gp_format_info(desc->format)->bytes;
    for (uint32_t i = 0; i < gp_surface_levels(desc) && !desc->memory; i++)
        texels += (uint64_t)gp_surface_level_side(desc->width, i) *
                  gp_surface_level_side(desc->height, i);
    return texels * gp_format_info(desc->format)->bytes;
}
