/* The scenes through glasspipe. */
#include "tests/peer/peer.h"

#include "pipeline/units/vertex_stage.h"

#include <string.h>

GpResult peer_picture_create(bool with_triangles, PeerPicture *picture)
{
    *picture = (PeerPicture){
        .rgba = gp_alloc(PEER_PIXELS, sizeof *picture->rgba),
        .depth = gp_alloc(PEER_PIXELS, sizeof *picture->depth),
        .triangle = with_triangles ? gp_alloc(PEER_PIXELS, sizeof *picture->triangle) : NULL,
    };
    if (picture->rgba && picture->depth && (picture->triangle || !with_triangles))
        return GP_OK;
    peer_picture_free(picture);
    return GP_ERROR_MEMORY;
}

void peer_picture_free(PeerPicture *picture)
{
    gp_free(picture->rgba);
    gp_free(picture->depth);
    gp_free(picture->triangle);
    *picture = (PeerPicture){ 0 };
}

static void copy_texels(const GpSurface *color, const GpSurface *depth, PeerPicture *picture)
{
    for (size_t i = 0; i < PEER_PIXELS; i++) {
        const uint8_t *bgra = color->level[0].texels + i * 4;
        picture->rgba[i][0] = bgra[2];
        picture->rgba[i][1] = bgra[1];
        picture->rgba[i][2] = bgra[0];
        picture->rgba[i][3] = bgra[3];
    }
    memcpy(picture->depth, depth->level[0].texels, PEER_PIXELS * sizeof(float));
}

static GpResult run(const PeerScene *scene, float shift, GpSurface *color, GpSurface *depth,
                    GpError *error)
{
    GpDraw draw = {
        .name = "scene",
        .program = &phong_program,
        .uniforms = &scene->uniforms,
        .geometry = { .vertex_count = scene->vertex_count,
                      .indices = scene->indices,
                      .index_count = scene->index_count },
        .viewport = { .x = shift, .width = PEER_SIZE, .height = PEER_SIZE },
        .state = { .depth = { .test = GP_LESS, .write = true } },
    };
    draw.geometry.streams[GP_POSITION] = (GpStream){ .data = scene->vertices[0].position,
                                                     .stride = sizeof(PeerVertex),
                                                     .components = 3 };
    draw.geometry.streams[GP_NORMAL] = (GpStream){ .data = scene->vertices[0].normal,
                                                   .stride = sizeof(PeerVertex),
                                                   .components = 3 };
    GpPass pass = {
        .name = "scene",
        .color = { { .surface = color, .clear = true, .clear_color = { 0.10f, 0.12f, 0.15f, 0 } } },
        .depth = { .surface = depth, .clear_depth = true, .depth_value = 1 },
        .draws = &draw,
        .draw_count = 1,
    };
    GpList list = { .passes = &pass, .pass_count = 1 };
    GpDevice *device;
    GpResult result = gp_device_create(&(GpDeviceDesc){ 0 }, &device, error);
    if (result)
        return result;
    result = gp_device_run(device, &list, error);
    gp_device_destroy(&device);
    return result;
}

GpResult peer_draw_glasspipe(const PeerScene *scene, float shift, PeerPicture *picture,
                             GpError *error)
{
    GpSurface *color = NULL, *depth = NULL;
    GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = PEER_SIZE, .height = PEER_SIZE };
    GpResult result = gp_surface_create(&desc, &color, error);
    desc.format = GP_D32F;
    if (!result)
        result = gp_surface_create(&desc, &depth, error);
    if (!result)
        result = run(scene, shift, color, depth, error);
    if (!result)
        copy_texels(color, depth, picture);
    gp_surface_destroy(&color);
    gp_surface_destroy(&depth);
    return result;
}

void peer_clip_positions(const PeerScene *scene, float (*clip)[4])
{
    GpVertexStage stage = { .program = &phong_program,
                            .code = gp_program_code(&phong_program, 4),
                            .uniforms = &scene->uniforms };
    for (uint32_t i = 0; i < scene->vertex_count; i += 4) {
        GpVertex shaded[4];
        int count = scene->vertex_count - i < 4 ? (int)(scene->vertex_count - i) : 4;
        gp_shade_vertices(&stage, scene->vertices[i].position, count, shaded);
        for (int k = 0; k < count; k++)
            memcpy(clip[i + (uint32_t)k], shaded[k].clip, sizeof shaded[k].clip);
    }
}
