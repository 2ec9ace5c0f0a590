#include "apps/compare/comparison.h"

#include <inttypes.h>
#include <string.h>

const ComparisonSettings comparison_defaults = {
    .limits = { .fail = -1,
                .fail_percent = -1,
                .hard_fail = -1,
                .warn = -1,
                .warn_percent = -1,
                .hard_warn = -1 },
    .flip_fail = -1,
};

/* --- alpha ------------------------------------------------------------------------------------ */

static bool has_alpha(const GpImage *image)
{
    return image->channels % 2 == 0;
}

static ComparedAlpha alpha_of(const GpImage *a, const GpImage *b, bool no_alpha)
{
    if (!has_alpha(a) || !has_alpha(b))
        return has_alpha(a) ? ALPHA_FIRST : has_alpha(b) ? ALPHA_SECOND : ALPHA_NONE;
    return no_alpha ? ALPHA_LEFT_OUT : ALPHA_COMPARED;
}

const char *comparison_alpha_name(ComparedAlpha alpha)
{
    static const char *const names[ALPHAS] = { "none", "compared", "left out", "only first",
                                               "only second" };
    return names[alpha];
}

const char *comparison_alpha(const Comparison *comparison)
{
    static const char *const words[ALPHAS] = {
        [ALPHA_NONE] = "",
        [ALPHA_COMPARED] = "",
        [ALPHA_LEFT_OUT] = "alpha was left out",
        [ALPHA_FIRST] = "only the first has alpha, which was not compared",
        [ALPHA_SECOND] = "only the second has alpha, which was not compared",
    };
    return words[comparison->alpha];
}

/* --- samples and floats ----------------------------------------------------------------------- */

/* Of pictures of one size. */
static bool has_same_samples(const GpImage *a, const GpImage *b)
{
    const size_t bytes = (size_t)a->width * a->height * a->channels * gp_image_sample_size(a->type);
    return a->type == b->type && a->channels == b->channels && memcmp(a->data, b->data, bytes) == 0;
}

typedef struct Loading {
    const GpImage *images;
    Picture *pictures;
    int channels; /* of both; 0: each its own */
    GpResult result[2];
} Loading;

static void load_one(void *context, uint32_t item, int worker)
{
    (void)worker;
    Loading *loading = context;
    Picture *picture = &loading->pictures[item];
    loading->result[item] = picture_of_image(&loading->images[item], picture, NULL);
    if (!loading->result[item] && loading->channels)
        loading->result[item] = picture_set_channels(picture, loading->channels, NULL);
}

static GpResult load_pictures(const GpImage images[2], int channels, GpPool *pool,
                              Picture pictures[2], GpError *error)
{
    Loading loading = { .images = images, .pictures = pictures, .channels = channels };
    gp_pool_run(pool, 2, load_one, &loading);
    return loading.result[0] || loading.result[1] ? gp_fail(error, GP_ERROR_MEMORY, "out of memory")
                                                  : GP_OK;
}

/* --- comparing -------------------------------------------------------------------------------- */

static GpResult see_flip(const Picture pictures[2], GpPool *pool, Comparison *made, GpError *error)
{
    made->flip_map =
        gp_alloc((size_t)pictures[0].width * pictures[0].height, sizeof *made->flip_map);
    return made->flip_map ? flip_compare(&pictures[0], &pictures[1], made->pixels_per_degree, pool,
                                         made->flip_map, &made->flip, error)
                          : gp_fail(error, GP_ERROR_MEMORY, "out of memory");
}

static bool only_flip_judges(const ComparisonSettings *settings)
{
    const CompareLimits *limits = &settings->limits;
    return settings->flip_fail >= 0 && limits->fail < 0 && limits->fail_percent < 0 &&
           limits->hard_fail < 0;
}

static bool flip_fails(const Comparison *comparison, const ComparisonSettings *settings)
{
    return settings->flip_fail >= 0 && comparison->flip.mean > settings->flip_fail;
}

static int channels_to_compare(const GpImage images[2], ComparedAlpha alpha)
{
    const bool color = images[0].channels > 2 || images[1].channels > 2;
    return (color ? 3 : 1) + (alpha == ALPHA_COMPARED);
}

/* Pictures of one size and number of channels. */
static GpResult compare_floats(const Picture pictures[2], const ComparisonSettings *settings,
                               GpPool *pool, Comparison *made, GpError *error)
{
    compare_pictures(&pictures[0], &pictures[1], &settings->limits, &made->report);
    if (!made->report.same && see_flip(pictures, pool, made, error))
        return GP_ERROR_MEMORY;
    made->failed =
        (made->report.failed && !only_flip_judges(settings)) || flip_fails(made, settings);
    made->warned = made->report.warned;
    return GP_OK;
}

GpResult comparison_make(const GpImage images[2], bool views, const ComparisonSettings *settings,
                         GpPool *pool, Picture pictures[2], Comparison *comparison, GpError *error)
{
    const double ppd = settings->pixels_per_degree;
    Comparison made = { .pixels_per_degree = ppd > 0 ? ppd : FLIP_PIXELS_PER_DEGREE };
    int channels = 0;
    for (int i = 0; i < 2; i++) {
        pictures[i] = (Picture){ .values = NULL };
        made.sizes[i][0] = images[i].width;
        made.sizes[i][1] = images[i].height;
    }
    made.failed = made.other_sizes =
        made.sizes[0][0] != made.sizes[1][0] || made.sizes[0][1] != made.sizes[1][1];
    if (!made.other_sizes) {
        made.alpha = alpha_of(&images[0], &images[1], settings->no_alpha);
        channels = channels_to_compare(images, made.alpha);
    }
    const bool same = !made.other_sizes && has_same_samples(&images[0], &images[1]);
    GpResult result = GP_OK;
    if (views || !same)
        result = load_pictures(images, channels, pool, pictures, error);
    if (same)
        made.report = compare_same(images[0].width, images[0].height);
    else if (!result && !made.other_sizes)
        result = compare_floats(pictures, settings, pool, &made, error);
    if (result) {
        comparison_free(&made);
        for (int i = 0; i < 2; i++)
            picture_free(&pictures[i]);
    }
    *comparison = made;
    return result;
}

void comparison_free(Comparison *comparison)
{
    gp_free(comparison->flip_map);
    *comparison = (Comparison){ .flip_map = NULL };
}

/* --- words ------------------------------------------------------------------------------------ */

static void say_count(const CompareReport *report, uint64_t count, Text *text)
{
    text_add(text, "%" PRIu64 " of %" PRIu64 " pixels (%.3g %%) differ", count, report->pixels,
             100.0 * (double)count / (double)report->pixels);
}

/* A limit that was crossed: FLIP's where no other was, then that of any pixel, then that of how
 * many. */
static void say_failure(const Comparison *comparison, const ComparisonSettings *settings,
                        Text *text)
{
    const CompareReport *report = &comparison->report;
    const CompareLimits *limits = &settings->limits;
    text_add(text, "different: ");
    if (!report->failed || only_flip_judges(settings)) {
        text_add(text, "the mean FLIP is %.6f, more than %g", comparison->flip.mean,
                 settings->flip_fail);
    } else if (limits->hard_fail >= 0 && report->max > limits->hard_fail) {
        text_add(text, "a pixel differs by %.6g, more than the %g that any may", report->max,
                 limits->hard_fail);
    } else {
        say_count(report, limits->fail > 0 ? report->failing : report->differing, text);
        if (limits->fail > 0)
            text_add(text, " by more than %g", limits->fail);
        if (limits->fail_percent > 0)
            text_add(text, "; %g %% may", limits->fail_percent);
    }
}

void comparison_say(const Comparison *comparison, const ComparisonSettings *settings, Text *text)
{
    const CompareReport *report = &comparison->report;
    if (comparison->other_sizes) {
        text_add(text, "different sizes: %ux%u and %ux%u", comparison->sizes[0][0],
                 comparison->sizes[0][1], comparison->sizes[1][0], comparison->sizes[1][1]);
    } else if (comparison->failed) {
        say_failure(comparison, settings, text);
    } else if (!report->same) {
        text_add(text, "within the limits: ");
        say_count(report, report->differing, text);
        text_add(text, ", the farthest by %.6g", report->max);
    } else {
        text_add(text, "same bits in all %ux%u pixels", comparison->sizes[0][0],
                 comparison->sizes[0][1]);
    }
}
