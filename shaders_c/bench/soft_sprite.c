/* Points as Gaussian spots, colours multiplied by alpha: the splats of Westover, "Footprint
 * evaluation for volume rendering", SIGGRAPH 1990. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/bench/soft_sprite.h"

#define LOG2_E 1.44269504088896340736f

/* Square of the distance from the centre of the sprite, 1 at the edges. */
GP_INLINE flt square_radius(float2 sprite)
{
    float2 from_centre = mul(sub(sprite, 0.5f), 2);
    return dp2(from_centre, from_centre);
}

/* --- spots on a sphere ------------------------------------------------------------------------ */

typedef struct SoftVarying {
    float2 sprite;
    float3 color;
} SoftVarying;

vertex_shader(soft_sprite_vs, SoftSpriteUniforms, PointVertex, SoftVarying)
{
    flt lambert = max(dp3(in->position, u3(c->light)), 0);
    *position = m4x4(in->position, c->mvp);
    *point_size = bcast(c->size);
    out->sprite = vec2(0, 0); /* of points it runs from 0 to 1 over the square */
    out->color = mul(u3(c->color), lrp(lambert, bcast(1), c->ambient));
}

pixel_shader(soft_sprite_ps, SoftSpriteUniforms, SoftVarying)
{
    flt square = square_radius(in->sprite);
    discard(square > 1.0f);
    flt alpha = exp_(square * (-4 * LOG2_E)) * c->opacity;
    return rgba(mul(in->color, alpha), alpha);
}

program(soft_sprite_program, soft_sprite_vs, soft_sprite_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } },
        .varyings = { { "sprite", 2, GP_SPRITE_COORD }, { "color", 3, GP_FLAT } },
        .may_discard = true, .writes_point_size = true)

/* --- spots of a sheet ------------------------------------------------------------------------- */

typedef struct SheetVarying {
    float2 sprite;
    flt value;
} SheetVarying;

vertex_shader(sheet_sprite_vs, SheetSpriteUniforms, PointVertex, SheetVarying)
{
    *position = vec4(in->position.x, in->position.y, 0.5f, 1);
    *point_size = bcast(c->size);
    out->sprite = vec2(0, 0);
    out->value = in->position.z;
}

pixel_shader(sheet_sprite_ps, SheetSpriteUniforms, SheetVarying)
{
    flt alpha = exp_(square_radius(in->sprite) * (-3 * LOG2_E)) * c->opacity;
    float3 color = vec3(in->value, 0.6f, 1.0f - in->value);
    return rgba(mul(color, alpha), alpha);
}

program(sheet_sprite_program, sheet_sprite_vs, sheet_sprite_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 } },
        .varyings = { { "sprite", 2, GP_SPRITE_COORD }, { "value", 1, GP_FLAT } },
        .writes_point_size = true)
