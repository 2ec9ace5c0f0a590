/* Groups: which passes may run tile by tile, and the one thing each that ends a group. */
#include "pipeline/list/list.h"
#include "tests/shaders/exercise.h"
#include "tests/support/unit.h"

enum { MOST = 80 };

typedef struct Frame {
    GpSurface *surface[2 * MOST];
    GpDraw draw[MOST];
    GpPass pass[MOST];
    GpList list;
} Frame;

static GpSurface *surface(uint32_t width, uint32_t height, GpRect window, void *memory)
{
    GpSurface *s = NULL;
    const GpSurfaceDesc desc = {
        .format = GP_A8R8G8B8, .width = width, .height = height, .window = window, .memory = memory
    };
    assert_int_equal(gp_surface_create(&desc, &s, NULL), GP_OK);
    return s;
}

/* Passes that draw into a target each; the first half of the surfaces are these. */
static Frame *begin(uint32_t passes)
{
    static Frame f;
    memset(&f, 0, sizeof f);
    for (uint32_t i = 0; i < passes; i++) {
        f.surface[i] = surface(256, 128, (GpRect){ 0 }, NULL);
        f.draw[i].program = &exercise_color;
        f.pass[i] = (GpPass){ .color[0] = { .surface = f.surface[i] },
                              .draws = &f.draw[i],
                              .draw_count = 1 };
    }
    f.list = (GpList){ f.pass, passes };
    return &f;
}

static void replace(Frame *f, int number, GpSurface *with)
{
    gp_surface_destroy(&f->surface[number]);
    f->surface[number] = with;
    if (number < MOST)
        f->pass[number].color[0].surface = with;
}

/* A pass reads a surface in one texture slot. */
static void reads(Frame *f, int pass, const GpProgram *program, GpSurface *read)
{
    f->draw[pass].program = program;
    for (int slot = 0; slot < GP_MAX_SAMPLERS; slot++)
        f->draw[pass].textures[slot].surface = read;
}

/* Groups by pass, as digits: "0011" is two of two. */
static void ends_as(Frame *f, const char *what, const char *expected)
{
    uint32_t group_of[MOST];
    char got[MOST + 1] = "";
    const uint32_t groups = gp_list_groups(&f->list, group_of);
    for (uint32_t i = 0; i < f->list.pass_count; i++)
        got[i] = (char)('0' + group_of[i]);
    if (strcmp(got, expected) != 0)
        fail_msg("%s: groups %s, expected %s", what, got, expected);
    assert_int_equal(groups, f->list.pass_count ? group_of[f->list.pass_count - 1] + 1 : 0);
    for (size_t i = 0; i < GP_COUNT(f->surface); i++)
        gp_surface_destroy(&f->surface[i]);
}

static void passes_of_one_size_are_one_group(void **state)
{
    (void)state;
    ends_as(begin(0), "none", "");
    ends_as(begin(1), "one", "0");
    ends_as(begin(4), "four", "0000");
    Frame *f = begin(4);
    f->pass[2].color[0].surface = NULL;
    f->pass[2].depth.surface = f->surface[0];
    ends_as(f, "depth alone", "0000");
    f = begin(4);
    replace(f, 2, surface(128, 128, (GpRect){ 0 }, NULL));
    ends_as(f, "width", "0012");
    f = begin(4);
    replace(f, 2, surface(256, 256, (GpRect){ 0 }, NULL));
    ends_as(f, "height", "0012");
    f = begin(4);
    replace(f, 2, surface(256, 128, (GpRect){ 0, 0, 128, 128 }, NULL));
    ends_as(f, "window", "0012");
}

static void reading_elsewhere_ends_a_group_and_reading_in_place_does_not(void **state)
{
    (void)state;
    Frame *f = begin(4);
    reads(f, 2, &exercise_local, f->surface[0]);
    ends_as(f, "in place", "0000");
    f = begin(4);
    reads(f, 2, &exercise_texture, f->surface[1]);
    ends_as(f, "an earlier target", "0011");
    f = begin(4);
    f->surface[MOST] = surface(256, 128, (GpRect){ 0 }, NULL);
    reads(f, 2, &exercise_texture, f->surface[MOST]);
    ends_as(f, "no target", "0000");
    f = begin(4);
    reads(f, 0, &exercise_texture, f->surface[3]);
    ends_as(f, "a later target", "0001");
    f = begin(4);
    reads(f, 1, &exercise_vertex_texture, f->surface[0]);
    ends_as(f, "by vertices", "0111");
}

/* Memory of one target under two names. */
static void other_names_of_a_target_end_a_group(void **state)
{
    (void)state;
    Frame *f = begin(4);
    replace(f, 2, surface(256, 128, (GpRect){ 0 }, f->surface[1]->level[0].texels));
    ends_as(f, "the same texels", "0011");
    f = begin(4);
    f->surface[MOST] = surface(256, 128, (GpRect){ 0 }, f->surface[1]->level[0].texels);
    reads(f, 2, &exercise_local, f->surface[MOST]);
    ends_as(f, "read in place", "0011");
    f = begin(4);
    f->surface[MOST] = surface(256, 128, (GpRect){ 0 }, f->surface[3]->level[0].texels);
    reads(f, 1, &exercise_local, f->surface[MOST]);
    ends_as(f, "of a later target", "0001");
    f = begin(4);
    static uint8_t memory[256 * 128 * 4];
    replace(f, 1, surface(256, 128, (GpRect){ 0 }, memory));
    ends_as(f, "texels of its own", "0000");
}

/* More surfaces than are kept in mind: what was forgotten might be read. */
static void many_surfaces_end_a_group(void **state)
{
    (void)state;
    enum { PASSES = 70, KEPT = 64 };
    for (int reading = 0; reading < 2; reading++) {
        Frame *f = begin(PASSES);
        for (int i = 0; reading && i < PASSES; i++) {
            f->surface[MOST + i] = surface(1, 1, (GpRect){ 0 }, NULL);
            reads(f, i, &exercise_texture, f->surface[MOST + i]);
            f->pass[i].color[0].surface = f->surface[0];
        }
        char expected[PASSES + 1] = "";
        for (int i = 0; i < PASSES; i++)
            expected[i] = i <= KEPT ? '0' : '1'; /* the one too many is known when the next comes */
        ends_as(f, reading ? "read" : "written", expected);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(passes_of_one_size_are_one_group),
        cmocka_unit_test(reading_elsewhere_ends_a_group_and_reading_in_place_does_not),
        cmocka_unit_test(other_names_of_a_target_end_a_group),
        cmocka_unit_test(many_surfaces_end_a_group),
    };
    return cmocka_run_group_tests_name("groups", tests, NULL, NULL);
}
