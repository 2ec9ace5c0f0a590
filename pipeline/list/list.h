/* Lists, passes and draws: the whole work of a frame as plain data.
 *
 * A list is an array of passes; a pass is render targets and an array of draws; a draw is a
 * program, its uniforms, geometry, fixed state and textures. Nothing happens until gp_device_run: a
 * list can be printed, checked, dumped pass by pass, inspected and run again. Everything is
 * borrowed until the run returns.
 */
#ifndef GP_LIST_H
#define GP_LIST_H

#include "pipeline/resources/geometry.h"
#include "pipeline/shader/program.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One draw: a program with its uniforms, over a geometry, under a state. Everything is borrowed. */
typedef struct GpDraw {
    const char *name; /* for messages; may be NULL */
    const GpProgram *program;
    const void *uniforms; /* program->uniform_bytes bytes */
    GpGeometry geometry;
    GpState state;
    GpViewport viewport;
    GpTexture textures[GP_MAX_SAMPLERS];
} GpDraw;

/* Where colours go, and what is there before the first draw. */
typedef struct GpColorTarget {
    GpSurface *surface; /* NULL: no target i; the targets in use are 0..n-1 */
    bool clear;         /* before the first draw; otherwise the content is kept */
    float clear_color[4];
} GpColorTarget;

/* Where depth and stencil go, and what is there before the first draw; a surface of NULL: no
 * depth. */
typedef struct GpDepthTarget {
    GpSurface *surface;
    bool clear_depth, clear_stencil;
    float depth_value; /* the value cleared to */
    uint8_t stencil_value;
} GpDepthTarget;

/* Draws into the same targets, in their order. */
typedef struct GpPass {
    const char *name;
    GpColorTarget color[GP_MAX_TARGETS];
    GpDepthTarget depth;
    const GpDraw *draws;
    uint32_t draw_count;
    GpOrder order; /* of a pixel's fragments */

    /* What targets clear, they clear inside these, each cut to the targets, and whatever scissor
     * and viewport say; none: everywhere. (Direct3D's Clear. In the middle of a frame it is a
     * pass.) */
    const GpRect *clear_rects;
    uint32_t clear_rect_count;
} GpPass;

/* Passes in their order: the work of a frame. */
typedef struct GpList {
    const GpPass *passes;
    uint32_t pass_count;
} GpList;

/* Size that all targets of a pass share, after gp_list_check. */
void gp_pass_size(const GpPass *pass, uint32_t *width, uint32_t *height);

/* The part of them that all its targets have, after gp_list_check; where it is drawn. */
GpRect gp_pass_window(const GpPass *pass);

/* Whether a pass clears any of its targets. */
bool gp_pass_clears(const GpPass *pass);

/* The parts in which a pass clears, at least one, and part i of them: pixels of the targets, or
 * none. */
static inline uint32_t gp_pass_clear_parts(const GpPass *pass)
{
    return pass->clear_rect_count ? pass->clear_rect_count : 1;
}
GpRect gp_pass_clear_part(const GpPass *pass, uint32_t i);

/* Whether a surface is one of the targets of a pass, or has its texels in one. */
bool gp_pass_renders_to(const GpPass *pass, const GpSurface *surface);

/* Checks everything that can be checked before the first pixel: targets (formats, equal sizes, no
 * surface twice, none that is also a texture of the pass), programs (gp_program_check, targets
 * written against targets bound), geometry (streams present, indices in range), state
 * (enumerations, scissor, finite viewport inside the guard band, a ternary test with its compare
 * function and epsilon, blending and logic on formats that have them, stencil only with stencil
 * bits), textures (bound where the program reads, compare samplers on depth surfaces, local reads
 * on surfaces of the pass's size, no others on surfaces that have a window). The
 * floating-point control word is set for the duration and restored (R29).
 * errors GP_ERROR_MEMORY; GP_ERROR_INVALID, with the pass, the draw and the field named:
 *        "pass 2 'light', draw 0 'quad': textures[1].surface: not bound, but deferred_program reads
 *        slot 1" */
GpResult gp_list_check(const GpList *list, GpError *error);

/* Groups: consecutive passes of one size and window in which a pixel reads earlier targets of the
 * group only at its own position (gp_load_local), and none has two names for one memory, may run
 * tile by tile, all passes of a tile in turn, with the same result by construction.
 * out  group_of[pass]: group number, from 0, rising
 * returns the number of groups */
uint32_t gp_list_groups(const GpList *list, uint32_t *group_of);

#ifdef __cplusplus
}
#endif

#endif
