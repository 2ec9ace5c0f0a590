/* Pictures of a scene as items: frames of a path, and windows of one frame. */
#ifndef APPS_COMMANDS_RENDER_SEQUENCE_H
#define APPS_COMMANDS_RENDER_SEQUENCE_H

#include "apps/commands/options.h"

typedef struct Render {
    Options options; /* first: see options.h */
    const char *scene, *output, *dump;
    bool list_passes, schema;
    const char *window, *path, *frames;
    uint32_t turn;
} Render;

/* Whether what is asked for is more than one picture in one piece. */
bool render_is_sequence(const Render *render);

/* Draws it. returns the command's exit code */
int render_sequence(const Render *render, const char *output);

#endif
