/* Adaptive shadow maps: Fernando, Fernandez, Bala and Greenberg, SIGGRAPH 2001.
 *
 * DEVIATES: theirs is a quadtree that grows from frame to frame; here there are two levels, the map
 * and tiles of it, all chosen anew for each frame. A frame of ours is a list that is built once: a
 * level more would be a read-back more, and a page table that is read once for each level.
 *
 * What asks is drawn; what the processor does is what it does in the paper: it reads which tiles
 * were asked for and gives them places. */
#include "apps/scene/bounds.h"
#include "apps/techniques/shadow/adaptive.h"

#include <math.h>

enum {
    TILES = SHADOW_TILES,
    MAX_TILES = 256,   /* drawn again, of one map */
    FACTOR = 4,        /* texels of a tile to one of the map, a side */
    REQUEST_SHARE = 2, /* of the picture's pixels one in so many, each way, asks */
};

static const float nothing[4] = { 0 };

/* --- asking ----------------------------------------------------------------------------------- */

static GpSurface *draw_request(const ShadowBuild *build, const ShadowLight *light)
{
    Frame *frame = build->frame;
    const GpPass *scene = &build->scene->list.passes[0];
    uint32_t width = (build->scene->picture->width + REQUEST_SHARE - 1) / REQUEST_SHARE;
    uint32_t height = (build->scene->picture->height + REQUEST_SHARE - 1) / REQUEST_SHARE;
    GpSurface *request = frame_surface(frame, GP_R32F, width, height, 1);
    frame_pass(frame, "request", request, frame_surface(frame, GP_D32F, width, height, 1), nothing);
    for (uint32_t i = 0; i < scene->draw_count; i++)
        shadow_draw_object(build, light, &scene->draws[i], &shadow_request_program, true);
    return request;
}

/* A point for each pixel of the request: vertices that read a texture, in place of a read-back of
 * the whole picture. */
static GpSurface *draw_marks(const ShadowBuild *build, const GpSurface *request)
{
    static const ShadowMarkUniforms uniforms = { TILES };
    Frame *frame = build->frame;
    GpSurface *marks = frame_surface(frame, GP_A8R8G8B8, TILES, TILES, 1);
    uint32_t count = request->width * request->height;
    float(*pixel)[2] = frame_alloc(frame, count, sizeof *pixel);
    for (uint32_t i = 0; pixel && i < count; i++) {
        pixel[i][0] = ((float)(i % request->width) + 0.5f) / (float)request->width;
        pixel[i][1] = ((float)(i / request->width) + 0.5f) / (float)request->height;
    }
    GpGeometry points = { .primitive = GP_POINTS, .vertex_count = count };
    points.streams[GP_TEXCOORD0] = (GpStream){ .data = pixel, .components = 2 };
    frame_pass(frame, "mark", marks, NULL, nothing);
    GpDraw *draw = frame_draw(frame, &shadow_mark_program, &uniforms, &points);
    draw->textures[0].surface = request;
    return marks;
}

/* Runs the passes from `first` on. */
static GpResult run(const ShadowBuild *build, uint32_t first, GpError *error)
{
    const GpList *all = &build->frame->list;
    const GpList list = { all->passes + first, all->pass_count - first };
    return gp_device_run(build->device, &list, error);
}

/* --- places ----------------------------------------------------------------------------------- */

static uint32_t *texel(const GpSurface *surface, uint32_t tile)
{
    return (uint32_t *)(void *)gp_surface_texel(surface->level, 4, tile % TILES, tile / TILES);
}

/* Numbers of the marked tiles, row by row; those that the atlas has no room for stay as they are on
 * the map. */
static uint32_t find_marked(const GpSurface *marks, uint32_t room, uint32_t tiles[])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < TILES * TILES && count < room; i++)
        if (*texel(marks, i))
            tiles[count++] = i;
    return count;
}

static void fill_table(const uint32_t tiles[], uint32_t count, ShadowLight *light)
{
    for (uint32_t i = 0; light->table->level[0].texels && i < count; i++)
        *texel(light->table, tiles[i]) =
            0xff000000 | (i % light->columns) << 16 | (i / light->columns) << 8;
}

/* Tiles that are neighbours in the map and in the atlas, from tiles[0] on. */
static uint32_t run_length(const ShadowLight *light, const uint32_t tiles[], uint32_t slot,
                           uint32_t count)
{
    uint32_t length = 1;
    while (slot + length < count && (slot + length) % light->columns != 0 &&
           tiles[slot + length] == tiles[slot] + length && tiles[slot + length] % TILES != 0)
        length++;
    return length;
}

/* The map's view of `length` tiles in a row. */
static void crop(const double from[4][4], uint32_t tile, uint32_t length, float to[4][4])
{
    double x = (2.0 * (tile % TILES) + length) / TILES - 1;
    double y = 1 - (2.0 * (tile / TILES) + 1) / TILES;
    for (int i = 0; i < 4; i++) {
        to[0][i] = (float)((from[0][i] - x * from[3][i]) * TILES / length);
        to[1][i] = (float)((from[1][i] - y * from[3][i]) * TILES);
        to[2][i] = (float)from[2][i];
        to[3][i] = (float)from[3][i];
    }
}

/* False where all of a box is on the outer side of one of a view's four sides. */
static bool may_see(float clip[4][4], const Bounds *box)
{
    int outside[4] = { 0 };
    for (int corner = 0; corner < 8; corner++) {
        double out[4];
        for (int k = 0; k < 4; k++) {
            out[k] = (double)clip[k][3];
            for (int i = 0; i < 3; i++)
                out[k] += (double)clip[k][i] * (corner >> i & 1 ? box->high[i] : box->low[i]);
        }
        for (int k = 0; k < 2; k++) {
            outside[k] += out[k] > out[3];
            outside[2 + k] += out[k] < -out[3];
        }
    }
    for (int k = 0; k < 4; k++)
        if (outside[k] == 8)
            return false;
    return true;
}

static void draw_tiles(const ShadowBuild *build, ShadowLight *light, const uint32_t tiles[],
                       uint32_t count)
{
    const GpPass *scene = &build->scene->list.passes[0];
    Bounds *boxes = frame_alloc(build->frame, scene->draw_count, sizeof *boxes);
    float size = (float)light->tile;
    for (uint32_t i = 0; boxes && i < scene->draw_count; i++)
        boxes[i] = draw_bounds(&scene->draws[i]);
    for (uint32_t slot = 0, length; boxes && slot < count; slot += length) {
        float clip[4][4];
        length = run_length(light, tiles, slot, count);
        crop(light->view[0].clip, tiles[slot], length, clip);
        const void *uniforms = frame_copy(build->frame, clip, sizeof clip);
        const GpViewport viewport = { .x = (float)(slot % light->columns) * size,
                                      .y = (float)(slot / light->columns) * size,
                                      .width = (float)length * size,
                                      .height = size };
        for (uint32_t i = 0; i < scene->draw_count; i++)
            if (may_see(clip, &boxes[i]))
                shadow_draw_caster(build, light, i, uniforms, &viewport, true);
    }
}

GpResult shadow_draw_tiles(const ShadowBuild *build, ShadowLight *light, GpError *error)
{
    Frame *frame = build->frame;
    uint32_t first = frame->list.pass_count - 1;
    const GpSurface *marks = draw_marks(build, draw_request(build, light));
    GpResult result = frame_result(frame, error);
    if (!result)
        result = run(build, first, error);
    if (result)
        return result;

    uint32_t tiles[MAX_TILES];
    light->tile = light->size * FACTOR < TILES ? 1 : light->size * FACTOR / TILES;
    uint32_t side = GP_MAX_SIZE / light->tile, room = side * side;
    uint32_t count = find_marked(marks, room < MAX_TILES ? room : MAX_TILES, tiles);
    if (count == 0)
        return GP_OK;
    light->columns = (uint32_t)ceil(sqrt(count));
    light->rows = (count + light->columns - 1) / light->columns;
    light->table = frame_surface(frame, GP_A8R8G8B8, TILES, TILES, 1);
    light->atlas = frame_surface(frame, shadow_map_format(build->setting, light->source),
                                 light->columns * light->tile, light->rows * light->tile, 1);
    fill_table(tiles, count, light);
    frame_pass(frame, "tiles", NULL, light->atlas, NULL)->depth.clear_stencil =
        gp_format_info(light->atlas->format)->has_stencil;
    draw_tiles(build, light, tiles, count);
    return GP_OK;
}
