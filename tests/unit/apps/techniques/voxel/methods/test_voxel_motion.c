/* Models that move: built once, moved between frames, and each frame held against the model that
 * the processor has moved, in double. */
#include "apps/techniques/voxel/volume/combine.h"
#include "tests/support/unit.h"
#include "tests/support/devices.h"
#include "tests/support/voxel_case.h"

#include <math.h>

enum { SIZE = 48, BYTES = SIZE * SIZE * SIZE / 8, FRAMES = 5 };

/* Nearer to a decision than this, in voxels, either answer is right: a vertex comes by two products
 * more than one that stands still. */
static const double surface_margin = 2e-3, solid_margin = 1.0 / 128;

/* --- the processor's part --------------------------------------------------------------------- */

static void move_point(const VoxelMotion *motion, const float *p, double q[3])
{
    for (int k = 0; k < 3; k++) {
        const float *row = motion->to_voxels[k];
        q[k] = (double)row[3];
        for (int i = 0; i < 3; i++)
            q[k] += (double)row[i] * (double)p[i];
    }
    const double centre = (double)motion->centre;
    const double angle = (q[1] - centre) * (double)motion->twist;
    const double x = q[0] - centre, z = q[2] - centre;
    q[0] = cos(angle) * x + sin(angle) * z + centre;
    q[2] = cos(angle) * z - sin(angle) * x + centre;
}

static void move_triangles(const VoxelCase *c, const VoxelMotion *motion)
{
    for (uint32_t i = 0; i < c->model.triangle_count; i++)
        for (int j = 0; j < 3; j++)
            move_point(motion,
                       c->model.positions + 3 * (size_t)c->model.indices[3 * i + (uint32_t)j],
                       c->triangles[i].corner[j]);
}

/* What a frame may hold at least and at most. */
typedef struct Certainty {
    uint8_t certain[BYTES], possible[BYTES];
} Certainty;

static void find_bounds(const VoxelCase *c, const VoxelMotion *motion, VoxelMethod method,
                        Certainty *bounds)
{
    static uint8_t near[BYTES];
    memset(bounds, 0, sizeof *bounds);
    move_triangles(c, motion);
    if (method == VOXEL_XOR) {
        memset(near, 0, sizeof near);
        voxel_solid(c->triangles, c->model.triangle_count, SIZE, bounds->certain);
        voxel_near(c->triangles, c->model.triangle_count, SIZE, solid_margin, near);
        for (int i = 0; i < BYTES; i++) {
            bounds->possible[i] = bounds->certain[i] | near[i];
            bounds->certain[i] = (uint8_t)(bounds->certain[i] & ~near[i]);
        }
    } else if (method == VOXEL_THIN) {
        voxel_thin(c->triangles, c->model.triangle_count, SIZE, VOXEL_ALL_AXES, -surface_margin,
                   bounds->certain);
        voxel_thin(c->triangles, c->model.triangle_count, SIZE, VOXEL_ALL_AXES, surface_margin,
                   bounds->possible);
    } else {
        voxel_surface(c->triangles, c->model.triangle_count, SIZE, -surface_margin,
                      bounds->certain);
        voxel_surface(c->triangles, c->model.triangle_count, SIZE, surface_margin,
                      bounds->possible);
    }
}

static void check_between(const char *name, int frame, const Certainty *bounds,
                          const uint8_t *voxels)
{
    const uint64_t missing = voxel_count_without(bounds->certain, voxels, SIZE),
                   extra = voxel_count_without(voxels, bounds->possible, SIZE);
    if (missing || extra)
        fail_msg("%s, frame %d: %lu voxels, of which %lu missing, %lu extra", name, frame,
                 (unsigned long)voxel_count(voxels, SIZE), (unsigned long)missing,
                 (unsigned long)extra);
}

/* --- frames ----------------------------------------------------------------------------------- */

/* A moving model's volume, in a frame. */
typedef struct Mover {
    VoxelCase c;
    VoxelMotions motions;
    FlatTexture flat;
} Mover;

static void add_mover(const char *shape, const VoxelSetting *setting, double most_twist,
                      Frame *frame, Mover *mover)
{
    GpError error = { "" };
    mover->c = voxel_case_open(shape, 0, SIZE);
    mover->motions.first = NULL;
    mover->c.model.motions = &mover->motions;
    mover->c.model.most_twist = (float)most_twist;
    if (voxel_build(&mover->c.model, setting, frame, &mover->flat, &error))
        fail_msg("%s", error.text);
}

static void draw_frame(GpDevice *device, const Frame *frame, const FlatTexture *flat,
                       uint8_t *voxels)
{
    GpError error = { "" };
    if (gp_device_run(device, &frame->list, &error))
        fail_msg("%s", error.text);
    flat_texture_read(flat, voxels);
}

/* Smaller by a factor, about the volume's centre, so that it has room to turn. */
static void shrink(VoxelMotion *motion, float factor)
{
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 4; i++)
            motion->to_voxels[k][i] *= factor;
        motion->to_voxels[k][3] += (1 - factor) * motion->centre;
    }
}

/* --- twists ----------------------------------------------------------------------------------- */

static const struct {
    const char *name, *shape;
    VoxelSetting setting;
    float factor; /* beyond 0.7 parts of it turn out of the volume */
} twists[] = {
    { "touched", "teapot", { .size = SIZE, .bits = 1, .method = VOXEL_CONSERVATIVE }, 0.7f },
    { "sampled", "knot", { .size = SIZE, .bits = 1, .method = VOXEL_THIN }, 1 },
    { "inside",
      "knot",
      { .size = SIZE, .bits = 1, .kind = VOXEL_SOLID, .method = VOXEL_XOR },
      0.7f },
    { "cut off", "cube", { .size = SIZE, .bits = 1, .method = VOXEL_CONSERVATIVE }, 1 },
};

/* Half a turn over the height, at most, back and forth. */
static const double most_twist = 3.14159 / SIZE;

static VoxelMotion twist_of_frame(const VoxelCase *c, float factor, int frame)
{
    VoxelMotion motion = c->model.motion;
    shrink(&motion, factor);
    motion.twist = (float)(most_twist * (2.0 * frame / (FRAMES - 1) - 1));
    return motion;
}

static void a_twisting_model_is_exact_in_every_frame(void **state)
{
    (void)state;
    static uint8_t voxels[BYTES], before[BYTES];
    static Certainty bounds;
    static Mover mover;
    for (size_t i = 0; i < GP_COUNT(twists); i++) {
        Frame frame;
        frame = (Frame){ .color = NULL };
        add_mover(twists[i].shape, &twists[i].setting, most_twist, &frame, &mover);
        GpDevice *device = device_open(&(GpDeviceDesc){ .threads = 2 });
        for (int step = 0; step < FRAMES; step++) {
            const VoxelMotion motion = twist_of_frame(&mover.c, twists[i].factor, step);
            voxel_move(&mover.motions, &motion);
            memcpy(before, voxels, sizeof voxels);
            draw_frame(device, &frame, &mover.flat, voxels);
            find_bounds(&mover.c, &motion, twists[i].setting.method, &bounds);
            check_between(twists[i].name, step, &bounds, voxels);
            assert_true(voxel_count(voxels, SIZE) > 500);
            assert_true(voxel_count_without(voxels, before, SIZE) > 100); /* it does move */
        }
        gp_device_destroy(&device);
        frame_free(&frame);
        voxel_case_free(&mover.c);
    }
}

static void frames_have_the_same_bits_everywhere(void **state)
{
    (void)state;
    static uint8_t voxels[BYTES], first[BYTES];
    static Mover mover;
    for (size_t i = 0; i < GP_COUNT(twists); i++) {
        Frame frame;
        frame = (Frame){ .color = NULL };
        add_mover(twists[i].shape, &twists[i].setting, most_twist, &frame, &mover);
        const VoxelMotion motion = twist_of_frame(&mover.c, twists[i].factor, FRAMES - 1);
        voxel_move(&mover.motions, &motion);
        for (size_t d = 0; device_here(d); d++) {
            GpDevice *device = device_open(device_here(d));
            draw_frame(device, &frame, &mover.flat, voxels);
            if (d == 0)
                memcpy(first, voxels, sizeof first);
            assert_memory_equal(voxels, first, sizeof first);
            gp_device_destroy(&device);
        }
        frame_free(&frame);
        voxel_case_free(&mover.c);
    }
}

/* --- two rigid objects ------------------------------------------------------------------------ */

/* Half as large, turned about x, and so many voxels beside the centre along x. */
static VoxelMotion rigid_motion(const VoxelCase *c, double angle, double aside)
{
    VoxelMotion motion = c->model.motion, turned;
    shrink(&motion, 0.5f);
    turned = motion;
    const double cosine = cos(angle), sine = sin(angle), centre = (double)motion.centre;
    for (int i = 0; i < 4; i++) {
        const double back = i == 3 ? centre : 0;
        const double y = (double)motion.to_voxels[1][i] - back;
        const double z = (double)motion.to_voxels[2][i] - back;
        turned.to_voxels[1][i] = (float)(cosine * y - sine * z + back);
        turned.to_voxels[2][i] = (float)(sine * y + cosine * z + back);
    }
    turned.to_voxels[0][3] += (float)aside;
    return turned;
}

static void and_bits(uint8_t *bits, const uint8_t *other)
{
    for (int i = 0; i < BYTES; i++)
        bits[i] &= other[i];
}

/* A torus and a knot come towards each other along x, turning. */
static void moving_objects_collide_where_they_do(void **state)
{
    (void)state;
    enum { STEPS = 8 };
    static Mover a, b;
    static Certainty bounds, other;
    static uint8_t voxels[BYTES];
    const VoxelSetting setting = { .size = SIZE, .bits = 1, .method = VOXEL_CONSERVATIVE };
    const VoxelRange whole = voxel_range_whole(SIZE);
    Frame frame = { .color = NULL };
    add_mover("torus", &setting, 0, &frame, &a);
    add_mover("knot", &setting, 0, &frame, &b);
    const FlatTexture hits = flat_texture_make(&frame, SIZE, 1);
    voxel_collide(&frame, &a.flat, &b.flat, &whole, &hits);
    GpDevice *device = device_open(&(GpDeviceDesc){ .threads = 2 });
    bool apart = false, touching = false;
    for (int step = 0; step < STEPS; step++) {
        const VoxelMotion first = rigid_motion(&a.c, 0.3 * step, 1.5 * step - 12);
        const VoxelMotion second = rigid_motion(&b.c, -0.2 * step, 12 - 1.5 * step);
        voxel_move(&a.motions, &first);
        voxel_move(&b.motions, &second);
        draw_frame(device, &frame, &hits, voxels);
        find_bounds(&a.c, &first, VOXEL_CONSERVATIVE, &bounds);
        find_bounds(&b.c, &second, VOXEL_CONSERVATIVE, &other);
        and_bits(bounds.certain, other.certain);
        and_bits(bounds.possible, other.possible);
        check_between("collision", step, &bounds, voxels);
        const uint64_t count = voxel_count(voxels, SIZE);
        assert_int_equal(count, voxel_count_range(&hits, &whole));
        apart = apart || count == 0;
        touching = touching || count > 100;
    }
    assert_true(apart && touching);
    gp_device_destroy(&device);
    frame_free(&frame);
    voxel_case_free(&a.c);
    voxel_case_free(&b.c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_twisting_model_is_exact_in_every_frame),
        cmocka_unit_test(frames_have_the_same_bits_everywhere),
        cmocka_unit_test(moving_objects_collide_where_they_do),
    };
    return cmocka_run_group_tests_name("voxel motion", tests, NULL, NULL);
}
