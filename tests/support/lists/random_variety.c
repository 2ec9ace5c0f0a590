#include "tests/support/lists/random_variety.h"

#include "tests/support/random.h"
#include "tests/support/random_geometry.h"

#include <string.h>

enum { GAP = 0xa5, MOST_GAP = 70 };

/* --- geometry --------------------------------------------------------------------------------- */

/* A stream's floats, or bits of any kind, as another type. */
static bool vary_stream(Random *r, uint32_t count, bool any_bits, GpStream *stream, void **kept)
{
    static const GpComponentType places[] = { GP_FLOAT16, GP_SNORM16 };
    const GpComponentType type = any_bits
                                     ? (GpComponentType)random_int(r, 1, GP_COMPONENT_TYPES - 1)
                                     : places[random_int(r, 0, 1)];
    const uint8_t components = type == GP_D3DCOLOR ? 4 : stream->components;
    const size_t stride = gp_component_bytes(type) * components + (size_t)random_int(r, 0, 3);
    uint8_t *bytes = gp_alloc(count, stride);
    if (!bytes)
        return false;
    for (size_t i = 0; i < count * stride; i++)
        bytes[i] = (uint8_t)random_word(r);
    for (uint32_t v = 0; !any_bits && v < count; v++)
        for (uint32_t c = 0; c < components; c++) {
            const uint8_t *from = (const uint8_t *)stream->data + (size_t)v * stream->stride;
            float value;
            memcpy(&value, from + c * sizeof value, sizeof value);
            const float within = value > -1 ? (value < 1 ? value : 1.0f) : -1.0f;
            const uint16_t code = type == GP_FLOAT16 ? gp_half_from_float(value)
                                                     : (uint16_t)(int16_t)(within * 32767);
            memcpy(bytes + v * stride + c * sizeof code, &code, sizeof code);
        }
    *stream = (GpStream){ bytes, (uint32_t)stride, components, type };
    *kept = bytes;
    return true;
}

static bool vary_indices(GpGeometry *geometry, void **kept)
{
    uint16_t *narrow = gp_alloc(geometry->index_count, sizeof *narrow);
    for (uint32_t i = 0; narrow && i < geometry->index_count; i++)
        narrow[i] = (uint16_t)geometry->indices[i];
    geometry->indices16 = narrow;
    geometry->indices = NULL;
    *kept = narrow;
    return narrow != NULL;
}

static bool vary_geometry(Random *r, GpGeometry *geometry, void *kept[4])
{
    if (geometry->primitive == GP_TRIANGLES && random_chance(r, 70))
        geometry->primitive = random_chance(r, 50) ? GP_TRIANGLE_STRIP : GP_TRIANGLE_FAN;
    if (geometry->indices && geometry->vertex_count <= 65536 && random_chance(r, 60) &&
        !vary_indices(geometry, &kept[0]))
        return false;
    static const GpSemantic semantics[] = { GP_COLOR, GP_TEXCOORD0, GP_POSITION };
    for (int i = 0; i < 3; i++)
        if (random_chance(r, i == 2 ? 20 : 60) &&
            !vary_stream(r, geometry->vertex_count, i < 2, &geometry->streams[semantics[i]],
                         &kept[1 + i]))
            return false;
    return true;
}

/* --- clears ----------------------------------------------------------------------------------- */

static bool clears(const GpPass *pass)
{
    bool some = pass->depth.surface && (pass->depth.clear_depth || pass->depth.clear_stencil);
    for (int i = 0; i < GP_MAX_TARGETS && pass->color[i].surface; i++)
        some = some || pass->color[i].clear;
    return some;
}

static void vary_clears(Random *r, GpPass *pass, GpRect rects[RANDOM_RECTS])
{
    if (!clears(pass) || !random_chance(r, 60))
        return;
    uint32_t width, height;
    gp_pass_size(pass, &width, &height);
    pass->clear_rects = rects;
    pass->clear_rect_count = (uint32_t)random_int(r, 1, RANDOM_RECTS);
    for (uint32_t i = 0; i < pass->clear_rect_count; i++) {
        rects[i].x0 = random_int(r, -9, (int32_t)width);
        rects[i].y0 = random_int(r, -9, (int32_t)height);
        rects[i].x1 = rects[i].x0 + random_int(r, -2, (int32_t)width + 9);
        rects[i].y1 = rects[i].y0 + random_int(r, -2, (int32_t)height + 9);
    }
}

/* --- surfaces --------------------------------------------------------------------------------- */

static size_t row_bytes(const GpSurface *surface)
{
    return (size_t)surface->width * gp_format_info(surface->format)->bytes;
}

/* Moves a surface of one level into memory with gaps between its rows, at any address. */
static bool borrow_memory(Random *r, GpSurface *surface, void **kept)
{
    const size_t row = row_bytes(surface);
    const size_t start = (size_t)random_int(r, 0, 15), gap = (size_t)random_int(r, 0, MOST_GAP);
    uint8_t *memory = gp_alloc_unset(start + surface->height * (row + gap));
    GpSurface *other = NULL;
    const GpSurfaceDesc desc = { .format = surface->format,
                                 .width = surface->width,
                                 .height = surface->height,
                                 .memory = memory ? memory + start : NULL,
                                 .pitch = row + gap };
    if (!memory)
        return false;
    memset(memory, GAP, start + surface->height * (row + gap));
    if (gp_surface_create(&desc, &other, NULL)) {
        gp_free(memory);
        return false;
    }
    for (uint32_t y = 0; y < surface->height; y++)
        memcpy(gp_surface_texel(&other->level[0], 1, 0, y),
               gp_surface_texel(&surface->level[0], 1, 0, y), row);
    const GpSurface own = *surface;
    *surface = *other;
    *other = own;
    gp_surface_destroy(&other);
    *kept = memory;
    return true;
}

static bool vary_surfaces(Random *r, RandomList *random)
{
    for (int i = 0; i < random->surface_count; i++) {
        GpSurface *surface = random->surfaces[i];
        if (surface->format == GP_A8R8G8B8 && random_chance(r, 50))
            surface->format = GP_X8R8G8B8;
        if (i < 3 && surface->format == GP_R8 && random_chance(r, 60)) /* textures come first */
            surface->format = GP_L8;
        if (surface->levels == 1 && random_chance(r, 30) &&
            !borrow_memory(r, surface, &random->kept_memory[i]))
            return false;
    }
    return true;
}

/* Another name for a target of an earlier pass: a texture of this one, or its first target. */
static bool add_name(Random *r, RandomList *random, uint32_t number)
{
    GpPass *pass = &random->passes[number];
    GpSurface *target = random->passes[random_int(r, 0, (int32_t)number - 1)].color[0].surface;
    GpSurface *name = NULL;
    if (!target)
        return true;
    const GpSurfaceDesc desc = { .format =
                                     target->format == GP_A8R8G8B8 ? GP_X8R8G8B8 : target->format,
                                 .width = target->width,
                                 .height = target->height,
                                 .memory = target->level[0].texels,
                                 .pitch = target->level[0].pitch };
    if (gp_surface_create(&desc, &name, NULL))
        return false;
    random->surfaces[random->surface_count++] = name;
    const GpPass before = *pass;
    const bool as_target = random_chance(r, 40);
    if (as_target)
        pass->color[0].surface = name;
    if (gp_list_check(&random->list, NULL) != GP_OK)
        *pass = before;
    for (uint32_t i = 0; !as_target && i < pass->draw_count; i++) {
        GpTexture *texture = &random->draws[number][i].textures[random_int(r, 0, 3)];
        const GpTexture old = *texture;
        texture->surface = name;
        if (gp_list_check(&random->list, NULL) != GP_OK)
            *texture = old;
    }
    return true;
}

/* --- all -------------------------------------------------------------------------------------- */

bool random_variety_add(uint64_t seed, RandomList *random)
{
    Random r = { seed * 0xd1b54a32d192ed03u + 7 };
    if (!vary_surfaces(&r, random))
        return false;
    for (uint32_t p = 0; p < random->list.pass_count; p++) {
        vary_clears(&r, &random->passes[p], random->rects[p]);
        for (uint32_t i = 0; i < random->passes[p].draw_count; i++)
            if (!vary_geometry(&r, &random->draws[p][i].geometry, random->kept_geometry[p][i]))
                return false;
        if (p > 0 && random_chance(&r, 30) && !add_name(&r, random, p))
            return false;
    }
    return true;
}

bool random_variety_gaps_kept(const RandomList *random)
{
    for (int i = 0; i < random->surface_count; i++) {
        const GpSurface *surface = random->surfaces[i];
        const size_t row = row_bytes(surface), pitch = surface->level[0].pitch;
        for (uint32_t y = 0; random->kept_memory[i] && y < surface->height; y++)
            for (size_t b = row; b < pitch; b++)
                if (surface->level[0].texels[y * pitch + b] != GAP)
                    return false;
    }
    return true;
}
