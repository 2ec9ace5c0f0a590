#include "apps/scene/objects.h"

#include "apps/scene/depth_images.h"
#include "apps/scene/materials.h"
#include "apps/scene/model.h"
#include "apps/scene/placing.h"
#include "apps/scene/splats.h"
#include "apps/scene/state.h"
#include "apps/scene/volumes.h"

#include <string.h>

enum {
    MAX_INLINE = 4096, /* vertices or triangles that a scene file may hold itself */
    FAR = 1000000,
};

/* --- where geometry comes from ---------------------------------------------------------------- */

static void read_triangles(const Node *triangles, Shape *shape)
{
    for (uint32_t i = 0; i < shape->index_count / 3; i++) {
        Node row = node_element(triangles, i);
        const long last = node_lacks(triangles) ? MAX_INLINE - 1 : (long)shape->vertex_count - 1;
        node_require(&row);
        if (!node_has_length(row, 3, "three vertex numbers"))
            continue;
        for (uint32_t k = 0; k < 3; k++)
            shape->indices[3 * i + k] = (uint32_t)node_integer(node_element(&row, k), 0, 0, last);
    }
}

/* Reads rows of numbers, one for each vertex, where there are any.
 * out    to: [vertices][count]; NULL: there was no memory, and no vertex */
static void read_rows(Node rows, uint32_t vertices, int count, float *to)
{
    if (node_exists(&rows) && node_length(rows, MAX_INLINE) != vertices)
        node_fail(&rows, GP_ERROR_FORMAT, "expected one row for each position");
    for (uint32_t i = 0; i < vertices && node_exists(&rows); i++, to += count) {
        Node row = node_element(&rows, i);
        node_require(&row);
        node_numbers(row, to, count, -FAR, FAR);
    }
}

/* A mesh that stands in the scene file: positions and triangles, and normals, texcoords and colors
 * of each vertex where they are given. */
static void read_inline(Node node, Shape *shape)
{
    node_define(&node, "mesh");
    Node positions = node_member(&node, "positions"), triangles = node_member(&node, "triangles");
    Node normals = node_member(&node, "normals"), colors = node_member(&node, "colors");
    node_require(&positions);
    node_require(&triangles);
    size_t vertices = node_length(positions, MAX_INLINE);
    size_t faces = node_length(triangles, MAX_INLINE);
    if (vertices == 0 || faces == 0)
        node_fail(&node, GP_ERROR_FORMAT, "no vertices or no triangles");
    else if (shape_alloc(shape, (uint32_t)vertices, (uint32_t)faces * 3))
        node_fail(&node, GP_ERROR_MEMORY, "no memory");
    read_triangles(&triangles, shape);
    const uint32_t count = shape->vertex_count;
    read_rows(positions, count, 3, shape->positions);
    read_rows(normals, count, 3, shape->normals);
    read_rows(node_member(&node, "texcoords"), count, 2, shape->texcoords);
    if (node_exists(&colors) && shape_need_colors(shape))
        node_fail(&node, GP_ERROR_MEMORY, "no memory");
    else
        read_rows(colors, count, 4, shape->colors);
    node_close(&node);
    if (node_lacks(&normals))
        shape_compute_normals(shape);
}

/* "mesh": a name, or the mesh itself; "points": a name. */
static void read_shape(const Node *node, bool points, Shape *shape)
{
    if (!points && node_is(node, JSON_OBJECT))
        read_inline(*node, shape);
    if (!points && !node_is_not(node, JSON_OBJECT))
        return;
    const char *name = node_string(*node, NULL);
    node_examples(node, "builtin:", points ? shape_points_name : shape_name);
    if (!name)
        return;
    GpError reason = { "" };
    GpResult result = model_shape(node->reader->file, name, points, shape, &reason);
    if (result)
        scene_fail(node, result, &reason);
}

/* --- vertices --------------------------------------------------------------------------------- */

/* "tile" [u, v]: texture coordinates times these. "size": the diameter of points. */
static void read_tile_and_size(Node tile_node, Node size_node, Shape *shape)
{
    float tile[2] = { 1, 1 };
    node_numbers(tile_node, tile, 2, -1000, 1000);
    float size = node_number(size_node, 0, 0, FAR);
    node_without_default(&size_node);
    for (size_t i = 0; i < 2 * (size_t)shape->vertex_count && shape->texcoords; i++)
        shape->texcoords[i] *= tile[i % 2];
    if (!node_exists(&size_node))
        return;
    shape->sizes = gp_alloc(shape->vertex_count, sizeof *shape->sizes);
    if (!shape->sizes)
        node_fail(&size_node, GP_ERROR_MEMORY, "no memory");
    for (uint32_t i = 0; i < shape->vertex_count && shape->sizes; i++)
        shape->sizes[i] = size;
}

/* Floats of a shape's vertices, from now on the frame's. */
static GpStream keep_floats(Frame *frame, float *floats, uint8_t components)
{
    return (GpStream){ .data = frame_own(frame, floats),
                       .stride = components * (uint32_t)sizeof *floats,
                       .components = components };
}

void scene_keep_shape(Frame *frame, Shape *shape, GpGeometry *geometry)
{
    const GpGeometry kept = {
        .primitive = shape->indices ? GP_TRIANGLES : GP_POINTS,
        .vertex_count = shape->vertex_count,
        .indices = frame_own(frame, shape->indices),
        .index_count = shape->index_count,
        .streams = { [GP_POSITION] = keep_floats(frame, shape->positions, 3),
                     [GP_NORMAL] = keep_floats(frame, shape->normals, 3),
                     [GP_TEXCOORD0] = keep_floats(frame, shape->texcoords, 2),
                     [GP_COLOR] = keep_floats(frame, shape->colors, 4),
                     [GP_POINT_SIZE] = keep_floats(frame, shape->sizes, 1) },
    };
    *shape = (Shape){ .positions = NULL };
    if (kept.streams[GP_POSITION].data)
        *geometry = kept;
}

void scene_complete_streams(Frame *frame, const GpProgram *program, GpGeometry *geometry)
{
    for (size_t i = 0; i < GP_COUNT(program->inputs) && program->inputs[i].components; i++) {
        const GpSemantic semantic = program->inputs[i].semantic;
        const bool is_optional =
            semantic == GP_TEXCOORD0 || semantic == GP_COLOR || semantic == GP_POINT_SIZE;
        if (!is_optional || geometry->streams[semantic].data)
            continue;
        GpStream *stream = &geometry->streams[semantic];
        const size_t floats = (size_t)geometry->vertex_count * stream->components;
        float *data = frame_alloc(frame, floats, sizeof *data);
        for (size_t at = 0; semantic == GP_COLOR && at < floats && data; at++)
            data[at] = 1.0f;
        stream->data = data;
    }
}

/* --- objects ---------------------------------------------------------------------------------- */

/* A mirror image's triangles are turned round, so that they keep their outside. */
static void turn_triangles(Shape *shape)
{
    for (uint32_t i = 0; i < shape->index_count; i += 3) {
        uint32_t swap = shape->indices[i + 1];
        shape->indices[i + 1] = shape->indices[i + 2];
        shape->indices[i + 2] = swap;
    }
}

static void color_shape(Node node, const PlacedVertices *vertices, Shape *shape)
{
    const SceneColor color = scene_color(node, vertices);
    if (color.given && shape_need_colors(shape))
        node_fail(&node, GP_ERROR_MEMORY, "no memory");
    for (size_t i = 0; i < shape->vertex_count && color.given && shape->colors; i++)
        scene_color_at(&color, shape->positions + 3 * i, shape->normals + 3 * i,
                       shape->colors + 4 * i);
}

/* Reads "mesh" or "points" and all that changes their vertices. */
static void read_geometry(Loader *loader, Node *node, GpGeometry *geometry)
{
    Node mesh = node_member(node, "mesh"), points = node_member(node, "points");
    Node fit = node_member(node, "fit"), transform = node_member(node, "transform");
    Node volume = node_member(node, "volume"), image = node_member(node, "depth_image");
    const Node *const shapes[] = { &mesh, &points, &volume, &image };
    Shape shape = { 0 };
    node_one_of(shapes, GP_COUNT(shapes), SCENE_SHAPES);
    if (node_exists(&mesh))
        read_shape(&mesh, false, &shape);
    if (node_exists(&points)) {
        shape_free(&shape);
        read_shape(&points, true, &shape);
    }
    if (!shape.vertex_count)
        node_fail(node, GP_ERROR_FORMAT, "no vertices");
    const PlacedVertices vertices = { shape.positions, shape.normals, 3 * sizeof(float),
                                      shape.vertex_count };
    if (scene_place(transform, fit, &vertices).mirrored)
        turn_triangles(&shape);
    color_shape(node_member(node, "color"), &vertices, &shape);
    read_tile_and_size(node_member(node, "tile"), node_member(node, "size"), &shape);
    scene_keep_shape(loader->frame, &shape, geometry);
}

/* What only some programs read is refused where the object's does not: a member of the vertices. */
static void refuse_unread(Node *object, const char *key, GpSemantic input, const GpDraw *draw)
{
    Node node = node_member(object, key);
    bool reads = !draw->program || node_lacks(&node);
    for (int i = 0; !reads && draw->program->inputs[i].components; i++)
        reads = draw->program->inputs[i].semantic == input;
    if (!reads)
        node_fail(&node, GP_ERROR_FORMAT, "program %s does not use it",
                  scene_program_name(draw->program));
}

static void read_drawn(Loader *loader, Node *node, const SceneView *view, GpDraw *draw)
{
    static const char *const of_splats[] = { "subdivide", "sample" }, *const of_images[] = {
        "pixels"
    };
    draw->name = scene_copy(loader, node_string(node_member(node, "name"), ""));
    SceneView own = *view; /* an object's viewport does not change the pass's matrix */
    scene_read_viewport(node_member(node, "viewport"), &own.viewport);
    draw->viewport = own.viewport;
    if (view->has_depth)
        draw->state.depth = (GpDepthState){ .test = GP_LESS_EQUAL, .write = true };
    read_geometry(loader, node, &draw->geometry);
    scene_read_state(node_member(node, "state"), view, &draw->state);
    if (!loader->reader.result)
        scene_read_material(loader, node_member(node, "material"), &own,
                            draw->geometry.primitive == GP_POINTS ? "sprite" : "phong", draw);
    if (draw->program)
        scene_complete_streams(loader->frame, draw->program, &draw->geometry);
    scene_refuse(node, of_splats, GP_COUNT(of_splats), "of splats: expected a method");
    scene_refuse(node, of_images, GP_COUNT(of_images), "of depth images: expected one");
    scene_refuse_without_volume(node);
    refuse_unread(node, "color", GP_COLOR, draw);
    refuse_unread(node, "tile", GP_TEXCOORD0, draw);
    refuse_unread(node, "size", GP_POINT_SIZE, draw);
}

void scene_read_object(Loader *loader, Node node, const SceneView *view)
{
    const GpGeometry none = { .vertex_count = 0 };
    node_define(&node, "object");
    Node volume = node_member(&node, "volume"), method = node_member(&node, "method");
    Node image = node_member(&node, "depth_image");
    if (node_exists(&volume))
        scene_read_volume(loader, &node, view);
    if (node_lacks(&volume) && node_exists(&image))
        scene_read_depth_image(loader, &node, view);
    if (node_lacks(&volume) && node_lacks(&image) && node_exists(&method))
        scene_read_splats(loader, &node, view);
    if (node_lacks(&volume) && node_lacks(&image) && node_lacks(&method))
        read_drawn(loader, &node, view, frame_draw(loader->frame, NULL, NULL, &none));
    node_close(&node);
}

void scene_read_quad(Loader *loader, Node node, const SceneView *view, GpDraw *draw)
{
    Shape shape = { 0 };
    node_define(&node, "quad");
    draw->name = "quad";
    draw->viewport = view->viewport;
    if (shape_create("quad", &shape))
        node_fail(&node, GP_ERROR_MEMORY, "no memory");
    scene_keep_shape(loader->frame, &shape, &draw->geometry);
    scene_read_state(node_member(&node, "state"), view, &draw->state);
    scene_read_material(loader, node_member(&node, "material"), view, "blit", draw);
    node_close(&node);
}
