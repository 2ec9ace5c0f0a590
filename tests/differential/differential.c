/* Differential test: random scenes, drawn by the reference and by the fast executor, must have the
 * same bits in every attachment.
 *
 *   differential A..B     the seeds from A up to and with B (default 0..1999)
 *
 * Odd seeds add variety (random_variety.h), every other pair ternary depth tests
 * (random_ternary.h), every other four passes that sort (random_order.h), every other eight passes
 * that repeat earlier ones (random_repeats.h). $GP_ISA forces a lane width. Threads change from
 * seed to seed. Speaks TAP, and ends with "N passed, M failed"; a seed that fails says how to run
 * it alone.
 */
#include <glasspipe/glasspipe.h>
#include "tests/support/lists/random_order.h"
#include "tests/support/lists/random_repeats.h"
#include "tests/support/lists/random_ternary.h"
#include "tests/support/lists/random_variety.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* Sizes: most frames are small, so that many states are met; some span tiles; a few are huge. */
static uint32_t largest_side(uint64_t seed)
{
    return seed % 2000 == 1999 ? 2048 : seed % 100 == 99 ? 700 : seed % 10 == 9 ? 200 : 64;
}

/* Draws the scene of a seed; false with a reason where it cannot. */
static bool draw(uint64_t seed, const GpDeviceDesc *desc, RandomList *random, GpError *error)
{
    GpDevice *device = NULL;
    if (!random_list_create(seed, largest_side(seed), random) ||
        (seed % 2 && !random_variety_add(seed, random)) ||
        (seed % 4 > 1 && !random_ternary_add(seed, random)) ||
        (seed % 8 > 3 && !random_order_add(seed, random))) {
        gp_fail(error, GP_ERROR_MEMORY, "no memory for the scene");
        return false;
    }
    if (seed % 16 > 7)
        random_repeats_add(seed, random);
    bool drawn = gp_device_create(desc, &device, error) == GP_OK &&
                 gp_device_run(device, &random->list, error) == GP_OK;
    gp_device_destroy(&device);
    return drawn;
}

/* Tells the first pixel in which two surfaces differ. */
static void tell_difference(const GpSurface *a, const GpSurface *b, int number)
{
    const size_t bytes = gp_format_info(a->format)->bytes;
    uint32_t different = 0, x = 0, y = 0;
    for (uint32_t i = a->width * a->height; i-- > 0;)
        if (memcmp(gp_surface_texel(&a->level[0], bytes, i % a->width, i / a->width),
                   gp_surface_texel(&b->level[0], bytes, i % a->width, i / a->width), bytes) != 0) {
            different++;
            x = i % a->width;
            y = i / a->width;
        }
    printf("# surface %d, %s %ux%u: %u pixels differ, the first at %u, %u\n", number,
           gp_format_info(a->format)->name, a->width, a->height, different, x, y);
}

static bool same_bits(const RandomList *a, const RandomList *b)
{
    bool same = true;
    for (int i = 0; i < a->surface_count; i++)
        if (gp_surface_hash(a->surfaces[i]) != gp_surface_hash(b->surfaces[i])) {
            tell_difference(a->surfaces[i], b->surfaces[i], i);
            same = false;
        }
    if (!random_variety_gaps_kept(a) || !random_variety_gaps_kept(b)) {
        puts("# bytes between the rows of a surface have changed");
        same = false;
    }
    return same;
}

static bool check_seed(uint64_t seed, RandomList *reference, RandomList *fast)
{
    static const int threads[] = { 1, 2, 3, 8, 16 };
    GpError error = { "" };
    bool drawn =
        draw(seed, &(GpDeviceDesc){ .executor = GP_EXECUTOR_REFERENCE }, reference, &error) &&
        draw(seed, &(GpDeviceDesc){ .threads = threads[seed % GP_COUNT(threads)] }, fast, &error);
    bool same = drawn && same_bits(reference, fast);
    if (!drawn)
        printf("# %s\n", error.text);
    random_list_destroy(reference);
    random_list_destroy(fast);
    return same;
}

int main(int count, char **arguments)
{
    uint64_t first = 0, last = 1999, passed = 0, failed = 0;
    if (count > 2 ||
        (count == 2 &&
         (sscanf(arguments[1], "%" SCNu64 "..%" SCNu64, &first, &last) != 2 || last < first))) {
        fprintf(stderr, "usage: differential [A..B]\n");
        return 2;
    }
    RandomList *reference = gp_alloc(1, sizeof *reference), *fast = gp_alloc(1, sizeof *fast);
    if (!reference || !fast)
        return 4;
    printf("1..%" PRIu64 "\n", last - first + 1);
    for (uint64_t seed = first; seed <= last; seed++) {
        bool same = check_seed(seed, reference, fast);
        printf("%sok %" PRIu64 " - seed %" PRIu64 "\n", same ? "" : "not ", seed - first + 1, seed);
        if (!same)
            printf("# again: make differential SEEDS=%" PRIu64 "..%" PRIu64 "\n", seed, seed);
        passed += same;
        failed += !same;
    }
    printf("%" PRIu64 " passed, %" PRIu64 " failed\n", passed, failed);
    gp_free(reference);
    gp_free(fast);
    return failed != 0;
}
