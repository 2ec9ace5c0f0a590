#include "apps/commands/render/frames.h"

#include "apps/frame/picture.h"
#include "apps/frame/window.h"
#include "apps/techniques/shadow/shadowed.h"
#include "pipeline/io/image/image_file.h"

#include <stdio.h>
#include <string.h>
#include <xxhash.h>

/* Of a part: with its depth, and what else a scene has for each pixel, some hundred megabytes. */
static const uint32_t most_pixels = 1u << 23;

/* Of a window that is put together in memory: a few hundred megabytes on its way to a file. */
static const uint64_t most_in_memory = 1u << 25;

/* --- names ------------------------------------------------------------------------------------ */

uint32_t frames_number(const Frames *frames, uint32_t i)
{
    return frames->first + i * frames->step;
}

/* Digits in the place of the first run of #, as many as there are at least. */
void frames_file(const Frames *frames, uint32_t i, char path[FRAMES_PATH])
{
    const char *mark = frames->moves ? strchr(frames->output, '#') : NULL;
    if (!mark) {
        snprintf(path, FRAMES_PATH, "%s", frames->output);
        return;
    }
    const size_t digits = strspn(mark, "#");
    snprintf(path, FRAMES_PATH, "%.*s%0*u%s", (int)(mark - frames->output), frames->output,
             (int)digits, frames_number(frames, i), mark + digits);
}

static uint32_t parts_of(const Frames *frames)
{
    return frames->columns * frames->rows;
}

static void tell(const void *context, uint32_t item, char name[ITEM_NAME])
{
    const Frames *frames = context;
    const uint32_t parts = parts_of(frames), number = frames_number(frames, item / parts);
    if (parts == 1 && !frames->moves)
        snprintf(name, ITEM_NAME, "the picture");
    else if (parts == 1)
        snprintf(name, ITEM_NAME, "frame %u", number);
    else if (!frames->moves)
        snprintf(name, ITEM_NAME, "window %u of %u", item % parts + 1, parts);
    else
        snprintf(name, ITEM_NAME, "frame %u, window %u of %u", number, item % parts + 1, parts);
}

/* --- parts ------------------------------------------------------------------------------------ */

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static uint32_t step_up(uint32_t side)
{
    return (side + GP_WINDOW_STEP - 1) / GP_WINDOW_STEP * GP_WINDOW_STEP;
}

/* Parts that the sides from x0 to x1 touch, each of `part' pixels and at multiples of it. */
static uint32_t touched(int32_t x0, int32_t x1, uint32_t part)
{
    return ((uint32_t)x1 + part - 1) / part - (uint32_t)x0 / part;
}

/* One where that is enough; else as many as memory asks for, and more only where fewer than are
 * wanted: so that a large picture has the same parts whoever draws it, as its journal has. */
static void choose_parts(Frames *frames, uint32_t width, uint32_t height, uint32_t wanted)
{
    const GpRect *window = &frames->window;
    const bool fits = width <= GP_MAX_SIZE && height <= GP_MAX_SIZE &&
                      (uint64_t)step_up(width) * step_up(height) <= most_pixels;
    frames->columns = frames->rows = 1;
    frames->part[0] = step_up((uint32_t)window->x1); /* one, wherever it lies */
    frames->part[1] = step_up((uint32_t)window->y1);
    if (fits && wanted <= 1)
        return;
    frames->part[0] = least(step_up(width), GP_MAX_SIZE);
    frames->part[1] =
        least(most_pixels / frames->part[0] / GP_WINDOW_STEP * GP_WINDOW_STEP, GP_MAX_SIZE);
    frames->columns = touched(window->x0, window->x1, frames->part[0]);
    frames->rows = touched(window->y0, window->y1, frames->part[1]);
    if (frames->columns * frames->rows < wanted)
        frames->part[1] = least(step_up((height + wanted - 1) / wanted), frames->part[1]);
    frames->rows = touched(window->y0, window->y1, frames->part[1]);
}

GpResult frames_split(Frames *frames, uint32_t at_once, GpError *error)
{
    const GpRect *window = &frames->window;
    const uint32_t width = (uint32_t)(window->x1 - window->x0);
    const uint32_t height = (uint32_t)(window->y1 - window->y0);
    const uint32_t wanted = (at_once + frames->count - 1) / frames->count;
    choose_parts(frames, width, height, wanted);
    frames->in_strips =
        (uint64_t)width * height > most_in_memory || width > GP_MAX_SIZE || height > GP_MAX_SIZE;
    if (frames->in_strips && !strips_can_write(frames->output))
        return gp_fail(error, GP_ERROR_INVALID,
                       "-o %s: a picture of %ux%u is written in strips: expected .png or .ppm",
                       frames->output, width, height);
    frames->results = gp_alloc(frames->count + 1, sizeof *frames->results);
    frames->pictures = gp_alloc(frames->count + 1, sizeof(GpSurface *));
    frames->missing = gp_alloc(frames->count + 1, sizeof *frames->missing);
    if (!frames->results || !frames->pictures || !frames->missing)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    return GP_OK;
}

/* Pixels of part `item', of the whole picture. */
static GpRect part_rect(const Frames *frames, uint32_t item)
{
    const uint32_t number = item % parts_of(frames);
    const uint32_t column =
        number % frames->columns + (uint32_t)frames->window.x0 / frames->part[0];
    const uint32_t row = number / frames->columns + (uint32_t)frames->window.y0 / frames->part[1];
    const GpRect all = { (int32_t)(column * frames->part[0]), (int32_t)(row * frames->part[1]),
                         (int32_t)((column + 1) * frames->part[0]),
                         (int32_t)((row + 1) * frames->part[1]) };
    return gp_rect_common(all, frames->window);
}

/* --- drawing ---------------------------------------------------------------------------------- */

/* What comes before the bytes: of a whole frame its file, of a part its texels. */
typedef struct Head {
    FrameResult result;
    uint64_t is_file;
} Head;

static GpResult load(const Frames *frames, uint32_t frame, const GpRect *part, Scene *scene,
                     GpError *error)
{
    const uint32_t number = frames_number(frames, frame);
    const bool all = part->x0 == 0 && part->y0 == 0 && part->x1 == (int32_t)frames->whole[0] &&
                     part->y1 == (int32_t)frames->whole[1];
    json_t *changes =
        frames->path.count ? path_at(&frames->path, number / frames->path.rate) : NULL;
    if (frames->path.count && !changes)
        return gp_fail(error, GP_ERROR_MEMORY, "%.200s: no memory for its changes", frames->scene);
    SceneOptions options = { .width = frames->whole[0],
                             .height = frames->whole[1],
                             .changes = changes,
                             .turn = frames->turn ? 360.0 * (number % frames->turn) / frames->turn
                                                  : 0 };
    if (!all)
        options.window = window_around(*part, frames->whole[0], frames->whole[1]);
    const GpResult result = shadowed_scene_load(frames->scene, &options, scene, error);
    json_decref(changes);
    return result;
}

/* Texels of a rectangle, without gaps; NULL: out of memory. */
static char *read_texels(const GpSurface *surface, const GpRect *part, size_t *size)
{
    *size = (size_t)(part->x1 - part->x0) * (size_t)(part->y1 - part->y0) *
            gp_format_info(surface->format)->bytes;
    char *texels = gp_alloc_unset(*size);
    GpError unused;
    if (texels && !gp_surface_read_bytes(surface, 0, part, texels, 0, &unused))
        return texels;
    gp_free(texels);
    return NULL;
}

static GpResult add_file(const Frames *frames, uint32_t frame, const GpSurface *surface,
                         const GpRect *part, GpPool *pool, GpBytes *bytes, GpError *error)
{
    char path[FRAMES_PATH];
    GpImage image = { .data = NULL };
    GpFile file = { .data = NULL };
    frames_file(frames, frame, path);
    GpResult result = picture_samples(path, surface, part, &image, error);
    if (!result)
        result = gp_image_encode(path, &image, pool, &file, error);
    if (!result)
        gp_bytes_append(bytes, file.data, file.size);
    gp_file_free(&file);
    gp_image_free(&image);
    return result;
}

static GpResult add_part(const Frames *frames, uint32_t item, const GpSurface *surface,
                         GpPool *pool, GpBytes *bytes, GpError *error)
{
    const GpRect part = part_rect(frames, item);
    if (surface->width != frames->whole[0] || surface->height != frames->whole[1])
        return gp_fail(
            error, GP_ERROR_FORMAT,
            "%.200s: the picture is %ux%u, that of a pass with a size of its own: windows are "
            "of %ux%u",
            frames->scene, surface->width, surface->height, frames->whole[0], frames->whole[1]);
    size_t size;
    char *texels = read_texels(surface, &part, &size);
    if (!texels)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    const bool is_file = parts_of(frames) == 1 && !frames->in_strips;
    const Head head = { .result = { .format = surface->format,
                                    .width = (uint32_t)(part.x1 - part.x0),
                                    .height = (uint32_t)(part.y1 - part.y0),
                                    .hash = XXH3_64bits(texels, size) },
                        .is_file = is_file };
    gp_bytes_append(bytes, &head, sizeof head);
    if (!is_file)
        gp_bytes_append(bytes, texels, size);
    gp_free(texels);
    return is_file ? add_file(frames, item, surface, &part, pool, bytes, error) : GP_OK;
}

static GpResult draw(const void *context, uint32_t item, const ItemTools *tools, GpBytes *bytes,
                     size_t *same, GpError *error)
{
    (void)same;
    const Frames *frames = context;
    const GpRect part = part_rect(frames, item);
    Scene scene = { .picture = NULL };
    GpResult result = load(frames, item / parts_of(frames), &part, &scene, error);
    if (result)
        return result;
    GpError reason = { "" };
    result = gp_device_run(tools->device, &scene.list, &reason);
    if (result)
        gp_fail(error, result, "%.200s: %s", frames->scene, reason.text);
    else
        result = add_part(frames, item, scene.picture, tools->pool, bytes, error);
    scene_free(&scene);
    return result;
}

/* --- taking ----------------------------------------------------------------------------------- */

static GpResult take_file(Frames *frames, uint32_t frame, const Head *head, const char *bytes,
                          size_t size, GpError *error)
{
    char path[FRAMES_PATH];
    frames_file(frames, frame, path);
    frames->results[frame] = head->result;
    return gp_file_write(path, bytes, size, error);
}

static void describe(const Frames *frames, GpFormat format, FrameResult *result)
{
    *result = (FrameResult){ .format = format,
                             .width = (uint32_t)(frames->window.x1 - frames->window.x0),
                             .height = (uint32_t)(frames->window.y1 - frames->window.y0) };
}

static GpResult take_strip(Frames *frames, uint32_t item, const Head *head, const char *texels,
                           GpError *error)
{
    const uint32_t parts = parts_of(frames), frame = item / parts;
    FrameResult *result = &frames->results[frame];
    GpResult failure = GP_OK;
    if (item % parts == 0) {
        describe(frames, head->result.format, result);
        frames_file(frames, frame, frames->strips_path);
        failure = strips_begin(frames->strips_path, head->result.format, result->width,
                               result->height, &frames->strips, error);
    }
    if (!failure)
        failure =
            strips_add(frames->strips, texels, head->result.width, head->result.height, error);
    if (!failure && item % parts == parts - 1)
        failure = strips_end(&frames->strips, true, &result->hash, error);
    return failure;
}

/* Puts a part into its frame's picture, which is made for the first that comes. */
static GpResult put_part(Frames *frames, uint32_t item, const Head *head, const char *texels,
                         GpError *error)
{
    const uint32_t frame = item / parts_of(frames);
    const GpRect part = part_rect(frames, item);
    const size_t bytes = gp_format_info(head->result.format)->bytes;
    const size_t row = head->result.width * bytes;
    GpSurface **picture = &frames->pictures[frame];
    if (!*picture) {
        describe(frames, head->result.format, &frames->results[frame]);
        const GpSurfaceDesc desc = { .format = head->result.format,
                                     .width = frames->results[frame].width,
                                     .height = frames->results[frame].height };
        const GpResult result = gp_surface_create(&desc, picture, error);
        if (result)
            return result;
        frames->missing[frame] = parts_of(frames);
    }
    for (uint32_t y = 0; y < head->result.height; y++)
        memcpy(gp_surface_texel(&(*picture)->level[0], bytes,
                                (uint32_t)(part.x0 - frames->window.x0),
                                (uint32_t)(part.y0 - frames->window.y0) + y),
               texels + y * row, row);
    frames->missing[frame]--;
    return GP_OK;
}

static GpResult take_part(Frames *frames, uint32_t item, const Head *head, const char *texels,
                          GpError *error)
{
    const uint32_t frame = item / parts_of(frames);
    char path[FRAMES_PATH];
    GpResult result = put_part(frames, item, head, texels, error);
    if (result || frames->missing[frame] > 0)
        return result;
    frames_file(frames, frame, path);
    frames->results[frame].hash = gp_surface_hash(frames->pictures[frame]);
    result = picture_write_surface(path, frames->pictures[frame], false, NULL, error);
    gp_surface_destroy(&frames->pictures[frame]);
    return result;
}

static GpResult take(void *context, uint32_t item, const void *bytes, size_t size, GpError *error)
{
    Frames *frames = context;
    const GpRect part = part_rect(frames, item);
    Head head = { .is_file = 2 };
    if (size >= sizeof head)
        memcpy(&head, bytes, sizeof head);
    const bool fits = head.is_file < 2 && head.result.format < GP_FORMATS &&
                      head.result.width == (uint32_t)(part.x1 - part.x0) &&
                      head.result.height == (uint32_t)(part.y1 - part.y0);
    if (!fits)
        return gp_fail(error, GP_ERROR_FORMAT, "a part of the picture came damaged");
    const char *rest = (const char *)bytes + sizeof head;
    size -= sizeof head;
    if (head.is_file)
        return take_file(frames, item, &head, rest, size, error);
    if (size !=
        (size_t)head.result.width * head.result.height * gp_format_info(head.result.format)->bytes)
        return gp_fail(error, GP_ERROR_FORMAT, "a part of the picture came damaged");
    return frames->in_strips ? take_strip(frames, item, &head, rest, error)
                             : take_part(frames, item, &head, rest, error);
}

ItemWork frames_work(Frames *frames)
{
    return (ItemWork){ .count = frames->count * parts_of(frames),
                       .in_order = frames->in_strips,
                       .context = frames,
                       .tell = tell,
                       .draw = draw,
                       .take = take };
}

void frames_free(Frames *frames)
{
    GpError unused;
    uint64_t hash;
    strips_end(&frames->strips, false, &hash, &unused);
    for (uint32_t i = 0; frames->pictures && i < frames->count; i++)
        gp_surface_destroy(&frames->pictures[i]);
    gp_free(frames->pictures);
    gp_free(frames->missing);
    gp_free(frames->results);
    path_close(&frames->path);
    *frames = (Frames){ .count = 0 };
}
