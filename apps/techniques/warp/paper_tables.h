/* Tables 1 and 2 of paper 001. */
#ifndef APPS_TECHNIQUES_WARP_PAPER_TABLES_H
#define APPS_TECHNIQUES_WARP_PAPER_TABLES_H

#include "apps/techniques/paper_table.h"

extern const PaperTable *const warp_tables[];

#endif
