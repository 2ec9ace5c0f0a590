#include "apps/frame/window.h"

#include "pipeline/list/pass_target.h"

/* The target of any pass that a texture is; NULL: it is none. */
static GpSurface *find_target(const GpList *list, const GpSurface *texture)
{
    for (uint32_t p = 0; p < list->pass_count; p++)
        for (int t = 0; t <= GP_MAX_TARGETS; t++)
            if (texture && gp_pass_target(&list->passes[p], t) == texture)
                return gp_pass_target(&list->passes[p], t);
    return NULL;
}

static GpResult make_whole(GpSurface *surface, const GpPass *reader, GpError *error)
{
    GpError reason = { "" };
    const GpResult result = gp_surface_make_whole(surface, &reason);
    if (result != GP_ERROR_INVALID)
        return result ? gp_fail(error, result, "%s", reason.text) : GP_OK;
    return gp_fail(
        error, result,
        "pass '%s' reads what was drawn at other places too, so that all %ux%u pixels are "
        "needed at once, of at most %ux%u",
        reader->name ? reader->name : "", surface->width, surface->height, GP_MAX_SIZE,
        GP_MAX_SIZE);
}

/* Those that a pass's draws read: anywhere, or in place by a pass that draws the whole. */
static GpResult settle_reads(const GpList *list, const GpPass *pass, bool *changed, GpError *error)
{
    uint32_t width, height;
    gp_pass_size(pass, &width, &height);
    const GpRect window = gp_pass_window(pass);
    const bool whole =
        window.x1 - window.x0 == (int32_t)width && window.y1 - window.y0 == (int32_t)height;
    for (uint32_t i = 0; i < pass->draw_count; i++) {
        const GpProgram *program = pass->draws[i].program;
        const unsigned anywhere = program->samplers | program->vertex_samplers;
        unsigned read = anywhere | (whole ? program->local_reads : 0);
        for (; read; read &= read - 1) {
            const GpTexture *texture = &pass->draws[i].textures[__builtin_ctz(read)];
            GpSurface *surface = find_target(list, texture->surface);
            if (!surface || gp_surface_is_whole(surface))
                continue;
            const GpResult result = make_whole(surface, pass, error);
            if (result)
                return result;
            *changed = true;
        }
    }
    return GP_OK;
}

/* All targets of a pass are alike. */
static GpResult settle_targets(const GpPass *pass, bool *changed, GpError *error)
{
    bool whole = false;
    for (int t = 0; t <= GP_MAX_TARGETS; t++)
        whole = whole || (gp_pass_target(pass, t) && gp_surface_is_whole(gp_pass_target(pass, t)));
    for (int t = 0; t <= GP_MAX_TARGETS && whole; t++) {
        GpSurface *surface = gp_pass_target(pass, t);
        if (!surface || gp_surface_is_whole(surface))
            continue;
        const GpResult result = make_whole(surface, pass, error);
        if (result)
            return result;
        *changed = true;
    }
    return GP_OK;
}

GpResult window_settle(const GpList *list, GpError *error)
{
    GpResult result = GP_OK;
    for (bool changed = true; changed && !result;) {
        changed = false;
        for (uint32_t p = 0; p < list->pass_count && !result; p++) {
            result = settle_reads(list, &list->passes[p], &changed, error);
            if (!result)
                result = settle_targets(&list->passes[p], &changed, error);
        }
    }
    return result;
}

static int32_t step_up(int32_t at, uint32_t side)
{
    const int32_t up = (at + GP_WINDOW_STEP - 1) / GP_WINDOW_STEP * GP_WINDOW_STEP;
    return up < (int32_t)side ? up : (int32_t)side;
}

GpRect window_around(GpRect rect, uint32_t width, uint32_t height)
{
    return (GpRect){ rect.x0 / GP_WINDOW_STEP * GP_WINDOW_STEP,
                     rect.y0 / GP_WINDOW_STEP * GP_WINDOW_STEP, step_up(rect.x1, width),
                     step_up(rect.y1, height) };
}
