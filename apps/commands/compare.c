/* glasspipe compare: two pictures, bit by bit and by figures. */
#include "apps/base/json.h"
#include "apps/base/machine.h"
#include "apps/commands/command.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/compare/comparison_page.h"
#include "apps/golden/limits.h"
#include "pipeline/io/image/image_file.h"

#include <inttypes.h>
#include <stdio.h>

typedef struct Compare {
    Options options; /* first: see options.h */
    const char *paths[2];
    const char *output, *report;
    double scale; /* of the difference picture */
    ComparisonSettings settings;
} Compare;

static const SettingField options[] = {
    { "output", "FILE",
      "Write the absolute difference of the pictures to FILE (.png, .exr, .pfm or .ppm)",
      SETTING_TEXT, .offset = offsetof(Compare, output), .letter = 'o' },
    { "report", "FILE",
      "Write a page to FILE (.html): both pictures under a slider, difference, FLIP, worst tile",
      SETTING_TEXT, .offset = offsetof(Compare, report) },
    { "scale", "S", "Multiply the difference picture by S", SETTING_NUMBER,
      .offset = offsetof(Compare, scale), .high = OPTIONS_ANY },
    { .name = NULL },
};

static const CommandSyntax syntax = {
    .shared = OPTIONS_COMMON,
    .options = options,
    .arguments = "A B",
    .help =
        "Examples:\n"
        "  glasspipe render scenes/shadow.json --size 320x240 -o before.png\n"
        "  glasspipe shadow scenes/shadow.json --size 320x240 -o after.png\n"
        "  glasspipe compare before.png after.png\n"
        "  glasspipe compare before.png after.png -o diff.png --scale 10\n"
        "  glasspipe compare before.png after.png --report report.html\n"
        "  glasspipe compare before.png after.png --fail 0.004 --failpercent 0.1\n"
        "  glasspipe compare before.png after.png --flipfail 0.01 --no-alpha\n"
        "\n"
        "Compares two pictures: the same bits, or how far apart and where, with a verdict in "
        "words. "
        "Differences are of values in [0, 1] (codes divided by their largest) or of floats; a "
        "pixel's "
        "is its largest channel's. Alpha that only one picture has is not compared, which is "
        "said.\v"
        "PSNR is over all channels for a peak of 1. SSIM is the mean over 11x11 Gaussian windows "
        "(sigma 1.5) of the luminance for a range of 1. FLIP is what an eye would notice that "
        "flips "
        "between the pictures, from 0 to 1. Tolerances are named as idiff names them.\n"
        "Exit code 0: the same, or within the tolerances; 1: not.",
    .offset = offsetof(Compare, paths),
    .least = 2,
    .most = 2,
    .expected = "two pictures",
};

/* --- results ---------------------------------------------------------------------------------- */

static void print_values(const Picture *picture, uint32_t x, uint32_t y)
{
    size_t index = ((size_t)y * picture->width + x) * (size_t)picture->channels;
    for (int c = 0; c < picture->channels; c++)
        printf("%s%.9g", c ? ", " : "(", (double)picture->values[index + (size_t)c]);
    putchar(')');
}

static void print_figures(const Comparison *comparison, const Picture pictures[2])
{
    const CompareReport *r = &comparison->report;
    printf("differing  %" PRIu64 " of %" PRIu64 " pixels (%.4g %%)\n", r->differing, r->pixels,
           100.0 * (double)r->differing / (double)r->pixels);
    printf("failing    %" PRIu64 "\n", r->failing);
    printf("max        %.6g\n", r->max);
    printf("mean       %.6g\n", r->mean);
    printf("rmse       %.6g\n", r->rmse);
    printf("psnr       %.4f dB\n", r->psnr);
    printf("ssim       %.6f\n", r->ssim);
    printf("flip       %.6f, at most %.6f, at %.2f pixels per degree\n", comparison->flip.mean,
           comparison->flip.max, comparison->pixels_per_degree);
    printf("worst      tile of 64x64 at (%u, %u), %" PRIu64 " pixels differ\n", r->tile_x,
           r->tile_y, r->tile_differing);
    printf("first      (%u, %u): ", r->first_x, r->first_y);
    print_values(&pictures[0], r->first_x, r->first_y);
    fputs(" and ", stdout);
    print_values(&pictures[1], r->first_x, r->first_y);
    putchar('\n');
}

static void print_report(const Comparison *comparison, const char *verdict,
                         const Picture pictures[2])
{
    const char *alpha = comparison_alpha(comparison);
    printf("%s%s%s\n", verdict, alpha[0] ? "; " : "", alpha);
    if (!comparison->other_sizes && !comparison->report.same)
        print_figures(comparison, pictures);
}

static json_t *figures_json(const Comparison *comparison)
{
    const CompareReport *r = &comparison->report;
    json_t *object = json_pack(
        "{s:s, s:I, s:I, s:I, s:I, s:I, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "alpha",
        comparison_alpha_name(comparison->alpha), "width", (json_int_t)comparison->sizes[0][0],
        "height", (json_int_t)comparison->sizes[0][1], "pixels", (json_int_t)r->pixels, "differing",
        (json_int_t)r->differing, "failing", (json_int_t)r->failing, "max", json_number(r->max),
        "mean", json_number(r->mean), "rmse", json_number(r->rmse), "psnr", json_number(r->psnr),
        "ssim", json_number(r->ssim), "flip", json_number(comparison->flip.mean), "flip_max",
        json_number(comparison->flip.max), "pixels_per_degree",
        json_number(comparison->pixels_per_degree));
    if (!r->same) {
        json_object_set_new(object, "first",
                            json_pack("[I, I]", (json_int_t)r->first_x, (json_int_t)r->first_y));
        json_object_set_new(object, "worst_tile",
                            json_pack("{s:I, s:I, s:I}", "x", (json_int_t)r->tile_x, "y",
                                      (json_int_t)r->tile_y, "differing",
                                      (json_int_t)r->tile_differing));
    }
    return object;
}

static void print_json(const Comparison *c, const char *verdict)
{
    json_t *object = json_pack("{s:b, s:b, s:b, s:s}", "same", c->report.same, "failed", c->failed,
                               "warned", c->warned, "verdict", verdict);
    json_t *figures = c->other_sizes
                          ? json_pack("{s:[[II][II]]}", "sizes", (json_int_t)c->sizes[0][0],
                                      (json_int_t)c->sizes[0][1], (json_int_t)c->sizes[1][0],
                                      (json_int_t)c->sizes[1][1])
                          : figures_json(c);
    json_object_update(object, figures);
    json_decref(figures);
    output_json(object);
}

/* --- comparing -------------------------------------------------------------------------------- */

static int write_difference(const Compare *compare, const Picture pictures[2], GpPool *pool)
{
    Picture difference = pictures[0];
    size_t count = (size_t)difference.width * difference.height * (size_t)difference.channels;
    difference.values = gp_alloc(count, sizeof(float));
    if (!difference.values)
        return report(EXIT_INTERNAL, "out of memory");
    compare_difference(&pictures[0], &pictures[1], compare->scale, difference.values);
    GpError error = { "" };
    int code = EXIT_DONE;
    if (picture_write(compare->output, &difference, pool, &error))
        code = report(EXIT_INTERNAL, "%s", error.text);
    else
        notice(&compare->options, "wrote %s", compare->output);
    gp_free(difference.values);
    return code;
}

static int write_report(const Compare *compare, const Comparison *comparison,
                        const Picture pictures[2])
{
    Text page = { .data = NULL };
    GpError error = { "" };
    GpResult result =
        comparison_page(compare->paths, pictures, comparison, &compare->settings, &page, &error);
    if (!result)
        result = text_write(compare->report, &page, &error);
    text_free(&page);
    if (result)
        return report(EXIT_INTERNAL, "%s", error.text);
    notice(&compare->options, "wrote %s", compare->report);
    return EXIT_DONE;
}

static int print_comparison(const Compare *compare, const Comparison *comparison,
                            const Picture pictures[2])
{
    Text verdict = { .data = NULL };
    comparison_say(comparison, &compare->settings, &verdict);
    if (verdict.failed)
        return report(EXIT_INTERNAL, "out of memory");
    if (compare->options.json)
        print_json(comparison, verdict.data);
    else
        print_report(comparison, verdict.data, pictures);
    text_free(&verdict);
    if (comparison->warned)
        notice(&compare->options, "warning: the pictures differ by more than the warning limits");
    return EXIT_DONE;
}

static int compare_pair(GpPool *pool, const Compare *compare, const GpImage images[2])
{
    GpError error = { "" };
    Picture pictures[2];
    Comparison comparison;
    if (comparison_make(images, compare->output || compare->report, &compare->settings, pool,
                        pictures, &comparison, &error))
        return report(EXIT_INTERNAL, "%s", error.text);
    int code = print_comparison(compare, &comparison, pictures);
    if (!code && compare->output && comparison.other_sizes)
        notice(&compare->options, "%s: not written: pictures of other sizes have no difference",
               compare->output);
    else if (!code && compare->output)
        code = write_difference(compare, pictures, pool);
    if (!code && compare->report)
        code = write_report(compare, &comparison, pictures);
    if (!code)
        code = comparison.failed ? EXIT_DIFFERS : EXIT_DONE;
    comparison_free(&comparison);
    picture_free(&pictures[0]);
    picture_free(&pictures[1]);
    return code;
}

/* --- reading ---------------------------------------------------------------------------------- */

typedef struct Reading {
    const char *path;
    GpImage *image;
    GpResult result;
    GpError error;
} Reading;

static void read_one(void *context, uint32_t item, int worker)
{
    (void)worker;
    Reading *reading = (Reading *)context + item;
    reading->result = gp_image_read(reading->path, reading->image, &reading->error);
}

/* Both at once: that takes most of the time where they are the same. */
static int read_pair(GpPool *pool, const Compare *compare, GpImage images[2])
{
    Reading readings[2] = { { .path = compare->paths[0], .image = &images[0] },
                            { .path = compare->paths[1], .image = &images[1] } };
    gp_pool_run(pool, 2, read_one, readings);
    for (int i = 0; i < 2; i++)
        if (readings[i].result)
            return report(exit_of_input(readings[i].result), "%s", readings[i].error.text);
    return EXIT_DONE;
}

int cmd_compare(int argc, char **argv)
{
    Compare compare = { .scale = 1, .settings = comparison_defaults };
    CommandOptions limits = { .fields = comparison_fields, .object = &compare.settings };
    command_parse(&syntax, &limits, argc, argv, &compare);
    GpError error = { "" };
    if (compare.output && picture_check_path(compare.output, &error))
        return report(EXIT_USAGE, "-o %s", error.text);

    if (compare.report && (!compare.report[0] || gp_path_is_folder(compare.report)))
        return report(EXIT_USAGE, "--report %s: expected the name of a file to write",
                      compare.report);

    GpPool *pool = NULL;
    if (gp_pool_create(machine_processors(), &pool, &error))
        return report(EXIT_INTERNAL, "%s", error.text);
    GpImage images[2] = { { .data = NULL }, { .data = NULL } };
    int code = read_pair(pool, &compare, images);
    if (!code)
        code = compare_pair(pool, &compare, images);
    gp_pool_destroy(&pool);
    gp_image_free(&images[0]);
    gp_image_free(&images[1]);
    return code;
}
