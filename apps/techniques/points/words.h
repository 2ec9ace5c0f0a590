/* What the words on the charts of points mean. */
#ifndef APPS_TECHNIQUES_POINTS_WORDS_H
#define APPS_TECHNIQUES_POINTS_WORDS_H

#include "apps/techniques/technique.h"

extern const TechniqueWord points_words[];
extern const char points_truth_words[];

#endif
