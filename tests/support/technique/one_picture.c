#include "tests/support/technique/one_picture.h"

#include "tests/support/devices.h"
#include "tests/support/technique/technique_case.h"
#include "tests/support/unit.h"

#include <stdio.h>

void texts_are_one_picture(const Technique *technique, const TechniqueInput *input,
                           const char *const *texts, size_t count, uint64_t *hashes)
{
    int failed = 0;
    GpError error = { "" };
    TechniqueStage stage = { .technique = technique };
    for (size_t d = 0; device_here(d); d++) {
        if (technique->open(input, &stage.scene, &error))
            fail_msg("%s", error.text);
        stage.device = device_open(device_here(d));
        for (size_t i = 0; i < count; i++) {
            const uint64_t hash = technique_stage_hash(&stage, texts[i]);
            hashes[i] = d == 0 ? hash : hashes[i];
            if (hash == hashes[i])
                continue;
            print_error("%s: %s draws other bits\n", texts[i], device_name(device_here(d)));
            failed++;
        }
        gp_device_destroy(&stage.device);
        technique->close(stage.scene);
    }
    assert_int_equal(failed, 0);
}

void sweep_is_one_picture(const Technique *technique, const TechniqueInput *input,
                          uint64_t hashes[SWEEP_ROWS])
{
    char texts[SWEEP_ROWS][SETTING_MAX_TEXT];
    const char *text[SWEEP_ROWS];
    size_t count = 0;
    for (const TechniqueSweep *row = technique->experiments->sweep; row->method; row++, count++) {
        assert_true(count < SWEEP_ROWS);
        assert_true(technique_expand(row->options, &texts[count], 1) > 0);
        text[count] = texts[count];
    }
    texts_are_one_picture(technique, input, text, count, hashes);
}
