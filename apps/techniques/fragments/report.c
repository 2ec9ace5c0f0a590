#include "apps/techniques/fragments/report.h"

#include <inttypes.h>
#include <math.h>

/* --- against the truth ------------------------------------------------------------------------ */

/* How far above the truth a pixel is: red, green, blue. Returns whether that is wrong. */
static bool pixel_off(const FragmentTruth *truth, const GpSurface *picture, size_t at,
                      double off[3])
{
    const size_t bytes = gp_format_info(picture->format)->bytes;
    const uint32_t x = (uint32_t)(at % truth->width), y = (uint32_t)(at / truth->width);
    float rgba[4];
    bool is_wrong = false;
    gp_texel_load(picture->format, gp_surface_texel(&picture->level[0], bytes, x, y), rgba);
    for (int k = 0; k < 3; k++) {
        off[k] = (double)rgba[k] - truth->rgba[4 * at + (size_t)k];
        is_wrong = is_wrong || !(fabs(off[k]) <= 1 / 255.0);
    }
    return is_wrong;
}

FragmentError fragment_error(const FragmentModel *model, const GpSurface *picture)
{
    const FragmentTruth *truth = &model->truth;
    FragmentError error = { .wrong = 0 };
    double off[3];
    for (size_t at = 0; at < (size_t)truth->width * truth->height; at++) {
        const bool is_wrong = pixel_off(truth, picture, at, off);
        error.wrong += is_wrong;
        error.wrong_beyond_edges += is_wrong && !truth->is_edge[at];
        error.wrong_at_crossings += is_wrong && !truth->is_edge[at] && truth->is_crossing[at];
    }
    return error;
}

void fragment_difference(const FragmentModel *model, const GpSurface *picture, float *off)
{
    const double least = 1.0 / 3, whole = 0.1; /* of the colour; of white, from which it is full */
    const FragmentTruth *truth = &model->truth;
    for (size_t at = 0; at < (size_t)truth->width * truth->height; at++) {
        double each[3], most = 0;
        const bool is_wrong = pixel_off(truth, picture, at, each);
        for (int k = 0; k < 3; k++)
            most = fabs(each[k]) > fabs(most) ? each[k] : most;
        const double share = least + (1 - least) * fmin(fabs(most) / whole, 1);
        off[at] = is_wrong ? (float)copysign(share, most) : 0;
    }
}

/* --- work ------------------------------------------------------------------------------------- */

enum {
    MOST_SURFACES = 1024,
    /* Of a fragment that the machine sorts: its key and its number in the pixel's list, and what
     * was shaded, four floats and which draw it is of (pipeline/fast/lanes/shade/fragments.h). */
    BYTES_THAT_WAIT = 4 + 4 + 16 + 4
};

typedef struct Surfaces {
    const GpSurface *seen[MOST_SURFACES];
    uint32_t count;
    uint64_t bytes;
} Surfaces;

static void add_surface(Surfaces *surfaces, const GpSurface *surface)
{
    if (!surface)
        return;
    for (uint32_t i = 0; i < surfaces->count; i++)
        if (surfaces->seen[i] == surface)
            return;
    if (surfaces->count < MOST_SURFACES)
        surfaces->seen[surfaces->count++] = surface;
    surfaces->bytes += (uint64_t)surface->level[0].pitch * surface->height;
}

FragmentWork fragment_work(const FragmentModel *model, const Frame *frame)
{
    const GpList *list = &frame->list;
    FragmentWork work = { .passes = list->pass_count };
    Surfaces surfaces = { .seen = { frame->color }, .count = 1 };
    for (uint32_t p = 0; p < list->pass_count; p++) {
        const GpPass *pass = &list->passes[p];
        for (int t = 0; t < GP_MAX_TARGETS; t++)
            add_surface(&surfaces, pass->color[t].surface);
        add_surface(&surfaces, pass->depth.surface);
        for (uint32_t i = 0; i < pass->draw_count; i++) {
            for (int t = 0; t < GP_MAX_SAMPLERS; t++)
                add_surface(&surfaces, pass->draws[i].textures[t].surface);
            const uint32_t *indices = pass->draws[i].geometry.indices;
            work.readings += indices && (indices == model->mesh.drawn->indices ||
                                         indices == model->mesh.backwards->indices);
        }
    }
    if (((const FragmentOptions *)frame->made)->method == FRAGMENTS_CONVEX)
        work.readings = 1; /* in parts; slabs by four passes of what hardware does in one */
    work.bytes = surfaces.bytes;
    if (((const FragmentOptions *)frame->made)->method == FRAGMENTS_SORTED)
        work.bytes += model->count.fragments * BYTES_THAT_WAIT;
    return work;
}

/* --- words ------------------------------------------------------------------------------------ */

static void tell(json_t *members, const char *name, uint64_t value)
{
    if (members)
        json_object_set_new(members, name, json_integer((json_int_t)value));
}

void fragment_tell_work(const FragmentModel *model, const Frame *frame, json_t *members)
{
    const FragmentOptions *options = frame->made;
    const FragmentWork work = fragment_work(model, frame);
    const ConvexFacts *facts = model->facts;
    tell(members, "triangles", model->mesh.triangle_count);
    tell(members, "fragments", model->count.fragments);
    tell(members, "passes", work.passes);
    tell(members, "readings", work.readings);
    tell(members, "bytes", work.bytes);
    if (options->method != FRAGMENTS_CONVEX)
        return;
    tell(members, "pieces", facts->pieces);
    tell(members, "levels", facts->levels);
    tell(members, "split_sides", facts->split_sides);
    tell(members, "knots", facts->knots);
    tell(members, "knot_faces", facts->knot_faces);
}

void fragment_tell_error(const FragmentModel *model, const GpSurface *picture, json_t *members)
{
    const FragmentError off = fragment_error(model, picture);
    tell(members, "wrong", off.wrong);
    tell(members, "wrong_beyond_edges", off.wrong_beyond_edges);
    tell(members, "wrong_at_crossings", off.wrong_at_crossings);
    tell(members, "layers", model->truth.layers);
}

/* Of convex pieces: how they came to be drawn, and what kept them apart. */
static void say_pieces(const FragmentModel *model, bool by_grid, TechniqueReport *report)
{
    const ConvexFacts *facts = model->facts;
    char faults[200];
    pieces_faults(model->convex.pieces, faults, sizeof faults);
    text_add(&report->lines, "%u convex pieces in %u levels", facts->pieces, facts->levels);
    if (facts->knots > 0)
        text_add(&report->lines, "; %u faces in %u %s", facts->knot_faces, facts->knots,
                 by_grid ? "slabs of 4 layers" : "knots, sorted by the machine");
    if (by_grid && facts->split_sides > 0)
        text_add(&report->lines, "; %u circles cut", facts->split_sides);
    text_add(&report->lines, "\n");
    if (faults[0])
        text_add(&report->lines, "no piece goes on over %s\n", faults);
    if (model->cache_fault.text[0])
        text_add(&report->warnings, "%s\n", model->cache_fault.text);
}

GpResult fragment_report(void *made, const void *setting, const Frame *frame, GpDevice *device,
                         TechniqueReport *report, GpError *error)
{
    FragmentModel *model = made;
    const FragmentOptions *options = setting;
    fragment_tell_work(model, frame, report->members);
    if (options->method == FRAGMENTS_CONVEX)
        say_pieces(model, options->order == CONVEX_ORDER_GRID, report);
    if (!options->measures)
        return GP_OK;
    const GpResult result = fragment_model_truth(model, gp_device_threads(device), error);
    if (result)
        return result;
    const FragmentError off = fragment_error(model, frame->color);
    text_add(&report->lines, "%" PRIu64 " pixels wrong, %" PRIu64 " of them beyond edges",
             off.wrong, off.wrong_beyond_edges);
    if (off.wrong_at_crossings > 0)
        text_add(&report->lines, ", %" PRIu64 " of these where triangles cross",
                 off.wrong_at_crossings);
    text_add(&report->lines, "; %u layers\n", model->truth.layers);
    fragment_tell_error(model, frame->color, report->members);
    return GP_OK;
}
