#include "apps/commands/render/sequence.h"

#include "apps/base/json.h"
#include "apps/base/text.h"
#include "apps/commands/output.h"
#include "apps/commands/progress.h"
#include "apps/commands/render/frames.h"
#include "pipeline/io/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <xxhash.h>

enum { MOST_NUMBER = 10000000 }; /* of a frame */

bool render_is_sequence(const Render *render)
{
    const uint32_t *size = render->options.size;
    const bool one = render->dump || render->list_passes || render->options.json;
    return render->window || render->path || render->turn || size[0] > GP_MAX_SIZE ||
           size[1] > GP_MAX_SIZE || (items_are_shared() && !one);
}

/* --- what is asked for ------------------------------------------------------------------------ */

/* "A:B" or "A:B:STEP". */
static int read_frames(const char *text, Frames *frames)
{
    const char *at = text;
    uint32_t first, last, step = 1;
    bool good = text_take_whole(&at, MOST_NUMBER, &first) && text_take_word(&at, ":") &&
                text_take_whole(&at, MOST_NUMBER, &last);
    if (good && text_take_word(&at, ":"))
        good = text_take_whole(&at, MOST_NUMBER, &step);
    if (!good || *at || last < first || step < 1)
        return report(EXIT_USAGE,
                      "--frames: expected A:B or A:B:STEP, A not above B, both at most %d, not "
                      "'%s'",
                      MOST_NUMBER, text);
    frames->first = first;
    frames->step = step;
    frames->count = (last - first) / step + 1;
    return EXIT_DONE;
}

/* Two numbers with a character between. */
static bool take_pair(const char **at, const char *between, uint32_t pair[2])
{
    return text_take_whole(at, INT32_MAX, &pair[0]) && text_take_word(at, between) &&
           text_take_whole(at, INT32_MAX, &pair[1]);
}

/* "X,Y,WxH", and " of WxH" behind it. */
static int read_window(const char *text, Frames *frames)
{
    const char *at = text;
    uint32_t place[2], size[2], whole[2] = { frames->whole[0], frames->whole[1] };
    bool good = take_pair(&at, ",", place) && text_take_word(&at, ",") && take_pair(&at, "x", size);
    if (good && text_take_word(&at, " of "))
        good = take_pair(&at, "x", whole);
    if (!good || *at)
        return report(EXIT_USAGE, "--window: expected X,Y,WxH or \"X,Y,WxH of WxH\", not '%s'",
                      text);
    if (whole[0] < 1 || whole[0] > GP_MAX_WHOLE || whole[1] < 1 || whole[1] > GP_MAX_WHOLE)
        return report(EXIT_USAGE, "--window: a whole of %ux%u, at most %dx%d", whole[0], whole[1],
                      GP_MAX_WHOLE, GP_MAX_WHOLE);
    for (int i = 0; i < 2; i++)
        good = good && size[i] > 0 && place[i] < whole[i] && size[i] <= whole[i] - place[i];
    if (!good)
        return report(EXIT_USAGE, "--window: %u,%u,%ux%u is not inside %ux%u", place[0], place[1],
                      size[0], size[1], whole[0], whole[1]);
    memcpy(frames->whole, whole, sizeof whole);
    frames->window = (GpRect){ (int32_t)place[0], (int32_t)place[1], (int32_t)(place[0] + size[0]),
                               (int32_t)(place[1] + size[1]) };
    return EXIT_DONE;
}

/* Those up to the last key. */
static int count_frames(const Render *render, Frames *frames)
{
    const ScenePath *path = &frames->path;
    const double time = path->times[path->count - 1], last = time * path->rate + 1e-9;
    if (!(last >= 0))
        return report(EXIT_INPUT,
                      "%s: keys[%zu].time: %g, the last, is before frame 0: expected a key at 0 or "
                      "later",
                      render->path, path->count - 1, time);
    if (!(last < MOST_NUMBER + 1.0))
        return report(EXIT_INPUT,
                      "%s: keys[%zu].time: %g at %g frames a second is more than frame %d",
                      render->path, path->count - 1, time, path->rate, MOST_NUMBER);
    frames->count = (uint32_t)last + 1;
    return EXIT_DONE;
}

/* Those of the whole path, or of the whole turn, where none are named. */
static int choose_frames(const Render *render, Frames *frames)
{
    frames->count = frames->step = 1;
    if (render->frames)
        return read_frames(render->frames, frames);
    if (render->turn)
        frames->count = render->turn;
    else if (frames->path.count)
        return count_frames(render, frames);
    return EXIT_DONE;
}

static int prepare(const Render *render, const char *output, Frames *frames)
{
    GpError error = { "" };
    *frames = (Frames){ .scene = render->scene, .output = output, .turn = render->turn };
    const SceneOutline outline = scene_outline(render->scene);
    const bool given = render->options.size[0] > 0;
    frames->whole[0] = given ? render->options.size[0] : outline.width;
    frames->whole[1] = given ? render->options.size[1] : outline.height;
    int code = render->window ? read_window(render->window, frames) : EXIT_DONE;
    if (!code && render->path)
        code = exit_of_input(path_open(render->path, &frames->path, &error));
    if (code)
        return error.text[0] ? report(code, "%s", error.text) : code;
    if (!render->window)
        frames->window = (GpRect){ 0, 0, (int32_t)frames->whole[0], (int32_t)frames->whole[1] };
    frames->moves = render->path || render->turn;
    code = choose_frames(render, frames);
    if (!code && frames->moves && !strchr(output, '#'))
        code =
            report(EXIT_USAGE, "-o %s: expected # in the name, where a frame's digits go", output);
    return code;
}

/* --- results ---------------------------------------------------------------------------------- */

static json_t *json_of(const FrameResult *result, const char *file)
{
    char hash[17];
    snprintf(hash, sizeof hash, "%016llx", (unsigned long long)result->hash);
    return json_pack("{s:s, s:i, s:i, s:s, s:o}", "format", gp_format_info(result->format)->name,
                     "width", (int)result->width, "height", (int)result->height, "hash", hash,
                     "file", json_text(file));
}

static int tell_json(const Frames *frames)
{
    char file[FRAMES_PATH];
    json_t *all = json_array();
    for (uint32_t i = 0; i < frames->count; i++) {
        frames_file(frames, i, file);
        json_t *one = json_of(&frames->results[i], file);
        if (!one || !frames->moves) {
            json_decref(all);
            return output_json(one);
        }
        json_object_set_new(one, "frame", json_integer((json_int_t)frames_number(frames, i)));
        json_array_append_new(all, one);
    }
    return output_json(json_pack("{s:o}", "frames", all));
}

static int tell(const Render *render, const Frames *frames)
{
    if (render->options.json)
        return tell_json(frames);
    for (uint32_t i = 0; i < frames->count; i++) {
        const FrameResult *result = &frames->results[i];
        if (frames->moves)
            printf("frame %u: ", frames_number(frames, i));
        printf("hash %s %ux%u %016llx\n", gp_format_info(result->format)->name, result->width,
               result->height, (unsigned long long)result->hash);
    }
    return EXIT_DONE;
}

/* --- the run ---------------------------------------------------------------------------------- */

/* Of all that the pictures follow from, but for what the scene names. */
static uint64_t key_of(const Render *render, const Frames *frames)
{
    const char *const files[] = { render->scene, render->path };
    XXH3_state_t state;
    XXH3_64bits_reset(&state);
    for (size_t i = 0; i < GP_COUNT(files); i++) {
        char found[4096];
        GpFile file = { .data = NULL };
        GpError unused;
        if (files[i] && !gp_data_find(files[i], found, sizeof found, &unused) &&
            !gp_file_read(found, &file, &unused))
            XXH3_64bits_update(&state, file.data, file.size);
        gp_file_free(&file);
    }
    char text[512];
    const int length =
        snprintf(text, sizeof text, "%s %u:%u:%u %u %ux%u %d,%d,%d,%d %u %u %.300s", GP_VERSION,
                 frames->first, frames->count, frames->step, frames->turn, frames->whole[0],
                 frames->whole[1], frames->window.x0, frames->window.y0, frames->window.x1,
                 frames->window.y1, frames->part[0], frames->part[1], frames->output);
    XXH3_64bits_update(&state, text, (size_t)length < sizeof text ? (size_t)length : sizeof text);
    return XXH3_64bits_digest(&state);
}

static int run(const Render *render, Frames *frames)
{
    const Progress progress = progress_begin(&render->options);
    char journal[FRAMES_PATH];
    GpError error = { "" };
    ItemRun items = options_items(&render->options);
    snprintf(journal, sizeof journal, "%s.journal", frames->output);
    items.journal = journal;
    items.progress = progress_tell;
    items.user = &progress;
    const GpResult split = frames_split(frames, items_at_once(&items), &error);
    if (split)
        return report(split == GP_ERROR_MEMORY ? EXIT_INTERNAL : EXIT_USAGE, "%s", error.text);
    items.key = key_of(render, frames);
    const ItemWork work = frames_work(frames);
    const int code = (int)items_run(&work, &items, &error);
    if (code)
        return report(code, "%s", error.text);
    notice(&render->options, "wrote %s", frames->output);
    return tell(render, frames);
}

int render_sequence(const Render *render, const char *output)
{
    Frames frames;
    int code = prepare(render, output, &frames);
    if (!code)
        code = run(render, &frames);
    frames_free(&frames);
    return code;
}
