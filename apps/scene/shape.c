#include "apps/scene/shape.h"

#include "apps/base/vector.h"

#include <string.h>

GpResult shape_alloc(Shape *shape, uint32_t vertices, uint32_t indices)
{
    Shape made = { .vertices = gp_alloc(vertices, sizeof(ShapeVertex)),
                   .indices = indices ? gp_alloc(indices, sizeof(uint32_t)) : NULL,
                   .vertex_count = vertices,
                   .index_count = indices };
    if (!made.vertices || (indices && !made.indices)) {
        shape_free(&made);
        return GP_ERROR_MEMORY;
    }
    for (uint32_t i = 0; i < vertices; i++)
        for (int c = 0; c < 4; c++)
            made.vertices[i].color[c] = 1.0f;
    *shape = made;
    return GP_OK;
}

void shape_free(Shape *shape)
{
    gp_free(shape->vertices);
    gp_free(shape->indices);
    *shape = (Shape){ 0 };
}

void shape_set_vertex(ShapeVertex *vertex, ShapePoint *point)
{
    vector_normalize(point->normal);
    for (int i = 0; i < 3; i++) {
        vertex->position[i] = (float)(point->position[i] + 0.0); /* no -0: one place, one pattern */
        vertex->normal[i] = (float)point->normal[i];
    }
    vertex->texcoord[0] = (float)point->texcoord[0];
    vertex->texcoord[1] = (float)point->texcoord[1];
}

static bool same_place(const Shape *shape, uint32_t a, uint32_t b)
{
    return memcmp(shape->vertices[a].position, shape->vertices[b].position,
                  sizeof shape->vertices[a].position) == 0;
}

static void add_triangle(Shape *shape, uint32_t a, uint32_t b, uint32_t c)
{
    if (same_place(shape, a, b) || same_place(shape, b, c) || same_place(shape, c, a))
        return;
    shape->indices[shape->index_count++] = a;
    shape->indices[shape->index_count++] = b;
    shape->indices[shape->index_count++] = c;
}

static void add_patch(Shape *shape, const ShapePatch *patch)
{
    uint32_t first = shape->vertex_count, across = patch->columns + 1;
    for (uint32_t row = 0; row <= patch->rows; row++)
        for (uint32_t column = 0; column <= patch->columns; column++) {
            ShapePoint point = { .texcoord = { (double)column / patch->columns,
                                               (double)row / patch->rows } };
            patch->evaluate(patch, patch->columns_close ? column % patch->columns : column,
                            patch->rows_close ? row % patch->rows : row, &point);
            shape_set_vertex(&shape->vertices[shape->vertex_count++], &point);
        }
    for (uint32_t row = 0; row < patch->rows; row++)
        for (uint32_t column = 0; column < patch->columns; column++) {
            uint32_t at = first + row * across + column;
            add_triangle(shape, at, at + across, at + across + 1);
            add_triangle(shape, at, at + across + 1, at + 1);
        }
}

GpResult shape_from_patches(const ShapePatch *patches, int count, Shape *shape)
{
    uint32_t vertices = 0, indices = 0;
    for (int i = 0; i < count; i++) {
        vertices += (patches[i].columns + 1) * (patches[i].rows + 1);
        indices += patches[i].columns * patches[i].rows * 6;
    }
    GpResult result = shape_alloc(shape, vertices, indices);
    if (result)
        return result;
    shape->vertex_count = 0;
    shape->index_count = 0;
    for (int i = 0; i < count; i++)
        add_patch(shape, &patches[i]);
    return GP_OK;
}

void shape_compute_normals(Shape *shape)
{
    for (uint32_t i = 0; i < shape->vertex_count; i++)
        memset(shape->vertices[i].normal, 0, sizeof shape->vertices[i].normal);
    for (uint32_t i = 0; i + 2 < shape->index_count; i += 3) {
        ShapeVertex *corner[3];
        double a[3], b[3], normal[3];
        for (int k = 0; k < 3; k++)
            corner[k] = &shape->vertices[shape->indices[i + (uint32_t)k]];
        for (int k = 0; k < 3; k++) {
            a[k] = (double)corner[1]->position[k] - (double)corner[0]->position[k];
            b[k] = (double)corner[2]->position[k] - (double)corner[0]->position[k];
        }
        vector_cross(a, b, normal);
        for (int k = 0; k < 9; k++)
            corner[k / 3]->normal[k % 3] += (float)normal[k % 3];
    }
    for (uint32_t i = 0; i < shape->vertex_count; i++) {
        float *normal = shape->vertices[i].normal;
        double unit[3] = { (double)normal[0], (double)normal[1], (double)normal[2] };
        vector_normalize(unit);
        for (int k = 0; k < 3; k++)
            normal[k] = (float)unit[k];
    }
}
