/* The command that draws charts, of whichever techniques there are. */
#ifndef APPS_COMMANDS_CHART_H
#define APPS_COMMANDS_CHART_H

#include "apps/techniques/registry.h"

/* As cmd_chart, which has the registry's. */
int chart_command(const Technique *const *techniques, int argc, char **argv);

#endif
