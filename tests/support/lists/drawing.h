/* A frame of a few draws, whole: targets, uniforms, one pass; and running it. */
#ifndef TESTS_DRAWING_H
#define TESTS_DRAWING_H

#include <glasspipe/glasspipe.h>
#include "tests/shaders/exercise.h"
#include "tests/support/unit.h"

enum { SIZE = 64 };

typedef struct Corner {
    float position[4], color[4], uv[2];
} Corner;

typedef struct Drawing {
    GpSurface *color, *depth;
    ExerciseUniforms uniforms;
    GpDraw draw[8];
    GpPass pass;
    GpList list;
    GpError error;
} Drawing;

static inline Drawing new_drawing(GpFormat color)
{
    Drawing f = { 0 };
    assert_int_equal(
        gp_surface_create(
            &(GpSurfaceDesc){ .format = color, .width = SIZE, .height = SIZE, .name = "picture" },
            &f.color, &f.error),
        GP_OK);
    assert_int_equal(
        gp_surface_create(
            &(GpSurfaceDesc){ .format = GP_D24S8, .width = SIZE, .height = SIZE, .name = "depth" },
            &f.depth, &f.error),
        GP_OK);
    for (int i = 0; i < 4; i++)
        f.uniforms.matrix[i][i] = 1;
    return f;
}

/* Links its own parts; after this it must not move. */
static inline void link_drawing(Drawing *f, uint32_t draws, const GpProgram *program,
                                const Corner *corners, uint32_t count)
{
    f->pass = (GpPass){ .name = "main",
                        .color[0] = { .surface = f->color, .clear = true },
                        .depth = { .surface = f->depth,
                                   .clear_depth = true,
                                   .clear_stencil = true,
                                   .depth_value = 1 },
                        .draws = f->draw,
                        .draw_count = draws };
    f->list = (GpList){ &f->pass, 1 };
    for (uint32_t i = 0; i < draws; i++) {
        f->draw[i].name = "triangles";
        f->draw[i].program = program;
        f->draw[i].uniforms = &f->uniforms;
        f->draw[i].geometry = (GpGeometry){
            .vertex_count = count,
            .streams = { [GP_POSITION] = { corners->position, sizeof *corners, 4, GP_FLOAT32 },
                         [GP_COLOR] = { corners->color, sizeof *corners, 4, GP_FLOAT32 },
                         [GP_TEXCOORD0] = { corners->uv, sizeof *corners, 2, GP_FLOAT32 } },
        };
    }
}

static inline void free_drawing(Drawing *f)
{
    gp_surface_destroy(&f->color);
    gp_surface_destroy(&f->depth);
}

static inline GpResult run(const GpList *list, const GpDeviceDesc *desc, GpError *error)
{
    GpDevice *device = NULL;
    GpResult result = gp_device_create(desc, &device, error);
    if (result == GP_OK)
        result = gp_device_run(device, list, error);
    gp_device_destroy(&device);
    return result;
}

static const Corner full_screen[6] = {
    { { -1, 1, 0.5f, 1 }, { 1, 0, 0, 0.5f }, { 0, 0 } },
    { { 1, 1, 0.5f, 1 }, { 1, 0, 0, 0.5f }, { 1, 0 } },
    { { 1, -1, 0.5f, 1 }, { 1, 0, 0, 0.5f }, { 1, 1 } },
    { { -1, 1, 0.5f, 1 }, { 1, 0, 0, 0.5f }, { 0, 0 } },
    { { 1, -1, 0.5f, 1 }, { 1, 0, 0, 0.5f }, { 1, 1 } },
    { { -1, -1, 0.5f, 1 }, { 1, 0, 0, 0.5f }, { 0, 1 } },
};

/* Counts events. */
static inline void ignore_event(void *user, const GpTraceEvent *event)
{
    (void)event;
    ++*(long *)user;
}

#endif
