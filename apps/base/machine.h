/* What a measurement needs to know of the machine: clocks, memory, and who else is at work. */
#ifndef APPS_BASE_MACHINE_H
#define APPS_BASE_MACHINE_H

#include <stddef.h>
#include <time.h>

/* Milliseconds of a clock: CLOCK_MONOTONIC, CLOCK_PROCESS_CPUTIME_ID. */
double machine_clock_ms(clockid_t clock);

/* Times at the begin of a measurement: the clock's, this process's, and all processes'. */
typedef struct MachineLoad {
    double wall, own, all;
} MachineLoad;

MachineLoad machine_load_begin(void);

/* Processors that other processes kept busy since then, on average; negative where the system does
 * not tell. */
double machine_others(const MachineLoad *begin);

/* Gives free memory back and forgets the peak so far, where the system can: else only growth beyond
 * it shows. */
void machine_reset_peak(void);

/* Memory in use at most, in megabytes. */
double machine_peak_mb(void);

/* Processors that work may be spread over: at least 1, at most 1024. */
int machine_processors(void);

/* What is measured on: "2 x Intel(R) Xeon(R) Processor, Linux x86_64". */
void machine_describe(char *text, size_t size);

#endif
