/* Tables of the publications, measured again and printed beside what was printed. */
#ifndef APPS_COMMANDS_PAPER_TABLES_H
#define APPS_COMMANDS_PAPER_TABLES_H

#include "apps/commands/options.h"
#include "apps/techniques/registry.h"

/* The numbers of all tables: "2.1, 2.2". */
void paper_tables_list(const Technique *const *techniques, char *list, size_t size);

/* Measures a table and prints it, with --json a line of JSON a row. Rows whose scene needs a file
 * that is not there are left out with a message.
 * in   id: paper_table_find knows it; seconds: for each setting
 * returns an exit code, after a message if it is not EXIT_DONE */
int paper_table_run(const Technique *const *techniques, const char *id, const Options *options,
                    double seconds);

#endif
