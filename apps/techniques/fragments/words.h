/* Sentences for who reads a chart of fragments. */
#ifndef APPS_TECHNIQUES_FRAGMENTS_WORDS_H
#define APPS_TECHNIQUES_FRAGMENTS_WORDS_H

#include "apps/techniques/technique.h"

extern const char fragment_truth_words[];
extern const TechniqueWord fragment_words[];

#endif
