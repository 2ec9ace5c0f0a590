/* The ways of drawing all fragments of a mesh, as a table. */
#ifndef APPS_TECHNIQUES_FRAGMENTS_METHODS_H
#define APPS_TECHNIQUES_FRAGMENTS_METHODS_H

#include "apps/techniques/fragments/model.h"

typedef struct FragmentMethodRow {
    /* Draws over frame->color. errors GP_ERROR_MEMORY; GP_ERROR_UNSUPPORTED with the reason */
    GpResult (*add)(const FragmentModel *model, const FragmentOptions *options, Frame *frame,
                    GpError *error);
    bool has_glass;
} FragmentMethodRow;

extern const FragmentMethodRow fragment_methods[FRAGMENT_METHODS];

#endif
