/* Shader files of users: built by the compiler that is there, and loaded. */
#ifndef APPS_EFFECT_SHADER_FILE_H
#define APPS_EFFECT_SHADER_FILE_H

#include "pipeline/shader/program.h"

/* A zeroed one is empty. */
typedef struct ShaderFile {
    const GpProgram *program; /* lives as long as the file is open */
    void *library;
} ShaderFile;

/* Builds a file, or takes what was built of it before (install/build_shader.sh), and loads one of
 * its programs. The compiler's messages go to stderr.
 * in     name: of the program; NULL: the only one
 * errors GP_ERROR_IO: the file, no compiler; GP_ERROR_FORMAT: the compiler refuses it, there is no
 *        such program, or a choice; GP_ERROR_UNSUPPORTED: nowhere to build
 * owns   the caller, until shader_file_close */
GpResult shader_file_open(const char *path, const char *name, ShaderFile *file, GpError *error);

void shader_file_close(ShaderFile *file);

#endif
