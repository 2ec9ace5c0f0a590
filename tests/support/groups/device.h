/* A device of two threads for a whole group of tests: cmocka_run_group_tests(tests, device_set_up,
 * device_tear_down). */
#ifndef TESTS_GROUPS_DEVICE_H
#define TESTS_GROUPS_DEVICE_H

#include <glasspipe/glasspipe.h>

static GpDevice *device;

static inline int device_set_up(void **state)
{
    (void)state;
    return gp_device_create(&(GpDeviceDesc){ .threads = 2 }, &device, NULL);
}

static inline int device_tear_down(void **state)
{
    (void)state;
    gp_device_destroy(&device);
    return 0;
}

#endif
