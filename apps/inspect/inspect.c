#include "apps/inspect/inspect.h"

#include "apps/base/json.h"
#include "apps/base/page.h"
#include "apps/inspect/frame_tell.h"
#include "apps/inspect/lesson_answer.h"
#include "apps/inspect/record.h"
#include "apps/inspect/sources.h"

#include <stdlib.h>
#include <string.h>

enum {
    MOST_DRAWS = 512, /* told, of a pass */
    MOST_BYTES =
        9400000 /* of targets, fragments and histories; all else in a page is half a megabyte */
};

/* --- data ------------------------------------------------------------------------------------- */

/* The fast executor draws the frame over: its bits must be those that were recorded, and its clock
 * is looked at. */
static GpResult run_fast(Record *record, json_t **timings, GpError *error)
{
    const Inspect *inspect = record->inspect;
    GpDevice *device = NULL;
    GpResult result = gp_device_create(&(GpDeviceDesc){ .threads = inspect->threads,
                                                        .isa = inspect->isa,
                                                        .timed = !inspect->no_timings },
                                       &device, error);
    for (int run = 0; run < (inspect->no_timings ? 1 : 2) && !result; run++) {
        targets_restore(&record->targets);
        result = gp_device_run(device, inspect->list, error);
    }
    if (!result) {
        const GpSurface *other = targets_differ(&record->targets);
        if (other)
            result =
                gp_fail(error, GP_ERROR_UNSUPPORTED,
                        "the fast executor draws other bits than the reference: %s", other->name);
    }
    if (!result && !inspect->no_timings) {
        const GpPhases *phases = gp_device_phases(device);
        *timings = json_pack(
            "{s:i, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "threads", gp_device_threads(device),
            "isa", gp_device_isa(device), "prepare", json_milliseconds(phases->prepare), "vertices",
            json_milliseconds(phases->vertices), "bins", json_milliseconds(phases->bins), "tiles",
            json_milliseconds(phases->tiles), "raster", json_milliseconds(phases->raster),
            "shading", json_milliseconds(phases->shading), "transfer",
            json_milliseconds(phases->transfer));
    }
    gp_device_destroy(&device);
    return result;
}

static json_t *tell_passes(Record *record, Blobs *blobs)
{
    const GpList *list = record->inspect->list;
    json_t *passes = json_array();
    uint32_t *group = gp_alloc(list->pass_count, sizeof *group);
    if (group)
        gp_list_groups(list, group);
    for (uint32_t p = 0; p < list->pass_count; p++) {
        RecordPass *pass = &record->passes[p];
        json_t *told = frame_tell_pass(list, p, group ? group[p] : 0, MOST_DRAWS, &record->targets);
        json_object_set(told, "stops", pass->stops);
        json_object_set_new(told, "fragments", json_integer(pass->fragments_blob));
        json_object_set_new(told, "lod", json_integer(pass->lod_blob));
        json_object_set_new(told, "fragments_left_out", json_integer(pass->fragments.left_out));
        json_object_set(told, "histories", pass->told);
        blobs->failed = blobs->failed || pass->fragments.failed || pass->histories.failed;
        json_array_append_new(passes, told);
    }
    gp_free(group);
    return passes;
}

static json_t *tell_truth(const Inspect *inspect, Blobs *blobs)
{
    const InspectTruth *truth = &inspect->truth;
    if (!truth->off || !inspect->picture)
        return json_null();
    const size_t pixels = (size_t)inspect->picture->width * inspect->picture->height;
    return json_pack("{s:i, s:o, s:o, s:o}", "off",
                     blobs_add(blobs, truth->off, pixels * sizeof *truth->off), "over",
                     json_text(truth->over), "under", json_text(truth->under), "how",
                     json_text(truth->how));
}

/* How many pixels of two pictures differ; null where they are of different sizes or formats. */
static json_t *count_differing(const GpSurface *one, const GpSurface *other)
{
    if (!one || !other || one->width != other->width || one->height != other->height ||
        one->format != other->format)
        return json_null();
    const size_t bytes = gp_format_info(one->format)->bytes;
    json_int_t count = 0;
    for (uint32_t y = 0; y < one->height; y++)
        for (uint32_t x = 0; x < one->width; x++)
            count += memcmp(gp_surface_texel(&one->level[0], bytes, x, y),
                            gp_surface_texel(&other->level[0], bytes, x, y), bytes) != 0;
    return json_integer(count);
}

static json_t *tell_frame(Record *record, Blobs *blobs)
{
    const Inspect *inspect = record->inspect;
    json_t *verdicts = json_array();
    for (int i = 0; i < FRAGMENT_VERDICTS; i++)
        json_array_append_new(verdicts, json_string(fragment_verdict_names[i]));
    const GpSurface *picture = inspect->picture;
    json_t *frame = json_pack(
        "{s:i, s:o, s:o, s:i, s:i, s:i, s:o, s:i, s:[iiii], s:i}", "form", 1, "title",
        json_text(inspect->title), "about", json_text(inspect->about), "picture",
        picture ? targets_number(&record->targets, picture) : -1, "width",
        picture ? (int)picture->width : 0, "height", picture ? (int)picture->height : 0, "verdicts",
        verdicts, "grid", (int)record->step, "region", inspect->region.x0, inspect->region.y0,
        inspect->region.x1, inspect->region.y1, "dense", (int)inspect->draw);
    json_object_set_new(frame, "share", json_real(record->share));
    json_object_set_new(frame, "technique", json_text(inspect->technique));
    json_object_set_new(frame, "differing", count_differing(picture, inspect->beside));
    json_object_set_new(frame, "truth", tell_truth(inspect, blobs));
    json_object_set_new(frame, "passes", tell_passes(record, blobs));
    json_object_set_new(frame, "surfaces", targets_tell(&record->targets, inspect->list, blobs));
    json_object_set_new(frame, "sources",
                        json_integer(blobs_add_json(blobs, sources_tell(inspect->list))));
    json_object_set_new(frame, "programs", sources_of_programs(inspect->list));
    return frame;
}

/* --- the page --------------------------------------------------------------------------------- */

static bool is_page_file(const PageFile *file, const char *extension)
{
    const size_t length = strlen(file->path), end = strlen(extension);
    return strncmp(file->path, "apps/inspect/page/", 18) == 0 &&
           strcmp(file->path + length - end, extension) == 0;
}

static void add_files(Text *page, const char *extension)
{
    for (const PageFile *file = page_files; file->path; file++)
        if (is_page_file(file, extension))
            text_add(page, "%s", file->begin);
}

/* Modules know each other by their names, "page/main.js": an import map gives each its text. */
static void add_modules(Text *page)
{
    const char *before = "";
    text_add(page, "<script type=\"importmap\">{\"imports\":{");
    for (const PageFile *file = page_files; file->path; file++)
        if (is_page_file(file, ".js")) {
            text_add(page, "%s\n\"%s\":\"data:text/javascript;base64,", before,
                     file->path + strlen("apps/inspect/"));
            page_add_base64(page, (const unsigned char *)file->begin, page_file_size(file));
            text_add(page, "\"");
            before = ",";
        }
    text_add(page, "\n}}</script>\n");
}

static void add_page(Text *page, const Inspect *inspect, const char *blobs, const int frame[2],
                     int lesson, const json_t *timings)
{
    const char *title = inspect->lesson ? inspect->lesson->title : inspect->title;
    text_add(page, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                   "<meta name=\"viewport\" content=\"width=device-width\">\n");
    text_add_escaped(page, "<title>%s - glasspipe inspect</title>\n<style>\n", title);
    add_files(page, ".css");
    text_add(page, "</style>\n");
    add_modules(page);
    text_add(page, "</head>\n");
    add_files(page, ".html");
    text_add(page, "%s", blobs);
    if (timings) {
        char *text = json_dumps(timings, JSON_COMPACT);
        text_add(page,
                 "<!-- Times of one machine and one moment; --no-timings leaves them out. -->\n"
                 "<script type=\"application/json\" id=\"timings\">%s</script>\n",
                 text ? text : "null");
        page->failed = page->failed || !text;
        free(text);
    }
    text_add(page,
             "<script type=\"module\">import { start } from \"page/main.js\"; start(%d, %d, "
             "%d);</script>\n</body>\n</html>\n",
             frame[0], frame[1], lesson);
}

/* out: lesson: its blob; stays as it is without */
static GpResult add_lesson(const Record *record, Blobs *blobs, int *lesson, GpError *error)
{
    json_t *told = NULL;
    if (!record->inspect->lesson)
        return GP_OK;
    const GpResult result = lesson_tell(record->inspect->lesson, record, blobs, &told, error);
    if (!result)
        *lesson = blobs_add_json(blobs, told);
    return result;
}

static void tell_fragments(Record *record, Blobs *blobs)
{
    for (uint32_t p = 0; p < record->pass_count; p++) {
        RecordPass *pass = &record->passes[p];
        pass->fragments_blob = fragments_blob(&pass->fragments, blobs);
        pass->lod_blob = fragments_lod_blob(&pass->fragments, blobs);
    }
}

static void tell_histories(Record *record, Blobs *blobs)
{
    for (uint32_t p = 0; p < record->pass_count; p++) {
        json_decref(record->passes[p].told);
        record->passes[p].told = histories_tell(&record->passes[p].histories, blobs);
    }
}

/* Tells the pixels' histories, of as many as leave the blobs within so many bytes; of no fewer than
 * a few. */
static GpResult fit_histories(Record *record, Blobs *blobs, size_t most, GpError *error)
{
    enum { TURNS = 3 };
    const BlobsMark before = blobs_mark(blobs);
    GpResult result = GP_OK;
    for (int turn = 0; !result; turn++) {
        tell_histories(record, blobs);
        const size_t now = blobs_mark(blobs).length, length = before.length;
        if (turn == TURNS || now <= most || length >= most)
            break;
        blobs_cut(blobs, before);
        const double part = 0.9 * (double)(most - length) / (double)(now - length);
        result = record_fewer(record, part, error);
    }
    return result;
}

/* The data of one frame, in so many bytes if that can be. out: frame, lesson: blobs; timings: NULL
 * without */
static GpResult add_frame(const Inspect *inspect, size_t most, Blobs *blobs, int *frame,
                          int *lesson, json_t **timings, GpError *error)
{
    Record record;
    const size_t before = blobs_mark(blobs).length;
    GpResult result = record_frame(inspect, blobs, &record, error);
    if (!result) {
        tell_fragments(&record, blobs);
        result = fit_histories(&record, blobs, before + most, error);
    }
    if (!result)
        result = run_fast(&record, timings, error);
    if (!result)
        result = add_lesson(&record, blobs, lesson, error);
    errands_wait(blobs->errands); /* the stops' ranges */
    if (!result)
        *frame = blobs_add_json(blobs, tell_frame(&record, blobs));
    record_free(&record);
    return result;
}

GpResult inspect_page(const Inspect *inspect, const Inspect *against, Text *page, GpError *error)
{
    Errands *errands = inspect->threads == 1 ? NULL : errands_begin();
    Blobs blobs = { .errands = errands };
    json_t *timings = NULL, *of_other = NULL;
    int frame[2] = { BLOB_NONE, BLOB_NONE }, lesson = BLOB_NONE;
    const size_t most = against ? MOST_BYTES / 2 : MOST_BYTES;
    *page = (Text){ .data = NULL };
    Inspect other = against ? *against : (Inspect){ .title = "" };
    other.beside = inspect->picture;
    GpResult result = add_frame(inspect, most, &blobs, &frame[0], &lesson, &timings, error);
    if (!result && against)
        result = add_frame(&other, most, &blobs, &frame[1], &lesson, &of_other, error);
    const char *text = blobs_text(&blobs);
    if (!result && text)
        add_page(page, inspect, text, frame, lesson, timings);
    if (!result && (!text || page->failed))
        result = gp_fail(error, GP_ERROR_MEMORY, "no memory for the page");
    if (result)
        text_free(page);
    json_decref(timings);
    json_decref(of_other);
    blobs_free(&blobs);
    errands_end(&errands);
    return result;
}
