/* The bits of pictures of fragments: one picture for every executor, number of threads and lane
 * width. */
#include "apps/techniques/fragments/options.h"
#include "apps/techniques/fragments/technique.h"
#include "tests/support/technique/one_picture.h"
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

static void check(const FragmentOptions *options, const char *const *texts, size_t count)
{
    uint64_t hashes[GP_COUNT(plain)];
    const TechniqueInput input = {
        .path = "builtin:torus", .width = SIDE, .height = SIDE, .setting = options
    };
    texts_are_one_picture(&fragment_technique, &input, texts, count, hashes);
}

static void every_method_is_one_picture(void **state)
{
    (void)state;
    check(&fragment_option_defaults, plain, GP_COUNT(plain));
}

static void a_body_is_one_picture(void **state)
{
    (void)state;
    FragmentOptions options = fragment_option_defaults;
    options.sigma = 2;
    check(&options, glass, GP_COUNT(glass));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_is_one_picture),
        cmocka_unit_test(a_body_is_one_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
