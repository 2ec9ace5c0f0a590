/* Whether limits of memory mean here what they say: sanitizers and emulators have memory of their
 * own. */
#ifndef TESTS_LIMITED_H
#define TESTS_LIMITED_H

#include <stdbool.h>
#include <stdlib.h>

#ifndef __has_feature
#define __has_feature(feature) 0 /* gcc says it by macros */
#endif

static inline bool limits_hold(void)
{
#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__ ||                                 \
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    return false;
#else
    const char *emulator = getenv("EMULATOR");
    return !(emulator && *emulator);
#endif
}

#endif
