/* What `make fuzz` runs, without it: each target accepts its own seeds, and gets over the cases
 * that were once found to break it. */
#include "tests/fuzz/fuzz.h"
#include "tests/support/unit.h"

#include <dirent.h>
#include <stdio.h>

#include "pipeline/io/file.h"

typedef struct Seeds {
    const FuzzTarget *target;
    int accepted, count;
} Seeds;

static void run_seed(void *user, const char *name, const void *data, size_t size)
{
    Seeds *seeds = user;
    assert_true(size <= seeds->target->most);
    seeds->count++;
    if (seeds->target->run(data, size))
        seeds->accepted++;
    else
        print_message("# %s: the seed %s is refused\n", seeds->target->name, name);
}

static void every_target_accepts_its_seeds(void **state)
{
    (void)state;
    int refused = 0;
    for (int i = 0; fuzz_targets[i]; i++) {
        Seeds seeds = { fuzz_targets[i], 0, 0 };
        fuzz_targets[i]->seeds(&(FuzzSeeds){ run_seed, &seeds });
        if (seeds.count == 0)
            fail_msg("%s has no seeds", fuzz_targets[i]->name);
        refused += seeds.count - seeds.accepted;
    }
    assert_int_equal(refused, 0);
}

static int run_folder(const FuzzTarget *target)
{
    char folder[256], path[1024];
    struct dirent **entries;
    snprintf(folder, sizeof folder, "tests/fuzz/found/%s", target->name);
    const int count = scandir(folder, &entries, NULL, alphasort);
    int run = 0;
    for (int i = 0; i < count; i++) {
        GpFile file;
        GpError error;
        snprintf(path, sizeof path, "%s/%s", folder, entries[i]->d_name);
        if (entries[i]->d_name[0] != '.') {
            assert_int_equal(gp_file_read(path, &file, &error), GP_OK);
            print_message("# %s\n", path);
            target->run((const uint8_t *)file.data, file.size);
            gp_file_free(&file);
            run++;
        }
        free(entries[i]);
    }
    if (count >= 0)
        free(entries);
    return run;
}

static void found_cases_stay_mended(void **state)
{
    (void)state;
    int run = 0;
    for (int i = 0; fuzz_targets[i]; i++)
        run += run_folder(fuzz_targets[i]);
    assert_true(run > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_target_accepts_its_seeds),
        cmocka_unit_test(found_cases_stay_mended),
    };
    return cmocka_run_group_tests_name("fuzz targets", tests, NULL, NULL);
}
