#include "apps/techniques/shadow/discs.h"

#include "apps/base/vector.h"

#include <math.h>
#include <string.h>

typedef struct DiscCorner {
    float position[3], place[2];
} DiscCorner;

/* Counter-clockwise seen from where the normal points to. */
static void corners_of(const Surfel *surfel, DiscCorner corners[4])
{
    static const float places[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    double normal[3], aside[3], first[3], second[3];
    int least = 0;
    for (int k = 0; k < 3; k++) {
        normal[k] = (double)surfel->normal[k];
        least = fabs(normal[k]) < fabs(normal[least]) ? k : least;
    }
    vector_set(aside, least == 0, least == 1, least == 2);
    vector_cross(aside, normal, first);
    vector_normalize(first);
    vector_cross(normal, first, second);
    for (int i = 0; i < 4; i++) {
        memcpy(corners[i].place, places[i], sizeof places[i]);
        for (int k = 0; k < 3; k++)
            corners[i].position[k] =
                (float)((double)surfel->position[k] +
                        (double)surfel->radius *
                            ((double)places[i][0] * first[k] + (double)places[i][1] * second[k]));
    }
}

static GpResult make_draw(const Surfels *model, Frame *memory, GpDraw *draw)
{
    static const uint32_t triangles[6] = { 0, 1, 2, 0, 2, 3 };
    DiscCorner *corners = frame_alloc(memory, model->count, 4 * sizeof *corners);
    uint32_t *indices = frame_alloc(memory, model->count, 6 * sizeof *indices);
    if (!corners || !indices)
        return GP_ERROR_MEMORY;
    for (size_t i = 0; i < model->count; i++) {
        corners_of(&model->surfels[i], corners + 4 * i);
        for (size_t k = 0; k < 6; k++)
            indices[6 * i + k] = (uint32_t)(4 * i) + triangles[k];
    }
    *draw = (GpDraw){
        .name = "discs",
        .program = &shadow_disc_program,
        .geometry = { .vertex_count = 4 * model->count,
                      .indices = indices,
                      .index_count = 6 * model->count,
                      .streams = { [GP_POSITION] = { corners->position, sizeof *corners, 3,
                                                     GP_FLOAT32 },
                                   [GP_TEXCOORD0] = { corners->place, sizeof *corners, 2,
                                                      GP_FLOAT32 } } },
    };
    return GP_OK;
}

GpResult shadow_scene_with_discs(const Scene *scene, Frame *memory, Scene *made, GpError *error)
{
    const uint32_t objects = scene->list.passes[0].draw_count, models = scene->splats.source_count;
    const uint32_t passes = scene->list.pass_count;
    GpPass *pass = frame_alloc(memory, passes, sizeof *pass);
    GpDraw *draws = frame_alloc(memory, objects + models + 1, sizeof *draws);
    GpResult result = pass && draws ? GP_OK : GP_ERROR_MEMORY;
    if (!result && objects)
        memcpy(draws, scene->list.passes[0].draws, objects * sizeof *draws);
    for (uint32_t i = 0; i < models && !result; i++) {
        result = scene->splat_models[i].count > 1u << 29
                     ? GP_ERROR_UNSUPPORTED
                     : make_draw(&scene->splat_models[i], memory, &draws[objects + i]);
    }
    if (result == GP_ERROR_UNSUPPORTED)
        return gp_fail(error, result, "too many splats cast shadows: over 2^29 of one model");
    if (result)
        return gp_fail(error, result, "out of memory");
    memcpy(pass, scene->list.passes, passes * sizeof *pass);
    pass->draws = draws;
    pass->draw_count = objects + models;
    *made = *scene;
    made->list.passes = pass;
    return GP_OK;
}
