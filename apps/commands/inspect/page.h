/* What `glasspipe inspect` was asked for, the frame that it opens, and the page that it writes of
 * it. */
#ifndef APPS_COMMANDS_INSPECT_PAGE_H
#define APPS_COMMANDS_INSPECT_PAGE_H

#include "apps/commands/command.h"
#include "apps/commands/options.h"
#include "apps/inspect/lesson.h"
#include "apps/scene/scene.h"
#include "apps/techniques/technique.h"

typedef struct InspectCommand {
    Options options; /* first: see options.h */
    const char *scene, *output, *technique_name, *against, *lesson_path;
    double region[4]; /* x, y, width, height; width 0: none */
    uint32_t draw, pixels;
    bool no_timings, truth;
    const Technique *technique; /* NULL: the scene as it is */
    CommandOptions settings;    /* of the technique */
    const Lesson *lesson;       /* NULL: the page asks nothing */
} InspectCommand;

/* A frame, and what it is made of. */
typedef struct Drawn {
    Scene scene;
    void *opened; /* the technique's */
    Frame frame;
    const GpList *list;
    const GpSurface *picture;
    const Experiment *experiment; /* that knows how far the picture is off */
    float *off;                   /* [height][width]; NULL: unknown */
} Drawn;

/* Opens a scene, or the frame that the command's technique makes of one; an exit code, with its
 * message said.
 * in     setting: of the technique; NULL without one
 * owns   the caller, until inspect_release, after a failure too */
int inspect_open(const InspectCommand *command, const char *path, void *setting, Drawn *drawn);
void inspect_release(const InspectCommand *command, Drawn *drawn);

/* Writes the page. in: other: what --against names; else anything */
int inspect_write(const InspectCommand *command, const char *path, const Drawn *drawn,
                  const Drawn *other);

#endif
