/* Random lists for so many seconds, on one device of each executor: `make soak SOAK_S=600`.
 *
 * The same seeds come round again and again. Each has the bits of its first time, and once all have
 * been there, the program's memory grows no more. Says how many lists it ran, and its memory at
 * both times. */
#include <glasspipe/glasspipe.h>
#include "tests/support/lists/random_order.h"
#include "tests/support/lists/random_repeats.h"
#include "tests/support/lists/random_ternary.h"
#include "tests/support/lists/random_variety.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

enum {
    SEEDS = 96,
    SIDE = 128,
    WARM = 3,       /* rounds after which memory has its size: the allocator's own settles too */
    ALLOWED = 1024, /* pages: 4 MB */
};

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Pages that the program has in memory. */
static long resident(void)
{
    long all = 0, pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (!file || fscanf(file, "%ld %ld", &all, &pages) != 2)
        pages = 0;
    if (file)
        fclose(file);
    return pages;
}

static bool make_list(uint64_t seed, RandomList *random)
{
    const bool made = random_list_create(seed, SIDE, random) &&
                      (seed % 2 == 0 || random_variety_add(seed, random)) &&
                      (seed % 4 < 2 || random_ternary_add(seed, random)) &&
                      (seed % 8 < 4 || random_order_add(seed, random));
    if (made && seed % 16 > 7)
        random_repeats_add(seed, random);
    return made;
}

/* The hash of a seed's list; 0 where it does not run. */
static uint64_t run(GpDevice *device, uint64_t seed)
{
    static RandomList random;
    GpError error = { "" };
    const bool drawn =
        make_list(seed, &random) && gp_device_run(device, &random.list, &error) == GP_OK;
    const uint64_t hash = drawn ? random_list_hash(&random) : 0;
    random_list_destroy(&random);
    if (!drawn)
        fprintf(stderr, "seed %" PRIu64 ": %s\n", seed, error.text);
    return hash;
}

int main(int count, char **arguments)
{
    const double seconds = count > 1 ? atof(arguments[1]) : 10, end = now() + seconds;
    static uint64_t first[SEEDS];
    GpDevice *fast = NULL, *reference = NULL;
    GpError error;
    uint64_t lists = 0;
    long warm = 0;
    if (gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &fast, &error) ||
        gp_device_create(&(GpDeviceDesc){ .executor = GP_EXECUTOR_REFERENCE }, &reference, &error))
        return 4;
    for (int round = 0; round <= WARM || now() < end; round++) {
        for (uint64_t seed = 0; seed < SEEDS; seed++, lists++) {
            GpDevice *device = round == 0 ? reference : fast;
            const uint64_t hash = run(device, seed);
            first[seed] = round == 0 ? hash : first[seed];
            if (hash == 0 || hash != first[seed]) {
                printf("seed %" PRIu64 ", round %d: other bits\n", seed, round);
                return 1;
            }
        }
        if (round == WARM)
            warm = resident();
    }
    const long grown = resident() - warm;
    printf("%" PRIu64 " lists in %.0f s, the same bits each time; memory %ld KB, then %ld KB\n",
           lists, seconds, warm * 4, (warm + grown) * 4);
    gp_device_destroy(&fast);
    gp_device_destroy(&reference);
    return grown > ALLOWED;
}
