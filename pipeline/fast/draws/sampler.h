/* Samplers as the lanes want them: what a texture slot's state means, worked out once a draw. */
#ifndef GP_FAST_SAMPLER_H
#define GP_FAST_SAMPLER_H

#include "pipeline/shader/program.h"

/* What becomes of texels. */
typedef enum FastSampling {
    FAST_UNBOUND, /* no texture: (0, 0, 0, 1) */
    FAST_CODES,   /* 8-bit codes, weighed as integers */
    FAST_FLOATS,  /* decoded, then mixed */
    FAST_COMPARE, /* depth codes, compared with the reference */
} FastSampling;

typedef struct FastLevel {
    const uint8_t *texels;
    int32_t pitch, width, height;
    float scale_u, scale_v; /* 256ths of a texel to the whole level */
} FastLevel;

typedef struct FastSampler {
    const GpSurface *surface;
    FastSampling sampling;
    GpFormat format;
    uint8_t shift;    /* log2 of the bytes of a texel */
    uint8_t channels; /* that texels differ in: those stored, or depth */
    GpFilter min, mag;
    GpMipFilter mip;
    GpAddress address_u, address_v;
    bool has_border;                  /* some axis is GP_BORDER */
    bool one_level;                   /* the same level and filter for every level of detail */
    uint32_t level;                   /* where mip is GP_MIP_NONE, or there is but one */
    float lod_bias, min_lod, max_lod; /* no upper clamp is infinite */
    uint32_t border_code;             /* FAST_CODES: the texel; FAST_COMPARE: its depth code */
    float border[4];                  /* FAST_FLOATS: as loaded */
    FastLevel levels[GP_MAX_LEVELS];
} FastSampler;

/* Prepares one slot.
 * out  sampler: valid while the texture's surface is; its content may change, its shape not */
void fast_prepare_sampler(const GpTexture *texture, FastSampler *sampler);

#endif
