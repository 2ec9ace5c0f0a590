#include "apps/items/journal.h"
#include "pipeline/io/file.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>
#include <xxhash.h>

static const char first_line[] = "glasspipe journal 1\n";

typedef struct Record {
    uint64_t item, size, hash;
} Record;

static GpResult fail(const char *path, GpError *error)
{
    const int problem = errno ? errno : EIO;
    return gp_fail(error, gp_result_of_errno(problem), "%.200s: %s", path, strerror(problem));
}

/* --- reading ---------------------------------------------------------------------------------- */

static GpResult read_head(FILE *file, const char *path, uint64_t key, GpError *error)
{
    char line[sizeof first_line] = "";
    uint64_t own = 0;
    if (fread(line, sizeof first_line - 1, 1, file) != 1 || strcmp(line, first_line) != 0 ||
        fread(&own, sizeof own, 1, file) != 1)
        return gp_fail(error, GP_ERROR_FORMAT, "%.200s: no journal", path);
    if (own != key)
        return gp_fail(error, GP_ERROR_FORMAT,
                       "%.200s: of other work, or of another version; remove it to begin anew",
                       path);
    return GP_OK;
}

/* The next item; false: there is none that is whole. */
static bool read_record(FILE *file, long end, Record *record, char **bytes)
{
    if (fread(record, sizeof *record, 1, file) != 1)
        return false;
    if (record->size > (uint64_t)(end - ftell(file)))
        return false;
    *bytes = gp_alloc(record->size + 1, 1);
    if (*bytes && (record->size == 0 || fread(*bytes, record->size, 1, file) == 1) &&
        XXH3_64bits(*bytes, record->size) == record->hash)
        return true;
    gp_free(*bytes);
    return false;
}

typedef GpResult PutFn(void *context, uint32_t item, char *bytes, size_t size, GpError *error);

/* Reads all there is and leaves the file behind the last whole item. */
static GpResult read_all(FILE *file, const char *path, PutFn *put, void *context, GpError *error)
{
    Record record;
    char *bytes;
    const long head = ftell(file);
    fseek(file, 0, SEEK_END);
    const long end = ftell(file);
    long whole = head;
    fseek(file, head, SEEK_SET);
    GpResult result = GP_OK;
    while (!result && read_record(file, end, &record, &bytes)) {
        result = put(context, (uint32_t)record.item, bytes, record.size, error);
        whole = ftell(file);
    }
    if (!result && (fseek(file, whole, SEEK_SET) != 0 || ftruncate(fileno(file), whole) != 0))
        result = fail(path, error);
    return result;
}

/* --- writing ---------------------------------------------------------------------------------- */

static GpResult begin(FILE *file, const char *path, uint64_t key, GpError *error)
{
    errno = 0;
    if (fwrite(first_line, sizeof first_line - 1, 1, file) != 1 ||
        fwrite(&key, sizeof key, 1, file) != 1 || fflush(file) != 0)
        return fail(path, error);
    return GP_OK;
}

GpResult journal_open(const char *path, uint64_t key, bool resume, PutFn *put, void *context,
                      Journal *journal, GpError *error)
{
    errno = 0;
    FILE *file = resume ? fopen(path, "r+b") : NULL;
    const bool is_there = file != NULL;
    if (!file)
        file = fopen(path, "wb");
    if (!file)
        return fail(path, error);
    GpResult result = is_there ? read_head(file, path, key, error) : begin(file, path, key, error);
    if (!result && is_there)
        result = read_all(file, path, put, context, error);
    if (result)
        fclose(file);
    else
        *journal = (Journal){ file, path };
    return result;
}

GpResult journal_add(const Journal *journal, uint32_t item, const void *bytes, size_t size,
                     GpError *error)
{
    const Record record = { item, size, XXH3_64bits(bytes ? bytes : "", size) };
    errno = 0;
    if (fwrite(&record, sizeof record, 1, journal->file) != 1 ||
        (size > 0 && fwrite(bytes, size, 1, journal->file) != 1) || fflush(journal->file) != 0)
        return fail(journal->path, error);
    return GP_OK;
}

GpResult journal_close(Journal *journal, bool done, GpError *error)
{
    if (!journal->file)
        return GP_OK;
    errno = 0;
    const bool failed = fclose(journal->file) != 0 || (done && unlink(journal->path) != 0);
    journal->file = NULL;
    return failed ? fail(journal->path, error) : GP_OK;
}
