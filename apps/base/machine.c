#include "apps/base/machine.h"

#include "apps/base/text.h"

#include <fcntl.h>
#include <malloc.h>
#include <stdio.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>

double machine_clock_ms(clockid_t clock)
{
    struct timespec time;
    clock_gettime(clock, &time);
    return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
}

/* Processor time of all processes since the machine started; negative where it does not tell. */
static double busy_ms(void)
{
    unsigned long long user, nice, system, idle, wait, irq, softirq;
    FILE *file = fopen("/proc/stat", "re");
    if (!file)
        return -1;
    int read = fscanf(file, "cpu %llu %llu %llu %llu %llu %llu %llu", &user, &nice, &system, &idle,
                      &wait, &irq, &softirq);
    fclose(file);
    if (read != 7)
        return -1;
    double ticks = (double)(user + nice + system + irq + softirq);
    return ticks * 1e3 / (double)sysconf(_SC_CLK_TCK);
}

MachineLoad machine_load_begin(void)
{
    return (MachineLoad){ .wall = machine_clock_ms(CLOCK_MONOTONIC),
                          .own = machine_clock_ms(CLOCK_PROCESS_CPUTIME_ID),
                          .all = busy_ms() };
}

double machine_others(const MachineLoad *begin)
{
    MachineLoad now = machine_load_begin();
    if (begin->all < 0 || now.all < 0 || now.wall <= begin->wall)
        return -1;
    double others = (now.all - begin->all) - (now.own - begin->own);
    return others > 0 ? others / (now.wall - begin->wall) : 0;
}

void machine_reset_peak(void)
{
    malloc_trim(0);
    int file = open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC);
    if (file < 0)
        return;
    (void)!write(file, "5", 1);
    close(file);
}

double machine_peak_mb(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return (double)usage.ru_maxrss / 1024;
}

void machine_describe(char *text, size_t size)
{
    char line[256], model[80] = "processor";
    FILE *file = fopen("/proc/cpuinfo", "re");
    while (file && fgets(line, sizeof line, file))
        if (sscanf(line, "model name : %79[^\n]", model) == 1)
            break;
    if (file)
        fclose(file);
    struct utsname system;
    uname(&system);
    snprintf(line, sizeof line, "%ld x %s, %.60s %.60s", sysconf(_SC_NPROCESSORS_ONLN), model,
             system.sysname, system.machine);
    text_copy(text, size, line);
}

int machine_processors(void)
{
    const long online = sysconf(_SC_NPROCESSORS_ONLN);
    return online < 1 ? 1 : online > 1024 ? 1024 : (int)online;
}
