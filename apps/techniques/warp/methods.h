/* The ways of drawing a depth image, as a table. */
#ifndef APPS_TECHNIQUES_WARP_METHODS_H
#define APPS_TECHNIQUES_WARP_METHODS_H

#include "apps/techniques/warp/model.h"

/* Appends the passes that draw a setting's picture over the target; makes first, once, what the
 * method keeps of the images.
 * in     device: to capture with
 * errors GP_ERROR_MEMORY; GP_ERROR_INVALID: the method does not go with what is drawn, with the
 *        reason */
GpResult warp_methods_add(WarpModel *model, const WarpOptions *options, const WarpView *view,
                          const WarpTarget *target, GpDevice *device, Frame *frame, GpError *error);

/* The method that a setting means where it leaves that to be chosen. */
WarpMethod warp_method_of(const WarpModel *model, const WarpOptions *options);

/* What a view does to a method, a line each. */
void warp_methods_warn(const WarpModel *model, const WarpOptions *options, const WarpView *view,
                       Text *warnings);

/* Frees what methods keep of all images. */
void warp_methods_close(WarpModel *model);

#endif
