/* The charts of points. */
#ifndef APPS_TECHNIQUES_POINTS_EXPERIMENTS_H
#define APPS_TECHNIQUES_POINTS_EXPERIMENTS_H

#include "apps/techniques/technique.h"

extern const Experiment points_experiments[];

#endif
