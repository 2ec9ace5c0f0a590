/* What runs of many pictures read: paths of scenes that move, journals of what was drawn before. */
#include "apps/items/journal.h"
#include "apps/scene/path.h"
#include "tests/fuzz/targets.h"

#include <string.h>
#include <unistd.h>
#include <xxhash.h>

/* --- paths ------------------------------------------------------------------------------------ */

static const char moved[] = "{ \"camera\": { \"eye\": [0, 1, 5], \"at\": [0, 0, 0] }, \"lights\": "
                            "[ { \"direction\": [1, -2, -1] } ],"
                            " \"objects\": [ { \"mesh\": \"builtin:cube\", \"name\": \"box\", "
                            "\"translate\": [0, 0, 0] } ] }";

/* Every moment is put into a scene: before the first key, at them, between, and behind the last. */
static bool run_path(const uint8_t *data, size_t size)
{
    ScenePath path = { .root = NULL };
    GpError error = { "" };
    if (!fuzz_accepted(path_open(fuzz_file(".json", data, size), &path, &error), &error))
        return false;
    fuzz_claim(path.count > 0 && path.rate > 0, "a path has keys, and frames");
    const double first = path.times[0], last = path.times[path.count - 1];
    const double times[] = { first - 1, first, (first + last) / 2, last, last + 1 };
    for (size_t i = 0; i < GP_COUNT(times); i++) {
        json_t *scene = json_loads(moved, 0, NULL), *changes = path_at(&path, times[i]);
        fuzz_claim(scene && changes, "there is memory");
        fuzz_accepted(path_change(scene, changes, &error), &error);
        json_decref(changes);
        json_decref(scene);
    }
    path_close(&path);
    return true;
}

static void seeds_path(const FuzzSeeds *to)
{
    fuzz_seed_text(to, "all",
                   "{ \"rate\": 25, \"interpolation\": \"smooth\", \"keys\": [\n"
                   "  { \"time\": 0, \"camera\": { \"eye\": [0, 1, 5] } },\n"
                   "  { \"time\": 0.5, \"lights\": { \"0\": { \"direction\": [0, -1, 0] } } },\n"
                   "  { \"time\": 2, \"camera\": { \"eye\": [5, 1, 0] },\n"
                   "    \"objects\": { \"box\": { \"translate\": [0, 2, 0] } } } ] }");
}

/* --- journals --------------------------------------------------------------------------------- */

enum { KEY = 77, MOST = 1024, HEAD = 28, RECORD = 24 };

/* Hashes are made right, so that the records are met: each where the sizes say that one is. */
static void make_right(uint8_t *bytes, size_t size)
{
    for (size_t at = HEAD; at + RECORD <= size;) {
        uint64_t record[3];
        memcpy(record, bytes + at, RECORD);
        at += RECORD;
        if (record[1] > size - at)
            return;
        record[2] = XXH3_64bits(bytes + at, record[1]);
        memcpy(bytes + at - RECORD, record, RECORD);
        at += record[1];
    }
}

/* Bytes of all items that were put. */
static GpResult put(void *sum, uint32_t item, char *bytes, size_t size, GpError *error)
{
    (void)item;
    (void)error;
    for (size_t i = 0; i < size; i++)
        *(uint32_t *)sum += (uint8_t)bytes[i];
    *(uint32_t *)sum += 1;
    gp_free(bytes);
    return GP_OK;
}

/* What was read once is what is read again, after another item was added. */
static bool run_journal(const uint8_t *data, size_t size)
{
    uint8_t bytes[MOST];
    uint32_t first = 0, again = 0;
    Journal journal = { .file = NULL };
    GpError error = { "" };
    if (size > MOST)
        return false;
    memcpy(bytes, data, size);
    make_right(bytes, size);
    const char *path = fuzz_file(".journal", bytes, size);
    if (!fuzz_accepted(journal_open(path, KEY, true, put, &first, &journal, &error), &error))
        return false;
    fuzz_claim(journal_add(&journal, 9, "x", 1, &error) == GP_OK &&
                   journal_close(&journal, false, &error) == GP_OK &&
                   journal_open(path, KEY, true, put, &again, &journal, &error) == GP_OK,
               "a journal that was read can be gone on with");
    fuzz_claim(again == first + 'x' + 1, "no item is lost");
    fuzz_claim(journal_close(&journal, true, &error) == GP_OK, "it can be removed");
    return true;
}

static void seeds_journal(const FuzzSeeds *to)
{
    Journal journal;
    GpError error;
    const char *path = fuzz_path(".journal");
    const bool written = journal_open(path, KEY, false, put, NULL, &journal, &error) == GP_OK &&
                         journal_add(&journal, 3, "some bytes", 10, &error) == GP_OK &&
                         journal_add(&journal, 0, "", 0, &error) == GP_OK &&
                         journal_add(&journal, 1, "more", 4, &error) == GP_OK &&
                         journal_close(&journal, false, &error) == GP_OK;
    if (written)
        fuzz_seed_file(to, "three", path);
}

const FuzzTarget fuzz_path_file = { "path", 2048, run_path, seeds_path, fuzz_mutate_json };
const FuzzTarget fuzz_journal = { "journal", MOST, run_journal, seeds_journal, NULL };
