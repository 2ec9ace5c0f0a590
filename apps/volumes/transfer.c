#include "apps/volumes/transfer.h"

#include "apps/base/stable_math.h"
#include "pipeline/io/input.h"

#include <string.h>

/* --- built in --------------------------------------------------------------------------------- */

const char *const transfer_names[] = { "bonsai",       "engine", "marschner-lobb",
                                       "checkerboard", "fog",    NULL };

/* In the order of the names. */
static const Transfer builtins[] = {
    { 6,
      { { 0, { 0, 0, 0, 0 } },
        { 25, { .2, .6, .2, 0 } },
        { 45, { .2, .7, .2, .03 } },
        { 70, { .5, .4, .2, .05 } },
        { 120, { .9, .7, .4, .08 } },
        { 255, { 1, 1, .9, .3 } } } },
    { 6,
      { { 0, { 0, 0, 0, 0 } },
        { 60, { .5, .5, .6, 0 } },
        { 110, { .6, .6, .7, .02 } },
        { 150, { .8, .6, .3, .02 } },
        { 200, { 1, .5, .1, .12 } },
        { 255, { 1, .9, .5, .3 } } } },
    { 6,
      { { 0, { 0, 0, 0, 0 } },
        { 100, { .1, .3, 1, 0 } },
        { 128, { .2, .8, .9, .03 } },
        { 160, { 1, .8, .2, .06 } },
        { 200, { 1, .2, .1, 0 } },
        { 255, { 1, .2, .1, 0 } } } },
    { 2, { { 85, { .1, .1, .12, .99 } }, { 170, { .95, .95, .9, .99 } } } },
    { 2, { { 0, { 1, 1, 1, 0 } }, { 255, { 1, 1, 1, .05 } } } },
};

/* --- files ------------------------------------------------------------------------------------ */

/* The next word of a line as a number of a range. */
static double read_number(GpInput *input, const char *what, double least, double most)
{
    char shown[44];
    GpWord word;
    float value = 0;
    if (!gp_input_word(input, &word) || *word.text == '#')
        gp_input_fail(input, GP_ERROR_FORMAT, "the line ends, expected %s: value r g b a", what);
    else if (!gp_word_number(&word, &value))
        gp_input_fail(input, GP_ERROR_FORMAT, "expected a number for %s, not '%s'", what,
                      gp_word_show(&word, shown));
    else if ((double)value < least || (double)value > most)
        gp_input_fail(input, GP_ERROR_FORMAT, "expected %s of %g to %g, not %s", what, least, most,
                      gp_word_show(&word, shown));
    return (double)value;
}

static void read_stop(GpInput *input, bool is_bytes, Transfer *transfer)
{
    static const char *const channels[] = { "red", "green", "blue", "opacity" };
    const double anything = 3.5e38;
    GpWord word;
    char shown[44];
    if (transfer->count == TRANSFER_MAX_STOPS) {
        gp_input_fail(input, GP_ERROR_FORMAT, "expected at most %d stops", TRANSFER_MAX_STOPS);
        return;
    }
    TransferStop *stop = &transfer->stops[transfer->count++];
    stop->value = is_bytes ? read_number(input, "a value", 0, FIELD_VALUES - 1)
                           : read_number(input, "a value", -anything, anything);
    for (int c = 0; c < 4; c++)
        stop->rgba[c] = read_number(input, channels[c], 0, 1);
    if (gp_input_word(input, &word) && *word.text != '#')
        gp_input_fail(input, GP_ERROR_FORMAT, "expected value r g b a and no '%s' behind them",
                      gp_word_show(&word, shown));
    if (transfer->count > 1 && !(stop->value > stop[-1].value))
        gp_input_fail(input, GP_ERROR_FORMAT,
                      "expected values that rise, and %g is not above %g of the stop before",
                      stop->value, stop[-1].value);
}

/* From the first to the last value of the file to all of the field's. */
static void spread(Transfer *transfer)
{
    const double first = transfer->stops[0].value,
                 last = transfer->stops[transfer->count - 1].value;
    for (uint32_t i = 0; i < transfer->count; i++) {
        const double at = transfer->stops[i].value - first;
        transfer->stops[i].value = last > first ? at * (FIELD_VALUES - 1) / (last - first) : 0;
    }
}

static GpResult read_file(const char *path, const Field *field, Transfer *transfer, GpError *error)
{
    GpFile file;
    GpInput input;
    GpResult result = gp_input_open(path, &file, &input, error);
    if (result != GP_OK)
        return result;
    const bool is_bytes = field->least == 0 && field->most == FIELD_VALUES - 1;
    Transfer made = { .count = 0 };
    while (input.result == GP_OK && gp_input_line(&input))
        read_stop(&input, is_bytes, &made);
    gp_file_free(&file);
    if (input.result != GP_OK)
        return input.result;
    if (made.count == 0)
        return gp_fail(error, GP_ERROR_FORMAT, "%s: no stops, expected lines of value r g b a",
                       path);
    if (!is_bytes)
        spread(&made);
    *transfer = made;
    return GP_OK;
}

GpResult transfer_open(const char *name, const Field *field, Transfer *transfer, GpError *error)
{
    for (size_t i = 0; transfer_names[i]; i++) {
        if (strcmp(name, transfer_names[i]) == 0) {
            *transfer = builtins[i];
            return GP_OK;
        }
    }
    char path[4096];
    const GpResult result = gp_data_find(name, path, sizeof path, error);
    return result ? result : read_file(path, field, transfer, error);
}

/* --- values ----------------------------------------------------------------------------------- */

double transfer_extinction(double opacity)
{
    const double most = 1 - 0x1p-24;
    return -stable_log(1 - (opacity < most ? opacity : most));
}

void transfer_at(const Transfer *transfer, double value, double rgba[4])
{
    const TransferStop *stop = transfer->stops;
    const TransferStop *last = stop + transfer->count - 1;
    while (stop < last && stop[1].value <= value)
        stop++;
    const bool is_between = stop < last && value > stop->value;
    const double t = is_between ? (value - stop->value) / (stop[1].value - stop->value) : 0;
    for (int c = 0; c < 4; c++)
        rgba[c] =
            is_between ? stop->rgba[c] + t * (stop[1].rgba[c] - stop->rgba[c]) : stop->rgba[c];
}

void transfer_table(const Transfer *transfer, float table[FIELD_VALUES][4])
{
    for (int i = 0; i < FIELD_VALUES; i++) {
        double rgba[4];
        transfer_at(transfer, i, rgba);
        for (int c = 0; c < 4; c++)
            table[i][c] = (float)rgba[c];
    }
}
