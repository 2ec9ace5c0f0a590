/* Which pixels of a pass are recorded whole. */
#ifndef APPS_INSPECT_RECORD_CHOICE_H
#define APPS_INSPECT_RECORD_CHOICE_H

#include "apps/inspect/record.h"

/* Chooses pixels of each pass once the fragments are known: of its share. errors GP_ERROR_MEMORY */
GpResult record_choose(Record *record, GpError *error);

/* Once histories are recorded: lowers the share until they take about such a part of the bytes, by
 * how many each pass's fragments took, and chooses again. errors GP_ERROR_MEMORY */
GpResult record_choose_fewer(Record *record, double part, GpError *error);

#endif
