/* Texture reads of a packet: levels of detail from quads, then one sample a lane. */
#ifndef GP_TEXTURE_READ_H
#define GP_TEXTURE_READ_H

#include "pipeline/shader/program.h"
#include "pipeline/units/texture.h"

/* Reads one packet from a texture.
 * in   read: as the shader gave it; distinct: lanes that differ (the rest repeat lane
 *      0..distinct-1, as a quad does on wider lanes), a multiple of 4, at most read->lanes
 * out  read->texel; reports[distinct] where not NULL
 * note differences are the quad's: right minus left within a row, lower minus upper within a
 *      column, the same as dsx and dsy give */
void gp_texture_read(const GpTexture *texture, const GpTextureRead *read, int distinct,
                     GpSampleReport *reports);

/* The two functions that a shader call wants, without a report: texld and its kin, all lanes
 * distinct; and gp_load_local, a plain read of the surface (lanes outside it read 0). */
void gp_read_texture_plain(const GpShaderCall *call, const GpTextureRead *read);
void gp_read_local_plain(const GpShaderCall *call, int slot, int packet, int lanes, float *texel);

#endif
