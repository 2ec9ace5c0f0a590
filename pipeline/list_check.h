/* The list's check, for an executor that goes on with the ranges of indices it has found. */
#ifndef GP_LIST_CHECK_H
#define GP_LIST_CHECK_H

#include "pipeline/index_range.h"
#include "pipeline/list.h"

/* As gp_list_check; the last ranges that it read are known after it. */
GpResult gp_list_check_ranges(const GpList *list, GpIndexRanges *ranges, GpError *error);

#endif
