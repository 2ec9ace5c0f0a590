/* Instruction sets: what this build has, what this processor runs, what a list was compiled for. */
#include "pipeline/list/isa.h"

#include <stdatomic.h>
#include <string.h>
#ifdef __x86_64__
#include <cpuid.h>
#endif

int gp_isa_lanes(const char *name)
{
    static const struct {
        const char *name;
        int lanes;
    } known[] = {
        { "auto", 0 }, { "sse2", 4 },   { "neon", 4 },    { "lanes4", 4 },
        { "avx2", 8 }, { "lanes8", 8 }, { "avx512", 16 }, { "lanes16", 16 },
    };
    if (!name)
        return 0;
    for (size_t i = 0; i < GP_COUNT(known); i++)
        if (strcmp(name, known[i].name) == 0)
            return known[i].lanes;
    return -1;
}

#ifdef __x86_64__
/* Halves from floats and back. clang 14 has no name for it to be asked by; and the instruction that
 * tells takes as long as a small draw on a virtual machine, so it is run once. */
static bool has_f16c(void)
{
    enum { UNKNOWN, NO, YES };
    static atomic_int known = UNKNOWN;
    int answer = atomic_load_explicit(&known, memory_order_relaxed);
    if (answer == UNKNOWN) {
        unsigned a, b, c, d;
        answer = __get_cpuid(1, &a, &b, &c, &d) && c & bit_F16C ? YES : NO;
        atomic_store_explicit(&known, answer, memory_order_relaxed);
    }
    return answer == YES;
}
#endif

bool gp_isa_runs(const char *name)
{
#if defined(__x86_64__)
    if (strcmp(name, "avx512") == 0)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
               has_f16c();
    if (strcmp(name, "avx2") == 0)
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && has_f16c();
    return strcmp(name, "neon") != 0;
#elif defined(__aarch64__)
    return strcmp(name, "neon") == 0 || strcmp(name, "generic") == 0;
#else
    return strcmp(name, "generic") == 0;
#endif
}

/* What the build compiled for each width (see ISAS in the Makefile). */
static const char *const built_isas[GP_CODE_WIDTHS] = {
#ifdef GP_LANES4_ISA
    GP_LANES4_ISA,
#else
    NULL,
#endif
#ifdef GP_LANES8_ISA
    GP_LANES8_ISA,
#else
    NULL,
#endif
#ifdef GP_LANES16_ISA
    GP_LANES16_ISA,
#else
    NULL,
#endif
};

const char *gp_isa_of_lanes(int lanes)
{
    const char *isa = built_isas[gp_code_width(lanes)];
    return isa && gp_isa_runs(isa) ? isa : NULL;
}

bool gp_isa_serves(const GpList *list, int lanes, const GpProgram **missing)
{
    for (uint32_t p = 0; p < list->pass_count; p++)
        for (uint32_t i = 0; i < list->passes[p].draw_count; i++) {
            const GpProgram *program = list->passes[p].draws[i].program;
            const GpProgramCode *code = gp_program_code(program, lanes);
            if (!code || !gp_isa_runs(code->isa)) {
                *missing = program;
                return false;
            }
        }
    *missing = NULL;
    return true;
}
