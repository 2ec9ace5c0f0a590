/* Tables 1, 2 and 4 of paper 003; its table 3 is of points. */
#ifndef APPS_TECHNIQUES_VOLUME_PAPER_TABLES_H
#define APPS_TECHNIQUES_VOLUME_PAPER_TABLES_H

#include "apps/techniques/paper_table.h"

extern const PaperTable *const volume_tables[];

#endif
