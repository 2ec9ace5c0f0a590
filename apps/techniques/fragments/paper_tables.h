/* Tables 1 to 3 of paper 002. */
#ifndef APPS_TECHNIQUES_FRAGMENTS_PAPER_TABLES_H
#define APPS_TECHNIQUES_FRAGMENTS_PAPER_TABLES_H

#include "apps/techniques/paper_table.h"

extern const PaperTable *const fragment_tables[];

#endif
