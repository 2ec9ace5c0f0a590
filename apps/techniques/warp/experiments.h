/* The charts of depth images. */
#ifndef APPS_TECHNIQUES_WARP_EXPERIMENTS_H
#define APPS_TECHNIQUES_WARP_EXPERIMENTS_H

#include "apps/techniques/technique.h"

extern const Experiment warp_experiments[];

#endif
