#include "shaders_c/points/sequence.h"

#include "shaders_c/points/disc_shared.h"

typedef struct NodeVertex {
    SurfelVertex surfel;
    float2 size;
} NodeVertex;

vertex_shader(sequence_square_vs, SequenceUniforms, NodeVertex, FlatVarying)
{
    const SplatUniforms *splat = &c->lit.splat;
    const SurfelVertex *surfel = &in->surfel;
    EyeSurfel eye = surfel_before_eye(splat, surfel->position, surfel->normal, surfel->radius);
    flt depth = eye.position.z;
    eye.drawn = eye.drawn & (msk)(depth >= in->size.x * c->per_radius) &
                (msk)(depth < in->size.y * (c->per_radius + 1));
    *position = surfel_clip(splat, &eye, bcast(0));
    *point_size = disc_side(&eye);
    out->color = lit_color(&c->lit, surfel, &eye);
}

pixel_shader(sequence_square_ps, SequenceUniforms, FlatVarying)
{
    return rgba(in->color, 1);
}

program(sequence_square_program, sequence_square_vs, sequence_square_ps, MODEL_2_0,
        .inputs = { SURFEL_INPUTS, { GP_TEXCOORD0, 2 } }, .varyings = { { "color", 3, GP_FLAT } },
        .writes_point_size = true)
