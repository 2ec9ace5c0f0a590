/* The chart of volumes. */
#ifndef APPS_TECHNIQUES_VOLUME_EXPERIMENTS_H
#define APPS_TECHNIQUES_VOLUME_EXPERIMENTS_H

#include "apps/techniques/technique.h"

extern const Experiment volume_experiments[];

#endif
