#include "pipeline/fast/stages.h"

const FastStages *fast_stages(int lanes)
{
    return lanes == 4 ? &fast_stages4 : lanes == 8 ? &fast_stages8 : &fast_stages16;
}
