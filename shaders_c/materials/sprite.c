/* Points as balls: a square sprite whose corners are discarded and whose pixels have a ball's
 * normals. GP_POINT_SIZE is the ball's diameter in world units.
 *
 * The normals are those of a ball seen straight on, along the camera's axes. Those are in the
 * matrix: with a perspective camera without shear, row 0 of world to clip is a multiple of its
 * right, row 1 of its up, and row 3 is its forward; |row 1| is the cotangent of half the angle of
 * view, so that |row 1| * height / 2 / w is the number of pixels a world unit takes. */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/materials/sprite.h"

typedef struct Vertex {
    float3 position;
    float4 color;
    flt diameter;
} Vertex;

typedef struct Varying {
    float2 sprite;
    float4 color;
    float3 light; /* towards the light: right, up, towards the eye */
} Varying;

vertex_shader(sprite_vs, SpriteUniforms, Vertex, Varying)
{
    float4 clip = m4x4(in->position, c->mvp);
    float3 row1 = u3(c->mvp[1]), L = u3(c->light);
    flt per_length = rsq(dp3(row1, row1));

    *position = clip;
    *point_size = in->diameter * (c->height * 0.5f) / (clip.w * per_length);
    out->sprite = vec2(0, 0); /* of points it runs from 0 to 1 over the square */
    out->color = in->color;
    out->light =
        vec3(dp3(nrm(u3(c->mvp[0])), L), dp3(row1, L) * per_length, -dp3(u3(c->mvp[3]), L));
}

pixel_shader(sprite_ps, SpriteUniforms, Varying)
{
    float2 p = mad(in->sprite, 2, -1);
    flt square = dp2(p, p);
    discard(square > 1.0f);

    flt towards_eye = sqrt_(max(1.0f - square, 0));
    flt lambert = max(dp3(vec3(p.x, -p.y, towards_eye), in->light), 0);
    return rgba(mul(xyz(in->color), lambert + c->ambient), in->color.w);
}

program(sprite_program, sprite_vs, sprite_ps, MODEL_2_0,
        .inputs = { { GP_POSITION, 3 }, { GP_COLOR, 4 }, { GP_POINT_SIZE, 1 } },
        .varyings = { { "sprite", 2, GP_SPRITE_COORD },
                      { "color", 4, GP_PERSPECTIVE },
                      { "light", 3, GP_FLAT } },
        .may_discard = true, .writes_point_size = true)
