/* Lists: sizes and targets of passes, and which passes may run as a group. */
#include "pipeline/list/list.h"

void gp_pass_size(const GpPass *pass, uint32_t *width, uint32_t *height)
{
    const GpSurface *surface =
        pass->color[0].surface ? pass->color[0].surface : pass->depth.surface;
    *width = surface->width;
    *height = surface->height;
}

GpRect gp_pass_clear_part(const GpPass *pass, uint32_t i)
{
    uint32_t width, height;
    gp_pass_size(pass, &width, &height);
    const GpRect all = { 0, 0, (int32_t)width, (int32_t)height };
    return pass->clear_rect_count ? gp_rect_common(pass->clear_rects[i], all) : all;
}

bool gp_pass_renders_to(const GpPass *pass, const GpSurface *surface)
{
    for (int t = 0; t < GP_MAX_TARGETS; t++)
        if (gp_surfaces_share(pass->color[t].surface, surface))
            return true;
    return gp_surfaces_share(pass->depth.surface, surface);
}

/* --- memory of the caller's ------------------------------------------------------------------- */

static const GpSurface *target_of(const GpPass *pass, int number)
{
    return number < GP_MAX_TARGETS ? pass->color[number].surface : pass->depth.surface;
}

/* The surfaces that a pass has at hand pixel by pixel: its targets, and what its draws read in place.
 * Calls `look` with each until that says true. */
static bool any_at_hand(const GpPass *pass,
                        bool (*look)(const GpSurface *surface, const GpPass *context),
                        const GpPass *context)
{
    for (int t = 0; t <= GP_MAX_TARGETS; t++)
        if (target_of(pass, t) && look(target_of(pass, t), context))
            return true;
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        const GpDraw *draw = &pass->draws[i];
        for (unsigned read = draw->program->local_reads; read; read &= read - 1)
            if (look(draw->textures[__builtin_ctz(read)].surface, context))
                return true;
    }
    return false;
}

static bool is_borrowed(const GpSurface *surface, const GpPass *context)
{
    (void)context;
    return surface && surface->borrowed;
}

/* Whether a pass renders to a surface's texels by another surface. */
static bool is_target_by_other_name(const GpSurface *surface, const GpPass *writer)
{
    for (int t = 0; t <= GP_MAX_TARGETS; t++)
        if (target_of(writer, t) != surface && gp_surfaces_share(target_of(writer, t), surface))
            return true;
    return false;
}

/* --- groups ----------------------------------------------------------------------------------- */

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

/* A pass joins the group [first, pass) if it has its size, reads its targets only in place, renders to
 * nothing that the group reads elsewhere, and none of their texels has two names.
 * in   some_read, some_borrowed: of the two, one reads elsewhere, or has borrowed surfaces, at all */
static bool joins(const GpList *list, uint32_t first, uint32_t pass, bool some_read,
                  bool some_borrowed)
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
    for (uint32_t member = first; some_borrowed && member < pass; member++)
        if (any_at_hand(&list->passes[pass], is_target_by_other_name, &list->passes[member]) ||
            any_at_hand(&list->passes[member], is_target_by_other_name, &list->passes[pass]))
            return false;
    return true;
}

uint32_t gp_list_groups(const GpList *list, uint32_t *group_of)
{
    uint32_t groups = 0, first = 0;
    bool some_read = false, some_borrowed = false;
    for (uint32_t pass = 0; pass < list->pass_count; pass++) {
        bool reads = reads_elsewhere(&list->passes[pass]);
        bool borrows = any_at_hand(&list->passes[pass], is_borrowed, NULL);
        some_read = some_read || reads;
        some_borrowed = some_borrowed || borrows;
        if (pass == 0 || !joins(list, first, pass, some_read, some_borrowed)) {
            first = pass;
            some_read = reads;
            some_borrowed = borrows;
            groups++;
        }
        group_of[pass] = groups - 1;
    }
    return groups;
}
