#include "apps/fragments/drawing/lists.h"

#include "apps/fragments/drawing/passes.h"
#include "apps/fragments/drawing/windows.h"
#include "shaders_c/fragments/lists.h"

typedef struct Lists {
    FragmentPasses passes;
    const ListSetting *setting;
    uint32_t count;     /* of layers */
    GpSurface **layer;  /* entries, by their places */
    GpSurface *stencil; /* how many fragments of a pixel there have been, and opaque depths */
    GpSurface *none;    /* no entry anywhere */
    /* of windows: */
    GpSurface *window[2];
    GpGeometry windowed;
} Lists;

static const float no_entry[4] = { LIST_NONE, LIST_NONE, LIST_NONE, LIST_NONE };

static bool begin(Lists *lists)
{
    FragmentPasses *passes = &lists->passes;
    Frame *frame = passes->frame;
    lists->layer = frame_alloc(frame, lists->count, sizeof *lists->layer);
    for (uint32_t i = 0; i < lists->count && lists->layer; i++)
        lists->layer[i] = fragment_surface(passes, GP_A32B32G32R32F);
    lists->stencil = fragment_surface(passes, GP_D24S8);
    lists->none = fragment_surface(passes, GP_A32B32G32R32F);
    frame_pass(frame, "none", lists->none, lists->stencil, no_entry);
    fragment_begin_depth(passes);
    return lists->layer;
}

static GpResult begin_windows(Lists *lists, GpError *error)
{
    FragmentPasses *passes = &lists->passes;
    const GpGeometry *drawn = passes->mesh->drawn;
    float *windows = frame_alloc(passes->frame, drawn->vertex_count, sizeof *windows);
    lists->windowed = *drawn;
    lists->windowed.streams[GP_TEXCOORD0] = (GpStream){ .data = windows, .components = 1 };
    for (int i = 0; i < 2; i++)
        lists->window[i] = fragment_surface(passes, GP_R32F);
    frame_pass(passes->frame, "windows", lists->window[1], NULL,
               (const float[4]){ -1, -1, -1, -1 });
    return windows ? fragment_windows(passes->mesh, passes->view, lists->setting->hazard, windows,
                                      error)
                   : frame_result(passes->frame, error);
}

/* --- the fragments at a place ----------------------------------------------------------------- */

/* Of targets 1 and 2 (shaders_c/fragments/lists.h). */
static void set_windows(const Lists *lists, uint32_t place, GpPass *pass, GpDraw *draw)
{
    draw->program = &list_window_program;
    draw->geometry = lists->windowed;
    draw->textures[0].surface = lists->window[(place + 1) % 2];
    draw->state.blend[2] = (GpBlend){ .op = GP_BLEND_MAX, .keep = 14 };
    pass->color[1] = (GpColorTarget){ lists->window[place % 2], true, { -1, -1, -1, -1 } };
    pass->color[2].surface = place ? lists->layer[place - 1] : lists->none;
    if (place == 0)
        draw->state.blend[2].keep = 15;
}

static void add_layer(Lists *lists, uint32_t place)
{
    FragmentPasses *passes = &lists->passes;
    GpPass *pass = frame_pass(passes->frame, "list", lists->layer[place], lists->stencil, no_entry);
    pass->depth.clear_depth = false;
    pass->depth.clear_stencil = true;
    passes->uniforms.place = (float)place;
    GpDraw *draw = lists->setting->is_packed ? fragment_draw(passes, &list_packed_program, NULL)
                                             : fragment_draw(passes, &list_program, NULL);
    draw->state.stencil = (GpStencilState){
        .enable = true,
        .reference = (uint8_t)place,
        .front = { .test = GP_EQUAL, .fail = GP_STENCIL_INCR_SAT, .pass = GP_STENCIL_INCR_SAT }
    };
    if (lists->setting->hazard)
        set_windows(lists, place, pass, draw);
}

/* --- in order --------------------------------------------------------------------------------- */

/* The four nearest of those behind `last`, into one or the other four: a pass for each LIST_AT_ONCE
 * of the list.
 * returns those that have them */
static GpSurface **find_nearest(const Lists *lists, GpSurface *last,
                                GpSurface *nearest[2][LIST_KEPT])
{
    GpSurface *read[LIST_KEPT + 1 + LIST_AT_ONCE];
    int now = 0;
    read[LIST_KEPT] = last;
    for (uint32_t first = 0; first < lists->count; first += LIST_AT_ONCE, now = !now) {
        for (int i = 0; i < LIST_KEPT; i++)
            read[i] = first ? nearest[!now][i] : lists->none;
        for (uint32_t i = 0; i < LIST_AT_ONCE; i++)
            read[LIST_KEPT + 1 + i] =
                first + i < lists->count ? lists->layer[first + i] : lists->none;
        fragment_whole(&lists->passes, "nearest", &list_nearest_program, NULL,
                       (FragmentSlots){ read, GP_COUNT(read), nearest[now], LIST_KEPT });
    }
    return nearest[!now];
}

static void put_together(const Lists *lists)
{
    const FragmentPasses *passes = &lists->passes;
    const uint32_t kept = lists->setting->nearest, most = lists->count;
    const uint32_t wanted = kept && kept < most ? kept : most;
    GpSurface *nearest[2][2][LIST_KEPT]; /* this round's, and those of the one before */
    for (int i = 0; i < 4 * LIST_KEPT; i++)
        nearest[i / (2 * LIST_KEPT)][i / LIST_KEPT % 2][i % LIST_KEPT] =
            fragment_surface(passes, GP_A32B32G32R32F);
    GpSurface *all = fragment_layers(passes);
    GpSurface *last = fragment_surface(passes, GP_A32B32G32R32F);
    frame_pass(passes->frame, "layers", all, NULL, fragment_nothing);
    frame_pass(passes->frame, "before", last, NULL,
               (const float[4]){ LIST_BEFORE, LIST_BEFORE, LIST_BEFORE, LIST_BEFORE });
    for (uint32_t done = 0, round = 0; done < wanted; done += LIST_KEPT, round++) {
        GpSurface **four = find_nearest(lists, last, nearest[round % 2]);
        const ListLayersUniforms uniforms = { .count = (float)(wanted - done) };
        fragment_whole(passes, "under", &list_layers_program, &uniforms,
                       (FragmentSlots){ four, LIST_KEPT, &all, 1 })
            ->state.blend[0] = fragment_under;
        last = four[LIST_KEPT - 1];
    }
    fragment_put_over(passes, all);
}

GpResult lists_add(const FragmentMesh *mesh, const ListSetting *setting, const FragmentView *view,
                   GpSurface *color, GpSurface *depth, Frame *frame, GpError *error)
{
    Lists lists = { .passes = fragment_passes(mesh, view, color, depth, frame),
                    .setting = setting,
                    .count = setting->layers };
    if (setting->first && setting->first < lists.count)
        lists.count = setting->first;
    if (lists.count > LIST_MOST)
        return gp_fail(error, GP_ERROR_UNSUPPORTED,
                       "a pixel has %u fragments: lists have at most %d", lists.count, LIST_MOST);
    const bool has_room = begin(&lists);
    const GpResult result =
        has_room && setting->hazard ? begin_windows(&lists, error) : frame_result(frame, error);
    for (uint32_t place = 0; place < lists.count && has_room && !result; place++)
        add_layer(&lists, place);
    if (lists.count > 0 && has_room && !result)
        put_together(&lists);
    return result ? result : frame_result(frame, error);
}
