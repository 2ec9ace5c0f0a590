/* Surfaces: their memory, clears, mip levels, reading and hashes. */
#include "pipeline/resources/surface.h"

#include "pipeline/resources/surface_memory.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <xxhash.h>

/* --- rectangles ------------------------------------------------------------------------------- */

GpRect gp_rect_common(GpRect a, GpRect b)
{
    return (GpRect){ a.x0 > b.x0 ? a.x0 : b.x0, a.y0 > b.y0 ? a.y0 : b.y0,
                     a.x1 < b.x1 ? a.x1 : b.x1, a.y1 < b.y1 ? a.y1 : b.y1 };
}

/* --- life ------------------------------------------------------------------------------------- */

static GpResult check_memory(const GpSurfaceDesc *desc, GpError *error)
{
    const size_t row = (size_t)desc->width * gp_format_info(desc->format)->bytes;
    if (!desc->memory)
        return !desc->pitch
                   ? GP_OK
                   : gp_fail(error, GP_ERROR_INVALID, "surface: a pitch is said, but no memory");
    if (desc->levels > 1)
        return gp_fail(error, GP_ERROR_INVALID,
                       "surface: memory of one's own has one level, not %u", desc->levels);
    if (desc->pitch && desc->pitch < row)
        return gp_fail(error, GP_ERROR_INVALID, "surface: pitch %zu is less than a row's %zu bytes",
                       desc->pitch, row);
    if (desc->pitch > INT32_MAX / desc->height)
        return gp_fail(error, GP_ERROR_INVALID, "surface: %u rows of %zu bytes are over 2 GB",
                       desc->height, desc->pitch);
    return GP_OK;
}

static bool has_window(const GpSurfaceDesc *desc)
{
    return desc->window.x0 || desc->window.y0 || desc->window.x1 || desc->window.y1;
}

static bool is_step(int32_t at, uint32_t side)
{
    return at % GP_WINDOW_STEP == 0 || at == (int32_t)side;
}

static GpResult check_window(const GpSurfaceDesc *desc, GpError *error)
{
    const GpRect *w = &desc->window;
    if (desc->memory || desc->levels > 1)
        return gp_fail(error, GP_ERROR_INVALID, "surface: a window has one level, of its own");
    if (w->x0 < 0 || w->y0 < 0 || gp_rect_is_empty(*w) || w->x1 > (int32_t)desc->width ||
        w->y1 > (int32_t)desc->height)
        return gp_fail(error, GP_ERROR_INVALID,
                       "surface: window [%d, %d) x [%d, %d) is not inside %ux%u", w->x0, w->x1,
                       w->y0, w->y1, desc->width, desc->height);
    if (w->x1 - w->x0 > GP_MAX_SIZE || w->y1 - w->y0 > GP_MAX_SIZE)
        return gp_fail(error, GP_ERROR_INVALID, "surface: window %dx%d is not within 1..%d",
                       w->x1 - w->x0, w->y1 - w->y0, GP_MAX_SIZE);
    if (w->x0 % GP_WINDOW_STEP || w->y0 % GP_WINDOW_STEP || !is_step(w->x1, desc->width) ||
        !is_step(w->y1, desc->height))
        return gp_fail(error, GP_ERROR_INVALID,
                       "surface: window [%d, %d) x [%d, %d) is not at multiples of %d", w->x0,
                       w->x1, w->y0, w->y1, GP_WINDOW_STEP);
    return GP_OK;
}

static GpResult check(const GpSurfaceDesc *desc, GpError *error)
{
    const uint32_t most_side = has_window(desc) ? GP_MAX_WHOLE : GP_MAX_SIZE;
    if (desc->format <= GP_FORMAT_NONE || desc->format >= GP_FORMATS)
        return gp_fail(error, GP_ERROR_INVALID, "surface: %d is no format", (int)desc->format);
    if (desc->width < 1 || desc->width > most_side || desc->height < 1 || desc->height > most_side)
        return gp_fail(error, GP_ERROR_INVALID, "surface: size %ux%u is not within 1..%u",
                       desc->width, desc->height, most_side);
    if (has_window(desc))
        return check_window(desc, error);
    const GpSurfaceDesc whole = { .width = desc->width,
                                  .height = desc->height,
                                  .levels = GP_MAX_LEVELS };
    const uint32_t most = gp_surface_levels(&whole);
    if (desc->levels > most && desc->levels < GP_MAX_LEVELS)
        return gp_fail(error, GP_ERROR_INVALID, "surface: %ux%u has %u levels, not %u", desc->width,
                       desc->height, most, desc->levels);
    return check_memory(desc, error);
}

/* From where texel (0, 0) would be to the first there is. */
static size_t window_offset(const GpSurface *surface, const GpLevel *level)
{
    return (size_t)surface->window.y0 * level->pitch +
           (size_t)surface->window.x0 * gp_format_info(surface->format)->bytes;
}

static void free_level(const GpSurface *surface, uint32_t i)
{
    uint8_t *texels = surface->level[i].texels;
    gp_free(texels && i == 0 ? texels + window_offset(surface, &surface->level[0]) : texels);
}

/* Memory for the texels of a window, which is the surface's; NULL: there is none. */
static uint8_t *make_window(const GpSurface *surface, GpLevel *level)
{
    const GpRect *window = &surface->window;
    level->pitch = (size_t)(window->x1 - window->x0) * gp_format_info(surface->format)->bytes;
    uint8_t *texels = gp_alloc((size_t)(window->y1 - window->y0), level->pitch);
    return texels ? texels - window_offset(surface, level) : NULL;
}

GpResult gp_surface_make_whole(GpSurface *surface, GpError *error)
{
    if (gp_surface_is_whole(surface))
        return GP_OK;
    const GpSurfaceDesc desc = { .format = surface->format,
                                 .width = surface->width,
                                 .height = surface->height };
    GpSurface *whole = NULL;
    const GpResult result = gp_surface_create(&desc, &whole, error);
    if (result)
        return result;
    free_level(surface, 0);
    surface->level[0] = whole->level[0];
    surface->window = whole->window;
    gp_free(whole);
    return GP_OK;
}

GpResult gp_surface_create(const GpSurfaceDesc *desc, GpSurface **surface, GpError *error)
{
    GpResult result = check(desc, error);
    if (result)
        return result;

    GpSurface *s = gp_alloc(1, sizeof *s);
    if (!s)
        return gp_fail(error, GP_ERROR_MEMORY, "surface: no memory");
    snprintf(s->name, sizeof s->name, "%s", desc->name ? desc->name : "");
    s->format = desc->format;
    s->width = desc->width;
    s->height = desc->height;
    s->borrowed = desc->memory != NULL;
    s->window =
        has_window(desc) ? desc->window : (GpRect){ 0, 0, (int32_t)s->width, (int32_t)s->height };
    s->levels = gp_surface_levels(desc);

    /* One allocation a level: an address beyond a level's end is then an error that sanitizers see,
     * not a texel of the next. */
    for (uint32_t i = 0; i < s->levels; i++) {
        GpLevel *level = &s->level[i];
        level->width = gp_surface_level_side(s->width, i);
        level->height = gp_surface_level_side(s->height, i);
        level->pitch = (size_t)level->width * gp_format_info(s->format)->bytes;
        if (s->borrowed) {
            level->pitch = desc->pitch ? desc->pitch : level->pitch;
            level->texels = desc->memory;
            continue;
        }
        level->texels = i ? gp_alloc(level->height, level->pitch) : make_window(s, level);
        if (!level->texels) {
            gp_surface_destroy(&s);
            return gp_fail(error, GP_ERROR_MEMORY, "surface: no memory for %ux%u %s, %.0f MB",
                           desc->width, desc->height, gp_format_info(desc->format)->name,
                           ceil((double)gp_surface_bytes(desc) / (1 << 20)));
        }
    }
    *surface = s;
    return GP_OK;
}

void gp_surface_destroy(GpSurface **surface)
{
    if (!surface || !*surface)
        return;
    for (uint32_t i = 0; !(*surface)->borrowed && i < (*surface)->levels; i++)
        free_level(*surface, i);
    gp_free(*surface);
    *surface = NULL;
}

/* --- shared memory ---------------------------------------------------------------------------- */

/* The memory that a level's texels take, as far as there are any. */
typedef struct Rows {
    uintptr_t first;
    size_t bytes, pitch, count; /* of a row, from row to row, how many */
} Rows;

static Rows rows_of(const GpSurface *surface, uint32_t number)
{
    const GpLevel *level = &surface->level[number];
    const GpRect whole = { 0, 0, (int32_t)level->width, (int32_t)level->height };
    const GpRect *there = number ? &whole : &surface->window;
    return (Rows){ .first = (uintptr_t)level->texels + (number ? 0 : window_offset(surface, level)),
                   .bytes =
                       (size_t)(there->x1 - there->x0) * gp_format_info(surface->format)->bytes,
                   .pitch = level->pitch,
                   .count = (size_t)(there->y1 - there->y0) };
}

/* Rows of one pitch, the first of them not after the second's: whether bytes of theirs meet. */
static bool rows_meet(const Rows *a, const Rows *b)
{
    const size_t rows = (b->first - a->first) / a->pitch, column = (b->first - a->first) % a->pitch;
    const size_t past = column + b->bytes > a->pitch ? column + b->bytes - a->pitch : 0;
    return (rows < a->count && column < a->bytes) || (past && rows + 1 < a->count);
}

static bool rows_share(const Rows *a, const Rows *b)
{
    if (a->first > b->first)
        return rows_share(b, a);
    if (a->pitch == b->pitch)
        return rows_meet(a, b);
    return b->first - a->first < (a->count - 1) * a->pitch + a->bytes;
}

bool gp_surfaces_share(const GpSurface *a, const GpSurface *b)
{
    if (a == b)
        return true;
    if (!a || !b || !(a->borrowed || b->borrowed))
        return false;
    for (uint32_t i = 0; i < a->levels; i++)
        for (uint32_t j = 0; j < b->levels; j++) {
            const Rows one = rows_of(a, i), other = rows_of(b, j);
            if (rows_share(&one, &other))
                return true;
        }
    return false;
}

/* --- content ---------------------------------------------------------------------------------- */

/* The texels that there are of a level. */
static GpRect texels_of(const GpSurface *surface, uint32_t i)
{
    const GpLevel *level = &surface->level[i];
    return i == 0 ? surface->window
                  : (GpRect){ 0, 0, (int32_t)level->width, (int32_t)level->height };
}

void gp_surface_clear_color_rect(GpSurface *surface, GpRect rect, const float rgba[4])
{
    const size_t bytes = gp_format_info(surface->format)->bytes;
    const GpLevel *level = &surface->level[0];
    uint8_t texel[16];

    rect = gp_rect_common(rect, surface->window);
    gp_texel_store(surface->format, texel, rgba, 0);
    for (int32_t y = rect.y0; y < rect.y1; y++)
        for (int32_t x = rect.x0; x < rect.x1; x++)
            memcpy(gp_surface_texel(level, bytes, (uint32_t)x, (uint32_t)y), texel, bytes);
}

void gp_surface_clear_depth_rect(GpSurface *surface, GpRect rect, float depth, uint8_t stencil,
                                 bool clear_depth, bool clear_stencil)
{
    const GpFormat format = surface->format;
    const size_t bytes = gp_format_info(format)->bytes;
    const GpLevel *level = &surface->level[0];
    const uint32_t code = gp_depth_code(format, depth < 0.0f ? 0.0f : depth > 1.0f ? 1.0f : depth);

    rect = gp_rect_common(rect, surface->window);
    for (int32_t y = rect.y0; y < rect.y1; y++) {
        for (int32_t x = rect.x0; x < rect.x1; x++) {
            uint8_t *texel = gp_surface_texel(level, bytes, (uint32_t)x, (uint32_t)y);
            uint32_t old_code;
            uint8_t old_stencil;
            gp_depth_load(format, texel, &old_code, &old_stencil);
            gp_depth_store(format, texel, clear_depth ? code : old_code,
                           clear_stencil ? stencil : old_stencil);
        }
    }
}

void gp_surface_clear_color(GpSurface *surface, const float rgba[4])
{
    gp_surface_clear_color_rect(surface, surface->window, rgba);
}

void gp_surface_clear_depth(GpSurface *surface, float depth, uint8_t stencil, bool clear_depth,
                            bool clear_stencil)
{
    gp_surface_clear_depth_rect(surface, surface->window, depth, stencil, clear_depth,
                                clear_stencil);
}

/* Writes a level as the 2x2 means of the one before. */
static void build_level(GpFormat format, const GpLevel *fine, const GpLevel *coarse)
{
    const size_t bytes = gp_format_info(format)->bytes;
    for (uint32_t y = 0; y < coarse->height; y++) {
        for (uint32_t x = 0; x < coarse->width; x++) {
            uint32_t x0 = 2 * x, x1 = fine->width > 1 ? x0 + 1 : x0;
            uint32_t y0 = 2 * y, y1 = fine->height > 1 ? y0 + 1 : y0;
            float a[4], b[4], c[4], d[4], mean[4];
            gp_texel_load(format, gp_surface_texel(fine, bytes, x0, y0), a);
            gp_texel_load(format, gp_surface_texel(fine, bytes, x1, y0), b);
            gp_texel_load(format, gp_surface_texel(fine, bytes, x0, y1), c);
            gp_texel_load(format, gp_surface_texel(fine, bytes, x1, y1), d);
            for (int i = 0; i < 4; i++)
                mean[i] =
                    (float)(0.25 * (((double)a[i] + (double)b[i]) + ((double)c[i] + (double)d[i])));
            gp_texel_store(format, gp_surface_texel(coarse, bytes, x, y), mean, 0);
        }
    }
}

void gp_surface_build_mips(GpSurface *surface)
{
    for (uint32_t i = 1; i < surface->levels; i++)
        build_level(surface->format, &surface->level[i - 1], &surface->level[i]);
}

/* --- reading ---------------------------------------------------------------------------------- */

/* The rectangle to read, of a level that there is. */
static GpResult find_rect(const GpSurface *surface, uint32_t level, const GpRect *rect,
                          GpRect *found, GpError *error)
{
    if (level >= surface->levels)
        return gp_fail(error, GP_ERROR_INVALID, "surface '%s': level %u, but it has %u",
                       surface->name, level, surface->levels);
    const GpRect all = texels_of(surface, level);
    *found = rect ? *rect : all;
    if (found->x0 < all.x0 || found->y0 < all.y0 || found->x1 < found->x0 ||
        found->y1 < found->y0 || found->x1 > all.x1 || found->y1 > all.y1)
        return gp_fail(error, GP_ERROR_INVALID,
                       "surface '%s': [%d, %d) x [%d, %d) is not inside its %dx%d texels",
                       surface->name, found->x0, found->x1, found->y0, found->y1, all.x1 - all.x0,
                       all.y1 - all.y0);
    return GP_OK;
}

static void load_texels(GpFormat format, const uint8_t *texel, int32_t count, float *rgba)
{
    const size_t bytes = gp_format_info(format)->bytes;
    for (int32_t i = 0; i < count; i++, texel += bytes, rgba += 4)
        gp_texel_load(format, texel, rgba);
}

/* The same of bytes, by what each of their 256 codes means. */
static void look_up_texels(GpFormat format, const float values[256], const uint8_t *texel,
                           int32_t count, float *rgba)
{
    const size_t bytes = gp_format_info(format)->bytes;
    for (int32_t i = 0; i < count; i++, texel += bytes, rgba += 4) {
        uint8_t code[4];
        gp_texel_codes(format, texel, code);
        for (int c = 0; c < 4; c++)
            rgba[c] = values[code[c]];
    }
}

GpResult gp_surface_read_floats(const GpSurface *surface, uint32_t level, const GpRect *rect,
                                float *rgba, GpError *error)
{
    const GpFormatInfo *info = gp_format_info(surface->format);
    GpRect r;
    GpResult result = find_rect(surface, level, rect, &r, error);
    if (result)
        return result;
    const int32_t width = r.x1 - r.x0;
    const bool looks_up = info->is_unorm8 && (int64_t)width * (r.y1 - r.y0) > 256;
    float values[256];
    for (uint32_t code = 0; code < 256 && looks_up; code++)
        values[code] = gp_float_from_unorm(code, 8);
    for (int32_t y = r.y0; y < r.y1; y++, rgba += 4 * (size_t)width) {
        const uint8_t *row =
            gp_surface_texel(&surface->level[level], info->bytes, (uint32_t)r.x0, (uint32_t)y);
        if (looks_up)
            look_up_texels(surface->format, values, row, width, rgba);
        else
            load_texels(surface->format, row, width, rgba);
    }
    return GP_OK;
}

GpResult gp_surface_read_bytes(const GpSurface *surface, uint32_t level, const GpRect *rect,
                               void *bytes, size_t pitch, GpError *error)
{
    const size_t texel = gp_format_info(surface->format)->bytes;
    GpRect r;
    GpResult result = find_rect(surface, level, rect, &r, error);
    if (result)
        return result;
    const size_t row = (size_t)(r.x1 - r.x0) * texel;
    if (pitch && pitch < row)
        return gp_fail(error, GP_ERROR_INVALID,
                       "surface '%s': pitch %zu is less than a row's %zu bytes", surface->name,
                       pitch, row);
    uint8_t *to = bytes;
    for (int32_t y = r.y0; row && y < r.y1; y++, to += pitch ? pitch : row)
        memcpy(to, gp_surface_texel(&surface->level[level], texel, (uint32_t)r.x0, (uint32_t)y),
               row);
    return GP_OK;
}

uint64_t gp_surface_hash(const GpSurface *surface)
{
    const GpLevel *level = &surface->level[0];
    const GpRect *window = &surface->window;
    const uint32_t height = (uint32_t)(window->y1 - window->y0);
    const size_t row = (size_t)(window->x1 - window->x0) * gp_format_info(surface->format)->bytes;
    const uint8_t *first = level->texels + window_offset(surface, level);
    if (level->pitch == row)
        return XXH3_64bits(first, height * row);
    XXH3_state_t state;
    XXH3_64bits_reset(&state);
    for (uint32_t y = 0; y < height; y++)
        XXH3_64bits_update(&state, first + y * level->pitch, row);
    return XXH3_64bits_digest(&state);
}
