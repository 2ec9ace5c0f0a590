/* Lists: sizes and targets of passes, and which passes may run as a group. */
#include "pipeline/list/list.h"

#include "pipeline/list/pass_target.h"

static const GpSurface *first_target(const GpPass *pass)
{
    return pass->color[0].surface ? pass->color[0].surface : pass->depth.surface;
}

void gp_pass_size(const GpPass *pass, uint32_t *width, uint32_t *height)
{
    *width = first_target(pass)->width;
    *height = first_target(pass)->height;
}

GpRect gp_pass_window(const GpPass *pass)
{
    return first_target(pass)->window;
}

bool gp_pass_clears(const GpPass *pass)
{
    bool clears = pass->depth.surface && (pass->depth.clear_depth || pass->depth.clear_stencil);
    for (int i = 0; i < GP_MAX_TARGETS; i++)
        clears = clears || (pass->color[i].surface && pass->color[i].clear);
    return clears;
}

GpRect gp_pass_clear_part(const GpPass *pass, uint32_t i)
{
    const GpRect all = gp_pass_window(pass);
    return pass->clear_rect_count ? gp_rect_common(pass->clear_rects[i], all) : all;
}

bool gp_pass_renders_to(const GpPass *pass, const GpSurface *surface)
{
    for (int t = 0; t <= GP_MAX_TARGETS; t++)
        if (gp_surfaces_share(gp_pass_target(pass, t), surface))
            return true;
    return false;
}

/* --- memory of the caller's ------------------------------------------------------------------- */

/* The surfaces that a pass has at hand pixel by pixel: its targets, and what its draws read in
 * place. Calls `look` with each until that says true. */
static bool any_at_hand(const GpPass *pass,
                        bool (*look)(const GpSurface *surface, const GpPass *context),
                        const GpPass *context)
{
    for (int t = 0; t <= GP_MAX_TARGETS; t++)
        if (gp_pass_target(pass, t) && look(gp_pass_target(pass, t), context))
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
        if (gp_pass_target(writer, t) != surface &&
            gp_surfaces_share(gp_pass_target(writer, t), surface))
            return true;
    return false;
}

/* --- groups ----------------------------------------------------------------------------------- */

/* Surfaces that passes read at other places than a pixel's own, and those that they render to.
 * Frames have many passes and few surfaces. */
enum { SURFACES = 64 };
typedef struct SurfaceSet {
    const GpSurface *surface[SURFACES];
    uint32_t count;
    bool overflows;
} SurfaceSet;

typedef struct PassSurfaces {
    SurfaceSet read, written;
} PassSurfaces;

static void add_surface(SurfaceSet *set, const GpSurface *surface)
{
    for (uint32_t i = 0; i < set->count; i++)
        if (set->surface[i] == surface)
            return;
    if (set->count == SURFACES)
        set->overflows = true;
    else if (surface)
        set->surface[set->count++] = surface;
}

static void add_surfaces(SurfaceSet *set, const SurfaceSet *more)
{
    for (uint32_t i = 0; i < more->count; i++)
        add_surface(set, more->surface[i]);
    set->overflows = set->overflows || more->overflows;
}

static void remove_surfaces(PassSurfaces *surfaces)
{
    surfaces->read.count = surfaces->written.count = 0;
    surfaces->read.overflows = surfaces->written.overflows = false;
}

static void find_surfaces(const GpPass *pass, PassSurfaces *surfaces)
{
    remove_surfaces(surfaces);
    for (int t = 0; t <= GP_MAX_TARGETS; t++)
        add_surface(&surfaces->written, gp_pass_target(pass, t));
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        const GpDraw *draw = &pass->draws[i];
        unsigned anywhere = draw->program->samplers | draw->program->vertex_samplers;
        for (; anywhere; anywhere &= anywhere - 1)
            add_surface(&surfaces->read, draw->textures[__builtin_ctz(anywhere)].surface);
    }
}

static bool any_shared(const SurfaceSet *a, const SurfaceSet *b)
{
    for (uint32_t i = 0; i < a->count; i++)
        for (uint32_t k = 0; k < b->count; k++)
            if (gp_surfaces_share(a->surface[i], b->surface[k]))
                return true;
    return false;
}

/* A pass joins the group [first, pass) if it has its size, reads its targets only in place, renders
 * to nothing that the group reads elsewhere, and none of their texels has two names. (Nor where
 * there are more surfaces than a set has room for: groups are not owed.)
 * in   group, own: surfaces of the group and of the pass; some_borrowed: of the two, one has
 *      borrowed surfaces at all */
static bool joins(const GpList *list, uint32_t first, uint32_t pass, const PassSurfaces *group,
                  const PassSurfaces *own, bool some_borrowed)
{
    uint32_t width, height, group_width, group_height;
    gp_pass_size(&list->passes[first], &group_width, &group_height);
    gp_pass_size(&list->passes[pass], &width, &height);
    if (width != group_width || height != group_height ||
        !gp_rect_equal(gp_pass_window(&list->passes[first]), gp_pass_window(&list->passes[pass])))
        return false;
    if (group->read.overflows || group->written.overflows || own->read.overflows ||
        any_shared(&own->read, &group->written) || any_shared(&own->written, &group->read))
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
    bool some_borrowed = false;
    PassSurfaces group, own;
    remove_surfaces(&group);
    for (uint32_t pass = 0; pass < list->pass_count; pass++) {
        const bool borrows = any_at_hand(&list->passes[pass], is_borrowed, NULL);
        find_surfaces(&list->passes[pass], &own);
        some_borrowed = some_borrowed || borrows;
        if (pass == 0 || !joins(list, first, pass, &group, &own, some_borrowed)) {
            first = pass;
            group = own;
            some_borrowed = borrows;
            groups++;
        } else {
            add_surfaces(&group.read, &own.read);
            add_surfaces(&group.written, &own.written);
        }
        group_of[pass] = groups - 1;
    }
    return groups;
}
