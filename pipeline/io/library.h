/* Libraries of C++, OpenImageIO and OpenMesh, that are loaded when something needs them, and may
 * not be there. */
#ifndef GP_IO_LIBRARY_H
#define GP_IO_LIBRARY_H

#include "pipeline/base/base.h"

/* Loads a library, looked for in ../lib beside the program too, and finds a name in it.
 * out    found: what the name stands for
 * errors GP_ERROR_UNSUPPORTED: it is not there, nor is one that it needs; GP_ERROR_MEMORY: it could
 *        not be loaded though it is there. The message goes on from the library's name: "..., which
 *        is not there"
 * owns   the process, to its end */
GpResult gp_library_find(const char *file, const char *name, void **found, GpError *error);

#endif
