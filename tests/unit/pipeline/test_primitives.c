/* Strips, fans, short indices and the types of vertices, on every device: what is drawn is what a
 * list of triangles from floats draws. */
#include <glasspipe/glasspipe.h>
#include "tests/shaders/exercise.h"
#include "tests/support/devices.h"
#include "tests/support/unit.h"

enum { SIZE = 48, CORNERS = 12 };

typedef struct Vertex {
    float position[4], color[4], uv[2];
} Vertex;

typedef struct Drawing {
    GpSurface *target;
    ExerciseUniforms uniforms;
    Vertex vertices[CORNERS];
    GpDraw draw;
    GpPass pass;
    GpList list;
} Drawing;

/* exercise_color: green is the flat value, red of corner 0, and nothing else. */
static void set_up(Drawing *d, GpPrimitive primitive)
{
    memset(d, 0, sizeof *d);
    const GpSurfaceDesc desc = { .format = GP_A32B32G32R32F, .width = SIZE, .height = SIZE };
    assert_int_equal(gp_surface_create(&desc, &d->target, NULL), GP_OK);
    for (int i = 0; i < 4; i++)
        d->uniforms.matrix[i][i] = 1;
    for (int i = 0; i < CORNERS; i++)
        d->vertices[i] =
            (Vertex){ { 0, 0, 0.5f, 1 }, { (float)(i + 1), 1, 1, 1 }, { 0.25f, 0.5f } };
    d->draw = (GpDraw){ .program = &exercise_color,
                        .uniforms = &d->uniforms,
                        .state.raster.cull = GP_CULL_CCW,
                        .geometry = { .primitive = primitive, .vertex_count = CORNERS } };
    const Vertex *v = d->vertices;
    d->draw.geometry.streams[GP_POSITION] = (GpStream){ v->position, sizeof *v, 4, GP_FLOAT32 };
    d->draw.geometry.streams[GP_COLOR] = (GpStream){ v->color, sizeof *v, 4, GP_FLOAT32 };
    d->draw.geometry.streams[GP_TEXCOORD0] = (GpStream){ v->uv, sizeof *v, 2, GP_FLOAT32 };
    d->pass = (GpPass){ .color[0] = { .surface = d->target, .clear = true },
                        .draws = &d->draw,
                        .draw_count = 1 };
    d->list = (GpList){ &d->pass, 1 };
}

/* Two rows of vertices, left to right: clockwise where it begins above. */
static void place_strip(Drawing *d)
{
    for (int i = 0; i < CORNERS; i++) {
        d->vertices[i].position[0] = -1 + 2 * (float)(i / 2) / (CORNERS / 2 - 1);
        d->vertices[i].position[1] = i % 2 ? 1 : -1;
    }
}

/* The bottom left corner, and vertices from above it round to its right. */
static void place_fan(Drawing *d)
{
    for (int i = 0; i < CORNERS; i++) {
        const float t = (float)(i - 1) / (CORNERS - 2);
        d->vertices[i].position[0] = i ? -1 + 2 * t : -1;
        d->vertices[i].position[1] = i ? 1 - 2 * t : -1;
    }
}

static float green_at(const Drawing *d, int x, int y)
{
    float rgba[4];
    gp_texel_load(GP_A32B32G32R32F,
                  gp_surface_texel(&d->target->level[0], 16, (uint32_t)x, (uint32_t)y), rgba);
    return rgba[1];
}

/* Looks at the pixel at each triangle's centroid.
 * in   first: vertex that is corner 0 of triangle 0 */
static void check_flat_values(const Drawing *d, int first)
{
    for (int t = 0; t < CORNERS - 2; t++) {
        const int fan = d->draw.geometry.primitive == GP_TRIANGLE_FAN;
        const int corner[3] = { fan ? 0 : t, t + 1, t + 2 };
        float x = 0, y = 0;
        for (int k = 0; k < 3; k++) {
            x += d->vertices[corner[k]].position[0] / 3;
            y += d->vertices[corner[k]].position[1] / 3;
        }
        const int column = (int)((x + 1) * SIZE / 2), row = (int)((1 - y) * SIZE / 2);
        assert_true(green_at(d, column, row) == (float)(t + first + 1));
    }
}

static void draws_flat(GpPrimitive primitive, int first)
{
    Drawing d;
    set_up(&d, primitive);
    if (primitive == GP_TRIANGLE_STRIP)
        place_strip(&d);
    else
        place_fan(&d);
    uint32_t wide[CORNERS];
    uint16_t narrow[CORNERS];
    for (uint16_t i = 0; i < CORNERS; i++)
        wide[i] = narrow[i] = i;
    for (int kind = 0; kind < 3; kind++)
        for (size_t n = 0; device_here(n); n++) {
            d.draw.geometry.indices = kind == 1 ? wide : NULL;
            d.draw.geometry.indices16 = kind == 2 ? narrow : NULL;
            d.draw.geometry.index_count = kind ? CORNERS : 0;
            run_list_on(device_here(n), &d.list);
            check_flat_values(&d, first);
        }
    gp_surface_destroy(&d.target);
}

static void a_strip_is_flat_by_vertex_i_and_no_triangle_is_culled(void **state)
{
    (void)state;
    draws_flat(GP_TRIANGLE_STRIP, 0);
}

static void a_fan_is_flat_by_vertex_i_plus_1_not_by_its_hub(void **state)
{
    (void)state;
    draws_flat(GP_TRIANGLE_FAN, 1);
}

/* Bit for bit what the same triangles of a list draw, cut by the near plane too. */
static void strips_and_fans_are_the_lists_that_they_stand_for(void **state)
{
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        Drawing d;
        uint32_t list[3 * (CORNERS - 2)];
        set_up(&d, kind % 2 ? GP_TRIANGLE_STRIP : GP_TRIANGLE_FAN);
        if (kind % 2)
            place_strip(&d);
        else
            place_fan(&d);
        for (int i = 0; kind >= 2 && i < CORNERS; i++)
            d.vertices[i].position[2] = i % 3 ? 0.5f : -0.25f;
        for (uint32_t t = 0; t < CORNERS - 2; t++) {
            list[3 * t] = kind % 2 ? t : t + 1;
            list[3 * t + 1] = kind % 2 ? t + 1 + t % 2 : t + 2;
            list[3 * t + 2] = kind % 2 ? t + 2 - t % 2 : 0;
        }
        GpGeometry *geometry = &d.draw.geometry;
        const GpGeometry joined = *geometry;
        for (size_t n = 0; device_here(n); n++) {
            *geometry = joined;
            run_list_on(device_here(n), &d.list);
            const uint64_t hash = gp_surface_hash(d.target);
            geometry->primitive = GP_TRIANGLES;
            geometry->indices = list;
            geometry->index_count = GP_COUNT(list);
            run_list_on(device_here(n), &d.list);
            assert_true(gp_surface_hash(d.target) == hash);
        }
        gp_surface_destroy(&d.target);
    }
}

/* The two vertices that are named twice join two strips by triangles of no area. */
static void degenerate_triangles_join_strips(void **state)
{
    (void)state;
    static const uint16_t joined[] = { 0, 1, 2, 3, 3, 8, 8, 9, 10, 11 };
    static const uint32_t apart[] = { 0, 1, 2, 1, 3, 2, 8, 9, 10, 9, 11, 10 };
    Drawing d;
    set_up(&d, GP_TRIANGLE_STRIP);
    place_strip(&d);
    for (size_t n = 0; device_here(n); n++) {
        GpGeometry *geometry = &d.draw.geometry;
        geometry->primitive = GP_TRIANGLE_STRIP;
        geometry->indices = NULL;
        geometry->indices16 = joined;
        geometry->index_count = GP_COUNT(joined);
        run_list_on(device_here(n), &d.list);
        const uint64_t hash = gp_surface_hash(d.target);
        assert_true(green_at(&d, SIZE / 2, SIZE / 2) == 0);
        assert_true(green_at(&d, 2, 2) != 0 && green_at(&d, SIZE - 2, SIZE - 2) != 0);
        geometry->primitive = GP_TRIANGLES;
        geometry->indices16 = NULL;
        geometry->indices = apart;
        geometry->index_count = GP_COUNT(apart);
        run_list_on(device_here(n), &d.list);
        assert_true(gp_surface_hash(d.target) == hash);
    }
    gp_surface_destroy(&d.target);
}

/* Colours of each type, and those floats: the same bits, on every width. */
static void vertex_types_draw_what_their_floats_draw(void **state)
{
    (void)state;
    Drawing d;
    uint16_t codes[4 * CORNERS];
    float floats[4 * CORNERS];
    set_up(&d, GP_TRIANGLE_STRIP);
    place_strip(&d);
    for (uint32_t i = 0; i < GP_COUNT(codes); i++)
        codes[i] = (uint16_t)(i % 4 == 0 ? 0x3c01 * (i + 1) : i * 2654435761u >> 20);
    for (GpComponentType type = GP_UNORM8; type < GP_COMPONENT_TYPES; type++) {
        GpStream stream = { codes, 0, 4, type };
        for (uint32_t v = 0; v < CORNERS; v++)
            for (uint32_t c = 0; c < 4; c++) {
                const uint8_t *record = (const uint8_t *)codes + v * 4 * gp_component_bytes(type);
                static const uint8_t bgra[4] = { 2, 1, 0, 3 };
                const uint16_t word = codes[4 * v + c];
                const uint8_t byte = record[type == GP_D3DCOLOR ? bgra[c] : c];
                floats[4 * v + c] =
                    type == GP_UNORM8 || type == GP_D3DCOLOR ? (float)(byte / 255.0)
                    : type == GP_UINT8                       ? byte
                    : type == GP_INT8                        ? (int8_t)byte
                    : type == GP_SNORM8  ? (int8_t)byte == -128 ? -1 : (float)((int8_t)byte / 127.0)
                     : type == GP_UINT16 ? word
                    : type == GP_INT16   ? (int16_t)word
                    : type == GP_UNORM16 ? (float)(word / 65535.0)
                    : type == GP_SNORM16
                        ? (int16_t)word == -32768 ? -1 : (float)((int16_t)word / 32767.0)
                        : gp_float_from_half(word);
            }
        for (uint8_t components = type == GP_D3DCOLOR ? 4 : 1; components <= 4; components++)
            for (size_t n = 0; device_here(n); n++) {
                stream.components = components;
                stream.stride = (uint32_t)(4 * gp_component_bytes(type));
                d.draw.geometry.streams[GP_COLOR] = stream;
                run_list_on(device_here(n), &d.list);
                const uint64_t hash = gp_surface_hash(d.target);
                d.draw.geometry.streams[GP_COLOR] =
                    (GpStream){ floats, 4 * sizeof(float), components, GP_FLOAT32 };
                run_list_on(device_here(n), &d.list);
                if (gp_surface_hash(d.target) != hash)
                    fail_msg("type %d, %d components, %s", (int)type, components,
                             device_name(device_here(n)));
            }
    }
    gp_surface_destroy(&d.target);
}

/* Whatever the lanes that look for it, and wherever it stands: alone it is beyond, and a vertex
 * more makes it right. */
static void an_index_beyond_the_vertices_is_found_anywhere(void **state)
{
    (void)state;
    enum { INDICES = 3 * 17 };
    Drawing d;
    uint32_t indices[INDICES];
    set_up(&d, GP_TRIANGLES);
    for (int i = 0; i < INDICES; i++)
        indices[i] = (uint32_t)i % (CORNERS - 1);
    d.draw.geometry.indices = indices;
    for (size_t n = 0; device_here(n); n++) {
        GpDevice *device = device_open(device_here(n));
        for (uint32_t count = 3; count <= INDICES; count += 3)
            for (uint32_t at = 0; at < count; at++) {
                const uint32_t kept = indices[at];
                indices[at] = CORNERS - 1;
                d.draw.geometry.index_count = count;
                d.draw.geometry.vertex_count = CORNERS - 1;
                if (gp_device_run(device, &d.list, NULL) != GP_ERROR_INVALID)
                    fail_msg("index %u of %u, %s", at, count, device_name(device_here(n)));
                d.draw.geometry.vertex_count = CORNERS;
                if (gp_device_run(device, &d.list, NULL) != GP_OK)
                    fail_msg("index %u of %u, %s", at, count, device_name(device_here(n)));
                indices[at] = kept;
            }
        gp_device_destroy(&device);
    }
    gp_surface_destroy(&d.target);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_strip_is_flat_by_vertex_i_and_no_triangle_is_culled),
        cmocka_unit_test(a_fan_is_flat_by_vertex_i_plus_1_not_by_its_hub),
        cmocka_unit_test(strips_and_fans_are_the_lists_that_they_stand_for),
        cmocka_unit_test(degenerate_triangles_join_strips),
        cmocka_unit_test(vertex_types_draw_what_their_floats_draw),
        cmocka_unit_test(an_index_beyond_the_vertices_is_found_anywhere),
    };
    return cmocka_run_group_tests_name("primitives", tests, NULL, NULL);
}
