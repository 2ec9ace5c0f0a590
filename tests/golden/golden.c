/* Golden frames: every attachment of small frames, by the hash of its raw bytes.
 *
 *   golden                 compares all cases with tests/golden/golden.txt, as TAP
 *   golden --first N       the first N of them, which are small
 *   golden --bless CASE    writes that case's lines anew
 *
 * A line is "case attachment WxH format hash". Both executors draw every case; $GP_ISA chooses the
 * shader code, and where the processor has no such code all is skipped; nothing may change with
 * either. Frames come from seeds (tests/support/random_list.h, and random_variety.h,
 * random_ternary.h or random_order.h on top), so that between them they use every state, format,
 * primitive and program.
 */
#include <glasspipe/glasspipe.h>
#include "tests/support/lists/random_order.h"
#include "tests/support/lists/random_ternary.h"
#include "tests/support/lists/random_variety.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const golden_file = "tests/golden/golden.txt";

enum {
    LARGEST = 64, /* pixels a side */
    MOST_CASES = 16 + 1 + 8 + 1 + 4 + 1 + 4 + 1,
};

/* Seeds whose attachments are listed one by one, and those after them in one case of a single hash;
 * of lists as they come, or changed. */
typedef struct Kind {
    const char *name;
    uint64_t single, summed;
    bool (*add)(uint64_t seed, RandomList *random);
} Kind;

static const Kind kinds[] = {
    { "random", 16, 600, NULL },
    { "varied", 8, 300, random_variety_add },
    { "ternary", 4, 200, random_ternary_add },
    { "sorted", 4, 150, random_order_add },
};

typedef struct Text {
    char *text;
    size_t length, room;
} Text;

static void append(Text *text, const char *line)
{
    size_t length = strlen(line);
    if (text->length + length + 1 > text->room) {
        text->room = 2 * (text->length + length + 1);
        text->text = realloc(text->text, text->room);
        GP_ASSERT(text->text);
    }
    memcpy(text->text + text->length, line, length + 1);
    text->length += length;
}

static void append_surface(Text *text, const char *name, const char *attachment,
                           const GpSurface *surface)
{
    char line[160];
    snprintf(line, sizeof line, "%s %s %ux%u %s %016" PRIx64 "\n", name, attachment, surface->width,
             surface->height, gp_format_info(surface->format)->name, gp_surface_hash(surface));
    append(text, line);
}

/* Draws the frame of a seed; stops the program where it cannot. */
static RandomList *draw_frame(const Kind *kind, uint64_t seed, GpExecutor executor)
{
    RandomList *random = gp_alloc(1, sizeof *random);
    GpDevice *device = NULL;
    GpError error = { "out of memory" };
    if (!random || !random_list_create(seed, LARGEST, random) ||
        (kind->add && !kind->add(seed, random)) ||
        gp_device_create(&(GpDeviceDesc){ .executor = executor }, &device, &error) ||
        gp_device_run(device, &random->list, &error)) {
        printf("Bail out! seed %" PRIu64 ": %s\n", seed, error.text);
        exit(1);
    }
    gp_device_destroy(&device);
    return random;
}

static void free_frame(RandomList *random)
{
    random_list_destroy(random);
    gp_free(random);
}

static void case_single(Text *text, const char *name, const Kind *kind, uint64_t seed,
                        GpExecutor executor)
{
    RandomList *random = draw_frame(kind, seed, executor);
    for (uint32_t p = 0; p < random->list.pass_count; p++) {
        const GpPass *pass = &random->passes[p];
        char attachment[32];
        for (int i = 0; i < GP_MAX_TARGETS && pass->color[i].surface; i++) {
            snprintf(attachment, sizeof attachment, "pass%u.%d", p, i);
            append_surface(text, name, attachment, pass->color[i].surface);
        }
        snprintf(attachment, sizeof attachment, "pass%u.depth", p);
        if (pass->depth.surface)
            append_surface(text, name, attachment, pass->depth.surface);
    }
    free_frame(random);
}

static void case_summed(Text *text, const char *name, const Kind *kind, GpExecutor executor)
{
    uint64_t hash = 0;
    char line[160];
    for (uint64_t seed = kind->single; seed < kind->single + kind->summed; seed++) {
        RandomList *random = draw_frame(kind, seed, executor);
        hash = hash * 31 + random_list_hash(random);
        free_frame(random);
    }
    snprintf(line, sizeof line, "%s all %dx%d mixed %016" PRIx64 "\n", name, LARGEST, LARGEST,
             hash);
    append(text, line);
}

static Text draw_case(int number, GpExecutor executor, char name[32])
{
    Text text = { 0 };
    const Kind *kind = kinds;
    for (; number > (int)kind->single; kind++)
        number -= (int)kind->single + 1;
    if (number < (int)kind->single) {
        snprintf(name, 32, "%s-%d", kind->name, number);
        case_single(&text, name, kind, (uint64_t)number, executor);
    } else {
        snprintf(name, 32, "%s-many", kind->name);
        case_summed(&text, name, kind, executor);
    }
    return text;
}

/* The lines of the golden file that belong to a case, or to any other (not). */
static Text golden_lines(const char *name, bool others)
{
    Text text = { 0 };
    append(&text, "");
    FILE *file = fopen(golden_file, "r");
    char line[256];
    size_t length = strlen(name);
    while (file && fgets(line, sizeof line, file)) {
        bool mine = strncmp(line, name, length) == 0 && line[length] == ' ';
        if (mine != others)
            append(&text, line);
    }
    if (file)
        fclose(file);
    return text;
}

static void print_as_comment(const char *title, const char *lines)
{
    printf("# %s\n", title);
    for (const char *at = lines; *at;) {
        size_t length = strcspn(at, "\n");
        printf("#   %.*s\n", (int)length, at);
        at += length + (at[length] == '\n');
    }
}

static int compare_first(int cases)
{
    static const struct {
        GpExecutor executor;
        const char *name;
    } executors[] = { { GP_EXECUTOR_REFERENCE, "reference" }, { GP_EXECUTOR_FAST, "fast" } };
    int failed = 0, number = 0;
    printf("1..%d\n", cases * (int)GP_COUNT(executors));
    for (int i = 0; i < cases; i++)
        for (size_t e = 0; e < GP_COUNT(executors); e++) {
            char name[32];
            Text drawn = draw_case(i, executors[e].executor, name);
            Text golden = golden_lines(name, false);
            bool same = golden.length > 0 && strcmp(drawn.text, golden.text) == 0;
            printf("%sok %d - %s %s\n", same ? "" : "not ", ++number, name, executors[e].name);
            if (!same) {
                print_as_comment("drawn", drawn.text);
                print_as_comment(golden.length ? "golden" : "golden: no such case", golden.text);
                failed++;
            }
            free(drawn.text);
            free(golden.text);
        }
    return failed ? 1 : 0;
}

static int bless(const char *wanted)
{
    for (int i = 0; i < MOST_CASES; i++) {
        char name[32];
        Text drawn = draw_case(i, GP_EXECUTOR_REFERENCE, name);
        if (strcmp(name, wanted) == 0) {
            Text others = golden_lines(name, true);
            FILE *file = fopen(golden_file, "w");
            bool written = file && fputs(others.text, file) >= 0 && fputs(drawn.text, file) >= 0;
            written = file && fclose(file) == 0 && written;
            free(others.text);
            free(drawn.text);
            return written ? 0 : 1;
        }
        free(drawn.text);
    }
    fprintf(stderr, "golden: no case '%s'\n", wanted);
    return 2;
}

/* Whether this processor has the code that $GP_ISA asks for. */
static bool has_isa(void)
{
    GpDevice *device = NULL;
    GpError error = { "" };
    const GpResult result = gp_device_create(&(GpDeviceDesc){ .threads = 1 }, &device, &error);
    gp_device_destroy(&device);
    if (result == GP_ERROR_UNSUPPORTED)
        printf("1..0 # SKIP %s\n", error.text);
    return result != GP_ERROR_UNSUPPORTED;
}

int main(int count, char **arguments)
{
    int cases = MOST_CASES;
    if (count == 3 && strcmp(arguments[1], "--bless") == 0)
        return bless(arguments[2]);
    if (count == 3 && strcmp(arguments[1], "--first") == 0)
        cases = atoi(arguments[2]);
    if ((count != 1 && count != 3) || cases < 1 || cases > MOST_CASES) {
        fputs("usage: golden [--first N | --bless CASE]\n", stderr);
        return 2;
    }
    return has_isa() ? compare_first(cases) : 0;
}
