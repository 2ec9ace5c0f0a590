/* What the names in charts of shadows mean. */
#ifndef APPS_TECHNIQUES_SHADOW_WORDS_H
#define APPS_TECHNIQUES_SHADOW_WORDS_H

#include "apps/techniques/technique.h"

extern const TechniqueWord shadow_words[];
extern const char shadow_truth_words[];

#endif
