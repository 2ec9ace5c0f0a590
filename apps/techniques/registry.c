#include "apps/techniques/registry.h"

#include "apps/techniques/fragments/technique.h"
#include "apps/techniques/points/technique.h"
#include "apps/techniques/shadow/technique.h"
#include "apps/techniques/volume/technique.h"
#include "apps/techniques/voxel/technique.h"
#include "apps/techniques/warp/technique.h"

#include <string.h>

TechniqueList technique_registry = {
    &voxel_technique,
    &shadow_technique,
    &points_technique,
    &volume_technique,
    &warp_technique,
    &fragment_technique,
    NULL,
};

const Technique *technique_find(const Technique *const *list, const char *name)
{
    for (; *list; list++)
        if (strcmp((*list)->name, name) == 0)
            return *list;
    return NULL;
}

const Experiment *experiment_find(const Technique *const *list, const char *name,
                                  const Technique **technique)
{
    for (; *list; list++)
        for (const Experiment *experiment = (*list)->experiments; experiment->name; experiment++)
            if (strcmp(experiment->name, name) == 0) {
                if (technique)
                    *technique = *list;
                return experiment;
            }
    return NULL;
}

const PaperTable *paper_table_find(const Technique *const *list, const char *id,
                                   const Technique **technique)
{
    for (; *list; list++)
        for (const PaperTable *const *table = (*list)->tables; table && *table; table++)
            if (strcmp((*table)->id, id) == 0) {
                *technique = *list;
                return *table;
            }
    return NULL;
}
