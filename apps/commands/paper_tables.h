/* Tables of the publications, measured again.
 *
 * Each kind of table has a file of its own, with its rows and how they are measured and printed.
 */
#ifndef APPS_COMMANDS_PAPER_TABLES_H
#define APPS_COMMANDS_PAPER_TABLES_H

#include "apps/commands/options.h"
#include "apps/techniques/timed_setting.h"

#include <jansson.h>

/* What measuring a table takes. */
typedef struct BenchTableRun {
    const Options *options;
    TechniqueClock clock; /* for each setting */
} BenchTableRun;

typedef struct BenchTable {
    const char *id;     /* "4.1" */
    const char *title;  /* in the words of the publication, translated */
    const char *source; /* where it was printed, and on what it was measured */

    /* Measures all rows and prints them beside what was printed; with --json a line of JSON a row.
     * Rows whose scene needs a file that is not there are left out with a message.
     * returns an exit code of commands.h */
    int (*run)(const struct BenchTable *table, const BenchTableRun *run);
    const void *content; /* of its kind */
} BenchTable;

extern const BenchTable bench_table_2_1, bench_table_2_2; /* bench_table_voxel_*.c */
extern const BenchTable bench_table_4_1, bench_table_4_2; /* bench_table_shadow.c */

/* The table of a number, or NULL. */
const BenchTable *bench_table_find(const char *id);

/* The numbers of all tables: "2.1, 2.2". */
void bench_table_list(char *list, size_t size);

/* Measures a table and prints it. in seconds: for each setting; returns an exit code */
int bench_table_run(const BenchTable *table, const Options *options, double seconds);

/* --- for the tables --------------------------------------------------------------------------- */

/* Opens the scene of a row.
 * out    scene: NULL where it needs a file that is not there, after a message
 * returns an exit code, after a message if it is not EXIT_DONE */
int bench_table_open(const BenchTableRun *run, const Technique *technique, const char *row,
                     const char *path, void **scene);

/* Prints a row as a line of JSON and releases it. */
void bench_table_print(json_t *row);

/* {"printed": .., "measured": ..} */
json_t *bench_table_pair(double printed, double measured);

#endif
