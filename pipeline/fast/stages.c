#include "pipeline/fast/lanes/stages.h"

/* Those that were compiled: a build may have fewer widths. */
static const FastStages *const stages[] = {
#ifdef GP_LANES4_ISA
    &fast_stages4,
#endif
#ifdef GP_LANES8_ISA
    &fast_stages8,
#endif
#ifdef GP_LANES16_ISA
    &fast_stages16,
#endif
};

const FastStages *fast_stages(int lanes)
{
    size_t i = 0;
    while (i < GP_COUNT(stages) && stages[i]->lanes != lanes)
        i++;
    GP_ASSERT(i < GP_COUNT(stages));
    return stages[i];
}
