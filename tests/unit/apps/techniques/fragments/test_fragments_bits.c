/* The bits of pictures of fragments: one picture for every executor, number of threads and lane width. */
#include "apps/techniques/fragments/options.h"
#include "apps/techniques/fragments/technique.h"
#include "tests/support/devices.h"
#include "tests/support/technique/technique_case.h"
#include "tests/support/unit.h"

enum { SIDE = 48 };

static const char *const plain[] = {
    "--method sorted",
    "--method convex",
    "--method convex --pieces outward --tolerance 0.01 --order grid",
    "--method dp",
    "--method ddp",
    "--method kbuffer --kept 3",
    "--method kbuffer --kept 9 --hazard 16",
    "--method stencil --kept 4",
    "--method bucket1",
    "--method bucket2",
    "--method adaptive",
    "--method mdt",
    "--method abuffer",
    "--method cpu",
    "--method weighted",
};
static const char *const glass[] = { "--method sorted", "--method convex", "--method dp",
                                     "--method ddp" };

/* Every method gives one hash, wherever it is drawn. */
static void check_devices(const char *mesh, const FragmentOptions *options,
                          const char *const *texts, size_t count)
{
    uint64_t first[GP_COUNT(plain)];
    int failed = 0;
    GpError error = { "" };
    TechniqueStage stage = { .technique = &fragment_technique };
    const TechniqueInput input = {
        .path = mesh, .width = SIDE, .height = SIDE, .setting = options
    };
    if (fragment_technique.open(&input, &stage.scene, &error))
        fail_msg("%s", error.text);
    for (size_t d = 0; device_here(d); d++) {
        stage.device = device_open(device_here(d));
        for (size_t i = 0; i < count; i++) {
            const uint64_t hash = technique_stage_hash(&stage, texts[i]);
            first[i] = d == 0 ? hash : first[i];
            if (hash == first[i])
                continue;
            print_error("%s: %s draws other bits\n", texts[i], device_name(device_here(d)));
            failed++;
        }
        gp_device_destroy(&stage.device);
    }
    fragment_technique.close(stage.scene);
    assert_int_equal(failed, 0);
}

static void every_method_is_one_picture(void **state)
{
    (void)state;
    check_devices("builtin:torus", &fragment_option_defaults, plain, GP_COUNT(plain));
}

static void a_body_is_one_picture(void **state)
{
    (void)state;
    FragmentOptions options = fragment_option_defaults;
    options.sigma = 2;
    check_devices("builtin:torus", &options, glass, GP_COUNT(glass));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_is_one_picture),
        cmocka_unit_test(a_body_is_one_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
