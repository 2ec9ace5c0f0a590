/* The list's check, for who runs lists again and again: with the ranges of indices that it has
 * found, and without counting the shaders of programs that were right before. */
#ifndef GP_LIST_CHECK_H
#define GP_LIST_CHECK_H

#include "pipeline/base/prefetch.h"
#include "pipeline/list/index_range.h"
#include "pipeline/list/list.h"
#include "pipeline/list/needs.h"
#include "pipeline/shader/counts.h"

/* Primitives of a draw, and of all draws of a pass that sorts: bins number them, and keep a bit. */
enum { GP_MAX_PRIMITIVES = 1 << 30 };

/* For who goes through a pass from draw to draw, at draw `number`: those of a long list are in no
 * cache. */
GP_PREFETCHES void gp_prefetch_draws(const GpPass *pass, uint32_t number)
{
    enum { AHEAD = 2 };
    if (number + AHEAD < pass->draw_count)
        gp_prefetch(&pass->draws[number + AHEAD], offsetof(GpDraw, textures));
}

/* Whether two draws have the same program, which reads no texture, viewport and state: of many
 * small draws neighbours do. They take 5 % less where that is asked before they are checked and
 * described again. */
bool gp_draws_alike(const GpDraw *a, const GpDraw *b);

/* Programs that were found right, the last few, as they were then. A zeroed one is empty. */
enum { GP_CHECKED_PROGRAMS = 16 };
typedef struct GpCheckedPrograms {
    const GpProgram *at[GP_CHECKED_PROGRAMS];
    GpProgram program[GP_CHECKED_PROGRAMS];
    GpPixelFacts facts[GP_CHECKED_PROGRAMS];
    unsigned count;
} GpCheckedPrograms;

/* gp_pixel_facts of a program; without counting, if it is one of these. */
GpPixelFacts gp_checked_facts(const GpCheckedPrograms *programs, const GpProgram *program);

/* As gp_list_check.
 * in/out programs: those that are found right are added; ranges: the last that were read are
 *      known */
GpResult gp_list_check_again(const GpList *list, GpCheckedPrograms *programs, GpIndexRanges *ranges,
                             GpError *error);

#endif
