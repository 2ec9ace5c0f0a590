#include "tests/support/fragments/meshes.h"

#include "apps/base/bounds.h"
#include "apps/base/vector.h"
#include "apps/scene/shapes.h"
#include "tests/support/unit.h"

enum { MOST_VERTICES = 40000, MOST_TRIANGLES = 40000 };

static void begin(FragmentCase *made)
{
    made->positions = gp_alloc(MOST_VERTICES, sizeof *made->positions);
    made->indices = gp_alloc(MOST_TRIANGLES, 3 * sizeof *made->indices);
    assert_true(made->positions && made->indices);
}

/* Adds a shape: scaled along each axis, turned, moved. */
static void add_shape(FragmentCase *made, const char *name, const double scale[3], double degrees,
                      const double move[3])
{
    Shape shape;
    double turn[4][4];
    assert_int_equal(shape_create(name, &shape), GP_OK);
    assert_true(made->vertex_count + shape.vertex_count <= MOST_VERTICES &&
                made->triangle_count + shape.index_count / 3 <= MOST_TRIANGLES);
    matrix_rotation((const double[]){ 0.3, 1, 0.2 }, degrees, turn);
    for (uint32_t i = 0; i < shape.index_count; i++)
        made->indices[3 * made->triangle_count + i] = made->vertex_count + shape.indices[i];
    made->triangle_count += shape.index_count / 3;
    for (uint32_t i = 0; i < shape.vertex_count; i++, made->vertex_count++)
        for (int row = 0; row < 3; row++) {
            double at = move[row];
            for (int k = 0; k < 3; k++)
                at += turn[row][k] * scale[k] * (double)shape.positions[3 * i + (uint32_t)k];
            made->positions[made->vertex_count][row] = (float)at;
        }
    shape_free(&shape);
}

static const double one[3] = { 1, 1, 1 }, nowhere[3] = { 0, 0, 0 };

/* A closed curve: round an axis so many times, and round a ring so many times. */
typedef struct Curve {
    double turns, twists, amplitude;
} Curve;

static void curve_at(const Curve *curve, double share, double at[3])
{
    double turn[2], twist[2];
    angle_sincos(360 * curve->turns * share, &turn[1], &turn[0]);
    angle_sincos(360 * curve->twists * share, &twist[1], &twist[0]);
    const double radius = 1 + curve->amplitude * twist[0];
    vector_set(at, radius * turn[0], radius * turn[1], curve->amplitude * twist[1]);
}

static void add_quad(FragmentCase *made, uint32_t first, const uint32_t corner[4])
{
    const uint32_t index[6] = { 0, 1, 2, 0, 2, 3 };
    for (int i = 0; i < 6; i++)
        made->indices[3 * made->triangle_count + (uint32_t)i] = first + corner[index[i]];
    made->triangle_count += 2;
}

static void add_sheet(FragmentCase *made, const double corner[4][3])
{
    const uint32_t first = made->vertex_count, all[4] = { 0, 1, 2, 3 };
    for (int i = 0; i < 4; i++, made->vertex_count++)
        for (int k = 0; k < 3; k++)
            made->positions[first + (uint32_t)i][k] = (float)corner[i][k];
    add_quad(made, first, all);
}

/* A tube about a curve, turned about x and moved. */
static void add_tube(FragmentCase *made, const Curve *curve, double radius, uint32_t parts,
                     double degrees, const double move[3])
{
    enum { AROUND = 10 };
    const uint32_t first = made->vertex_count;
    double turn[4][4];
    matrix_rotation((const double[]){ 1, 0, 0 }, degrees, turn);
    for (uint32_t i = 0; i < parts * AROUND; i++, made->vertex_count++) {
        const double share = (double)(i / AROUND) / parts;
        double at[3], next[3], way[3], out[2][3], sine, cosine;
        curve_at(curve, share, at);
        curve_at(curve, share + 1e-4, next);
        vector_subtract(next, at, way);
        vector_cross(way, at, out[0]);
        vector_cross(way, out[0], out[1]);
        vector_normalize(out[0]);
        vector_normalize(out[1]);
        angle_sincos(360.0 * (i % AROUND) / AROUND, &sine, &cosine);
        for (int k = 0; k < 3; k++)
            at[k] += radius * (cosine * out[0][k] + sine * out[1][k]);
        for (int row = 0; row < 3; row++)
            made->positions[made->vertex_count][row] =
                (float)(vector_dot(turn[row], at) + move[row]);
    }
    for (uint32_t i = 0; i < parts; i++)
        for (uint32_t k = 0; k < AROUND; k++) {
            const uint32_t here = i * AROUND, there = (i + 1) % parts * AROUND;
            const uint32_t corner[4] = { here + k, here + (k + 1) % AROUND,
                                         there + (k + 1) % AROUND, there + k };
            add_quad(made, first, corner);
        }
}

static void make_knot(FragmentCase *made)
{
    add_tube(made, &(Curve){ 2, 3, 0.4 }, 0.17, 96, 0, nowhere);
}

static void make_teapot(FragmentCase *made)
{
    add_shape(made, "teapot", one, 0, nowhere);
}

static void make_rings(FragmentCase *made)
{
    const Curve ring = { 1, 0, 0 };
    add_tube(made, &ring, 0.2, 48, 0, nowhere);
    add_tube(made, &ring, 0.2, 48, 80, (const double[]){ 0.9, 0.1, 0 });
}

/* A ball by halving the sides of an octahedron's faces: convex to the last bit. */
static void add_ball(FragmentCase *made, const double scale[3], double degrees,
                     const double move[3])
{
    const uint32_t parts = 8;
    double turn[4][4];
    matrix_rotation((const double[]){ 0.3, 1, 0.2 }, degrees, turn);
    for (uint32_t side = 0; side < 8; side++)
        for (uint32_t i = 0; i < parts; i++)
            for (uint32_t k = 0; k + i < parts; k++)
                for (uint32_t up = 0; up < 2 && k + i + up < parts; up++) {
                    const uint32_t corner[3][2] = { { i + up, k + up },
                                                    { i + 1, k },
                                                    { i, k + 1 } };
                    for (uint32_t c = 0; c < 3; c++, made->vertex_count++) {
                        const uint32_t turned =
                            (side & 1) ^ (side >> 1 & 1) ^ (side >> 2) ^ up ? 2 - c : c;
                        double at[3] = { corner[turned][0], corner[turned][1], 0 };
                        at[2] = parts - at[0] - at[1];
                        vector_normalize(at);
                        made->indices[made->vertex_count] = made->vertex_count;
                        for (int row = 0; row < 3; row++) {
                            double sum = move[row];
                            for (int n = 0; n < 3; n++)
                                sum += turn[row][n] * scale[n] * (side >> n & 1 ? -at[n] : at[n]);
                            made->positions[made->vertex_count][row] = (float)sum;
                        }
                    }
                    made->triangle_count++;
                }
}

static void make_nested(FragmentCase *made)
{
    for (int i = 0; i < 4; i++) {
        const double scale[3] = { 1 - 0.23 * i, 1 - 0.2 * i, 1 - 0.25 * i };
        add_ball(made, scale, 20 * i, (const double[]){ 0, 0, 0.02 * i });
    }
}

static void make_dent(FragmentCase *made)
{
    add_shape(made, "ball", one, 10, nowhere);
    for (uint32_t i = 0; i < made->vertex_count; i++)
        if (made->positions[i][2] > 0.4f)
            made->positions[i][2] = 0.8f - made->positions[i][2];
}

/* Tubes that bulge; each lies over the next one's end: no whole one can be drawn first. */
static void make_beams(FragmentCase *made)
{
    static const uint32_t parts = 8;
    static const double around[4][2] = { { 1, 0.5 }, { -1, 0.5 }, { -1, -0.5 }, { 1, -0.5 } };
    for (int i = 0; i < 3; i++) {
        const uint32_t first = made->vertex_count;
        double turn[4][4];
        matrix_rotation((const double[]){ 0, 0, 1 }, 120.0 * i, turn);
        for (uint32_t v = 0; v < 4 * (parts + 1); v++, made->vertex_count++) {
            const double x = 2.0 * (v / 4) / parts - 1, wide = 0.1 * (1 - 0.3 * x * x);
            const double at[3] = { x, 0.45 + wide * around[v % 4][0],
                                   0.2 * x + wide * around[v % 4][1] };
            for (int row = 0; row < 3; row++)
                made->positions[made->vertex_count][row] = (float)vector_dot(turn[row], at);
        }
        for (uint32_t v = 0; v < 4 * parts; v++) {
            const uint32_t next = v / 4 * 4 + (v + 1) % 4;
            const uint32_t corner[4] = { v, next, next + 4, v + 4 };
            add_quad(made, first, corner);
        }
    }
}

static void make_fan(FragmentCase *made)
{
    for (int i = 0; i < 7; i++) {
        double sine, cosine;
        angle_sincos(360.0 * i / 7, &sine, &cosine);
        const double out[2] = { cosine, sine }, in[2] = { 0.1 * cosine, 0.1 * sine };
        const double corner[4][3] = {
            { in[0], in[1], -1 }, { out[0], out[1], -1 }, { out[0], out[1], 1 }, { in[0], in[1], 1 }
        };
        add_sheet(made, corner);
    }
}

static void make_crossed(FragmentCase *made)
{
    const double a[4][3] = { { -1, -1, -0.5 }, { 1, -1, 0.6 }, { 1, 1, 0.6 }, { -1, 1, -0.5 } };
    const double b[4][3] = {
        { -1, -0.9, 0.4 }, { 1, -0.9, -0.3 }, { 1, 0.8, -0.3 }, { -1, 0.8, 0.4 }
    };
    add_sheet(made, a);
    add_sheet(made, b);
}

static void make_twins(FragmentCase *made)
{
    const double a[4][3] = { { -1, -1, 0 }, { 1, -1, 0.1 }, { 1, 1, 0.1 }, { -1, 1, 0 } };
    add_sheet(made, a);
    for (int i = 0; i < 6; i++)
        made->indices[6 + i] = made->indices[5 - i];
    made->triangle_count += 2;
}

static const struct {
    const char *name;
    bool is_clean;
    void (*make)(FragmentCase *made);
} cases[FRAGMENT_CASES] = {
    { "knot", true, make_knot },      { "rings", true, make_rings },
    { "nested", true, make_nested },  { "dent", true, make_dent },
    { "beams", true, make_beams },    { "fan", false, make_fan },
    { "teapot", false, make_teapot }, { "crossed", false, make_crossed },
    { "twins", false, make_twins },
};

FragmentCase fragment_case(int number)
{
    FragmentCase made = { .name = cases[number].name, .is_clean = cases[number].is_clean };
    begin(&made);
    cases[number].make(&made);
    return made;
}

void fragment_case_free(FragmentCase *made)
{
    gp_free(made->positions);
    gp_free(made->indices);
    *made = (FragmentCase){ .name = NULL };
}

FragmentMesh fragment_case_mesh(const FragmentCase *made)
{
    return (FragmentMesh){ .positions = (const float(*)[3])made->positions,
                           .vertex_count = made->vertex_count,
                           .indices = made->indices,
                           .triangle_count = made->triangle_count };
}

Camera fragment_case_camera(const FragmentCase *made, bool inside_too, Random *random)
{
    const Bounds bounds = bounds_of(&made->positions[0][0], 3 * sizeof(float), made->indices,
                                    3 * made->triangle_count);
    static const double distances[] = { 1.6, 3, 0.4 };
    const double side = bounds_longest(&bounds),
                 distance = side * distances[random_int(random, 0, inside_too ? 2 : 1)];
    Camera camera = { .up = { 0.1, 1, 0.2 }, .near = 0.05 * side, .far = 8 * side };
    double way[3];
    for (int k = 0; k < 3; k++)
        way[k] = (double)random_float(random, -1, 1);
    vector_normalize(way);
    for (int k = 0; k < 3; k++) {
        camera.at[k] = (bounds.low[k] + bounds.high[k]) / 2 + 0.01 * side;
        camera.eye[k] = camera.at[k] + distance * way[k];
    }
    if (random_int(random, 0, 3) == 0)
        camera.height = 1.4 * side;
    else
        camera.fovy = (double)random_float(random, 25, 70);
    return camera;
}
