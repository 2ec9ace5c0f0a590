/* glasspipe compare: two pictures, bit by bit and by figures. */
#include "apps/commands/command.h"
#include "apps/commands/commands.h"
#include "apps/commands/output.h"
#include "apps/frame/compare.h"
#include "apps/base/json.h"

#include <inttypes.h>
#include <stdio.h>

typedef struct Compare {
    Options options; /* first: see options.h */
    const char *paths[2];
    const char *output;
    double scale; /* of the difference picture */
    CompareLimits limits;
} Compare;

static const SettingField options[] = {
    { "output", "FILE",
      "Write the absolute difference of the pictures to FILE (.png, .exr, .pfm or .ppm)",
      SETTING_TEXT, .offset = offsetof(Compare, output), .letter = 'o' },
    { "scale", "S", "Multiply the difference picture by S", SETTING_NUMBER,
      .offset = offsetof(Compare, scale), .high = OPTIONS_ANY },
    { "fail", "F", "Call a pixel failing if it differs by more than F (default: 0)", SETTING_NUMBER,
      .offset = offsetof(Compare, limits.fail), .high = OPTIONS_ANY },
    { "failpercent", "P", "Allow P percent of failing pixels (default: 0)", SETTING_NUMBER,
      .offset = offsetof(Compare, limits.fail_percent), .high = OPTIONS_ANY },
    { "hardfail", "H", "Fail if any pixel differs by more than H", SETTING_NUMBER,
      .offset = offsetof(Compare, limits.hard_fail), .high = OPTIONS_ANY },
    { "warn", "F", "Warn about pixels that differ by more than F", SETTING_NUMBER,
      .offset = offsetof(Compare, limits.warn), .high = OPTIONS_ANY },
    { "warnpercent", "P", "Allow P percent of them (default: 0)", SETTING_NUMBER,
      .offset = offsetof(Compare, limits.warn_percent), .high = OPTIONS_ANY },
    { "hardwarn", "H", "Warn if any pixel differs by more than H", SETTING_NUMBER,
      .offset = offsetof(Compare, limits.hard_warn), .high = OPTIONS_ANY },
    { .name = NULL },
};

static const CommandSyntax syntax = {
    .shared = OPTIONS_COMMON,
    .options = options,
    .arguments = "A B",
    .help =
        "Examples:\n"
        "  glasspipe compare before.png after.png\n"
        "  glasspipe compare before.exr after.exr -o diff.png --scale 10\n"
        "  glasspipe compare a.png b.png --fail 0.004 --failpercent 0.1 --hardfail 0.1\n"
        "\n"
        "Compares two pictures: the same bits, or how far apart and where. Differences are of "
        "values in [0, 1] (codes divided by their largest) or of floats; a pixel's is its largest "
        "channel's.\v"
        "PSNR is over all channels for a peak of 1. SSIM is the mean over 11x11 Gaussian windows "
        "(sigma 1.5) of the luminance for a range of 1. Tolerances are named as idiff names them.\n"
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

static void print_report(const CompareReport *r, const Picture pictures[2])
{
    if (r->same) {
        printf("same bits, %ux%u\n", pictures[0].width, pictures[0].height);
        return;
    }
    printf("differing  %" PRIu64 " of %" PRIu64 " pixels (%.4g %%)\n", r->differing, r->pixels,
           100.0 * (double)r->differing / (double)r->pixels);
    printf("failing    %" PRIu64 "\n", r->failing);
    printf("max        %.6g\n", r->max);
    printf("mean       %.6g\n", r->mean);
    printf("rmse       %.6g\n", r->rmse);
    printf("psnr       %.4f dB\n", r->psnr);
    printf("ssim       %.6f\n", r->ssim);
    printf("worst      tile of 64x64 at (%u, %u), %" PRIu64 " pixels differ\n", r->tile_x,
           r->tile_y, r->tile_differing);
    printf("first      (%u, %u): ", r->first_x, r->first_y);
    print_values(&pictures[0], r->first_x, r->first_y);
    fputs(" and ", stdout);
    print_values(&pictures[1], r->first_x, r->first_y);
    putchar('\n');
}

static void print_json(const CompareReport *r, const Picture *picture)
{
    json_t *object = json_pack(
        "{s:b, s:b, s:b, s:I, s:I, s:I, s:I, s:I, s:o, s:o, s:o, s:o, s:o}", "same", r->same,
        "failed", r->failed, "warned", r->warned, "width", (json_int_t)picture->width, "height",
        (json_int_t)picture->height, "pixels", (json_int_t)r->pixels, "differing",
        (json_int_t)r->differing, "failing", (json_int_t)r->failing, "max", json_number(r->max),
        "mean", json_number(r->mean), "rmse", json_number(r->rmse), "psnr", json_number(r->psnr),
        "ssim", json_number(r->ssim));
    if (!r->same) {
        json_object_set_new(object, "first",
                            json_pack("[I, I]", (json_int_t)r->first_x, (json_int_t)r->first_y));
        json_object_set_new(object, "worst_tile",
                            json_pack("{s:I, s:I, s:I}", "x", (json_int_t)r->tile_x, "y",
                                      (json_int_t)r->tile_y, "differing",
                                      (json_int_t)r->tile_differing));
    }
    output_json(object);
}

/* --- comparing -------------------------------------------------------------------------------- */

static int write_difference(const Compare *compare, const Picture pictures[2])
{
    Picture difference = pictures[0];
    size_t count = (size_t)difference.width * difference.height * (size_t)difference.channels;
    difference.values = gp_alloc(count, sizeof(float));
    if (!difference.values)
        return report(EXIT_INTERNAL, "out of memory");
    compare_difference(&pictures[0], &pictures[1], compare->scale, difference.values);
    GpError error = { "" };
    int code = EXIT_DONE;
    if (picture_write(compare->output, &difference, &error))
        code = report(EXIT_INTERNAL, "%s", error.text);
    else
        notice(&compare->options, "wrote %s", compare->output);
    gp_free(difference.values);
    return code;
}

static int different_sizes(const Compare *compare, const Picture pictures[2])
{
    const Picture *a = &pictures[0], *b = &pictures[1];
    if (compare->options.json)
        output_json(json_pack("{s:b, s:b, s:[[II][II]]}", "same", 0, "failed", 1, "sizes",
                              (json_int_t)a->width, (json_int_t)a->height, (json_int_t)b->width,
                              (json_int_t)b->height));
    else
        printf("different sizes: %ux%u and %ux%u\n", a->width, a->height, b->width, b->height);
    return EXIT_DIFFERS;
}

/* Channels that hold both pictures: colour where either has it, alpha where either has it. */
static int common_channels(int a, int b)
{
    bool color = a > 2 || b > 2, alpha = a % 2 == 0 || b % 2 == 0;
    return (color ? 3 : 1) + alpha;
}

static int compare_pair(const Compare *compare, Picture pictures[2])
{
    GpError error = { "" };
    Picture *a = &pictures[0], *b = &pictures[1];
    if (a->width != b->width || a->height != b->height)
        return different_sizes(compare, pictures);
    int channels = common_channels(a->channels, b->channels);
    if (picture_widen(a, channels, &error) || picture_widen(b, channels, &error))
        return report(EXIT_INTERNAL, "%s", error.text);

    CompareReport result;
    compare_pictures(a, b, &compare->limits, &result);
    if (compare->options.json)
        print_json(&result, a);
    else
        print_report(&result, pictures);
    if (result.warned)
        notice(&compare->options, "warning: the pictures differ by more than the warning limits");
    int code = compare->output ? write_difference(compare, pictures) : EXIT_DONE;
    return code ? code : result.failed ? EXIT_DIFFERS : EXIT_DONE;
}

int cmd_compare(int argc, char **argv)
{
    Compare compare = { .scale = 1 };
    command_parse(&syntax, NULL, argc, argv, &compare);
    GpError error = { "" };
    if (compare.output && picture_check_path(compare.output, &error))
        return report(EXIT_USAGE, "-o %s", error.text);

    Picture pictures[2] = { { .width = 0 }, { .width = 0 } };
    int code = EXIT_DONE;
    for (int i = 0; i < 2 && !code; i++) {
        GpResult result = picture_read(compare.paths[i], &pictures[i], &error);
        if (result)
            code = report(exit_of_input(result), "%s", error.text);
    }
    if (!code)
        code = compare_pair(&compare, pictures);
    picture_free(&pictures[0]);
    picture_free(&pictures[1]);
    return code;
}
