/* Facts of a pixel shader that only its counting build knows. */
#include "pipeline/shader/counts.h"

static uint64_t all_components(int count)
{
    return count >= 64 ? ~(uint64_t)0 : ((uint64_t)1 << count) - 1;
}

GpPixelFacts gp_pixel_facts(const GpProgram *program)
{
    uint64_t all = all_components(program->varying_components);
    GpShaderCounts pixel;
    if (!program->count || !program->code[0]->pixel || !program->count(program, NULL, &pixel))
        return (GpPixelFacts){ all, 0 };
    return (GpPixelFacts){ all & pixel.inputs_read, pixel.copied_slot };
}
