/* Surfaces and geometry as objects of OpenGL. */
#include "tests/peer/bench/replay_parts.h"

#include <string.h>

static const unsigned formats[GP_FORMATS] = {
    [GP_A8R8G8B8] = GL_RGBA8,
    [GP_A16B16G16R16F] = GL_RGBA16F,
    [GP_A32B32G32R32F] = GL_RGBA32F,
    [GP_D32F] = GL_DEPTH_COMPONENT32F,
};

static const unsigned addresses[GP_ADDRESSES] = {
    [GP_WRAP] = GL_REPEAT,
    [GP_MIRROR] = GL_MIRRORED_REPEAT,
    [GP_CLAMP] = GL_CLAMP_TO_EDGE,
};

/* --- textures and targets --------------------------------------------------------------------- */

void replay_swap_red_and_blue(const uint8_t *from, size_t texels, uint8_t *to)
{
    for (size_t i = 0; i < 4 * texels; i += 4) {
        const uint8_t swapped[4] = { from[i + 2], from[i + 1], from[i], from[i + 3] };
        memcpy(to + i, swapped, 4);
    }
}

static GpResult upload(const Gl *gl, const GpSurface *surface, GpError *error)
{
    uint8_t *rgba = gp_alloc((size_t)surface->width * surface->height, 4);
    if (!rgba)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for a texture");
    for (uint32_t i = 0; i < surface->levels; i++) {
        const GpLevel *level = &surface->level[i];
        replay_swap_red_and_blue(level->texels, (size_t)level->width * level->height, rgba);
        gl->TexSubImage2D(GL_TEXTURE_2D, (int)i, 0, 0, (int)level->width, (int)level->height,
                          GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    }
    gp_free(rgba);
    return GP_OK;
}

static void set_filters(const Gl *gl, unsigned min_filter, unsigned mag_filter)
{
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (int)min_filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, (int)mag_filter);
}

unsigned replay_find_texture(const Replay *r, const GpSurface *surface)
{
    for (int i = 0; i < r->texture_count; i++)
        if (r->textures[i].surface == surface)
            return r->textures[i].name;
    return 0;
}

GpResult replay_make_texture(Replay *r, const GpSurface *surface, GpError *error)
{
    const Gl *gl = r->gl;
    unsigned name, format = formats[surface->format];
    if (replay_find_texture(r, surface))
        return GP_OK;
    if (r->texture_count == REPLAY_SURFACES || !format)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "more surfaces, or other formats, than known");
    gl->GenTextures(1, &name);
    gl->BindTexture(GL_TEXTURE_2D, name);
    gl->TexStorage2D(GL_TEXTURE_2D, (int)surface->levels, format, (int)surface->width,
                     (int)surface->height);
    set_filters(gl, GL_NEAREST, GL_NEAREST);
    r->textures[r->texture_count++] = (Texture){ surface, name };
    return surface->format == GP_A8R8G8B8 ? upload(gl, surface, error) : GP_OK;
}

/* OpenGL ES keeps a sampler's state with the texture; every surface is sampled one way. */
GpResult replay_set_sampler(const Replay *r, const GpTexture *texture, GpError *error)
{
    const Gl *gl = r->gl;
    const GpSampler *sampler = &texture->sampler;
    unsigned min_filter = sampler->min == GP_LINEAR ? GL_LINEAR : GL_NEAREST;
    unsigned mag_filter = sampler->mag == GP_LINEAR ? GL_LINEAR : GL_NEAREST;
    unsigned u = addresses[sampler->address_u], v = addresses[sampler->address_v];
    if (!u || !v)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "a texture's addressing is not translated");
    if (sampler->mip) /* NEAREST or LINEAR between levels */
        min_filter += GL_NEAREST_MIPMAP_NEAREST - GL_NEAREST + (sampler->mip == GP_MIP_LINEAR) * 2u;
    gl->BindTexture(GL_TEXTURE_2D, replay_find_texture(r, texture->surface));
    set_filters(gl, min_filter, mag_filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, (int)u);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, (int)v);
    if (sampler->compare) {
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }
    return GP_OK;
}

static bool same_targets(const GpPass *a, const GpPass *b)
{
    bool same = a->depth.surface == b->depth.surface;
    for (int i = 0; i < GP_MAX_TARGETS; i++)
        same = same && a->color[i].surface == b->color[i].surface;
    return same;
}

GpResult replay_make_framebuffer(Replay *r, uint32_t index, GpError *error)
{
    const Gl *gl = r->gl;
    const GpPass *pass = &r->list->passes[index];
    for (uint32_t i = 0; i < index; i++)
        if (same_targets(pass, &r->list->passes[i])) {
            r->framebuffers[index] = r->framebuffers[i];
            return GP_OK;
        }
    unsigned places[GP_MAX_TARGETS] = { 0 }, name; /* 0 is GL_NONE */
    int colors = 0;
    gl->GenFramebuffers(1, &name);
    gl->BindFramebuffer(GL_FRAMEBUFFER, name);
    for (; colors < GP_MAX_TARGETS && pass->color[colors].surface; colors++) {
        places[colors] = GL_COLOR_ATTACHMENT0 + (unsigned)colors;
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, places[colors], GL_TEXTURE_2D,
                                 replay_find_texture(r, pass->color[colors].surface), 0);
    }
    if (pass->depth.surface)
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                                 replay_find_texture(r, pass->depth.surface), 0);
    gl->DrawBuffers(colors ? colors : 1, places);
    r->framebuffers[index] = name;
    if (gl->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return gp_fail(error, GP_ERROR_UNSUPPORTED, "OpenGL ES refused the targets of a pass");
    return GP_OK;
}

/* --- geometry --------------------------------------------------------------------------------- */

/* The attribute that a geometry has beside the position, or an empty one. */
static const GpStream *second_stream(const GpGeometry *geometry)
{
    int semantic = GP_POSITION + 1;
    while (semantic < GP_SEMANTICS - 1 && !geometry->streams[semantic].data)
        semantic++;
    return &geometry->streams[semantic];
}

static void copy_stream(const GpStream *stream, uint32_t count, float *to, size_t step)
{
    const size_t packed = stream->components * sizeof *to;
    const size_t stride = stream->stride ? stream->stride : packed;
    for (size_t i = 0; stream->data && i < count; i++)
        memcpy(to + i * step, (const char *)stream->data + i * stride, packed);
}

GpResult replay_make_array(const Gl *gl, const GpGeometry *geometry, unsigned *array,
                           GpError *error)
{
    const GpStream *streams[2] = { &geometry->streams[GP_POSITION], second_stream(geometry) };
    const size_t step = (size_t)streams[0]->components + streams[1]->components;
    float *vertices = gp_alloc(geometry->vertex_count, step * sizeof *vertices);
    size_t offset = 0;
    unsigned buffers[2];
    if (!vertices)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for vertices");
    gl->GenVertexArrays(1, array);
    gl->BindVertexArray(*array);
    gl->GenBuffers(2, buffers);
    gl->BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    for (unsigned i = 0; i < 2 && streams[i]->data; i++) {
        copy_stream(streams[i], geometry->vertex_count, vertices + offset, step);
        gl->VertexAttribPointer(i, streams[i]->components, GL_FLOAT, 0, (int)(step * sizeof(float)),
                                (const void *)(offset * sizeof(float)));
        gl->EnableVertexAttribArray(i);
        offset += streams[i]->components;
    }
    gl->BufferData(GL_ARRAY_BUFFER, (intptr_t)(geometry->vertex_count * step * sizeof *vertices),
                   vertices, GL_STATIC_DRAW);
    if (geometry->indices) {
        gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
        gl->BufferData(GL_ELEMENT_ARRAY_BUFFER,
                       (intptr_t)(geometry->index_count * sizeof *geometry->indices),
                       geometry->indices, GL_STATIC_DRAW);
    }
    gp_free(vertices);
    return GP_OK;
}
