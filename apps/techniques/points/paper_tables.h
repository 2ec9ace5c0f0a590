/* The tables of points in the publications, to be measured again. */
#ifndef APPS_TECHNIQUES_POINTS_PAPER_TABLES_H
#define APPS_TECHNIQUES_POINTS_PAPER_TABLES_H

#include "apps/techniques/paper_table.h"

extern const PaperTable *const points_tables[];

#endif
