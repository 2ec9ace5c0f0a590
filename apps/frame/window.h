/* Pictures drawn by windows: surfaces that have a part of their texels, of a list that would draw
 * the whole (GpSurfaceDesc.window). */
#ifndef APPS_FRAME_WINDOW_H
#define APPS_FRAME_WINDOW_H

#include <glasspipe/glasspipe.h>

/* Gives all their texels to those surfaces that shaders read elsewhere than in place, and to what
 * is drawn together with them. What the list draws into its windows is then what the whole would
 * have there, by construction.
 * errors GP_ERROR_INVALID: such a surface is larger than GP_MAX_SIZE; GP_ERROR_MEMORY */
GpResult window_settle(const GpList *list, GpError *error);

/* The smallest window that surfaces can have with a rectangle in it. */
GpRect window_around(GpRect rect, uint32_t width, uint32_t height);

#endif
