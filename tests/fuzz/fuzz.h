/* Fuzz targets: readers of what users bring, each a function of bytes.
 *
 * `make fuzz` gives them bytes by libFuzzer, under the sanitizers; `make test` gives them their
 * seeds and the cases that were once found (tests/fuzz/found/TARGET). A target that finds something
 * wrong ends the program by fuzz_claim, as a sanitizer does. */
#ifndef TESTS_FUZZ_FUZZ_H
#define TESTS_FUZZ_FUZZ_H

#include <glasspipe/glasspipe.h>

#include <stddef.h>
#include <stdint.h>

/* Takes the seeds of a target, one after the other. */
typedef struct FuzzSeeds {
    void (*take)(void *user, const char *name, const void *data, size_t size);
    void *user;
} FuzzSeeds;

typedef struct FuzzTarget {
    const char *name;
    size_t most; /* bytes of an input */

    /* Whether the input was accepted, rather than refused with a reason; both are right. */
    bool (*run)(const uint8_t *data, size_t size);

    /* Gives inputs that are accepted, made by the program's own writers where it has one. */
    void (*seeds)(const FuzzSeeds *to);

    /* Changes an input, to at most `most` bytes; returns its size. NULL: any bytes are changed. */
    size_t (*mutate)(uint8_t *data, size_t size, size_t most, unsigned seed);
} FuzzTarget;

/* NULL at the end. */
extern const FuzzTarget *const fuzz_targets[];

/* A file of the folder $TMPDIR (or /tmp), the same one each time, with these bytes. */
const char *fuzz_file(const char *extension, const void *data, size_t size);

/* The same without content; removed. */
const char *fuzz_path(const char *extension);

/* A refusal has a reason, of one line; returns whether there is none. */
bool fuzz_accepted(GpResult result, const GpError *error);

/* Ends the program where something does not hold. */
void fuzz_claim(bool holds, const char *what);

/* Hands a text on as a seed. */
void fuzz_seed_text(const FuzzSeeds *to, const char *name, const char *text);

/* Hands a file on as a seed, and removes it. */
void fuzz_seed_file(const FuzzSeeds *to, const char *name, const char *path);

/* A device on one thread, kept: that programs are checked once makes lists a hundred times
 * faster. */
GpDevice *fuzz_device(GpExecutor executor);

/* libFuzzer's own way to change bytes, set where it is there. */
extern size_t (*fuzz_mutate_bytes)(uint8_t *data, size_t size, size_t most);

/* Changes JSON by its values and members: numbers to their limits, names to others that scenes
 * know, parts to other parts. What is no JSON is changed as bytes. */
size_t fuzz_mutate_json(uint8_t *data, size_t size, size_t most, unsigned seed);

#endif
