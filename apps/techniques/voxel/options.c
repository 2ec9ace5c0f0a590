#include "apps/techniques/voxel/options.h"

#include "apps/commands/technique_command.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    KEY_XFORM = TECHNIQUE_FIRST_KEY,
    KEY_REPORT,
    KEY_POINTS,
    KEY_TWIST,
    KEY_WITH,
    KEY_COMBINE,
    KEY_FIT,
    KEY_MOVE,
    KEY_SCAN,
    KEY_LOOK,
    KEY_SHADING,
    KEY_PICTURE,
    KEY_FROM,
    KEY_UP,
    KEY_ZOOM,
};

/* clang-format off */
const struct argp_option voxel_options[] = {
    { "xform", KEY_XFORM, "S TX TY TZ", 0, "Where the model lies in the volume: voxels = S * position "
      "+ T (default: its box, in the middle)", 0 },
    { "report", KEY_REPORT, NULL, 0, "Print what the mesh is: whether it is closed, and what is wrong "
      "with it; of solids, where axes disagree", 0 },
    { "points", KEY_POINTS, NULL, 0, "Take a mesh's vertices alone, as points", 0 },
    { "twist", KEY_TWIST, "DEGREES", 0, "Twist the mesh, from its floor to its top by so much", 0 },
    { "with", KEY_WITH, "MESH", 0, "A second model, in one volume with the first", 0 },
    { "combine", KEY_COMBINE, "HOW", 0, "What two models make: union (default), intersection, "
      "difference; collide: the voxels that both have, and where they are", 0 },
    { "fit", KEY_FIT, "F", 0, "Give the second model F times the first's longest side, and its "
      "middle; without a second: the model in its volume, or scan", 0 },
    { "move", KEY_MOVE, "X Y Z", 0, "Then move it, by longest sides of the first", 0 },
    { "scan", KEY_SCAN, "FILE", 0, "Show the model inside a scanned volume: .nrrd, or .raw, .raw.gz "
      "with a .json beside it", 0 },
    { "look", KEY_LOOK, "HOW", 0, "Of pictures: opaque (default) or transparent", 0 },
    { "shading", KEY_SHADING, "HOW", 0, "Of opaque voxels: smooth (default) or cubes", 0 },
    { "picture", KEY_PICTURE, "WxH", 0, "Size of a picture (default: 512x512)", 0 },
    { "from", KEY_FROM, "AZIMUTH ELEVATION", 0, "Where a picture is seen from, in degrees (default: "
      "30 20; 0 0 is in front)", 0 },
    { "up", KEY_UP, "AXIS", 0, "Which axis points up in a picture: y (default), z, x, -y or -z", 0 },
    { "zoom", KEY_ZOOM, "F", 0, "Larger by so much than what fills a picture", 0 },
    { NULL, 0, NULL, 0, NULL, 0 },
};
/* clang-format on */

/* --- arguments -------------------------------------------------------------------------------- */

static const double most_place = 1e30; /* so that it is a float too */

/* The option's argument is the first number; the others follow it. */
static void parse_numbers(struct argp_state *state, const char *name, const char *first, int count,
                          double *numbers)
{
    static const char *const words[] = { "no", "one", "two", "three", "four" };
    for (int i = 0; i < count; i++) {
        const char *text = i == 0                      ? first
                           : state->next < state->argc ? state->argv[state->next++]
                                                       : "";
        char *end;
        numbers[i] = strtod(text, &end);
        if (end == text || *end || !(fabs(numbers[i]) <= most_place))
            argp_error(state, "%s: expected %s number%s up to 1e30, not '%.100s'", name,
                       words[count], count > 1 ? "s" : "", text);
    }
}

static double parse_number(struct argp_state *state, const char *name, const char *text,
                           double least, double most)
{
    double number;
    parse_numbers(state, name, text, 1, &number);
    if (number < least || number > most)
        argp_error(state, "%s: expected a number from %g to %g, not '%.100s'", name, least, most,
                   text);
    return number;
}

/* names: NULL at the end, and printed as `expected` */
static int parse_name(struct argp_state *state, const char *option, const char *const *names,
                      const char *expected, const char *text)
{
    for (int i = 0; names[i]; i++)
        if (strcmp(text, names[i]) == 0)
            return i;
    argp_error(state, "%s: expected %s, not '%.100s'", option, expected, text);
    return 0;
}

/* --- one option ------------------------------------------------------------------------------- */

static void parse_box(struct argp_state *state, const char *text, VoxelOptions *options)
{
    parse_numbers(state, "--xform", text, 4, options->box);
    if (options->box[0] <= 0)
        argp_error(state, "--xform: expected four numbers, the first above 0, not '%.100s'", text);
    options->is_placed = true;
}

static void parse_from(struct argp_state *state, const char *text, VoxelPicture *picture)
{
    double angles[2];
    parse_numbers(state, "--from", text, 2, angles);
    if (fabs(angles[0]) > 360 || fabs(angles[1]) > 89)
        argp_error(state, "--from: expected -360 to 360 and -89 to 89 degrees, not %g %g",
                   angles[0], angles[1]);
    picture->orbit.azimuth = angles[0];
    picture->orbit.elevation = angles[1];
}

/* Of pictures; false: another key. */
static bool parse_picture(int key, const char *text, struct argp_state *state,
                          VoxelPicture *picture)
{
    static const char *const looks[] = { "opaque", "transparent", NULL };
    static const char *const shadings[] = { "smooth", "cubes", NULL };
    static const char *const ups[] = { "y", "z", "x", "-y", "-z", NULL };
    switch (key) {
    case KEY_LOOK:
        picture->look = parse_name(state, "--look", looks, "opaque or transparent", text);
        return true;
    case KEY_SHADING:
        picture->shading = parse_name(state, "--shading", shadings, "smooth or cubes", text);
        return true;
    case KEY_PICTURE:
        options_size(state, "--picture", text, &picture->width, &picture->height);
        return true;
    case KEY_FROM:
        parse_from(state, text, picture);
        return true;
    case KEY_UP:
        picture->orbit.up = parse_name(state, "--up", ups, "y, z, x, -y or -z", text);
        return true;
    case KEY_ZOOM:
        picture->orbit.zoom = parse_number(state, "--zoom", text, 0.1, 10);
        return true;
    default:
        return false;
    }
}

/* Of a second model, and of where it lies; false: another key. */
static bool parse_second(int key, const char *text, struct argp_state *state, VoxelOptions *options)
{
    static const char *const ways[] = { "union", "intersection", "difference", "collide", NULL };
    switch (key) {
    case KEY_WITH:
        options->with = text;
        return true;
    case KEY_COMBINE:
        options->combine = parse_name(state, "--combine", ways,
                                      "union, intersection, difference or collide", text);
        options->has_combine = true;
        return true;
    case KEY_FIT:
        options->place.fit = parse_number(state, "--fit", text, 0.001, 1000);
        return true;
    case KEY_MOVE:
        parse_numbers(state, "--move", text, 3, options->place.move);
        options->has_move = true;
        return true;
    default:
        return false;
    }
}

error_t voxel_options_parse(int key, char *text, struct argp_state *state, void *own)
{
    VoxelOptions *options = own;
    if (parse_second(key, text, state, options))
        return 0;
    if (parse_picture(key, text, state, &options->picture)) {
        options->has_picture = true;
        return 0;
    }
    switch (key) {
    case KEY_XFORM:
        parse_box(state, text, options);
        return 0;
    case KEY_REPORT:
        options->wants_report = true;
        return 0;
    case KEY_POINTS:
        options->wants_points = true;
        return 0;
    case KEY_TWIST:
        options->twist = parse_number(state, "--twist", text, -VOXEL_MOST_TWIST, VOXEL_MOST_TWIST);
        return 0;
    case KEY_SCAN:
        options->scan = text;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

GpResult voxel_options_check(const VoxelOptions *options, bool to_picture, GpError *error)
{
    const bool alone = !options->with, fits = options->place.fit > 0;
    const bool moves = options->has_move, scanned = options->scan != NULL;
    const struct {
        bool is_wrong;
        const char *reason;
    } rules[] = {
        { scanned && !to_picture, "--scan is for pictures: -o FILE.png" },
        { options->has_picture && !to_picture,
          "--look, --shading, --picture, --from, --up and --zoom are for pictures: -o FILE.png" },
        { alone && options->has_combine, "--combine needs a second model: --with" },
        { !alone && scanned, "--scan is around one model, without --with" },
        { alone && options->is_placed && (fits || moves),
          "--xform places the model, so that --fit and --move cannot" },
        { alone && moves && !scanned && !fits,
          "--move moves a second model (--with), or one of another size (--fit)" },
    };
    for (size_t i = 0; i < GP_COUNT(rules); i++)
        if (rules[i].is_wrong)
            return gp_fail(error, GP_ERROR_INVALID, "%s", rules[i].reason);
    return GP_OK;
}
