/* What libFuzzer calls: the target that $FUZZ names, for `make fuzz`. With FUZZ_SEEDS=FOLDER it
 * writes all targets' seeds there instead; without either it prints the targets' names and largest
 * inputs. */
#include "tests/fuzz/fuzz.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Its interface has no header for C. */
int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed);
size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most);

static const FuzzTarget *target;

static void write_seed(void *user, const char *name, const void *data, size_t size)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", (const char *)user, name);
    FILE *file = fopen(path, "wb");
    fuzz_claim(file && fwrite(data, 1, size, file) == size && fclose(file) == 0,
               "a seed can be written");
}

static void write_seeds(const char *folder)
{
    for (int i = 0; fuzz_targets[i]; i++) {
        char path[2048];
        snprintf(path, sizeof path, "%s/%s", folder, fuzz_targets[i]->name);
        mkdir(path, 0777);
        fuzz_targets[i]->seeds(&(FuzzSeeds){ write_seed, path });
    }
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    const char *name = getenv("FUZZ"), *seeds = getenv("FUZZ_SEEDS");
    fuzz_mutate_bytes = LLVMFuzzerMutate;
    if (seeds) {
        write_seeds(seeds);
        exit(0);
    }
    for (int i = 0; name && fuzz_targets[i]; i++)
        target = strcmp(name, fuzz_targets[i]->name) == 0 ? fuzz_targets[i] : target;
    if (!target) {
        for (int i = 0; fuzz_targets[i]; i++)
            printf("%s %zu\n", fuzz_targets[i]->name, fuzz_targets[i]->most);
        exit(name ? 2 : 0);
    }
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    target->run(data, size);
    return 0;
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed)
{
    return target->mutate ? target->mutate(data, size, most, seed)
                          : LLVMFuzzerMutate(data, size, most);
}
