/* The command of a technique: options made of its settings, a scene in, a picture or a volume
 * out. */
#ifndef APPS_COMMANDS_TECHNIQUE_COMMAND_H
#define APPS_COMMANDS_TECHNIQUE_COMMAND_H

#include "apps/techniques/technique.h"

/* Runs it as a subcommand: options of the settings, --error E (the cheapest setting that comes so
 * near to the truth of the scene), --curve FILE (a chart to begin with), -o FILE, whose extension
 * says what is written, and those of options_frame or, where the settings have a --size of their
 * own, options_run.
 * returns an exit code */
int technique_command(const Technique *technique, int argc, char **argv);

#endif
