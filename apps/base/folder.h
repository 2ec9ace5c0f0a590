/* Folders that results are written to. */
#ifndef APPS_BASE_FOLDER_H
#define APPS_BASE_FOLDER_H

#include "pipeline/base/base.h"

/* Makes a folder unless it is there; those above it must be.
 * errors GP_ERROR_IO, with its name: it cannot be made, or a file of the name is there */
GpResult folder_make(const char *path, GpError *error);

#endif
