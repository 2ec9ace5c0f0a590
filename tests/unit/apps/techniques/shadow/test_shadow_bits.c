/* The bits of shadow maps: one picture for every executor, number of threads and lane width; and
 * why the plain method's four compares and the hardware's filter are not the same, to the last
 * bit. */
#include "apps/techniques/shadow/technique.h"
#include "apps/techniques/shadow/shadow.h"
#include "pipeline/units/texture.h"
#include "tests/support/devices.h"
#include "tests/support/technique/one_picture.h"
#include "tests/support/technique/technique_case.h"
#include "tests/support/unit.h"

#include <math.h>
#include <stdio.h>

enum { MAP = 64, SIDE = 96 };

/* --- one picture ------------------------------------------------------------------------------ */

/* Every text of options gives one hash, wherever it is drawn. */
static void check(const char *path, const char *const *texts, size_t count)
{
    uint64_t hashes[SWEEP_ROWS];
    const TechniqueInput input = {
        .path = path, .width = SIDE, .height = SIDE, .setting = shadow_technique.defaults
    };
    texts_are_one_picture(&shadow_technique, &input, texts, count, hashes);
    for (size_t i = 1; i < count; i++) /* or nothing was compared */
        assert_true(hashes[i] != hashes[0]);
}

static void every_method_of_the_sweep_is_one_picture(void **state)
{
    (void)state;
    char texts[SWEEP_ROWS][SETTING_MAX_TEXT];
    const char *text[SWEEP_ROWS];
    int count = 0;
    for (const TechniqueSweep *row = shadow_technique.experiments->sweep; row->method;
         row++, count++) {
        assert_true(count < SWEEP_ROWS);
        assert_true(technique_expand(row->options, &texts[count], 1) > 0);
        snprintf(strchr(texts[count], '\0'), 24, " --map %d", MAP + count);
        text[count] = texts[count];
    }
    check("scenes/shadow_soft.json", text, (size_t)count); /* every setting goes with it */
}

static void soft_shadows_are_one_picture(void **state)
{
    (void)state;
    static const char *const texts[] = { "--method plain --filter soft --map 64",
                                         "--method plain --filter soft --facing smooth --map 64" };
    check("scenes/shadow_soft.json", texts, GP_COUNT(texts));
}

static void several_lights_and_a_cube_map_are_one_picture(void **state)
{
    (void)state;
    static const char *const texts[] = { "--map 64", "--map 64 --facing smooth --filter nearest",
                                         "--map 64 --depth d32f --outside printed --casters far" };
    check("scenes/shadow_lamps.json", texts, GP_COUNT(texts));
}

/* --- four compares and a filter --------------------------------------------------------------- */

/* The floor leans so little to the light that the last bits of its depth decide. */
static const char scene[] =
    "{'size': [96, 96], 'camera': {'eye': [2.4, 2.6, 3.4], 'at': [0, 0.35, 0], 'fovy': 36}, "
    "'lights': [{'position': [0, 3, 0.1], 'at': [0.001, 0, 0.1], 'shadow': {'fovy': 60, 'near': "
    "0.5, 'far': 8}}], 'objects': [{'mesh': 'builtin:plane', 'transform': {'scale': [2, 1, 2]}}, "
    "{'mesh': 'builtin:torus', 'transform': {'rotate': [1, 0, 0, 90]}, 'fit': [0.6, 0, 0.3, 1]}, "
    "{'mesh': 'builtin:cube', 'fit': [-0.6, 0, -0.3, 0.7]}]}";

/* No bias: differences show best where a surface shades itself. */
static const char plain_options[] = "--method plain --bias 0 --fit light --map 64";
static const char hardware_options[] = "--depth d32f --bias 0 --slope 0 --fit light --map 64";

/* What the shader of one fragment saw and returned. */
typedef struct Fragment {
    int32_t x, y;
    float place[4];    /* as interpolated */
    float coord[4][4]; /* of its reads of the map, as given to the sampler */
    float stored[4];   /* what they gave */
    int reads;
    float visibility; /* its alpha */
} Fragment;

enum { PLACE = 6, MAX_FRAGMENTS = 4 * SIDE * SIDE }; /* varyings before the place: normal, world */

typedef struct Record {
    Fragment open[SIDE][SIDE]; /* between interpolation and the pixel shader's end */
    Fragment *fragments;
    uint32_t count;
} Record;

static void record_event(void *user, const GpTraceEvent *event)
{
    Record *record = user;
    if (event->x < 0 || event->x >= SIDE || event->y >= SIDE)
        return;
    Fragment *open = &record->open[event->y][event->x];
    if (event->kind == GP_TRACE_INTERPOLATE) {
        *open = (Fragment){ .x = event->x, .y = event->y };
        memcpy(open->place, event->interpolate.varyings + PLACE, sizeof open->place);
    } else if (event->kind == GP_TRACE_TEXTURE && event->texture.slot == 1) {
        assert_true(open->reads < 4);
        open->stored[open->reads] = event->texture.texel[0];
        memcpy(open->coord[open->reads++], event->texture.coord, sizeof open->coord[0]);
    } else if (event->kind == GP_TRACE_PIXEL) {
        assert_true(record->count < MAX_FRAGMENTS);
        open->visibility = event->pixel.color[0][3];
        record->fragments[record->count++] = *open;
    }
}

/* Draws with the reference executor and records the fragments of the lit pass.
 * owns   the caller frees *frame and the record */
static Record *record_frame(void *opened, const char *options, Frame *frame)
{
    Record *record = gp_alloc(1, sizeof *record);
    GpError error = { "" };
    assert_non_null(record);
    record->fragments = gp_alloc(MAX_FRAGMENTS, sizeof *record->fragments);
    assert_non_null(record->fragments);
    const GpDeviceDesc desc = {
        .executor = GP_EXECUTOR_REFERENCE,
        .trace = { .event = record_event, .user = record, .one_pass = true, .pass = 1 },
    };
    TechniqueStage stage = { .technique = &shadow_technique, .scene = opened };
    stage.device = device_open(&desc);
    if (technique_stage_draw(&stage, options, frame, &error))
        fail_msg("%s: %s", options, error.text);
    gp_device_destroy(&stage.device);
    assert_true(record->count > SIDE * SIDE / 2);
    return record;
}

static void free_record(Record *record)
{
    gp_free(record->fragments);
    gp_free(record);
}

/* The place that the plain shader makes of its interpolant, in its arithmetic. */
static void plain_place(const Fragment *f, float place[3])
{
    const float half_texel = 0.5f / (float)MAP;
    place[0] = f->place[0] / f->place[3] * 0.5f + (0.5f + half_texel);
    place[1] = f->place[1] / f->place[3] * -0.5f + (0.5f + half_texel);
    place[2] = f->place[2] / f->place[3] - 0.0f;
}

static float mix(float t, float a, float b)
{
    return t * (a - b) + b;
}

/* The plain shader's mean of its four compares, which it may read in any order. */
static float four_compares(const Fragment *f, const float place[3], float s, float t)
{
    float passed[2][2] = { { 0 } };
    for (int i = 0; i < 4; i++) {
        bool lower = f->coord[i][1] > place[1];
        bool right = f->coord[i][0] > place[0];
        passed[lower][right] = f->stored[i] >= place[2] ? 1 : 0;
    }
    return mix(t, mix(s, passed[1][1], passed[1][0]), mix(s, passed[0][1], passed[0][0]));
}

/* The hardware's filter on a map of floats. */
static float filter(const GpSurface *map, const float place[3])
{
    const GpTexture texture = { map,
                                { .min = GP_LINEAR,
                                  .mag = GP_LINEAR,
                                  .address_u = GP_BORDER,
                                  .address_v = GP_BORDER,
                                  .border = { 1, 1, 1, 1 },
                                  .compare = true } };
    float rgba[4];
    gp_texture_sample(&texture, place, 0, rgba, NULL);
    return rgba[0];
}

/* 256ths, to nearest even, as the sampler cuts a position. */
static float in_256ths(float fraction)
{
    return rintf(fraction * 256) / 256;
}

/* A copy of a colour map's floats as depths, so that the hardware can read it. */
static GpSurface *as_depth(const GpSurface *map)
{
    const GpSurfaceDesc desc = { .format = GP_D32F, .width = map->width, .height = map->height };
    GpSurface *depth;
    GpError error;
    assert_int_equal(gp_surface_create(&desc, &depth, &error), GP_OK);
    memcpy(depth->level[0].texels, map->level[0].texels, MAP * MAP * sizeof(float));
    return depth;
}

/* From the plain method's picture to the hardware's, one change at a time. Both ends are what was
 * drawn, in every fragment that faces the light; and so is what lies between, which leaves no
 * fourth cause.
 *   fractions: the sampler knows 256ths of a texel, the shader floats map: colours hold z / w of
 *   interpolated z and w; depth buffers the rasterizer's own depth, which
 *        is linear on the screen
 *   place: one matrix to texture coordinates, and division; or division first, and then a scale */
static void three_causes_part_four_compares_from_a_filter(void **state)
{
    (void)state;
    TechniqueStage stage;
    GpError error = { "" };
    if (technique_stage_open(&shadow_technique, scene, 0, 0, &stage, &error))
        fail_msg("%s", error.text);
    Frame plain_work, hardware_work;
    Record *plain = record_frame(stage.scene, plain_options, &plain_work);
    Record *hardware = record_frame(stage.scene, hardware_options, &hardware_work);
    GpSurface *plain_map = as_depth(plain_work.list.passes[0].color[0].surface);
    const GpSurface *map = hardware_work.list.passes[0].depth.surface;
    uint32_t fractions = 0, maps = 0, places = 0, compared = 0;
    assert_int_equal(plain->count, hardware->count);
    for (uint32_t i = 0; i < plain->count; i++) {
        const Fragment *p = &plain->fragments[i], *h = &hardware->fragments[i];
        assert_true(p->x == h->x && p->y == h->y && p->reads == 4 && h->reads == 1);
        if (p->visibility == 0 && h->visibility == 0)
            continue; /* most of them face away */
        float place[3], s, t;
        plain_place(p, place);
        s = place[0] * MAP - 0.5f;
        t = place[1] * MAP - 0.5f;
        s -= floorf(s);
        t -= floorf(t);
        float drawn = four_compares(p, place, s, t);
        float rounded = four_compares(p, place, in_256ths(s), in_256ths(t));
        float other_map = filter(map, place), other_place = filter(map, h->coord[0]);
        assert_true(drawn == p->visibility);
        assert_true(rounded == filter(plain_map, place));
        assert_true(other_place == h->visibility);
        fractions += drawn != rounded;
        maps += rounded != other_map;
        places += other_map != other_place;
        compared++;
    }
    print_message("# of %u fragments: fractions part %u, maps %u, places %u\n", compared, fractions,
                  maps, places);
    assert_true(fractions > compared / 10);
    assert_true(maps > 0 && places > 0);
    gp_surface_destroy(&plain_map);
    free_record(plain);
    free_record(hardware);
    frame_free(&plain_work);
    frame_free(&hardware_work);
    technique_stage_close(&stage);
}

/* The plain method draws with a depth buffer too: its bits are the hardware's map. Its colours are
 * other roundings of the same depths. */
static void colours_are_not_the_depth_buffer(void **state)
{
    (void)state;
    TechniqueStage stage;
    GpError error = { "" };
    Frame plain, hardware;
    if (technique_stage_open(&shadow_technique, scene, 0, 0, &stage, &error) ||
        technique_stage_draw(&stage, plain_options, &plain, &error) ||
        technique_stage_draw(&stage, hardware_options, &hardware, &error))
        fail_msg("%s", error.text);
    const GpPass *pass = &plain.list.passes[0];
    const uint8_t *own = pass->depth.surface->level[0].texels;
    assert_memory_equal(own, hardware.list.passes[0].depth.surface->level[0].texels,
                        MAP * MAP * sizeof(float));
    uint32_t different = 0;
    for (size_t i = 0; i < MAP * MAP; i++) {
        float depth, color;
        memcpy(&depth, own + i * sizeof depth, sizeof depth);
        memcpy(&color, pass->color[0].surface->level[0].texels + i * sizeof color, sizeof color);
        different += depth != color;
        assert_true(fabsf(depth - color) < 0x1p-20f);
    }
    print_message("# %u of %d texels differ\n", different, MAP * MAP);
    assert_true(different > MAP * MAP / 10);
    frame_free(&plain);
    frame_free(&hardware);
    technique_stage_close(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_of_the_sweep_is_one_picture),
        cmocka_unit_test(soft_shadows_are_one_picture),
        cmocka_unit_test(several_lights_and_a_cube_map_are_one_picture),
        cmocka_unit_test(three_causes_part_four_compares_from_a_filter),
        cmocka_unit_test(colours_are_not_the_depth_buffer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
