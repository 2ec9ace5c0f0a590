#include "pipeline/list.h"

void gp_pass_size(const GpPass *pass, uint32_t *width, uint32_t *height)
{
    const GpSurface *surface =
        pass->color[0].surface ? pass->color[0].surface : pass->depth.surface;
    *width = surface->width;
    *height = surface->height;
}

/* Whether a draw reads `surface` at other places than its own pixel. */
static bool reads_elsewhere(const GpDraw *draw, const GpSurface *surface)
{
    uint16_t anywhere = draw->program->samplers | draw->program->vertex_samplers;
    for (int i = 0; i < GP_MAX_SAMPLERS; i++)
        if ((anywhere >> i & 1) && draw->textures[i].surface == surface)
            return true;
    return false;
}

/* Whether a pass reads elsewhere in something that `writer` renders to. */
static bool depends_elsewhere(const GpPass *pass, const GpPass *writer)
{
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        for (int t = 0; t < GP_MAX_TARGETS; t++)
            if (writer->color[t].surface &&
                reads_elsewhere(&pass->draws[i], writer->color[t].surface))
                return true;
        if (writer->depth.surface && reads_elsewhere(&pass->draws[i], writer->depth.surface))
            return true;
    }
    return false;
}

/* A pass joins the group [first, pass) if it has its size, reads its targets only in place, and
 * renders to nothing that the group reads elsewhere. */
static bool joins(const GpList *list, uint32_t first, uint32_t pass)
{
    uint32_t width, height, group_width, group_height;
    gp_pass_size(&list->passes[first], &group_width, &group_height);
    gp_pass_size(&list->passes[pass], &width, &height);
    if (width != group_width || height != group_height)
        return false;
    for (uint32_t member = first; member < pass; member++)
        if (depends_elsewhere(&list->passes[pass], &list->passes[member]) ||
            depends_elsewhere(&list->passes[member], &list->passes[pass]))
            return false;
    return true;
}

uint32_t gp_list_groups(const GpList *list, uint32_t *group_of)
{
    uint32_t groups = 0, first = 0;
    for (uint32_t pass = 0; pass < list->pass_count; pass++) {
        if (pass == 0 || !joins(list, first, pass)) {
            first = pass;
            groups++;
        }
        group_of[pass] = groups - 1;
    }
    return groups;
}
