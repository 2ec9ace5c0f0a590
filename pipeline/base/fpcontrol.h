/* The floating-point control word: rounding to nearest, gradual underflow, no traps (R29).
 *
 * Another library in the process may have switched denormals off or changed the rounding; every run
 * of a device sets what the model asks for and puts back what it found. */
#ifndef GP_FPCONTROL_H
#define GP_FPCONTROL_H

#include <stdint.h>

typedef struct GpFpControl {
    uint64_t saved;
} GpFpControl;

/* Sets the model's control word for this thread; returns what to restore. */
GpFpControl gp_fp_enter(void);
void gp_fp_leave(GpFpControl control);

#endif
