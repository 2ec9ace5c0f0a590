/* The techniques that there are, and what belongs to them by its name. */
#ifndef APPS_TECHNIQUES_REGISTRY_H
#define APPS_TECHNIQUES_REGISTRY_H

#include "apps/techniques/paper_table.h"
#include "apps/techniques/technique.h"

/* A list of techniques, NULL at the end. */
typedef const Technique *const TechniqueList[];

extern TechniqueList technique_registry;

/* The technique of a name, or NULL. */
const Technique *technique_find(const Technique *const *list, const char *name);

/* The experiment of a name, or NULL. out technique: whose it is; NULL allowed */
const Experiment *experiment_find(const Technique *const *list, const char *name,
                                  const Technique **technique);

/* The table of a number, or NULL. out technique: whose it is */
const PaperTable *paper_table_find(const Technique *const *list, const char *id,
                                   const Technique **technique);

#endif
