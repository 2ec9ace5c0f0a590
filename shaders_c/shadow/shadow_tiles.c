/* Fernando, Fernandez, Bala and Greenberg, "Adaptive shadow maps", SIGGRAPH 2001: what the eye sees
 * asks for finer pieces of the map where it finds an edge of a shadow. */

/* Square roots, one after the other, and a power, once the maps are read. */
#define GP_SHADER_AT_ONCE 4
#include "shaders_c/shadow/shadow_tiles.h"
#include "shaders_c/shadow/shadow_shared.h"

vertex_shader(lit_vs, ShadowTilesUniforms, MeshVertex, Varying)
{
    transform(&c->shadow, in->position, in->normal, position, out);
}

vertex_shader(lit_textured_vs, ShadowTilesUniforms, TexturedVertex, TexturedVarying)
{
    transform(&c->shadow, in->position, in->normal, position, &out->lit);
    out->uv = in->texcoord;
}

/* Place in the map in tiles, from its upper left corner. The map has Direct3D 9's pixel centres. */
GP_INLINE float2 tile_place(const ShadowTilesUniforms *c, float4 place)
{
    flt corner = bcast(c->shadow.half_texel), tiles = bcast(c->tiles);
    return vec2((place.x / place.w - corner) * tiles, (place.y / place.w - corner) * tiles);
}

/* --- the request ------------------------------------------------------------------------------ */

/* An edge runs where the four texels around the place disagree. A surface that faces away is dark
 * without a map. */
pixel_shader(request_ps, ShadowTilesUniforms, Varying)
{
    flt seen = texldp(1, in->place).x;
    float2 place = tile_place(c, in->place);
    flt tiles = bcast(c->tiles), column = floor_(place.x), row = floor_(place.y);
    msk edge = (seen > 0.0f) & (seen < 1.0f) & (smooth(gp, &c->shadow, in) > 0.0f);
    msk inside =
        (in->place.w > 0.0f) & (column >= 0.0f) & (column < tiles) & (row >= 0.0f) & (row < tiles);
    return sp4(sel(edge & inside, row * tiles + column + 1.0f, bcast(0)));
}

typedef struct MarkVertex {
    float2 pixel;
} MarkVertex;

typedef struct MarkVarying {
} MarkVarying;

/* Pixels that ask for nothing go behind the far plane. */
vertex_shader(mark_vs, ShadowMarkUniforms, MarkVertex, MarkVarying)
{
    flt tile = texldl(0, vec4(in->pixel.x, in->pixel.y, 0, 0)).x - 1.0f;
    flt step = rcp(bcast(c->tiles)), row = floor_((tile + 0.5f) * step);
    flt column = tile - row * c->tiles;
    flt x = (column + 0.5f) * step, y = (row + 0.5f) * step;
    flt depth = sel(tile >= 0.0f, bcast(0), bcast(2));
    *position = vec4(x * 2.0f - 1.0f, 1.0f - y * 2.0f, depth, 1);
}

pixel_shader(mark_ps, ShadowMarkUniforms, MarkVarying)
{
    (void)in;
    return sp4(bcast(1));
}

/* --- the light -------------------------------------------------------------------------------- */

/* The table is read in the centre of its texels, since a place beside their edge is rounded to the
 * next one. Filters stay inside a tile: its neighbour in the atlas is none in the world. */
GP_INLINE flt tiles(GpInvocation *gp, const ShadowTilesUniforms *c, const Varying *in)
{
    float2 place = tile_place(c, in->place);
    flt step = rcp(bcast(c->tiles)), least = bcast(c->inset), most = bcast(1 - c->inset);
    flt centre_x = (floor_(place.x) + 0.5f) * step, centre_y = (floor_(place.y) + 0.5f) * step;
    float4 entry = texldl(2, vec4(centre_x, centre_y, 0, 0));
    flt column = floor_(entry.x * 255.0f + 0.5f), row = floor_(entry.y * 255.0f + 0.5f);
    flt u = (column + min(max(frc(place.x), least), most)) * c->atlas_tiles[0];
    flt v = (row + min(max(frc(place.y), least), most)) * c->atlas_tiles[1];
    flt fine = texldl(3, vec4(u, v, in->place.z / in->place.w, 0)).x;
    return sel(entry.w > 0.5f, fine, texldp(1, in->place).x);
}

/* --- programs --------------------------------------------------------------------------------- */

#define MAPS (1 << 1 | 1 << 2 | 1 << 3)

/* clang-format off */
SHADOW_PAIR(tiles, smooth, ShadowTilesUniforms, &c->shadow, MAPS, 3_0, false)
SHADOW_PAIR(tiles, flat, ShadowTilesUniforms, &c->shadow, MAPS, 3_0, true)
/* clang-format on */

program(shadow_request_program, lit_vs, request_ps, MODEL_3_0, .inputs = { MESH_INPUTS },
        .varyings = { LIT_VARYINGS }, .samplers = 1 << 1)

program(shadow_mark_program, mark_vs, mark_ps, MODEL_3_0, .inputs = { { GP_TEXCOORD0, 2 } },
        .vertex_samplers = 1 << 0)
