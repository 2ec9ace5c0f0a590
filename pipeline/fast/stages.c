#include "pipeline/fast/stages.h"

/* Those that were compiled: a build may have fewer widths. */
static const FastStages *const stages[] = {
#ifdef GP_HAS_LANES4
    &fast_stages4,
#endif
#ifdef GP_HAS_LANES8
    &fast_stages8,
#endif
#ifdef GP_HAS_LANES16
    &fast_stages16,
#endif
};

const FastStages *fast_stages(int lanes)
{
    for (size_t i = 0; i < GP_COUNT(stages); i++)
        if (stages[i]->lanes == lanes)
            return stages[i];
    GP_ASSERT(!"a width that was compiled");
    return NULL;
}
