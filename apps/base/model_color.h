/* What models are coloured by, in words: --color of several commands. */
#ifndef APPS_BASE_MODEL_COLOR_H
#define APPS_BASE_MODEL_COLOR_H

#include "pipeline/base/base.h"

#define MODEL_COLOR_HELP                                                                           \
    "waves:K, 0.5 + 0.5 sin(K p), unlit; or white, grey, clay, gold, jade or black"

/* Red, green and blue of a colour's name in 255ths; NULL: there is none of that name. */
const uint8_t *model_color(const char *name);

/* Takes K of "waves:K"; 0 where the colour is another, or NULL.
 * errors GP_ERROR_INVALID: none of file, the names above and such as waves:40 */
GpResult model_waves(const char *color, double *waves, GpError *error);

#endif
