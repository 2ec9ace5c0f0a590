/* The tables of shadow mapping: 4.1, and 4.2, the same with bilinear filtering. */
#ifndef APPS_TECHNIQUES_SHADOW_PAPER_TABLES_H
#define APPS_TECHNIQUES_SHADOW_PAPER_TABLES_H

#include "apps/techniques/paper_table.h"

extern const PaperTable *const shadow_tables[];

#endif
