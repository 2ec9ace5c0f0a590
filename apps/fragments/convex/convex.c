#include "apps/fragments/convex/convex.h"

#include "apps/fragments/convex/cells.h"
#include "apps/fragments/drawing/passes.h"
#include "apps/fragments/order/grid.h"
#include "apps/fragments/pieces/pieces_cache.h"
#include "shaders_c/fragments/convex.h"

#include <string.h>

/* --- for all views ---------------------------------------------------------------------------- */

/* What is told of pieces, and of what parts them, as of one work. */
typedef struct Told {
    const ConvexSetting *setting;
    double begin, part;
} Told;

static bool tell(void *context, double share)
{
    const Told *told = context;
    const ConvexSetting *setting = told->setting;
    return !setting->progress ||
           setting->progress(setting->context, told->begin + told->part * share);
}

/* Reads what there is; a cache that is not there yet is no fault. */
static GpResult read_cache(const ConvexSetting *setting, uint64_t key, Pieces *pieces,
                           PiecesBlock *block, GpError *fault)
{
    const GpResult result = pieces_read(setting->cache, key, pieces, block, fault);
    if (result == GP_ERROR_IO)
        fault->text[0] = '\0';
    return result;
}

static void write_cache(const ConvexModel *model, const ConvexSetting *setting, uint64_t key,
                        GpError *fault)
{
    PiecesBlock block = { NULL, 0 };
    if (model->partings && partings_pack(model->partings, &block))
        gp_fail(fault, GP_ERROR_MEMORY, "%s: no memory", setting->cache);
    else
        pieces_write(setting->cache, key, model->pieces, &block, fault);
    gp_free(block.bytes);
}

/* Those of a block, or new ones. */
static GpResult find_partings(ConvexModel *model, const ConvexSetting *setting,
                              const PiecesBlock *block, bool *is_new, GpError *error)
{
    Told told = { setting, 0.5, 0.5 };
    Partings *partings = gp_alloc(1, sizeof *partings);
    if (!partings)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    GpResult result = block->bytes ? partings_unpack(block, model->pieces, partings) : GP_ERROR_IO;
    if (result) {
        *is_new = true;
        result = partings_make(&model->order, tell, &told, partings, error);
    }
    if (result)
        gp_free(partings);
    else
        model->partings = partings;
    return result;
}

static GpResult find_all(const ConvexSetting *setting, uint64_t key, ConvexModel *model,
                         GpError *fault, GpError *error)
{
    const FragmentMesh *mesh = model->mesh;
    Told told = { setting, 0, setting->has_partings ? 0.5 : 1 };
    PiecesBlock block = { NULL, 0 };
    bool is_new = !setting->cache || read_cache(setting, key, model->pieces, &block, fault);
    GpResult result = GP_OK;
    if (is_new)
        result =
            pieces_make(mesh->positions, mesh->vertex_count, mesh->indices, mesh->triangle_count,
                        &setting->pieces, tell, &told, model->pieces, error);
    if (!result)
        result = order_mesh_make(mesh, model->pieces, &model->order, error);
    if (!result && setting->has_partings)
        result = find_partings(model, setting, &block, &is_new, error);
    if (!result && is_new && setting->cache)
        write_cache(model, setting, key, fault);
    gp_free(block.bytes);
    return result;
}

GpResult convex_open(const FragmentMesh *mesh, const ConvexSetting *setting, ConvexModel *model,
                     GpError *fault, GpError *error)
{
    ConvexModel made = { .mesh = mesh, .pieces = gp_alloc(1, sizeof *made.pieces) };
    fault->text[0] = '\0';
    if (!made.pieces)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    const uint64_t key = setting->cache
                             ? pieces_key(mesh->positions, mesh->vertex_count, mesh->indices,
                                          mesh->triangle_count, &setting->pieces)
                             : 0;
    const GpResult result = find_all(setting, key, &made, fault, error);
    if (result)
        convex_close(&made);
    else
        *model = made;
    return result;
}

void convex_close(ConvexModel *model)
{
    if (model->partings)
        partings_free(model->partings);
    gp_free(model->partings);
    order_mesh_free(&model->order);
    if (model->pieces)
        pieces_free(model->pieces);
    gp_free(model->pieces);
    *model = (ConvexModel){ .mesh = NULL };
}

/* --- one view --------------------------------------------------------------------------------- */

typedef struct Levels {
    FragmentPasses passes;
    const Pieces *pieces;
    const Screen *screen;
    const Order *order;
    Cells cells;
    GpSurface *near, *far, *all;
    GpSurface *layer[SLAB_LAYERS], *layer_depth[SLAB_LAYERS]; /* of slabs, by their places */
    /* how many fragments of a pixel there have been; NULL: knots, and no slabs */
    GpSurface *stencil;
    uint32_t *mark, *number; /* of the mesh's vertices: the last draw that has it, and where */
    uint32_t draws;
} Levels;

/* One vertex with all that draws take of it. */
typedef struct Vertex {
    float position[3], color[4], normal[3];
} Vertex;

/* The vertex of a mesh, and in `copied` what it is in a draw's own. */
static uint32_t copy_vertex(Levels *levels, uint32_t vertex, Vertex *copied, uint32_t *count)
{
    const GpStream *streams = levels->passes.mesh->drawn->streams;
    if (levels->mark[vertex] != levels->draws) {
        Vertex *to = &copied[*count];
        memcpy(to->position, (const float(*)[3])streams[GP_POSITION].data + vertex,
               sizeof to->position);
        memcpy(to->color, (const float(*)[4])streams[GP_COLOR].data + vertex, sizeof to->color);
        if (streams[GP_NORMAL].data)
            memcpy(to->normal, (const float(*)[3])streams[GP_NORMAL].data + vertex,
                   sizeof to->normal);
        levels->mark[vertex] = levels->draws;
        levels->number[vertex] = (*count)++;
    }
    return levels->number[vertex];
}

/* The mesh's faces of a list, those of pieces that are turned over turned. Their vertices are
 * copied, since draws shade all between the least and the greatest of their indices. */
static GpGeometry faces_geometry(Levels *levels, const uint32_t *faces, uint32_t count)
{
    Frame *frame = levels->passes.frame;
    const uint32_t *indices = levels->passes.mesh->drawn->indices;
    uint32_t *index = frame_alloc(frame, count, 3 * sizeof *index), vertices = 0;
    Vertex *copied = frame_alloc(frame, count, 3 * sizeof *copied);
    levels->draws++;
    for (uint32_t i = 0; i < 3 * count && index && copied; i++) {
        const uint32_t face = faces[i / 3], piece = levels->pieces->piece_of[face];
        const uint32_t corner = levels->pieces->inward[piece] ? (3 - i % 3) % 3 : i % 3;
        index[i] = copy_vertex(levels, indices[3 * (size_t)face + corner], copied, &vertices);
    }
    return (GpGeometry){ .vertex_count = vertices,
                         .indices = index,
                         .index_count = 3 * count,
                         .streams = { [GP_POSITION] = { copied[0].position, sizeof *copied, 3 },
                                      [GP_COLOR] = { copied[0].color, sizeof *copied, 4 },
                                      [GP_NORMAL] = { copied[0].normal, sizeof *copied, 3 } } };
}

static void use_cells(Levels *levels, const uint32_t *faces, uint32_t count)
{
    cells_clear(&levels->cells);
    for (uint32_t i = 0; i < count; i++)
        cells_use(&levels->cells, &levels->screen->faces[faces[i]].box);
}

static void draw_sides(Levels *levels, const uint32_t *faces, uint32_t count)
{
    const FragmentPasses *passes = &levels->passes;
    Frame *frame = passes->frame;
    const GpGeometry geometry = faces_geometry(levels, faces, count);
    GpPass *pass = fragment_pass(passes, "sides", levels->near, 0);
    pass->color[1] = (GpColorTarget){ .surface = levels->far, .clear = true };
    pass->clear_rects = cells_rects(&levels->cells, frame, &pass->clear_rect_count);
    GpDraw *draw = fragment_draw(passes, &convex_program, &convex_glass_program);
    draw->geometry = geometry;
    draw->state.blend[0] = draw->state.blend[1] = (GpBlend){ .op = GP_BLEND_MAX };
}

/* Both sides go under what is there, where the level has anything. */
static void join_sides(Levels *levels)
{
    Frame *frame = levels->passes.frame;
    const GpGeometry geometry = cells_geometry(&levels->cells, frame);
    frame_pass(frame, "join", levels->all, NULL, fragment_nothing)->color[0].clear = false;
    GpDraw *draw = frame_draw(frame, &convex_join_program, NULL, &geometry);
    draw->textures[0].surface = levels->near;
    draw->textures[1].surface = levels->far;
    draw->state.blend[0] = fragment_under;
}

static void draw_knots(Levels *levels, const uint32_t *faces, uint32_t count)
{
    const FragmentPasses *passes = &levels->passes;
    const GpGeometry geometry = faces_geometry(levels, faces, count);
    GpPass *pass = fragment_pass(passes, "knots", levels->all, 0);
    pass->color[0].clear = false;
    pass->order = GP_ORDER_DEPTH_NEAR_FIRST;
    GpDraw *draw = fragment_draw(passes, &convex_knot_program, &convex_knot_glass_program);
    draw->geometry = geometry;
    draw->state.blend[0] = fragment_under;
}

static void begin_slabs(Levels *levels)
{
    const FragmentPasses *passes = &levels->passes;
    for (int i = 0; i < SLAB_LAYERS; i++) {
        levels->layer[i] = fragment_surface(passes, GP_A32B32G32R32F);
        levels->layer_depth[i] = fragment_surface(passes, GP_R32F);
    }
    levels->stencil = fragment_surface(passes, GP_D24S8);
    frame_pass(passes->frame, "slabs", NULL, levels->stencil, fragment_nothing);
    fragment_begin_depth(passes);
}

/* Of each pixel the fragment at a place in the order of drawing. */
static void draw_layer(Levels *levels, const GpGeometry *geometry, uint32_t place)
{
    const FragmentPasses *passes = &levels->passes;
    GpPass *pass =
        frame_pass(passes->frame, "slab", levels->layer[place], levels->stencil, fragment_nothing);
    pass->color[1] = (GpColorTarget){ levels->layer_depth[place], true, { SLAB_NONE } };
    pass->depth.clear_depth = false;
    pass->depth.clear_stencil = true;
    pass->clear_rects = cells_rects(&levels->cells, passes->frame, &pass->clear_rect_count);
    GpDraw *draw = fragment_draw(passes, &convex_slab_program, &convex_slab_glass_program);
    draw->geometry = *geometry;
    draw->state.stencil = (GpStencilState){
        .enable = true,
        .reference = (uint8_t)place,
        .front = { .test = GP_EQUAL, .fail = GP_STENCIL_INCR_SAT, .pass = GP_STENCIL_INCR_SAT }
    };
}

/* Slabs that share no pixel, by the stencil-routed k-buffer. */
static void draw_slabs(Levels *levels, const uint32_t *faces, uint32_t count)
{
    Frame *frame = levels->passes.frame;
    const GpGeometry geometry = faces_geometry(levels, faces, count);
    use_cells(levels, faces, count);
    for (uint32_t place = 0; place < SLAB_LAYERS; place++)
        draw_layer(levels, &geometry, place);
    const GpGeometry cells = cells_geometry(&levels->cells, frame);
    frame_pass(frame, "join", levels->all, NULL, fragment_nothing)->color[0].clear = false;
    GpDraw *draw = frame_draw(frame, &convex_slab_join_program, NULL, &cells);
    for (int i = 0; i < SLAB_LAYERS; i++) {
        draw->textures[i].surface = levels->layer[i];
        draw->textures[SLAB_LAYERS + i].surface = levels->layer_depth[i];
    }
    draw->state.blend[0] = fragment_under;
}

static void draw_levels(Levels *levels)
{
    const Order *order = levels->order;
    for (uint32_t i = 0; i < order->level_count; i++) {
        const uint32_t *faces = order->faces + order->first[i];
        const uint32_t *knots = order->knots + order->knot_first[i];
        const uint32_t count = order->first[i + 1] - order->first[i];
        const uint32_t knot_count = order->knot_first[i + 1] - order->knot_first[i];
        if (count > 0) {
            use_cells(levels, faces, count);
            draw_sides(levels, faces, count);
            join_sides(levels);
        }
        if (knot_count > 0 && levels->stencil)
            draw_slabs(levels, knots, knot_count);
        else if (knot_count > 0)
            draw_knots(levels, knots, knot_count);
    }
}

static GpResult add_levels(const ConvexModel *model, ConvexOrder by, FragmentPasses passes,
                           const Screen *screen, const Order *order)
{
    const FragmentView *view = passes.view;
    Levels levels = { .passes = passes,
                      .pieces = model->pieces,
                      .screen = screen,
                      .order = order,
                      .cells = cells_make(passes.frame, view->width, view->height),
                      .near = fragment_surface(&passes, GP_A32B32G32R32F),
                      .far = fragment_surface(&passes, GP_A32B32G32R32F),
                      .all = fragment_surface(&passes, GP_A32B32G32R32F) };
    frame_pass(passes.frame, "nothing", levels.all, NULL, fragment_nothing);
    if (by == CONVEX_ORDER_GRID)
        begin_slabs(&levels);
    levels.mark = gp_alloc(passes.mesh->drawn->vertex_count, sizeof *levels.mark);
    levels.number = gp_alloc(passes.mesh->drawn->vertex_count, sizeof *levels.number);
    const bool has_room = levels.mark && levels.number && levels.cells.is_used;
    if (has_room)
        draw_levels(&levels);
    gp_free(levels.mark);
    gp_free(levels.number);
    if (!has_room)
        return GP_ERROR_MEMORY;
    fragment_put_over(&passes, levels.all);
    return GP_OK;
}

GpResult convex_add(const ConvexModel *model, ConvexOrder by, const FragmentView *view,
                    GpSurface *color, GpSurface *depth, Frame *frame, ConvexFacts *facts,
                    GpError *error)
{
    Screen screen = { .faces = NULL };
    Order order = { .level_count = 0 };
    GpResult result = screen_make(model->mesh, view, &screen, error);
    if (!result)
        result = by == CONVEX_ORDER_GRID
                     ? order_by_grid(&model->order, model->partings, view, &screen, &order, error)
                     : order_find(&model->order, view, &screen, &order, error);
    if (!result) {
        result = add_levels(model, by, fragment_passes(model->mesh, view, color, depth, frame),
                            &screen, &order);
        if (facts)
            *facts = (ConvexFacts){ model->pieces->count, order.level_count,
                                    order.sides,          order.split_sides,
                                    order.knot_count,     order.knot_first[order.level_count] };
        result = result ? gp_fail(error, result, "out of memory") : frame_result(frame, error);
    }
    order_free(&order);
    screen_free(&screen);
    return result;
}
