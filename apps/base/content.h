/* What an input says, as a number: two inputs with the same number give the same pictures. */
#ifndef APPS_BASE_CONTENT_H
#define APPS_BASE_CONTENT_H

#include "pipeline/base/base.h"

/* Hashes a name as the program's inputs are named: the bytes of the file that gp_data_find finds,
 * and, where it is JSON, those of all files that its texts name, as a scene names meshes and
 * pictures, which are looked for beside it first; else the name itself, as of a builtin shape. A
 * name counts by what it leads to, so that copies of a scene in two folders are one.
 * in   seed: what was hashed before; 0: nothing */
uint64_t content_hash(const char *name, uint64_t seed);

/* Bytes, behind what was hashed before. */
uint64_t content_hash_bytes(const void *bytes, size_t size, uint64_t seed);

/* A hash of this program's own code and constants: what another build draws may differ. Not the
 * same from build to build. */
uint64_t content_hash_program(void);

#endif
