/* Tables of the publications, measured again. */
#ifndef APPS_BENCH_TABLES_H
#define APPS_BENCH_TABLES_H

#include "apps/options.h"
#include "apps/technique.h"

enum { TABLE_COLUMNS = 2 };

typedef struct BenchTableRow {
    const char *name, *scene; /* as printed; what is drawn here: a path */
    double printed[TABLE_COLUMNS];
} BenchTableRow;

/* Frames a second of settings of one technique. */
typedef struct BenchTable {
    const char *id;     /* "4.1" */
    const char *title;  /* in the words of the publication, translated */
    const char *source; /* where it was printed, and on what it was measured */
    const Technique *technique;
    const char *columns[TABLE_COLUMNS], *options[TABLE_COLUMNS];
    const BenchTableRow *rows; /* name NULL ends them */
} BenchTable;

extern const BenchTable bench_tables[]; /* id NULL ends them */

/* The table of a number, or NULL. */
const BenchTable *bench_table_find(const char *id);

/* Measures a table and prints it beside what was printed; with options->json a line of JSON a row.
 * Rows whose scene needs a file that is not there are left out with a message.
 * in   seconds: for each setting
 * returns an exit code of commands.h */
int bench_table_run(const BenchTable *table, const Options *options, double seconds);

#endif
