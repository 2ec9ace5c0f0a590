#include "apps/points/compress.h"

#include "apps/base/bounds.h"
#include "apps/base/stable_math.h"
#include "apps/base/vector.h"
#include "apps/points/clusters.h"
#include "apps/points/normal_codes.h"

#include <float.h>
#include <string.h>

/* Largest codes. */
enum { ACROSS = 2047, THICK = 1023, SEVEN = 127, FOUR = 15 };

#define LOG_2 0.69314718055994530942

typedef struct Job {
    const Patches *patches;
    Compressed *made;
    AngleBorders borders; /* printed form */
} Job;

static uint32_t round_code(double value, uint32_t most)
{
    return !(value > 0) ? 0 : value >= most ? most : (uint32_t)(value + 0.5);
}

/* The code of low + code * step. */
static uint32_t code_of(double value, double low, double step, uint32_t most)
{
    return step > 0 ? round_code((value - low) / step, most) : 0;
}

/* Surfels of a patch, of all levels. */
static PatchWindow all_of(const Patches *patches, const Patch *patch)
{
    const PatchLevel *levels = patch_levels(patches, patch);
    const PatchLevel *last = &levels[patch->level_count - 1];
    return (PatchWindow){ levels->first, last->first + last->count - levels->first };
}

/* Radii and shares of a patch, from least to most in `most_code` steps each. */
static void span_values(const Surfel *surfels, uint32_t count, uint32_t share_codes,
                        CompressedFrame *frame)
{
    float radius[2] = { FLT_MAX, 0 };
    uint8_t share[2] = { 255, 0 };
    for (uint32_t i = 0; i < count; i++) {
        radius[0] = surfels[i].radius < radius[0] ? surfels[i].radius : radius[0];
        radius[1] = surfels[i].radius > radius[1] ? surfels[i].radius : radius[1];
        share[0] = surfels[i].share < share[0] ? surfels[i].share : share[0];
        share[1] = surfels[i].share > share[1] ? surfels[i].share : share[1];
    }
    const double low = stable_log((double)radius[0]) / LOG_2;
    const double high = stable_log((double)radius[1]) / LOG_2;
    frame->radius[0] = (float)low;
    frame->radius[1] = (float)((high - low) / SEVEN);
    frame->share[0] = (float)(share[0] / 255.0);
    frame->share[1] = (float)((share[1] - share[0]) / 255.0 / share_codes);
}

/* --- ours ------------------------------------------------------------------------------------- */

static void frame_ours(const PatchBox *box, CompressedFrame *frame)
{
    double origin[3];
    vector_widen(box->centre, origin);
    for (int i = 0; i < 3; i++) {
        const double half = (double)box->half[i];
        double axis[3];
        vector_widen(box->axes[i], axis);
        vector_add_scaled(origin, -half, axis, origin);
        for (int k = 0; k < 3; k++)
            frame->steps[i][k] = (float)(2 * half / (i < 2 ? ACROSS : THICK) * axis[k]);
    }
    for (int k = 0; k < 3; k++)
        frame->origin[k] = (float)origin[k];
}

static void words_ours(const PatchBox *box, const CompressedFrame *frame, const Surfel *surfel,
                       uint8_t bytes[8])
{
    double centre[3], from[3], normal[3];
    uint32_t place[3], direction[2];
    vector_widen(box->centre, centre);
    vector_widen(surfel->position, from);
    vector_widen(surfel->normal, normal);
    vector_subtract(from, centre, from);
    for (int i = 0; i < 3; i++) {
        const uint32_t most = i < 2 ? ACROSS : THICK;
        const double half = (double)box->half[i];
        double axis[3];
        vector_widen(box->axes[i], axis);
        place[i] = code_of(vector_dot(axis, from), -half, 2 * half / most, most);
    }
    normal_encode(normal, direction);
    const double log_radius = stable_log((double)surfel->radius) / LOG_2;
    const uint32_t radius =
        code_of(log_radius, (double)frame->radius[0], (double)frame->radius[1], SEVEN);
    const uint32_t share =
        code_of(surfel->share / 255.0, (double)frame->share[0], (double)frame->share[1], SEVEN);
    const uint32_t words[4] = { place[0] | (place[2] >> 5) << 11, place[1] | (place[2] & 31) << 11,
                                direction[0] | share << 9, direction[1] | radius << 9 };
    for (int i = 0; i < 8; i++) /* little-endian, as the machine's streams */
        bytes[i] = (uint8_t)(words[i / 2] >> i % 2 * 8);
}

static Surfel read_ours(const CompressedFrame *frame, const uint8_t bytes[8])
{
    uint32_t words[4];
    Surfel surfel = { .color = { 255, 255, 255 } };
    for (int i = 0; i < 4; i++)
        words[i] = bytes[2 * i] | (uint32_t)bytes[2 * i + 1] << 8;
    const uint32_t place[3] = { words[0] & 2047, words[1] & 2047,
                                words[0] >> 11 << 5 | words[1] >> 11 };
    double normal[3];
    normal_decode((uint32_t[]){ words[2] & 511, words[3] & 511 }, normal);
    for (int k = 0; k < 3; k++) {
        double at = (double)frame->origin[k];
        for (int i = 0; i < 3; i++)
            at += place[i] * (double)frame->steps[i][k];
        surfel.position[k] = (float)at;
        surfel.normal[k] = (float)normal[k];
    }
    surfel.radius = (float)stable_exp(
        LOG_2 * ((double)frame->radius[0] + (words[3] >> 9) * (double)frame->radius[1]));
    surfel.share = (uint8_t)round_code(
        255 * ((double)frame->share[0] + (words[2] >> 9) * (double)frame->share[1]), 255);
    return surfel;
}

/* --- printed ---------------------------------------------------------------------------------- */

static const uint32_t printed_cells[3] = { 2048, 2048, 1024 };

static void frame_printed(const Surfel *surfels, uint32_t count, CompressedFrame *frame)
{
    Bounds box = bounds_of_nothing;
    for (uint32_t i = 0; i < count; i++) {
        double at[3];
        vector_widen(surfels[i].position, at);
        bounds_add(&box, at);
    }
    for (int i = 0; i < 3; i++) {
        const double step = (box.high[i] - box.low[i]) / printed_cells[i];
        frame->steps[i][i] = (float)step;
        frame->origin[i] = (float)(box.low[i] + 0.5 * step);
    }
}

int tangent_form(const float normal[3])
{
    const float x = normal[0] < 0 ? -normal[0] : normal[0],
                y = normal[1] < 0 ? -normal[1] : normal[1];
    const float z = normal[2] < 0 ? -normal[2] : normal[2];
    return x <= y && x <= z ? 0 : y <= z ? 1 : 2;
}

static void words_printed(const Job *job, const CompressedFrame *frame, const Surfel *surfel,
                          uint8_t bytes[8])
{
    uint32_t cell[3];
    double normal[3], decoded[3];
    float rounded[3];
    for (int i = 0; i < 3; i++)
        cell[i] = code_of((double)surfel->position[i], (double)frame->origin[i],
                          (double)frame->steps[i][i], printed_cells[i] - 1);
    bytes[0] = (uint8_t)(cell[0] >> 3);
    bytes[1] = (uint8_t)(cell[1] >> 3);
    bytes[2] = (uint8_t)(cell[2] >> 2);
    bytes[3] = (uint8_t)((cell[0] & 7) | (cell[1] & 7) << 3 | (cell[2] & 3) << 6);
    vector_widen(surfel->normal, normal);
    angles_encode(&job->borders, normal, bytes + 4);
    angles_decode(bytes + 4, decoded);
    for (int i = 0; i < 3; i++)
        rounded[i] = (float)decoded[i];
    const uint32_t share =
        code_of(surfel->share / 255.0, (double)frame->share[0], (double)frame->share[1], FOUR);
    bytes[6] = (uint8_t)(tangent_form(rounded) | (int)(share << 4));
    bytes[7] = clusters_nearest(job->made->radii, surfel->radius);
}

static Surfel read_printed(const Compressed *compressed, const CompressedFrame *frame,
                           const uint8_t bytes[8])
{
    Surfel surfel = { .color = { 255, 255, 255 }, .radius = compressed->radii[bytes[7]] };
    const uint32_t cell[3] = { bytes[0] * 8u + (bytes[3] & 7), bytes[1] * 8u + (bytes[3] >> 3 & 7),
                               bytes[2] * 4u + (bytes[3] >> 6) };
    double normal[3];
    angles_decode(bytes + 4, normal);
    for (int i = 0; i < 3; i++) {
        surfel.position[i] =
            (float)((double)frame->origin[i] + cell[i] * (double)frame->steps[i][i]);
        surfel.normal[i] = (float)normal[i];
    }
    surfel.share = (uint8_t)round_code(
        255 * ((double)frame->share[0] + (bytes[6] >> 4) * (double)frame->share[1]), 255);
    return surfel;
}

/* --- all -------------------------------------------------------------------------------------- */

static void compress_patch(void *context, uint32_t item, int worker)
{
    const Job *job = context;
    const Patches *patches = job->patches;
    const Patch *patch = &patches->patches[item];
    const PatchWindow window = all_of(patches, patch);
    const Surfel *surfels = patches->surfels + window.first;
    const bool is_printed = job->made->form == COMPRESS_PRINTED;
    CompressedFrame frame = { .origin = { 0 } };
    (void)worker;
    span_values(surfels, window.count, is_printed ? FOUR : SEVEN, &frame);
    if (is_printed)
        frame_printed(surfels, window.count, &frame);
    else
        frame_ours(&patch->box, &frame);
    for (uint32_t i = 0; i < window.count; i++) {
        const size_t at = (size_t)window.first + i;
        uint8_t *bytes = job->made->words + at * COMPRESSED_BYTES;
        if (is_printed)
            words_printed(job, &frame, &surfels[i], bytes);
        else
            words_ours(&patch->box, &frame, &surfels[i], bytes);
        if (job->made->colors)
            memcpy(job->made->colors + 3 * at, surfels[i].color, 3);
    }
    job->made->frames[item] = frame;
}

GpResult patches_compress(const Patches *patches, CompressForm form, GpPool *pool,
                          Compressed *compressed)
{
    const uint32_t count = patches->surfel_count;
    Compressed made = { .form = form,
                        .surfel_count = count,
                        .words = gp_alloc_unset((size_t)count * COMPRESSED_BYTES),
                        .frames = gp_alloc(patches->patch_count, sizeof *made.frames) };
    if (patches->has_colors)
        made.colors = gp_alloc_unset((size_t)count * 3);
    if (!made.words || !made.frames || (patches->has_colors && !made.colors)) {
        compressed_free(&made);
        return GP_ERROR_MEMORY;
    }
    Job job = { .patches = patches, .made = &made };
    if (form == COMPRESS_PRINTED) {
        angle_borders(&job.borders);
        clusters_find(patches->surfels, count, made.radii);
    }
    gp_pool_run(pool, patches->patch_count, compress_patch, &job);
    *compressed = made;
    return GP_OK;
}

void compressed_free(Compressed *compressed)
{
    gp_free(compressed->words);
    gp_free(compressed->colors);
    gp_free(compressed->frames);
    *compressed = (Compressed){ .words = NULL };
}

Surfel compressed_surfel(const Compressed *compressed, uint32_t patch, uint32_t number)
{
    const uint8_t *bytes = compressed->words + (size_t)number * COMPRESSED_BYTES;
    const CompressedFrame *frame = &compressed->frames[patch];
    Surfel surfel = compressed->form == COMPRESS_PRINTED ? read_printed(compressed, frame, bytes)
                                                         : read_ours(frame, bytes);
    if (compressed->colors)
        memcpy(surfel.color, compressed->colors + (size_t)number * 3, 3);
    return surfel;
}

size_t compressed_bytes(const Patches *patches, const Compressed *compressed)
{
    return patches_bytes(patches) + sizeof *compressed +
           (size_t)compressed->surfel_count *
               (compressed->colors ? COMPRESSED_BYTES + 3u : COMPRESSED_BYTES) +
           patches->patch_count * sizeof *compressed->frames;
}
