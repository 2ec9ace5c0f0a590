/* The Mandelbrot set: what a shader costs that is one long loop. */
#define GP_SHADER_SW        /* 64 steps are too long for hardware's profiles */
#define GP_SHADER_AT_ONCE 4 /* each step waits for the one before */
#include "shaders_c/common/vertices_shared.h"
#include "shaders_c/bench/mandelbrot.h"

textured_quad_vertex_shader(mandelbrot_vs, NoUniforms);

typedef struct Orbit {
    flt cx, cy, x, y, steps;
    msk inside;
} Orbit;

pixel_shader_begin_turns(mandelbrot_ps, NoUniforms, UvVarying, Orbit, 16)
{
    flt zero = bcast(0), cx = in->uv.x * 2.6f - 1.9f, cy = in->uv.y * 2.6f - 1.3f;
    return (Orbit){ cx, cy, zero, zero, zero, zero == 0.0f };
}

GP_INLINE Orbit step(Orbit at)
{
    flt y = at.x * (at.y + at.y) + at.cy, x = at.x * at.x - at.y * at.y + at.cx;
    msk inside = at.inside & (x * x + y * y <= 4.0f);
    return (Orbit){ at.cx, at.cy, x, y, at.steps + sel(inside, bcast(1), 0), inside };
}

/* Four steps: whether all are outside, which a processor can only guess, is known later than the
 * steps themselves. */
pixel_shader_turn(mandelbrot_ps, NoUniforms, UvVarying, Orbit)
{
    *begun = step(step(step(step(*begun))));
    return begun->inside;
}

pixel_shader_end(mandelbrot_ps, NoUniforms, UvVarying, Orbit)
{
    return rgba(mul(vec3(1, 0.7f, 0.4f), begun->steps * (1.0f / 64)), 1);
}

program(mandelbrot_program, mandelbrot_vs, mandelbrot_ps, .vertex_profile = GP_VS_3_SW,
        .pixel_profile = GP_PS_3_SW, TEXTURED_QUAD_DECLARATIONS)
