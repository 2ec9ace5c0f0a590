/* The tables of voxelization: 2.1, its steps, and 2.2, its sizes. */
#ifndef APPS_TECHNIQUES_VOXEL_PAPER_TABLES_H
#define APPS_TECHNIQUES_VOXEL_PAPER_TABLES_H

#include "apps/techniques/paper_table.h"

extern const PaperTable *const voxel_tables[];

#endif
