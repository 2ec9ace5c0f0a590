#include "apps/commands/paper_tables.h"

#include "apps/commands/output.h"

#include <jansson.h>
#include <stdio.h>
#include <string.h>

enum { LEAST_FRAMES = 20 };

/* A table that is being measured. */
typedef struct TableRun {
    const Technique *technique;
    const PaperTable *table;
    const Options *options;
    TechniqueClock clock;
    void *scene; /* of the last row; NULL: its file is not there */
} TableRun;

void paper_tables_list(const Technique *const *techniques, char *list, size_t size)
{
    size_t used = 0;
    list[0] = '\0';
    for (; *techniques; techniques++)
        for (const PaperTable *const *table = (*techniques)->tables; table && *table; table++)
            used += used < size ? (size_t)snprintf(list + used, size - used, "%s%s",
                                                   used ? ", " : "", (*table)->id)
                                : 0;
}

/* --- printing --------------------------------------------------------------------------------- */

enum { PAIR_WIDTH = 16, SINGLE_WIDTH = 9 };

static void print_head(const PaperTable *table)
{
    printf("Table %s: %s (%s)\nprinted and here; %s\n%-8s", table->id, table->title, table->source,
           table->note, "");
    for (const PaperColumn *column = table->columns; column->name; column++)
        printf("  %*s", column->number == PAPER_BOTH ? PAIR_WIDTH : SINGLE_WIDTH, column->name);
    putchar('\n');
    fflush(stdout);
}

/* measured: NULL where there is nothing to measure */
static void print_text(const PaperTable *table, const PaperRow *row, const double *measured)
{
    printf("%-8s", row->name);
    for (int i = 0; table->columns[i].name; i++) {
        const PaperColumn *column = &table->columns[i];
        char here[32] = "";
        if (measured && column->number != PAPER_GIVEN)
            snprintf(here, sizeof here, "%.*f", column->digits, measured[i]);
        if (column->number == PAPER_BOTH && row->printed[i] < 0)
            printf("  %7s %8s", "-", here);
        else if (column->number == PAPER_BOTH)
            printf("  %7.7g %8s", row->printed[i], here);
        else if (column->number == PAPER_GIVEN)
            printf("  %*g", SINGLE_WIDTH, row->printed[i]);
        else
            printf("  %*s", SINGLE_WIDTH, here);
    }
    printf("  %s%s\n", row->scene ? row->scene : "(not at hand)", row->reduced ? " (reduced)" : "");
    fflush(stdout); /* rows may take long: each is there when it is known */
}

static void print_reasons(const PaperTable *table)
{
    for (const char *const *reason = table->reasons; reason && *reason; reason++)
        printf("- %s\n", *reason);
}

static json_t *number(const PaperColumn *column, double value)
{
    return column->digits ? json_real(value) : json_integer((json_int_t)value);
}

static void print_json(const PaperTable *table, const PaperRow *row, const double *measured)
{
    json_t *object = json_pack("{s:s, s:s, s:s, s:b}", "table", table->id, "row", row->name,
                               "scene", row->scene, "reduced", row->reduced);
    for (int i = 0; table->columns[i].name; i++) {
        const PaperColumn *column = &table->columns[i];
        json_t *printed = row->printed[i] < 0 ? json_null() : number(column, row->printed[i]);
        json_t *here = number(column, measured[i]);
        json_t *value = column->number == PAPER_GIVEN ? json_incref(printed)
                        : column->number == PAPER_MEASURED
                            ? json_incref(here)
                            : json_pack("{s:O, s:O}", "printed", printed, "measured", here);
        json_object_set_new(object, column->name, value);
        json_decref(printed);
        json_decref(here);
    }
    output_json_line(object);
}

/* --- measuring -------------------------------------------------------------------------------- */

/* Opens the scene of a row, unless the row before had the same. */
static int open_scene(TableRun *run, const PaperRow *row)
{
    const PaperRow *before = row == run->table->rows ? NULL : row - 1;
    if (before && before->scene && strcmp(before->scene, row->scene) == 0)
        return EXIT_DONE;
    GpError error = { "" };
    if (run->scene)
        run->technique->close(run->scene);
    run->scene = NULL;
    GpResult result = technique_open(run->technique, row->scene, 0, 0, &run->scene, &error);
    if (result == GP_ERROR_FORMAT || result == GP_ERROR_IO) {
        notice(run->options, "%s: skipped: %s", row->name, error.text);
        return EXIT_DONE;
    }
    return result ? report(EXIT_INTERNAL, "%s", error.text) : EXIT_DONE;
}

static int run_row(TableRun *run, const PaperRow *row)
{
    const PaperTable *table = run->table;
    double measured[PAPER_MAX_COLUMNS] = { 0 };
    GpError error = { "" };
    if (!row->scene) {
        if (!run->options->json)
            print_text(table, row, NULL);
        return EXIT_DONE;
    }
    int code = open_scene(run, row);
    if (!run->scene)
        return code;
    if (table->measure(table, row, run->technique, run->scene, &run->clock, measured, &error))
        return report(EXIT_INPUT, "%s: %s", row->name, error.text);
    if (run->options->json)
        print_json(table, row, measured);
    else
        print_text(table, row, measured);
    return EXIT_DONE;
}

int paper_table_run(const Technique *const *techniques, const char *id, const Options *options,
                    double seconds)
{
    TableRun run = { .options = options,
                     .clock = { .plan = { seconds, LEAST_FRAMES, 2 * seconds } } };
    run.table = paper_table_find(techniques, id, &run.technique);
    int code = options_device(options, NULL, &run.clock.device);
    if (code)
        return code;
    run.clock.each = gp_alloc(TIMING_MAX_FRAMES, sizeof *run.clock.each);
    if (!run.clock.each)
        code = report(EXIT_INTERNAL, "out of memory");
    else if (!options->json)
        print_head(run.table);
    for (const PaperRow *row = run.table->rows; row->name && !code; row++)
        code = run_row(&run, row);
    if (!code && !options->json)
        print_reasons(run.table);
    if (run.scene)
        run.technique->close(run.scene);
    gp_free(run.clock.each);
    gp_device_destroy(&run.clock.device);
    return code;
}
