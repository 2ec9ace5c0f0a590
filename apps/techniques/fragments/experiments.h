/* The chart of meshes of which all fragments count. */
#ifndef APPS_TECHNIQUES_FRAGMENTS_EXPERIMENTS_H
#define APPS_TECHNIQUES_FRAGMENTS_EXPERIMENTS_H

#include "apps/techniques/technique.h"

extern const Experiment fragment_experiments[];

#endif
