/* What was asked of a technique's command. */
#ifndef APPS_COMMANDS_TECHNIQUE_ARGS_H
#define APPS_COMMANDS_TECHNIQUE_ARGS_H

#include "apps/commands/command.h"
#include "apps/techniques/technique.h"

typedef struct TechniqueArgs {
    Options options; /* first: see options.h */
    const Technique *technique;
    CommandOptions settings;
    const char *scene, *output, *alpha;
    char extension[8]; /* of the output */

    /* --error and what is for it */
    const char *error, *curve;
    bool trusts_chart;
    double most; /* error; negative: not asked for */
    bool per_cent;
    const Experiment *experiment; /* that is meant; NULL: the chart's own */
} TechniqueArgs;

/* What a frame of these arguments is made of. */
static inline TechniqueInput technique_input(const TechniqueArgs *args)
{
    return (TechniqueInput){ .path = args->scene,
                             .width = args->options.size[0],
                             .height = args->options.size[1],
                             .setting = args->settings.object };
}

#endif
