/* Lists of all fragments of a pixel, put in order afterwards: A-buffers, and what keeps some of
 * them.
 *
 * The machine adds nothing to a list by itself, as later ones do by atomic operations. Here stencil
 * does it, as in the stencil-routed A-buffer: each fragment of a pixel increments it, and of pass n
 * over the mesh the n-th alone gets through, into the n-th surface. So a pass over the mesh is
 * drawn for each layer; the lists are those of hardware that needs one pass. Pixel shaders then
 * take the nearest four, the next four, and so on.
 * source Myers and Bavoil, "Stencil routed A-buffer", SIGGRAPH sketches 2007; Carpenter, "The
 *        A-buffer, an antialiased hidden surface method", SIGGRAPH 1984 */
#ifndef APPS_FRAGMENTS_DRAWING_LISTS_H
#define APPS_FRAGMENTS_DRAWING_LISTS_H

#include "apps/fragments/drawing/view.h"

enum { LIST_MOST = 254 };

typedef struct ListSetting {
    uint32_t layers; /* fragments of the pixel that has most, at most LIST_MOST */
    /* of a pixel's fragments the first so many, as they are drawn, are kept; 0: all */
    uint32_t first;
    uint32_t nearest; /* of these the nearest so many; 0: all */
    bool is_packed;   /* depth and colour in 32 bits */
    /* Fragments in flight, which see their pixel as it was before the first of them: of those of
     * one window (windows.h) in one pixel the last alone is kept, since what it writes is what it
     * saw and itself. 0: each sees what the one before it wrote. */
    uint32_t hazard;
} ListSetting;

/* As view.h has it, of the fragments that are kept, without glass. Colours have 12 bits a channel.
 * errors GP_ERROR_UNSUPPORTED: too many layers; GP_ERROR_MEMORY */
GpResult lists_add(const FragmentMesh *mesh, const ListSetting *setting, const FragmentView *view,
                   GpSurface *color, GpSurface *depth, Frame *frame, GpError *error);

#endif
