/* Sentences for who reads a chart of depth images. */
#ifndef APPS_TECHNIQUES_WARP_WORDS_H
#define APPS_TECHNIQUES_WARP_WORDS_H

#include "apps/techniques/technique.h"

extern const char warp_truth_words[];
extern const TechniqueWord warp_words[];

#endif
