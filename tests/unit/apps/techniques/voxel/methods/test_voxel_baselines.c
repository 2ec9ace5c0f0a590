/* The baselines of voxelization against exact voxels: what each is right about, and how each
 * fails. */
#include "apps/techniques/voxel/methods/methods.h"
#include "apps/truth/triangle.h"
#include "tests/support/unit.h"
#include "tests/support/voxel_case.h"

enum { N = 48, FULL = N * N * N / 8 };

/* Positions are snapped to 1/256 of a voxel across the view: what lies within this of deciding
 * otherwise may. */
#define MARGIN (1.0 / 128)

/* A turn by no special angle (voxel_case_open). */
static const double askew = 0.7;

/* Appends to a frame what makes a volume. */
typedef void Method(const VoxelModel *, const VoxelSetting *, Frame *, const FlatTexture *);

typedef struct Drawing {
    Method *method;
    const VoxelModel *model;
    VoxelKind kind;
} Drawing;

static void append(const void *context, Frame *frame, const FlatTexture *flat)
{
    const Drawing *d = context;
    const VoxelSetting setting = { .kind = d->kind, .size = flat->size, .bits = 1 };
    d->method(d->model, &setting, frame, flat);
}

static void draw(Method *method, const VoxelCase *c, VoxelKind kind, uint8_t *bits)
{
    const Drawing drawing = { method, &c->model, kind };
    voxel_run(append, &drawing, c->size, false, bits);
}

/* --- what is right ---------------------------------------------------------------------------- */

/* How much a triangle rises along z from one column to the next, at most; it faces z where that is
 * less than 1 in x and y. */
static double steepness(const TruthTriangle *t)
{
    double n[3];
    truth_normal(t, n);
    return fmax(fabs(n[0]), fabs(n[1])) / fabs(n[2]);
}

/* Voxels for certain; voxels at most. */
typedef struct Bounded {
    uint8_t least[FULL], most[FULL];
} Bounded;

/* Those that lines through centres along an axis meet. */
static void meet_lines(const VoxelCase *c, int axis, Bounded *met)
{
    memset(met, 0, sizeof *met);
    voxel_thin(c->triangles, c->model.triangle_count, N, 1u << axis, -MARGIN, met->least);
    voxel_thin(c->triangles, c->model.triangle_count, N, 1u << axis, MARGIN, met->most);
}

typedef struct Surface {
    uint64_t found, lost_facing, lost, extra;
    uint64_t beyond; /* what lines along z cannot meet, and others do */
} Surface;

/* Against what lines through centres meet: along z, and along all axes. */
static Surface measure_surface(Method *method, const VoxelCase *c)
{
    static uint8_t bits[FULL], facing[FULL], all[FULL], along_z[FULL];
    memset(facing, 0, FULL);
    memset(all, 0, FULL);
    for (uint32_t i = 0; i < c->model.triangle_count; i++)
        if (steepness(&c->triangles[i]) < 1)
            voxel_thin(&c->triangles[i], 1, N, 0, -MARGIN, facing);
    voxel_thin(c->triangles, c->model.triangle_count, N, VOXEL_ALL_AXES, -MARGIN, all);
    memset(along_z, 0, FULL);
    for (uint32_t i = 0; i < c->model.triangle_count; i++) {
        /* by how much depth changes over what positions are snapped by */
        const double margin = MARGIN * fmin(2 * steepness(&c->triangles[i]) + 1, N);
        voxel_thin(&c->triangles[i], 1, N, 1u << 2, margin, along_z);
    }
    draw(method, c, VOXEL_SURFACE, bits);
    return (Surface){ voxel_count(bits, N), voxel_count_without(facing, bits, N),
                      voxel_count_without(all, bits, N), voxel_count_without(bits, along_z, N),
                      voxel_count_without(all, along_z, N) };
}

typedef struct Solid {
    uint64_t found, missing, extra; /* those beside the surface apart */
} Solid;

/* Against the parity of centres. */
static Solid measure_solid(Method *method, const VoxelCase *c)
{
    static uint8_t bits[FULL], inside[FULL], beside[FULL];
    memset(inside, 0, FULL);
    memset(beside, 0, FULL);
    voxel_solid(c->triangles, c->model.triangle_count, N, inside);
    voxel_surface(c->triangles, c->model.triangle_count, N, MARGIN - 0.5, beside);
    draw(method, c, VOXEL_SOLID, bits);
    Solid s = { .found = voxel_count(bits, N) };
    for (size_t i = 0; i < FULL; i++) {
        s.missing += (uint64_t)__builtin_popcount(inside[i] & ~bits[i] & ~beside[i] & 0xff);
        s.extra += (uint64_t)__builtin_popcount(bits[i] & ~inside[i] & ~beside[i] & 0xff);
    }
    return s;
}

/* Nothing is set that no line meets, and nothing is lost of triangles that face the view; what only
 * other views see is lost. */
static void surfaces_are_what_one_view_sees(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double turn;
        uint64_t found, lost; /* 0: not known otherwise */
    } cases[] = {
        { "sphere", 0, 0, 0 },
        { "torus", 0, 0, 0 },
        { "cube", askew, 0, 0 },
        /* its sides, edge-on, are gone; lines that meet a diagonal are no triangle's for certain */
        { "cube", 0, 2 * 46 * 46, 4 * 45 * 44 - 4 * 44 },
        { "meshes/bunny.ply", 0, 0, 0 },
    };
    static Method *const methods[] = { voxel_slices, voxel_layered_depth };
    for (size_t i = 0; i < GP_COUNT(cases); i++)
        for (size_t m = 0; m < GP_COUNT(methods); m++) {
            VoxelCase c = voxel_case_open(cases[i].name, cases[i].turn, N);
            Surface s = measure_surface(methods[m], &c);
            assert_int_equal(s.extra, 0);
            assert_int_equal(s.lost_facing, 0);
            assert_true(s.beyond > 500 && s.lost >= s.beyond);
            if (cases[i].found) {
                assert_int_equal(s.found, cases[i].found);
                assert_int_equal(s.lost, cases[i].lost);
            }
            voxel_case_free(&c);
        }
}

static void closed_solids_are_the_parity_of_centres(void **state)
{
    (void)state;
    static Method *const methods[] = { voxel_slices, voxel_layered_depth };
    static const char *const names[] = { "sphere", "torus", "cube", "knot", "meshes/horse.ply" };
    for (size_t i = 0; i < GP_COUNT(names); i++)
        for (size_t m = 0; m < GP_COUNT(methods); m++) {
            VoxelCase c = voxel_case_open(names[i], i % 2 ? askew : 0, N);
            Solid s = measure_solid(methods[m], &c);
            assert_true(s.found > 1000);
            assert_int_equal(s.missing, 0);
            assert_int_equal(s.extra, 0);
            voxel_case_free(&c);
        }
}

/* --- how they fail ---------------------------------------------------------------------------- */

/* Voxels between the first and the last that lines along an axis meet; taken away from
 * `between`. */
static void keep_between(const uint8_t *met, int axis, bool ends, uint8_t *between)
{
    const uint32_t step[3] = { 1, N, N * N };
    for (uint32_t column = 0; column < N * N; column++) {
        const uint32_t start =
            column % N * step[(axis + 1) % 3] + column / N * step[(axis + 2) % 3];
        uint32_t first = N, last = 0;
        for (uint32_t z = 0; z < N; z++) {
            const uint32_t i = start + z * step[axis];
            if (met[i / 8] >> i % 8 & 1) {
                first = first < z ? first : z;
                last = z;
            }
        }
        for (uint32_t z = 0; z < N; z++) {
            const uint32_t i = start + z * step[axis];
            if (ends ? z < first || z > last : z <= first || z >= last)
                between[i / 8] = (uint8_t)(between[i / 8] & ~(1u << i % 8));
        }
    }
}

/* What lies between surfaces along all three axes: all that six faces cannot tell from the
 * inside. */
static void find_unseen(const VoxelCase *c, Bounded *unseen)
{
    static Bounded met;
    memset(unseen, 0xff, sizeof *unseen);
    for (int axis = 0; axis < 3; axis++) {
        meet_lines(c, axis, &met);
        keep_between(met.least, axis, false, unseen->least);
        keep_between(met.most, axis, true, unseen->most);
    }
}

/* Six faces are exact for what is convex, and for bends that one of them sees; other bends fill. */
static void six_faces_fill_what_none_sees(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double turn;
        bool fills;
    } cases[] = {
        { "sphere", 0, false },    { "cube", askew, false }, { "torus", 0, false },
        { "torus", askew, false }, { "knot", 0, true },      { "knot", askew, true },
    };
    static uint8_t bits[FULL], solid[FULL];
    static Bounded unseen;
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        VoxelCase c = voxel_case_open(cases[i].name, cases[i].turn, N);
        Solid s = measure_solid(voxel_faces, &c);
        assert_true(s.found > 1000);
        assert_int_equal(s.missing, 0);
        assert_int_equal(s.extra > 0, cases[i].fills);
        draw(voxel_faces, &c, VOXEL_SOLID, bits);
        find_unseen(&c, &unseen);
        assert_int_equal(voxel_count_without(unseen.least, bits, N), 0);
        assert_int_equal(voxel_count_without(bits, unseen.most, N), 0);
        memset(solid, 0, FULL);
        voxel_solid(c.triangles, c.model.triangle_count, N, solid);
        assert_int_equal(voxel_count_without(unseen.least, solid, N) > 0, cases[i].fills);
        voxel_case_free(&c);
    }
}

/* A sphere with a smaller one inside, turned inside out. */
static VoxelCase hollow_sphere(void)
{
    VoxelCase outer = voxel_case_open("sphere", 0, N);
    const uint32_t count = outer.model.triangle_count;
    float *corners = gp_alloc(2 * (size_t)count, 9 * sizeof *corners);
    for (uint32_t i = 0; i < 9 * count; i++) {
        const double place = outer.triangles[i / 9].corner[i / 3 % 3][i % 3];
        const uint32_t turned = 9 * (i / 9) + 3 * (2 - i / 3 % 3) + i % 3;
        corners[i] = (float)place;
        corners[9 * count + turned] = (float)((place + N / 2.0) / 2);
    }
    VoxelCase hollow = voxel_case_of(corners, 2 * count, N);
    gp_free(corners);
    voxel_case_free(&outer);
    return hollow;
}

static void six_faces_fill_a_cavity_whole(void **state)
{
    (void)state;
    static uint8_t cavity[FULL], beside[FULL];
    VoxelCase c = hollow_sphere();
    const uint32_t half = c.model.triangle_count / 2;
    memset(cavity, 0, FULL);
    memset(beside, 0, FULL);
    voxel_solid(c.triangles + half, half, N, cavity);
    voxel_surface(c.triangles + half, half, N, MARGIN - 0.5, beside);
    Solid faces = measure_solid(voxel_faces, &c), layers = measure_solid(voxel_layered_depth, &c);
    assert_true(faces.extra > 5000);
    assert_int_equal(faces.extra, voxel_count_without(cavity, beside, N));
    assert_int_equal(faces.missing, 0);
    assert_int_equal(layers.extra + layers.missing, 0); /* which layers do not */
    voxel_case_free(&c);
}

/* --- boxes, in voxels: counted by hand -------------------------------------------------------- */

enum { COLUMNS = 40 * 40, BOX_TRIANGLES = 12, MOST_BOXES = 10 };

/* Boxes of 40 x 40 columns, from height to height. */
typedef struct Boxes {
    float low[MOST_BOXES], high[MOST_BOXES];
    uint32_t count;
    bool open; /* the last one has no far end */
} Boxes;

/* Corner k of a box is at its far side along axis i where bit i of k is set. */
static uint64_t count_boxes(const Boxes *boxes, Method *method, VoxelKind kind)
{
    static const uint8_t corner[BOX_TRIANGLES][3] = { { 0, 2, 1 }, { 1, 2, 3 }, { 0, 1, 4 },
                                                      { 1, 5, 4 }, { 0, 4, 2 }, { 2, 4, 6 },
                                                      { 2, 6, 3 }, { 3, 6, 7 }, { 1, 3, 5 },
                                                      { 3, 7, 5 }, { 4, 5, 6 }, { 5, 7, 6 } };
    static uint8_t bits[FULL];
    float corners[MOST_BOXES * BOX_TRIANGLES][3][3];
    const uint32_t triangles = BOX_TRIANGLES * boxes->count - (boxes->open ? 2 : 0);
    for (uint32_t t = 0; t < triangles; t++)
        for (int i = 0; i < 3; i++) {
            const uint32_t box = t / BOX_TRIANGLES, at = corner[t % BOX_TRIANGLES][i];
            corners[t][i][0] = at & 1 ? 44 : 4;
            corners[t][i][1] = at & 2 ? 44 : 4;
            corners[t][i][2] = at & 4 ? boxes->high[box] : boxes->low[box];
        }
    VoxelCase c = voxel_case_of(corners[0][0], triangles, N);
    draw(method, &c, kind, bits);
    voxel_case_free(&c);
    return voxel_count(bits, N);
}

/* Ten boxes have twenty layers; the last four are lost. */
static void layers_beyond_the_bound_are_lost(void **state)
{
    (void)state;
    Boxes stack = { .count = MOST_BOXES };
    for (uint32_t b = 0; b < stack.count; b++) {
        stack.low[b] = (float)(4 * b) + 2.25f; /* two centres each */
        stack.high[b] = stack.low[b] + 2;
    }
    assert_int_equal(count_boxes(&stack, voxel_slices, VOXEL_SURFACE), 20 * COLUMNS);
    assert_int_equal(count_boxes(&stack, voxel_layered_depth, VOXEL_SURFACE),
                     VOXEL_LAYERS * COLUMNS);
    assert_int_equal(count_boxes(&stack, voxel_slices, VOXEL_SOLID), 10 * 2 * COLUMNS);
    assert_int_equal(count_boxes(&stack, voxel_layered_depth, VOXEL_SOLID), VOXEL_LAYERS * COLUMNS);
}

/* Where two surfaces lie at one depth, peeling takes them for one, and the second box is
 * outside. */
static void layers_that_coincide_are_one(void **state)
{
    (void)state;
    const Boxes pair = { .count = 2, .low = { 5, 15 }, .high = { 15, 25 } };
    assert_int_equal(count_boxes(&pair, voxel_slices, VOXEL_SOLID), 20 * COLUMNS);
    assert_int_equal(count_boxes(&pair, voxel_layered_depth, VOXEL_SOLID), 10 * COLUMNS);
}

/* A box without its far end: slices run on to the end of the volume; a layer without a partner, and
 * faces that see one wall from both sides, make nothing. */
static void open_boxes_run_on_or_vanish(void **state)
{
    (void)state;
    const Boxes open = { .count = 1, .low = { 5 }, .high = { 25 }, .open = true };
    assert_int_equal(count_boxes(&open, voxel_slices, VOXEL_SOLID), (N - 5) * COLUMNS);
    assert_int_equal(count_boxes(&open, voxel_layered_depth, VOXEL_SOLID), 0);
    assert_int_equal(count_boxes(&open, voxel_faces, VOXEL_SOLID), 0);
}

/* --- bits ------------------------------------------------------------------------------------- */

static void every_device_draws_the_same_bits(void **state)
{
    (void)state;
    static const struct {
        Method *method;
        VoxelKind kind;
    } cases[] = {
        { voxel_slices, VOXEL_SURFACE },        { voxel_slices, VOXEL_SOLID },
        { voxel_layered_depth, VOXEL_SURFACE }, { voxel_layered_depth, VOXEL_SOLID },
        { voxel_faces, VOXEL_SOLID },
    };
    static uint8_t bits[FULL];
    VoxelCase c = voxel_case_open("torus", askew, 40);
    for (size_t i = 0; i < GP_COUNT(cases); i++) {
        const Drawing drawing = { cases[i].method, &c.model, cases[i].kind };
        voxel_run(append, &drawing, c.size, true, bits);
        assert_true(voxel_count(bits, c.size) > 500);
    }
    voxel_case_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(surfaces_are_what_one_view_sees),
        cmocka_unit_test(closed_solids_are_the_parity_of_centres),
        cmocka_unit_test(six_faces_fill_what_none_sees),
        cmocka_unit_test(six_faces_fill_a_cavity_whole),
        cmocka_unit_test(layers_beyond_the_bound_are_lost),
        cmocka_unit_test(layers_that_coincide_are_one),
        cmocka_unit_test(open_boxes_run_on_or_vanish),
        cmocka_unit_test(every_device_draws_the_same_bits),
    };
    return cmocka_run_group_tests_name("voxel baselines", tests, NULL, NULL);
}
