#include "pipeline/base/fpcontrol.h"

#if defined(__SSE__)

enum { MODEL_CONTROL = 0x1f80 }; /* all exceptions masked, nearest even, no FTZ, no DAZ */

static uint64_t read_control(void)
{
    return __builtin_ia32_stmxcsr();
}

static void write_control(uint64_t control)
{
    __builtin_ia32_ldmxcsr((unsigned)control);
}

#elif defined(__aarch64__)

enum { MODEL_CONTROL = 0 }; /* FPCR: nearest even, no flush to zero, no default NaN, no traps */

static uint64_t read_control(void)
{
    uint64_t control;
    __asm__ volatile("mrs %0, fpcr" : "=r"(control));
    return control;
}

static void write_control(uint64_t control)
{
    __asm__ volatile("msr fpcr, %0" : : "r"(control));
}

#else
#error "this processor's floating-point control word is not known here"
#endif

GpFpControl gp_fp_enter(void)
{
    GpFpControl control = { read_control() };
    write_control(MODEL_CONTROL);
    return control;
}

void gp_fp_leave(GpFpControl control)
{
    write_control(control.saved);
}
