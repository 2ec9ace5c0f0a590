/* peer_bench: the cases of `glasspipe bench` through OpenGL ES 3 on Mesa's llvmpipe.
 *
 *   peer_bench [-l] [--driver] [--threads N] [-t SECONDS] [--images DIR] [CASE...]
 *   peer_bench --chart peers.json
 *
 * Prints one line of JSON for every case, with the fields of `glasspipe bench`; -l lists the cases,
 * --driver names the driver; --chart draws a comparison as SVG. Exit status 77: there is no EGL, or
 * it has no llvmpipe.
 */
#include "tests/peer/bench/measure.h"
#include "tests/peer/bench/peer_chart.h"

#include "apps/bench/cases.h"
#include "pipeline/io/image/image_file.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SKIPPED = 77 };

typedef struct Options {
    int threads;
    double seconds;
    const char *images; /* folder, or NULL */
} Options;

typedef struct PeerPicture {
    uint32_t width, height;
    uint8_t *rgba; /* rows from the top */
} PeerPicture;

/* --- pictures --------------------------------------------------------------------------------- */

/* A case with a picture of its own makes it from its surfaces, so these receive what was drawn. */
static GpResult take_picture(Replay *replay, const BenchCase *drawn, const Frame *frame,
                             PeerPicture *picture, GpError *error)
{
    bench_picture_size(frame, &picture->width, &picture->height);
    picture->rgba = gp_alloc((size_t)picture->width * picture->height, 4);
    if (!picture->rgba)
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for a picture");
    if (!drawn->picture)
        return replay_show(replay, frame->color, frame->depth, picture->rgba, error);
    for (uint32_t p = 0; p < frame->list.pass_count; p++)
        for (int i = 0; i < GP_MAX_TARGETS && frame->list.passes[p].color[i].surface; i++)
            replay_fetch(replay, frame->list.passes[p].color[i].surface);
    drawn->picture(frame, picture->rgba);
    return replay_check(replay, error);
}

static GpResult write_picture(const char *folder, const char *name, PeerPicture *picture,
                              GpError *error)
{
    char path[1024];
    uint8_t *rgb = picture->rgba; /* in place: the last use of the picture */
    for (size_t i = 0; i < (size_t)picture->width * picture->height; i++)
        memmove(rgb + 3 * i, picture->rgba + 4 * i, 3);
    GpImage image = { .width = picture->width,
                      .height = picture->height,
                      .channels = 3,
                      .type = GP_IMAGE_U8,
                      .data = rgb };
    snprintf(path, sizeof path, "%s/%s.png", folder, name);
    return gp_image_write(path, &image, NULL, error);
}

/* --- cases ------------------------------------------------------------------------------------ */

static void print_line(const char *renderer, int threads, const BenchCase *drawn,
                       const PeerTiming *timing, const PeerPicture *picture)
{
    const double megapixels = (double)picture->width * picture->height * 1e-6;
    printf("{\"case\":\"%s\",\"renderer\":\"%s\",\"threads\":%d,\"width\":%u,\"height\":%u",
           drawn->name, renderer, threads, picture->width, picture->height);
    printf(",\"ms\":%.3f,\"min_ms\":%.3f,\"cpu_ms\":%.3f,\"first_ms\":%.2f", timing->ms,
           timing->min_ms, timing->cpu_ms, timing->first_ms);
    printf(",\"hash\":\"%08x\",\"frames\":%u",
           bench_picture_hash(picture->rgba, picture->width, picture->height), timing->frames);
    if (timing->others >= 0)
        printf(",\"others\":%.2f", timing->others);
    if (drawn->screens > 0)
        printf(",\"mpix\":%.2f", drawn->screens * megapixels);
    if (drawn->primitives > 1000)
        printf(",\"mprim\":%.4f", drawn->primitives * 1e-6);
    if (drawn->flop > 0)
        printf(",\"gflop\":%.4f", drawn->flop * megapixels * 1e-3);
    printf("}\n");
    fflush(stdout);
}

/* Draws a case that has been built, in a context of its own. */
static GpResult draw_case(const BenchCase *drawn, const Frame *frame, const Options *options,
                          GpError *error)
{
    Gl gl;
    Replay *replay = NULL;
    PeerTiming timing = { .frames = 0 };
    PeerPicture picture = { .rgba = NULL };
    GpResult result = gl_open(0, options->threads, &gl, error);
    if (!result)
        result = replay_create(&gl, &frame->list, &replay, error);
    if (!result) {
        timing = measure(replay, options->seconds);
        result = replay_check(replay, error);
    }
    if (!result)
        result = take_picture(replay, drawn, frame, &picture, error);
    if (!result)
        print_line((const char *)gl.GetString(GL_RENDERER), options->threads, drawn, &timing,
                   &picture);
    if (!result && options->images)
        result = write_picture(options->images, drawn->name, &picture, error);
    gp_free(picture.rgba);
    replay_destroy(&replay);
    gl_close(&gl);
    return result;
}

/* Returns an exit status; a case without its data is left out with a message. */
static int run_case(const BenchCase *drawn, const Options *options)
{
    Frame frame = { .color = NULL };
    GpError error = { "" };
    int status = EXIT_SUCCESS;
    if (drawn->build(drawn, &frame, &error))
        fprintf(stderr, "peer_bench: %s: skipped: %s\n", drawn->name, error.text);
    else if (draw_case(drawn, &frame, options, &error)) {
        fprintf(stderr, "peer_bench: %s: %s\n", drawn->name, error.text);
        status = EXIT_FAILURE;
    }
    frame_free(&frame);
    return status;
}

static int print_driver(const Options *options)
{
    Gl gl;
    GpError error = { "" };
    GpResult result = gl_open(0, options->threads, &gl, &error);
    if (result)
        fprintf(stderr, "%s\n", error.text);
    else
        printf("%s\n", (const char *)gl.GetString(GL_RENDERER));
    gl_close(&gl);
    return result ? SKIPPED : EXIT_SUCCESS;
}

static int list_cases(void)
{
    for (size_t i = 0; i < bench_case_count; i++)
        puts(bench_cases[i].name);
    return EXIT_SUCCESS;
}

static int draw_chart(const char *path)
{
    Text svg = { .data = NULL };
    GpError error = { "" };
    GpResult result = peer_chart_draw(path, &svg, &error);
    if (result)
        fprintf(stderr, "peer_bench: %s\n", error.text);
    else
        fputs(svg.data, stdout);
    text_free(&svg);
    return result ? EXIT_FAILURE : EXIT_SUCCESS;
}

static int usage(void)
{
    fprintf(stderr, "usage: peer_bench [-l] [--driver] [--threads N] [-t SECONDS] [--images DIR] "
                    "[CASE...]\n"
                    "       peer_bench --chart peers.json\n");
    return 2;
}

int main(int argc, char **argv)
{
    static const struct option long_options[] = {
        { "chart", required_argument, NULL, 'c' },
        { "driver", no_argument, NULL, 'd' },
        { "images", required_argument, NULL, 'i' },
        { "list", no_argument, NULL, 'l' },
        { "threads", required_argument, NULL, 'j' },
        { "time", required_argument, NULL, 't' },
        { NULL, 0, NULL, 0 },
    };
    Options options = { .threads = 2, .seconds = 3 };
    int letter, status = EXIT_SUCCESS;
    while ((letter = getopt_long(argc, argv, "lt:", long_options, NULL)) != -1) {
        if (letter == 'l')
            return list_cases();
        if (letter == 'd')
            return print_driver(&options);
        if (letter == 'c')
            return draw_chart(optarg);
        if (letter == 'i')
            options.images = optarg;
        else if (letter == 'j')
            options.threads = atoi(optarg);
        else if (letter == 't')
            options.seconds = atof(optarg);
        else
            return usage();
    }
    for (size_t i = 0; optind == argc && i < bench_case_count && !status; i++)
        status = run_case(&bench_cases[i], &options);
    for (int i = optind; i < argc && !status; i++) {
        const BenchCase *drawn = bench_case_find(argv[i]);
        if (!drawn)
            fprintf(stderr, "peer_bench: no case '%s'; -l lists them\n", argv[i]);
        status = drawn ? run_case(drawn, &options) : 2;
    }
    return status;
}
