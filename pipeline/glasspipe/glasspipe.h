/* glasspipe: a software GPU of the 2005 class that gives the same bits everywhere.
 *
 *     GpDevice *device;
 *     gp_device_create(&(GpDeviceDesc){ 0 }, &device, &error);
 *     gp_device_run(device, &list, &error);
 *     gp_device_destroy(&device);
 *
 * Include this header alone; shader files include <glasspipe/shader.h>. Every name begins with gp_,
 * Gp or GP_, and C++ may include it too.
 */
#ifndef GLASSPIPE_H
#define GLASSPIPE_H

#include "pipeline/list/counters.h"
#include "pipeline/list/list.h"
#include "pipeline/list/needs.h"
#include "pipeline/list/trace.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Of the library; the first number changes where programs must be compiled anew. */
#define GP_VERSION "0.1.0"

/* Who runs a list; all give the same bits. */
typedef enum GpExecutor {
    GP_EXECUTOR_FAST = 0,  /* tiles, lanes and threads */
    GP_EXECUTOR_REFERENCE, /* one unit after the other, one thread, can be traced wholly */
    GP_EXECUTORS
} GpExecutor;

/* How a list is run. All zero: the fast executor, on all processors, at the widest lanes. */
typedef struct GpDeviceDesc {
    GpExecutor executor;
    int threads; /* 0: one a processor; never changes a bit */
    /* NULL or "auto": $GP_ISA, else the widest that every program of a list was compiled for;
     * "sse2" "avx2" "avx512" "neon" force one. Never changes a bit */
    const char *isa;
    GpTrace trace; /* of the fast executor only with only_wanted, of the reference only without */
    bool timed;    /* fast executor: looks at the clock inside tiles too, which costs some time */
} GpDeviceDesc;

/* An executor with its threads, its memory and its counters; gp_device_create makes one. */
typedef struct GpDevice GpDevice;

/* Creates a device. Errors: GP_ERROR_INVALID (executor, threads, isa's name, a trace that the
 * executor does not have), GP_ERROR_UNSUPPORTED (an isa that this processor or build lacks),
 * GP_ERROR_MEMORY. Several devices may run at once, each from its own thread. */
GpResult gp_device_create(const GpDeviceDesc *desc, GpDevice **device, GpError *error);
void gp_device_destroy(GpDevice **device); /* NULL and a pointer to NULL are fine; sets NULL */

/* Checks the list (gp_list_check), then runs it to the end. What it has checked of a program it
 * remembers by the program's address and fields: programs and their code stay where and as they are
 * until the device is destroyed. On an error no texel has changed, but
 * for GP_ERROR_MEMORY of the fast executor, or of passes that sort, which may come after earlier
 * passes were drawn. The floating-point control word is set for the duration and restored (R29). */
GpResult gp_device_run(GpDevice *device, const GpList *list, GpError *error);

/* The isa that the last run used ("sse2", ...), or the forced one before any; "auto" before the
 * first. Valid as long as the device is. */
const char *gp_device_isa(const GpDevice *device);

/* As it was asked for. */
GpExecutor gp_device_executor(const GpDevice *device);

/* Threads that it runs on; the reference executor has one. */
int gp_device_threads(const GpDevice *device);

/* Work since the device was created, and times of the last run; valid as long as the device is. */
const GpCounters *gp_device_counters(const GpDevice *device);
const GpPhases *gp_device_phases(const GpDevice *device);

#ifdef __cplusplus
}
#endif

#endif
