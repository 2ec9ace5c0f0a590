/* Procedural shapes: closed, turned outwards, and of the size that geometry says. */
#include "apps/scene/shapes.h"
#include "tests/support/unit.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

static const char *const shape_names[] = { "sphere", "ball",  "cube", "torus", "knot",   "cylinder",
                                           "cone",   "plane", "disc", "quad",  "teapot", NULL };

static Shape make(const char *name)
{
    Shape shape = { 0 };
    assert_int_equal(shape_create(name, &shape), GP_OK);
    return shape;
}

static const float *corner(const Shape *shape, uint32_t at)
{
    return shape->positions + 3 * shape->indices[at];
}

static void face_normal(const Shape *shape, uint32_t triangle, double normal[3])
{
    double a[3], b[3];
    for (int i = 0; i < 3; i++) {
        a[i] = (double)corner(shape, triangle + 1)[i] - (double)corner(shape, triangle)[i];
        b[i] = (double)corner(shape, triangle + 2)[i] - (double)corner(shape, triangle)[i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        normal[i] = a[j] * b[k] - a[k] * b[j];
    }
}

/* By the divergence theorem: positive where triangles turn counter-clockwise seen from outside. */
static double volume(const Shape *shape)
{
    double sum = 0, normal[3];
    for (uint32_t i = 0; i < shape->index_count; i += 3) {
        face_normal(shape, i, normal);
        for (int k = 0; k < 3; k++)
            sum += normal[k] * (double)corner(shape, i)[k] / 6;
    }
    return sum;
}

/* --- edges ------------------------------------------------------------------------------------ */

typedef struct Edge {
    float a[3], b[3]; /* the smaller end first */
    int direction;
} Edge;

static int compare_edges(const void *left, const void *right)
{
    return memcmp(left, right, offsetof(Edge, direction));
}

static Edge edge_of(const float *from, const float *to)
{
    Edge edge = { .direction = 1 };
    bool swap = memcmp(from, to, sizeof edge.a) > 0;
    memcpy(edge.a, swap ? to : from, sizeof edge.a);
    memcpy(edge.b, swap ? from : to, sizeof edge.b);
    edge.direction = swap ? -1 : 1;
    return edge;
}

/* Number of edges that no other triangle has in the opposite direction, by the bits of their
 * ends. */
static uint32_t boundary_edges(const Shape *shape)
{
    Edge *edges = calloc(shape->index_count, sizeof *edges);
    uint32_t open = 0;
    assert_non_null(edges);
    for (uint32_t i = 0; i < shape->index_count; i++)
        edges[i] = edge_of(corner(shape, i), corner(shape, i % 3 == 2 ? i - 2 : i + 1));
    qsort(edges, shape->index_count, sizeof *edges, compare_edges);
    for (uint32_t i = 0; i < shape->index_count;) {
        uint32_t end = i;
        int sum = 0;
        for (; end < shape->index_count && compare_edges(&edges[i], &edges[end]) == 0; end++)
            sum += edges[end].direction;
        open += sum != 0;
        i = end;
    }
    free(edges);
    return open;
}

/* --- tests ------------------------------------------------------------------------------------ */

static void every_shape_has_unit_normals_on_the_outside_of_its_triangles(void **state)
{
    (void)state;
    for (int n = 0; shape_names[n]; n++) {
        Shape shape = make(shape_names[n]);
        assert_true(shape.index_count > 0 && shape.index_count % 3 == 0);
        for (uint32_t i = 0; i < shape.index_count; i++) {
            assert_true(shape.indices[i] < shape.vertex_count);
            const float *normal = shape.normals + 3 * shape.indices[i];
            double face[3], along = 0, length = 0, size = 0;
            face_normal(&shape, i - i % 3, face);
            for (int k = 0; k < 3; k++) {
                along += face[k] * (double)normal[k];
                length += (double)normal[k] * (double)normal[k];
                size += face[k] * face[k];
            }
            assert_true(fabs(length - 1) < 1e-6);
            assert_true(size > 0); /* no triangle is an edge */
            if (!(along > 0.3 * sqrt(size)))
                fail_msg("%s, corner %u: the normal is %g of its triangle's", shape_names[n], i,
                         along / sqrt(size));
        }
        shape_free(&shape);
    }
}

static void solids_are_closed_and_have_their_volume(void **state)
{
    (void)state;
    const struct {
        const char *name;
        double volume;
    } solids[] = {
        { "sphere", 4.0 / 3 * pi },
        { "cube", 8 },
        { "cylinder", 2 * pi },
        { "cone", 2.0 / 3 * pi },
        { "torus", 2 * pi * pi * 0.7 * 0.3 * 0.3 },
    };
    for (size_t i = 0; i < GP_COUNT(solids); i++) {
        Shape shape = make(solids[i].name);
        assert_int_equal(boundary_edges(&shape), 0);
        /* flat triangles lie inside: somewhat less than the round solid, never more */
        double share = volume(&shape) / solids[i].volume;
        if (!(share > 0.985 && share < 1.000001))
            fail_msg("%s has %g of its volume", solids[i].name, share);
        shape_free(&shape);
    }
}

/* Pappus: a tube's volume is its section times the length of its curve. */
static void the_knot_is_a_closed_tube(void **state)
{
    (void)state;
    Shape shape = make("knot");
    double length = 0;
    for (int i = 0; i < 100000; i++) {
        double t = 2 * pi * i / 100000, r = 2 + cos(3 * t);
        length += sqrt(9 * sin(3 * t) * sin(3 * t) + 4 * r * r + 9 * cos(3 * t) * cos(3 * t));
    }
    length *= 0.28 * 2 * pi / 100000;
    double share = volume(&shape) / (length * pi * 0.16 * 0.16);
    assert_int_equal(boundary_edges(&shape), 0);
    if (!(share > 0.98 && share < 1))
        fail_msg("%g of the volume", share);
    shape_free(&shape);
}

static bool has_vertex(const Shape *shape, float x, float y, float z)
{
    for (uint32_t i = 0; i < shape->vertex_count; i++) {
        const float *p = shape->positions + 3 * i;
        if (p[0] == x && p[1] == y && p[2] == z)
            return true;
    }
    return false;
}

static void the_teapot_goes_through_newells_corner_points(void **state)
{
    (void)state;
    Shape shape = make("teapot");
    static const float corners[][3] = {
        { 1.4f, 2.4f, 0 },    { 0, 2.4f, 1.5f },   { -2, 0.9f, 0 },     { 0, 0.15f, -1.5f },
        { 0, 0, 0 },          { 0, 3.15f, 0 },     { 0, 2.7f, 0.2f },   { -1.3f, 2.4f, 0 },
        { -1.6f, 2.025f, 0 }, { -1.5f, 2.25f, 0 }, { -3, 1.8f, 0 },     { -2.7f, 1.8f, 0 },
        { -2, 0.9f, 0 },      { -1.9f, 0.6f, 0 },  { 1.7f, 1.425f, 0 }, { 1.7f, 0.6f, 0 },
        { 2.7f, 2.4f, 0 },    { 3.3f, 2.4f, 0 },   { 2.8f, 2.4f, 0 },   { 3.2f, 2.4f, 0 },
    };
    for (size_t i = 0; i < GP_COUNT(corners); i++)
        if (!has_vertex(&shape, corners[i][0], corners[i][1], corners[i][2]))
            fail_msg("no vertex at %g %g %g", (double)corners[i][0], (double)corners[i][1],
                     (double)corners[i][2]);
    for (uint32_t i = 0; i < shape.vertex_count; i++) { /* the same on both sides of z = 0 */
        const float *p = shape.positions + 3 * i;
        assert_true(p[1] >= 0 && p[1] <= 3.15f);
        if (i % 97 == 0)
            assert_true(has_vertex(&shape, p[0], p[1], -p[2]));
    }
    shape_free(&shape);
}

static void handle_and_spout_of_the_teapot_face_outwards(void **state)
{
    (void)state;
    Shape shape = make("teapot");
    int seen = 0;
    for (uint32_t i = 0; i < shape.vertex_count; i++) {
        const float *position = shape.positions + 3 * i, *normal = shape.normals + 3 * i;
        if (position[0] == -3.0f) { /* the handle's back */
            assert_true(normal[0] < -0.99f);
            seen |= 1;
        }
        if (position[0] == 1.7f && position[1] == 0.6f) { /* below the spout */
            assert_true(normal[1] < -0.9f);
            seen |= 2;
        }
    }
    assert_int_equal(seen, 3);
    shape_free(&shape);
}

/* Open are only the rims of body and lid (48 edges each) and the two ends of handle and spout (24
 * each): between patches, seams and poles there is no crack. */
static void the_teapot_is_open_only_where_newells_patches_end(void **state)
{
    (void)state;
    Shape shape = make("teapot");
    assert_int_equal(boundary_edges(&shape), 2 * 48 + 4 * 24);
    shape_free(&shape);
}

static void texture_coordinates_run_over_the_picture(void **state)
{
    (void)state;
    for (int n = 0; shape_names[n]; n++) {
        Shape shape = make(shape_names[n]);
        float low[2] = { 2, 2 }, high[2] = { -2, -2 };
        for (uint32_t i = 0; i < shape.vertex_count; i++)
            for (uint32_t k = 0; k < 2; k++) {
                float t = shape.texcoords[2 * i + k];
                low[k] = t < low[k] ? t : low[k];
                high[k] = t > high[k] ? t : high[k];
            }
        for (int k = 0; k < 2; k++)
            assert_true(low[k] == 0 && high[k] == 1);
        shape_free(&shape);
    }
}

static void computed_normals_are_those_of_the_surface(void **state)
{
    (void)state;
    Shape shape = make("torus");
    const size_t bytes = shape.vertex_count * 3 * sizeof(float);
    float *before = malloc(bytes);
    assert_non_null(before);
    memcpy(before, shape.normals, bytes);
    shape_compute_normals(&shape);
    for (uint32_t i = 0; i < shape.vertex_count; i++) {
        double along = 0;
        for (uint32_t k = 0; k < 3; k++)
            along += (double)before[3 * i + k] * (double)shape.normals[3 * i + k];
        assert_true(along > 0.99);
    }
    free(before);
    shape_free(&shape);
}

static void points_lie_on_their_surface_and_apart(void **state)
{
    (void)state;
    Shape shape = { 0 };
    assert_int_equal(shape_create_points("sphere", &shape), GP_OK);
    assert_null(shape.indices);
    double mean[3] = { 0 };
    for (uint32_t i = 0; i < shape.vertex_count; i++) {
        const float *position = shape.positions + 3 * i, *normal = shape.normals + 3 * i;
        double square = 0;
        for (int k = 0; k < 3; k++) {
            square += (double)position[k] * (double)position[k];
            mean[k] += (double)position[k] / shape.vertex_count;
            assert_true(position[k] == normal[k]);
        }
        assert_true(fabs(square - 1) < 1e-6);
    }
    for (int k = 0; k < 3; k++)
        assert_true(fabs(mean[k]) < 1e-3);
    shape_free(&shape);
}

static void unknown_names_are_refused(void **state)
{
    (void)state;
    Shape shape = { 0 };
    assert_int_equal(shape_create("teapots", &shape), GP_ERROR_INVALID);
    assert_int_equal(shape_create_points("", &shape), GP_ERROR_INVALID);
    assert_null(shape.positions);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_shape_has_unit_normals_on_the_outside_of_its_triangles),
        cmocka_unit_test(solids_are_closed_and_have_their_volume),
        cmocka_unit_test(the_knot_is_a_closed_tube),
        cmocka_unit_test(the_teapot_goes_through_newells_corner_points),
        cmocka_unit_test(handle_and_spout_of_the_teapot_face_outwards),
        cmocka_unit_test(the_teapot_is_open_only_where_newells_patches_end),
        cmocka_unit_test(texture_coordinates_run_over_the_picture),
        cmocka_unit_test(computed_normals_are_those_of_the_surface),
        cmocka_unit_test(points_lie_on_their_surface_and_apart),
        cmocka_unit_test(unknown_names_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
