/* Every one-argument function of pipeline/base/detmath.h at every one of the 2^32 floats (R52).
 *
 * One line per function with the largest error in ulp and its argument, then the count of passed
 * and failed functions. Exit status 1 on a failure.
 */
#include "tests/kernel/detmath_oracle.h"

#include <pthread.h>
#include <stdio.h>
#include <unistd.h>

/* --- all arguments, shared among threads ------------------------------------------------------ */

typedef struct Share {
    const DetmathFunction *function;
    uint64_t begin, end; /* bits of the arguments, multiples of the lane count */
    double worst;
    float worst_x;
} Share;

static void *measure(void *argument)
{
    Share *share = argument;
    for (uint64_t bits = share->begin; bits < share->end; bits += GP_LANES) {
        flt x;
        for (int lane = 0; lane < GP_LANES; lane++)
            x[lane] = gp_bits_float((uint32_t)bits + (uint32_t)lane);
        flt result = share->function->lanes(x);
        for (int lane = 0; lane < GP_LANES; lane++) {
            double error = detmath_error(share->function, x[lane], result[lane]);
            if (error > share->worst) {
                share->worst = error;
                share->worst_x = x[lane];
            }
        }
    }
    return NULL;
}

static Share worst_of_all_floats(const DetmathFunction *function)
{
    enum { MOST_THREADS = 64 };
    Share shares[MOST_THREADS];
    pthread_t threads[MOST_THREADS];
    bool started[MOST_THREADS];
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    uint64_t count = cores < 1 ? 1 : cores > MOST_THREADS ? MOST_THREADS : (uint64_t)cores;
    uint64_t blocks = (UINT64_C(1) << 32) / GP_LANES;

    for (uint64_t i = 0; i < count; i++) {
        shares[i] = (Share){ .function = function,
                             .begin = blocks * i / count * GP_LANES,
                             .end = blocks * (i + 1) / count * GP_LANES };
        started[i] = pthread_create(&threads[i], NULL, measure, &shares[i]) == 0;
        if (!started[i])
            measure(&shares[i]);
    }
    Share worst = { .function = function };
    for (uint64_t i = 0; i < count; i++) {
        if (started[i])
            pthread_join(threads[i], NULL);
        if (shares[i].worst > worst.worst)
            worst = shares[i];
    }
    return worst;
}

int main(void)
{
    int failed = 0;
    for (size_t i = 0; i < GP_COUNT(detmath_functions); i++) {
        Share worst = worst_of_all_floats(&detmath_functions[i]);
        bool passed = worst.worst <= detmath_functions[i].ulps;
        failed += !passed;
        printf("%-8s %s  largest error %.4f ulp at %a\n", detmath_functions[i].name,
               passed ? "ok    " : "FAILED", worst.worst, (double)worst.worst_x);
        fflush(stdout);
    }
    printf("%d passed, %d failed\n", (int)GP_COUNT(detmath_functions) - failed, failed);
    return failed ? 1 : 0;
}
