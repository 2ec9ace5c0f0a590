#include "apps/depth_images/rivals/cells.h"

/* More leaves fewer holes behind edges, and wronger colours there. */
static const double usual_thickness = 0.1;

/* z of a pixel; those at the picture's rim go on outside. */
static float z_at(const DepthSlab *slab, const DepthPixels *pixels, int64_t x, int64_t y)
{
    x = x < 0 ? 0 : x >= pixels->width ? pixels->width - 1 : x;
    y = y < 0 ? 0 : y >= pixels->height ? pixels->height - 1 : y;
    return slab_z(slab, pixels->depth[(size_t)y * pixels->width + (size_t)x]);
}

GpResult depth_cells_open(const DepthSlab *slab, const DepthPixels *pixels, DepthCells *cells,
                          GpError *error)
{
    const double size[2] = { pixels->width, pixels->height };
    DepthCells made = { .z = NULL };
    int64_t low[2], count[2];
    for (int k = 0; k < 2; k++) { /* the first is before the first pixel */
        const double first = slab->first[k] * size[k] - 0.5, side = slab->side[k] * size[k];
        low[k] = (int64_t)floor(first);
        count[k] = (int64_t)floor(first + side) - low[k] + 1;
        made.first[k] = (float)(first - (double)low[k]);
        made.side[k] = (float)side;
    }
    const GpSurfaceDesc desc = { .format = GP_A32B32G32R32F,
                                 .width = (uint32_t)count[0],
                                 .height = (uint32_t)count[1] };
    const GpResult result = gp_surface_create(&desc, &made.z, error);
    if (result)
        return result;
    for (int64_t y = 0; y < count[1]; y++)
        for (int64_t x = 0; x < count[0]; x++) {
            float z[4];
            for (int corner = 0; corner < 4; corner++)
                z[corner] = z_at(slab, pixels, low[0] + x + corner % 2, low[1] + y + corner / 2);
            gp_texel_store(desc.format,
                           gp_surface_texel(&made.z->level[0], sizeof z, (uint32_t)x, (uint32_t)y),
                           z, 0);
        }
    *cells = made;
    return GP_OK;
}

void depth_cells_close(DepthCells *cells)
{
    gp_surface_destroy(&cells->z);
}

CellUniforms depth_cells_uniforms(const DepthCells *cells, double thickness)
{
    return (CellUniforms){
        .first = { cells->first[0], cells->first[1] },
        .side = { cells->side[0], cells->side[1] },
        .texel = { 1 / (float)cells->z->width, 1 / (float)cells->z->height },
        .thickness = (float)(thickness > 0   ? thickness
                             : thickness < 0 ? (double)SLAB_NOTHING
                                             : usual_thickness),
    };
}

void depth_cells_texture(const DepthCells *cells, GpDraw *draw)
{
    static const GpSampler points = { .address_u = GP_CLAMP, .address_v = GP_CLAMP };
    draw->textures[0] = (GpTexture){ cells->z, points };
}
