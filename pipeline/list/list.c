/* Lists: sizes and targets of passes, and which passes may run as a group. */
#include "pipeline/list/list.h"

void gp_pass_size(const GpPass *pass, uint32_t *width, uint32_t *height)
{
    const GpSurface *surface =
        pass->color[0].surface ? pass->color[0].surface : pass->depth.surface;
    *width = surface->width;
    *height = surface->height;
}

bool gp_pass_renders_to(const GpPass *pass, const GpSurface *surface)
{
    for (int t = 0; t < GP_MAX_TARGETS; t++)
        if (pass->color[t].surface == surface)
            return true;
    return pass->depth.surface == surface;
}

static bool reads_elsewhere(const GpPass *pass)
{
    for (uint32_t i = 0; i < pass->draw_count; i++)
        if (pass->draws[i].program->samplers | pass->draws[i].program->vertex_samplers)
            return true;
    return false;
}

/* Whether a pass reads something that `writer` renders to at other places than the pixel's own. */
static bool depends_elsewhere(const GpPass *pass, const GpPass *writer)
{
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        const GpDraw *draw = &pass->draws[i];
        unsigned anywhere = draw->program->samplers | draw->program->vertex_samplers;
        for (; anywhere; anywhere &= anywhere - 1)
            if (gp_pass_renders_to(writer, draw->textures[__builtin_ctz(anywhere)].surface))
                return true;
    }
    return false;
}

/* A pass joins the group [first, pass) if it has its size, reads its targets only in place, and
 * renders to nothing that the group reads elsewhere.
 * in   some_read: of the two, one reads elsewhere at all */
static bool joins(const GpList *list, uint32_t first, uint32_t pass, bool some_read)
{
    uint32_t width, height, group_width, group_height;
    gp_pass_size(&list->passes[first], &group_width, &group_height);
    gp_pass_size(&list->passes[pass], &width, &height);
    if (width != group_width || height != group_height)
        return false;
    for (uint32_t member = first; some_read && member < pass; member++)
        if (depends_elsewhere(&list->passes[pass], &list->passes[member]) ||
            depends_elsewhere(&list->passes[member], &list->passes[pass]))
            return false;
    return true;
}

uint32_t gp_list_groups(const GpList *list, uint32_t *group_of)
{
    uint32_t groups = 0, first = 0;
    bool some_read = false;
    for (uint32_t pass = 0; pass < list->pass_count; pass++) {
        bool reads = reads_elsewhere(&list->passes[pass]);
        some_read = some_read || reads;
        if (pass == 0 || !joins(list, first, pass, some_read)) {
            first = pass;
            some_read = reads;
            groups++;
        }
        group_of[pass] = groups - 1;
    }
    return groups;
}
