#include "apps/scene/shape.h"

#include "apps/base/vector.h"

#include <string.h>

GpResult shape_alloc(Shape *shape, uint32_t vertices, uint32_t indices)
{
    Shape made = { .positions = gp_alloc(vertices, 3 * sizeof(float)),
                   .normals = gp_alloc(vertices, 3 * sizeof(float)),
                   .texcoords = gp_alloc(vertices, 2 * sizeof(float)),
                   .indices = indices ? gp_alloc(indices, sizeof(uint32_t)) : NULL,
                   .vertex_count = vertices,
                   .index_count = indices };
    if (!made.positions || !made.normals || !made.texcoords || (indices && !made.indices)) {
        shape_free(&made);
        return GP_ERROR_MEMORY;
    }
    *shape = made;
    return GP_OK;
}

GpResult shape_need_colors(Shape *shape)
{
    const size_t count = 4 * (size_t)shape->vertex_count;
    if (shape->colors)
        return GP_OK;
    shape->colors = gp_alloc(count, sizeof *shape->colors);
    for (size_t i = 0; i < count && shape->colors; i++)
        shape->colors[i] = 1.0f;
    return shape->colors ? GP_OK : GP_ERROR_MEMORY;
}

void shape_free(Shape *shape)
{
    gp_free(shape->positions);
    gp_free(shape->normals);
    gp_free(shape->texcoords);
    gp_free(shape->colors);
    gp_free(shape->sizes);
    gp_free(shape->indices);
    *shape = (Shape){ 0 };
}

void shape_set_vertex(Shape *shape, uint32_t i, ShapePoint *point)
{
    vector_normalize(point->normal);
    for (uint32_t k = 0; k < 3; k++) {
        const double no_minus_0 = point->position[k] + 0.0; /* one place, one pattern */
        shape->positions[3 * i + k] = (float)no_minus_0;
        shape->normals[3 * i + k] = (float)point->normal[k];
    }
    shape->texcoords[2 * i] = (float)point->texcoord[0];
    shape->texcoords[2 * i + 1] = (float)point->texcoord[1];
}

static bool same_place(const Shape *shape, uint32_t a, uint32_t b)
{
    return memcmp(shape->positions + 3 * a, shape->positions + 3 * b, 3 * sizeof(float)) == 0;
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
            shape_set_vertex(shape, shape->vertex_count++, &point);
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
    for (uint32_t i = 0; i < 3 * shape->vertex_count; i++)
        shape->normals[i] = 0;
    for (uint32_t i = 0; i + 2 < shape->index_count; i += 3) {
        const uint32_t *corner = &shape->indices[i];
        const float *at[3];
        double a[3], b[3], normal[3];
        for (int k = 0; k < 3; k++)
            at[k] = shape->positions + 3 * corner[k];
        for (int k = 0; k < 3; k++) {
            a[k] = (double)at[1][k] - (double)at[0][k];
            b[k] = (double)at[2][k] - (double)at[0][k];
        }
        vector_cross(a, b, normal);
        for (int k = 0; k < 9; k++)
            shape->normals[3 * corner[k / 3] + (uint32_t)(k % 3)] += (float)normal[k % 3];
    }
    for (uint32_t i = 0; i < shape->vertex_count; i++) {
        float *normal = shape->normals + 3 * i;
        double unit[3] = { (double)normal[0], (double)normal[1], (double)normal[2] };
        vector_normalize(unit);
        for (int k = 0; k < 3; k++)
            normal[k] = (float)unit[k];
    }
}
