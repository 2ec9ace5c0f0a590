/* Files that commands keep what they build in: --cache. */
#ifndef APPS_COMMANDS_CACHE_FILE_H
#define APPS_COMMANDS_CACHE_FILE_H

#include "apps/techniques/settings.h"

/* Whether a setting's --cache may be written over: there is none, it is empty, or it begins as a
 * cache of this program does, of whatever version.
 * errors GP_ERROR_INVALID: it is another file, which is nobody's to replace */
GpResult cache_file_check(const SettingField *fields, const void *setting, GpError *error);

#endif
