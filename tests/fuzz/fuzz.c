#include "tests/fuzz/fuzz.h"

#include "pipeline/io/file.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

size_t (*fuzz_mutate_bytes)(uint8_t *data, size_t size, size_t most);

void fuzz_claim(bool holds, const char *what)
{
    if (holds)
        return;
    fprintf(stderr, "claim: %s\n", what);
    abort();
}

bool fuzz_accepted(GpResult result, const GpError *error)
{
    const size_t length = strnlen(error->text, sizeof error->text);
    fuzz_claim(result == GP_OK || length > 0, "a refusal has a reason");
    fuzz_claim(length < sizeof error->text, "a reason ends");
    return result == GP_OK;
}

GpDevice *fuzz_device(GpExecutor executor)
{
    static GpDevice *devices[GP_EXECUTORS];
    const GpDeviceDesc desc = { .executor = executor,
                                .threads = executor == GP_EXECUTOR_FAST ? 1 : 0 };
    GpError error;
    if (!devices[executor])
        fuzz_claim(gp_device_create(&desc, &devices[executor], &error) == GP_OK,
                   "there is a device");
    return devices[executor];
}

static const char *path_of(const char *extension)
{
    static char path[4096];
    const char *folder = getenv("TMPDIR");
    snprintf(path, sizeof path, "%s/glasspipe-fuzz-%d%s", folder ? folder : "/tmp", (int)getpid(),
             extension);
    return path;
}

const char *fuzz_path(const char *extension)
{
    const char *path = path_of(extension);
    unlink(path);
    return path;
}

/* Written over what is there: to make a file anew takes as long as most readers do. */
const char *fuzz_file(const char *extension, const void *data, size_t size)
{
    const char *path = path_of(extension);
    const int file = open(path, O_WRONLY | O_CREAT, 0666);
    fuzz_claim(file >= 0 && write(file, data, size) == (ssize_t)size &&
                   ftruncate(file, (off_t)size) == 0 && close(file) == 0,
               "the input can be written into $TMPDIR");
    return path;
}

void fuzz_seed_text(const FuzzSeeds *to, const char *name, const char *text)
{
    to->take(to->user, name, text, strlen(text));
}

void fuzz_seed_file(const FuzzSeeds *to, const char *name, const char *path)
{
    GpFile file;
    GpError error;
    fuzz_claim(gp_file_read(path, &file, &error) == GP_OK, "a seed can be read");
    to->take(to->user, name, file.data, file.size);
    gp_file_free(&file);
    unlink(path);
}
