#include "pipeline/fast/draws/clear.h"

#include "pipeline/base/lanes.h"

#include <string.h>

/* Fills the first row by doubling what is there, then copies it. */
static void fill_rows(uint8_t *row, size_t row_bytes, int32_t rows, size_t pitch,
                      const uint8_t *texel, size_t bytes)
{
    memcpy(row, texel, bytes);
    for (size_t done = bytes; done < row_bytes; done *= 2)
        memcpy(row + done, row, done < row_bytes - done ? done : row_bytes - done);
    for (int32_t y = 1; y < rows; y++)
        memcpy(row + (size_t)y * pitch, row, row_bytes);
}

static void store_rows_non_temporal(uint8_t *row, size_t row_bytes, int32_t rows, size_t pitch,
                                    const uint8_t *texel, size_t bytes)
{
    uint8_t several[sizeof(itg)];
    for (size_t at = 0; at < sizeof several; at += bytes)
        memcpy(several + at, texel, bytes);
    itg texels;
    memcpy(&texels, several, sizeof texels);
    for (int32_t y = 0; y < rows; y++, row += pitch)
        for (size_t at = 0; at < row_bytes; at += sizeof texels)
            itg_stream(row + at, texels);
    lanes_stream_end();
}

static void fill_box(const GpSurface *surface, const FastBox *box, const uint8_t *texel,
                     bool non_temporal)
{
    const GpLevel *level = &surface->level[0];
    const size_t bytes = gp_format_info(surface->format)->bytes;
    const size_t row_bytes = (size_t)(box->x1 - box->x0 + 1) * bytes;
    const int32_t rows = box->y1 - box->y0 + 1;
    uint8_t *row = gp_surface_texel(level, bytes, (uint32_t)box->x0, (uint32_t)box->y0);
    const bool even = ((uintptr_t)row | row_bytes | level->pitch) % sizeof(itg) == 0;
    if (non_temporal && even && fast_is_past_caches(surface))
        store_rows_non_temporal(row, row_bytes, rows, level->pitch, texel, bytes);
    else
        fill_rows(row, row_bytes, rows, level->pitch, texel, bytes);
}

/* Depth or stencil of D24S8 where the other one stays. */
static void fill_part(const GpDepthTarget *depth, const FastBox *box)
{
    const GpFormat format = depth->surface->format;
    const size_t bytes = gp_format_info(format)->bytes;
    const uint32_t new_code = gp_depth_code(format, depth->depth_value);
    for (int32_t y = box->y0; y <= box->y1; y++)
        for (int32_t x = box->x0; x <= box->x1; x++) {
            uint8_t *texel =
                gp_surface_texel(&depth->surface->level[0], bytes, (uint32_t)x, (uint32_t)y);
            uint32_t code;
            uint8_t stencil;
            gp_depth_load(format, texel, &code, &stencil);
            gp_depth_store(format, texel, depth->clear_depth ? new_code : code,
                           depth->clear_stencil ? depth->stencil_value : stencil);
        }
}

static void clear_part(const GpPass *pass, const FastBox *box, bool non_temporal)
{
    uint8_t texel[16];
    for (int t = 0; t < GP_MAX_TARGETS && pass->color[t].surface; t++) {
        if (!pass->color[t].clear)
            continue;
        gp_texel_store(pass->color[t].surface->format, texel, pass->color[t].clear_color, 0);
        fill_box(pass->color[t].surface, box, texel, non_temporal);
    }
    const GpDepthTarget *depth = &pass->depth;
    if (!depth->surface || !(depth->clear_depth || depth->clear_stencil))
        return;
    const GpFormat format = depth->surface->format;
    if (gp_format_info(format)->has_stencil && !(depth->clear_depth && depth->clear_stencil)) {
        fill_part(depth, box);
        return;
    }
    gp_depth_store(format, texel, gp_depth_code(format, depth->depth_value), depth->stencil_value);
    fill_box(depth->surface, box, texel, non_temporal);
}

FastBox fast_clear_part(const GpPass *pass, uint32_t i, const FastBox *box)
{
    const GpRect within = { box->x0, box->y0, box->x1 + 1, box->y1 + 1 };
    GpRect part = gp_rect_common(gp_pass_clear_part(pass, i), within);
    if (gp_rect_is_empty(part)) /* its ends may be any numbers */
        part = (GpRect){ 0, 0, 0, 0 };
    return (FastBox){ part.x0, part.y0, part.x1 - 1, part.y1 - 1 };
}

void fast_clear_box(const GpPass *pass, const FastBox *box, bool non_temporal)
{
    for (uint32_t i = 0; i < gp_pass_clear_parts(pass); i++) {
        const FastBox part = fast_clear_part(pass, i, box);
        if (!fast_box_is_empty(&part))
            clear_part(pass, &part, non_temporal);
    }
}
