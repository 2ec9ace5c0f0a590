/* The texture unit in lanes. */
#ifndef GP_FAST_SAMPLE_H
#define GP_FAST_SAMPLE_H

#include "pipeline/fast/draws/sampler.h"

/* Texture reads of one packet with all lanes distinct, bit for bit what gp_texture_read gives, but
 * for the sign and payload of NaN. One for each lane width; all are GpTextureFn.
 * in   call->executor: FastSampler[GP_MAX_SAMPLERS], prepared from call->textures as far as the
 *      program reads them; read->lanes: the function's own
 * source pipeline/units/texture.c and pipeline/units/texture_address.c, operation by operation */
void fast_read_texture_lanes4(const GpShaderCall *call, const GpTextureRead *read);
void fast_read_texture_lanes8(const GpShaderCall *call, const GpTextureRead *read);
void fast_read_texture_lanes16(const GpShaderCall *call, const GpTextureRead *read);

#endif
