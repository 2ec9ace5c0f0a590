/* The bits of pictures of volumes: one picture for every executor, number of threads and lane width. */
#include "apps/techniques/volume/options.h"
#include "apps/techniques/volume/technique.h"
#include "tests/support/devices.h"
#include "tests/support/technique_case.h"
#include "tests/support/unit.h"

#include <stdio.h>

enum { SIDE = 64, MAX_TEXTS = 64 };

/* One text of each row of the sweep. */
static int list_texts(char (*texts)[SETTING_MAX_TEXT])
{
    int count = 0;
    for (const TechniqueSweep *row = volume_technique.experiments->sweep; row->method; row++) {
        assert_true(count < MAX_TEXTS);
        assert_true(technique_expand(row->options, &texts[count++], 1) > 0);
    }
    return count;
}

/* Every method gives one hash, wherever it is drawn. */
static void check_devices(const char *volume, const VolumeOptions *options,
                          uint64_t first[MAX_TEXTS])
{
    char texts[MAX_TEXTS][SETTING_MAX_TEXT];
    const int count = list_texts(texts);
    int failed = 0;
    GpError error = { "" };
    TechniqueStage stage = { .technique = &volume_technique };
    const TechniqueInput input = {
        .path = volume, .width = SIDE, .height = SIDE, .setting = options
    };
    if (volume_technique.open(&input, &stage.scene, &error))
        fail_msg("%s", error.text);
    for (size_t d = 0; device_here(d); d++) {
        stage.device = device_open(device_here(d));
        for (int i = 0; i < count; i++) {
            const uint64_t hash = technique_stage_hash(&stage, texts[i]);
            first[i] = d == 0 ? hash : first[i];
            if (hash == first[i])
                continue;
            print_error("%s: %s draws other bits\n", texts[i], device_name(device_here(d)));
            failed++;
        }
        gp_device_destroy(&stage.device);
    }
    volume_technique.close(stage.scene);
    assert_int_equal(failed, 0);
}

static void every_method_of_the_sweep_is_one_picture(void **state)
{
    (void)state;
    uint64_t unlit[MAX_TEXTS], lit[MAX_TEXTS];
    VolumeOptions options = volume_option_defaults;
    check_devices("builtin:marschner-lobb:14", &options, unlit);
    options.lit = true;
    options.orbit.azimuth = 200;
    check_devices("builtin:ball:14", &options, lit);
    assert_true(lit[0] != unlit[0]); /* or nothing was compared */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_of_the_sweep_is_one_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
