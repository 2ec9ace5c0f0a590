/* What a texture read looked at: filled by the texture unit, told by traces. */
#ifndef GP_SAMPLE_REPORT_H
#define GP_SAMPLE_REPORT_H

#include "pipeline/base/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One texel that a sample used, for the inspector. */
typedef struct GpTexelUse {
    int32_t x, y; /* after addressing; -1, -1 where the border colour was used */
    uint8_t level;
    float weight;   /* share in the result, exact and not 0; all of a sample's sum to exactly 1 */
    float value[4]; /* as loaded: r g b a */
    bool passes;    /* of samplers that compare: it is not in front of the reference */
} GpTexelUse;

/* Which texels went into a texture read. */
typedef struct GpSampleReport {
    float lod; /* after bias and clamp, as an 8.8 fixed-point value */
    bool magnified;
    bool compares; /* the sampler compares depth */
    int count;     /* texels used, at most 8 */
    GpTexelUse texel[8];
} GpSampleReport;

#ifdef __cplusplus
}
#endif

#endif
