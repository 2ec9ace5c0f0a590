#include "tests/support/random_geometry.h"

#include "pipeline/base/base.h"

#include <math.h>

enum { VERTEX_FLOATS = 10, SOUP_VERTICES = 96, MESH_SIDE = 24, LAYERS = 6, CLOUD_POINTS = 1500 };

bool random_chance(Random *r, int percent)
{
    return random_int(r, 1, 100) <= percent;
}

/* Colour and texture coordinate. */
static void random_attributes(Random *r, float *vertex)
{
    for (int c = 4; c < VERTEX_FLOATS; c++)
        vertex[c] = random_float(r, 0, 1);
}

static float *make_vertices(uint32_t count, GpGeometry *geometry)
{
    float *v = gp_alloc(count * VERTEX_FLOATS, sizeof *v);
    const uint32_t stride = VERTEX_FLOATS * sizeof *v;
    geometry->vertex_count = count;
    geometry->streams[GP_POSITION] = (GpStream){ v, stride, 4, GP_FLOAT32 };
    geometry->streams[GP_COLOR] = (GpStream){ v ? v + 4 : NULL, stride, 4, GP_FLOAT32 };
    geometry->streams[GP_TEXCOORD0] = (GpStream){ v ? v + 8 : NULL, stride, 2, GP_FLOAT32 };
    return v;
}

static uint32_t *make_indices(uint32_t count, GpGeometry *geometry)
{
    uint32_t *index = gp_alloc(count, sizeof *index);
    geometry->indices = index;
    geometry->index_count = count;
    return index;
}

/* --- soups ------------------------------------------------------------------------------------ */

/* A clip-space position: mostly inside, sometimes far out, behind the eye, or no number. */
static void random_position(Random *r, float p[4])
{
    int kind = random_int(r, 0, 99);
    float reach = kind < 80 ? 1.2f : kind < 92 ? 6.0f : 3e4f;
    float w = kind < 70 ? 1.0f : random_float(r, kind < 95 ? 0.2f : -1.0f, 4);
    p[0] = random_float(r, -reach, reach) * w;
    p[1] = random_float(r, -reach, reach) * w;
    p[2] = random_float(r, kind < 85 ? 0 : -0.5f, kind < 85 ? 1 : 1.5f) * w;
    p[3] = w;
    if (kind == 99) {
        int component = random_int(r, 0, 3);
        p[component] = random_chance(r, 50) ? NAN : INFINITY;
    }
    if (kind < 40) /* on the sub-pixel grid, so that edges meet centres */
        for (int c = 0; c < 2; c++)
            p[c] = rintf(p[c] * 32) / 32;
}

static bool make_soup(Random *r, GpGeometry *geometry, float **vertices, uint32_t **indices)
{
    uint32_t count = 3 * (uint32_t)random_int(r, 1, SOUP_VERTICES / 3);
    float *v = *vertices = make_vertices(count, geometry);
    if (!v)
        return false;
    for (uint32_t i = 0; i < count; i++) {
        float *at = v + i * VERTEX_FLOATS;
        random_position(r, at);
        if (i % 3 == 2 && random_chance(r, 20)) /* slivers: next to the corner before */
            for (int c = 0; c < 4; c++)
                at[c] = at[c - VERTEX_FLOATS] + (c < 2 ? random_float(r, -0.01f, 0.01f) : 0);
        random_attributes(r, at);
    }
    if (!random_chance(r, 60))
        return true;
    uint32_t used = 3 * (uint32_t)random_int(r, 1, 60);
    uint32_t *index = *indices = make_indices(used, geometry);
    for (uint32_t i = 0; index && i < used; i++)
        index[i] = (uint32_t)random_int(r, 0, (int32_t)count - 1);
    return index != NULL;
}

/* --- meshes: a sheet of cells, shaken --------------------------------------------------------- */

static void mesh_vertex(Random *r, const float center[4], const float step[3], int column, int row,
                        float *p)
{
    float w = center[3], across = (float)(column - MESH_SIDE / 2),
          down = (float)(row - MESH_SIDE / 2);
    float shake_x = random_float(r, -0.3f, 0.3f), shake_y = random_float(r, -0.3f, 0.3f);
    float lift = random_float(r, -1, 1);
    p[0] = (center[0] + step[0] * (across + shake_x)) * w;
    p[1] = (center[1] + step[1] * (down + shake_y)) * w;
    p[2] = (center[2] + step[2] * lift) * w;
    p[3] = w * (1 + step[2] * across / MESH_SIDE);
}

static bool make_mesh(Random *r, GpGeometry *geometry, float **vertices, uint32_t **indices)
{
    const uint32_t row = MESH_SIDE + 1;
    float *v = *vertices = make_vertices(row * row, geometry);
    uint32_t *index = *indices = make_indices(6 * MESH_SIDE * MESH_SIDE, geometry);
    if (!v || !index)
        return false;
    float center[4], step[3];
    for (int c = 0; c < 2; c++) {
        center[c] = random_float(r, -0.8f, 0.8f);
        step[c] = random_float(r, 0.0005f, random_chance(r, 20) ? 0.3f : 0.08f);
    }
    center[2] = random_float(r, 0.1f, 0.9f);
    center[3] = random_float(r, 0.5f, 2);
    step[2] = random_float(r, 0, 0.15f);
    for (uint32_t i = 0; i < row * row; i++) {
        mesh_vertex(r, center, step, (int)(i % row), (int)(i / row), v + i * VERTEX_FLOATS);
        random_attributes(r, v + i * VERTEX_FLOATS);
    }
    for (uint32_t i = 0; i < MESH_SIDE * MESH_SIDE; i++) {
        const uint32_t a = i / MESH_SIDE * row + i % MESH_SIDE, b = a + 1, c = a + row, d = c + 1;
        const uint32_t two[6] = { a, b, c, b, d, c };
        for (int k = 0; k < 6; k++)
            *index++ = two[k];
    }
    return true;
}

/* --- layers of quads that fill the screen, or nearly ------------------------------------------ */

static bool make_layers(Random *r, GpGeometry *geometry, float **vertices, uint32_t **indices)
{
    static const uint32_t corners[6] = { 0, 1, 2, 0, 2, 3 };
    uint32_t layers = (uint32_t)random_int(r, 1, LAYERS);
    float *v = *vertices = make_vertices(4 * layers, geometry);
    uint32_t *index = *indices = make_indices(6 * layers, geometry);
    if (!v || !index)
        return false;
    for (uint32_t i = 0; i < 4 * layers; i++, v += VERTEX_FLOATS) {
        float half = i % 4 == 0 && random_chance(r, 30) ? random_float(r, 0.5f, 2) : 1;
        v[0] = i % 4 == 0 || i % 4 == 3 ? -half : half;
        v[1] = i % 4 < 2 ? -half : half;
        v[2] = random_float(r, 0, 1);
        v[3] = 1;
        random_attributes(r, v);
    }
    for (uint32_t i = 0; i < 6 * layers; i++)
        index[i] = i / 6 * 4 + corners[i % 6];
    return true;
}

/* --- clouds ----------------------------------------------------------------------------------- */

static bool make_cloud(Random *r, GpGeometry *geometry, float **vertices)
{
    uint32_t count = (uint32_t)random_int(r, 1, random_chance(r, 30) ? CLOUD_POINTS : 60);
    float *v = *vertices = make_vertices(count, geometry);
    float reach = random_float(r, 0.05f, 1.3f);
    for (uint32_t i = 0; v && i < count; i++, v += VERTEX_FLOATS) {
        random_position(r, v);
        v[0] *= reach;
        v[1] *= reach;
        random_attributes(r, v);
    }
    return *vertices != NULL;
}

bool random_geometry(Random *r, bool points, GpGeometry *geometry, float **vertices,
                     uint32_t **indices)
{
    *geometry = (GpGeometry){ .primitive = points ? GP_POINTS : GP_TRIANGLES };
    int kind = random_int(r, 0, 99);
    if (points && kind < 60)
        return make_cloud(r, geometry, vertices);
    if (kind < 15)
        return make_mesh(r, geometry, vertices, indices);
    if (kind < 25)
        return make_layers(r, geometry, vertices, indices);
    return make_soup(r, geometry, vertices, indices);
}
