/* How pictures are compared, as options: of the commands, and in the files beside scenes. */
#ifndef APPS_GOLDEN_LIMITS_H
#define APPS_GOLDEN_LIMITS_H

#include "apps/techniques/settings.h"

/* Of ComparisonSettings: --fail to --hardwarn as idiff names them, --flipfail, --ppd,
 * --no-alpha. */
extern const SettingField comparison_fields[];

#endif
