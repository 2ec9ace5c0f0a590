/* Sentences for who reads a chart of volumes. */
#ifndef APPS_TECHNIQUES_VOLUME_WORDS_H
#define APPS_TECHNIQUES_VOLUME_WORDS_H

#include "apps/techniques/technique.h"

extern const char volume_truth_words[];
extern const TechniqueWord volume_words[];

#endif
