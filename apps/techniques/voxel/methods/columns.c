/* Surfaces by columns: conservative and thin. A triangle is a point that carries its corners. */
#include "apps/techniques/voxel/methods/methods.h"
#include "apps/techniques/voxel/methods/lists.h"
#include "shaders_c/voxel/methods/columns.h"

#include <math.h>
#include <string.h>

enum { SLAB = 32, CORNERS = 9 }; /* voxels of a slab; floats of a triangle */

/* Longer than this in x or y, a triangle is drawn as a rectangle: a square round it has too many
 * columns that it does not cross. */
#define LONG_SIDE 24.0f

/* How a triangle is drawn. */
typedef enum Shape { ONE_COLUMN, SQUARE, RECTANGLE, NOT_AT_ALL, SHAPES } Shape;

static Shape shape_of(const VoxelExtent *extent, bool thin)
{
    if (extent->side > LONG_SIDE)
        return RECTANGLE;
    if (thin)
        return extent->meets_lines ? SQUARE : NOT_AT_ALL;
    return extent->in_column ? ONE_COLUMN : SQUARE;
}

/* Triangles by their shapes, in their order. */
static void sort_by_shape(const VoxelModel *model, Frame *frame, const VoxelExtent *extents,
                          bool thin, VoxelList lists[SHAPES])
{
    uint32_t *sorted = frame_alloc(frame, (size_t)model->triangle_count + 1, sizeof *sorted);
    uint32_t count[SHAPES] = { 0 }, next[SHAPES], first = 0;
    const uint32_t triangles = sorted && extents ? model->triangle_count : 0;
    for (uint32_t i = 0; i < triangles; i++)
        count[shape_of(&extents[i], thin)]++;
    for (int s = 0; s < SHAPES; s++) {
        lists[s] = (VoxelList){ count[s] ? sorted + first : NULL, count[s] };
        next[s] = first;
        first += count[s];
    }
    for (uint32_t i = 0; i < triangles; i++)
        sorted[next[shape_of(&extents[i], thin)]++] = i;
}

/* Whether a triangle may reach so many slabs beyond its lowest; one that moves may lie anywhere
 * over them. */
static bool reaches(const VoxelExtent *extent, float slabs)
{
    return floorf(extent->high / SLAB) - floorf(extent->low / SLAB) >= slabs;
}

/* --- streams ---------------------------------------------------------------------------------- */

static void copy_corners(const VoxelModel *model, uint32_t triangle, float corners[CORNERS])
{
    for (int j = 0; j < 3; j++)
        memcpy(corners + 3 * j,
               model->positions + 3 * (size_t)model->indices[3 * (size_t)triangle + (size_t)j],
               3 * sizeof *corners);
}

static void bind_corners(GpGeometry *geometry, const float *data, uint32_t stride)
{
    for (int j = 0; j < 3; j++)
        geometry->streams[GP_TEXCOORD0 + j] =
            (GpStream){ .data = data + 3 * j, .stride = stride, .components = 3 };
    geometry->streams[GP_POSITION] = geometry->streams[GP_TEXCOORD0];
}

/* One vertex for each triangle of a list. */
static GpGeometry make_points(const VoxelModel *model, Frame *frame, const uint32_t *list,
                              uint32_t count)
{
    float *corners = frame_alloc(frame, (size_t)count * CORNERS, sizeof *corners);
    if (!corners)
        return (GpGeometry){ .vertex_count = 0 };
    for (uint32_t i = 0; i < count; i++)
        copy_corners(model, list[i], corners + (size_t)i * CORNERS);
    GpGeometry points = { .primitive = GP_POINTS, .vertex_count = count };
    bind_corners(&points, corners, CORNERS * sizeof *corners);
    return points;
}

/* Four vertices and two triangles for each of a list. */
static GpGeometry make_rectangles(const VoxelModel *model, Frame *frame, const uint32_t *list,
                                  uint32_t count)
{
    enum { FLOATS = CORNERS + 1 };
    static const uint32_t halves[6] = { 0, 1, 2, 0, 2, 3 };
    float *vertices = frame_alloc(frame, (size_t)count * 4 * FLOATS, sizeof *vertices);
    uint32_t *indices = frame_alloc(frame, (size_t)count * 6, sizeof *indices);
    if (!vertices || !indices)
        return (GpGeometry){ .vertex_count = 0 };
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t j = 0; j < 4; j++) {
            float *vertex = vertices + ((size_t)i * 4 + j) * FLOATS;
            copy_corners(model, list[i], vertex);
            vertex[CORNERS] = (float)j;
        }
        for (uint32_t j = 0; j < 6; j++)
            indices[(size_t)i * 6 + j] = 4 * i + halves[j];
    }
    GpGeometry geometry = { .vertex_count = 4 * count,
                            .indices = indices,
                            .index_count = 6 * count };
    bind_corners(&geometry, vertices, FLOATS * sizeof *vertices);
    geometry.streams[GP_TEXCOORD3] = (GpStream){ .data = vertices + CORNERS,
                                                 .stride = FLOATS * sizeof *vertices,
                                                 .components = 1 };
    return geometry;
}

/* --- draws ------------------------------------------------------------------------------------ */

static void add_draw(const VoxelModel *model, Frame *frame, const FlatTexture *flat,
                     const GpProgram *program, uint32_t step, const GpGeometry *geometry)
{
    VoxelColumnsUniforms *uniforms = frame_alloc(frame, 1, sizeof *uniforms);
    if (!uniforms)
        return;
    *uniforms = (VoxelColumnsUniforms){ .flat = flat_texture_layout(flat), .step = (float)step };
    voxel_set_motion(model, frame, &uniforms->motion);
    frame_draw(frame, program, uniforms, geometry)->state.blend[0].op = GP_BLEND_LOGIC_OR;
}

/* Points of a draw: as many as stay in a core's caches from their vertices to their pixels. */
enum { POINTS_A_DRAW = 1 << 15 };

static const GpProgram *const touched[] = { [ONE_COLUMN] = &voxel_touched_column_program,
                                            [SQUARE] = &voxel_touched_program,
                                            [RECTANGLE] = &voxel_touched_rectangle_program };

static const GpProgram *const sampled[] = {
    [SQUARE] = &voxel_sampled_program, [RECTANGLE] = &voxel_sampled_rectangle_program
};

static void draw_list(const VoxelModel *model, Frame *frame, const FlatTexture *flat,
                      const GpProgram *program, bool rectangles, VoxelList list, uint32_t step)
{
    const uint32_t room = rectangles ? POINTS_A_DRAW / 4 : POINTS_A_DRAW;
    for (uint32_t done = 0; done < list.count; done += room) {
        const uint32_t *from = list.triangles + done;
        const uint32_t next = list.count - done < room ? list.count - done : room;
        GpGeometry geometry = rectangles ? make_rectangles(model, frame, from, next)
                                         : make_points(model, frame, from, next);
        add_draw(model, frame, flat, program, step, &geometry);
    }
}

void voxel_columns(const VoxelModel *model, const VoxelSetting *setting, Frame *frame,
                   const FlatTexture *flat)
{
    const bool thin = setting->method == VOXEL_THIN;
    const VoxelExtent *extents = voxel_extents(model, frame);
    VoxelList lists[SHAPES];
    sort_by_shape(model, frame, extents, thin, lists);
    flat_texture_pass(frame, thin ? "sampled" : "touched", flat);
    for (int s = 0; s < NOT_AT_ALL; s++) {
        VoxelList list = lists[s];
        for (uint32_t step = 0; list.count && step < flat->slabs; step++) {
            if (step) /* what reaches so far has reached all slabs before */
                list = voxel_choose(frame, extents, list, reaches, (float)step);
            draw_list(model, frame, flat, (thin ? sampled : touched)[s], s == RECTANGLE, list,
                      step);
        }
    }
}
