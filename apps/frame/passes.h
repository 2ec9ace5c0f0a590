/* Passes by name. */
#ifndef APPS_FRAME_PASSES_H
#define APPS_FRAME_PASSES_H

#include <glasspipe/glasspipe.h>

/* Finds the pass called `name`, or the pass of that number in decimal; the first of several.
 * returns its index, or list->pass_count where there is none */
uint32_t passes_find(const GpList *list, const char *name);

/* A target of a pass: "0" its first colour target, "1" and so on, "depth"; NULL: there is none. */
GpSurface *pass_target(const GpPass *pass, const char *name);

/* Finds a surface by name: "PASS" its colour target 0, "PASS.1" target 1 and so on,
 * "PASS.depth" its depth target. A pass whose name ends so is found under its whole name first.
 * out  surface: borrowed; pass: its index. To see what that pass left there, later passes, which
 *      may draw over it, must not run
 * errors GP_ERROR_INVALID: no such pass or target */
GpResult passes_find_target(const GpList *list, const char *target, GpSurface **surface,
                            uint32_t *pass, GpError *error);

#endif
