/* Text with a point a line. */
#include "pipeline/io/points/points_formats.h"

enum { MOST = 9, NONE = 0 };

typedef struct Rows {
    GpInput *input;
    size_t columns;    /* of every row; 0 before the first */
    GpBytes values;    /* floats of all rows */
    size_t count;      /* rows */
    int64_t promised;  /* rows still to come in this block; -1: nobody said */
    bool has_promises; /* then every row belongs to one */
} Rows;

/* Where a row has its normal and its colour; NONE: nowhere (0 is x). */
typedef struct Layout {
    size_t normal, color;
} Layout;

static bool begin_block(Rows *rows, int64_t promised)
{
    /* "0 0 0\n" is the shortest point; the last may end without. */
    const int64_t left = rows->input->end - rows->input->next;
    if (promised < 0 || promised > GP_INPUT_COUNT_MAX || promised > (left + 1) / 6)
        return gp_input_fail(rows->input, GP_ERROR_FORMAT,
                             "%lld points are promised, but only %lld bytes follow",
                             (long long)promised, (long long)left);
    rows->promised = promised;
    rows->has_promises = true;
    return true;
}

static bool read_row(Rows *rows)
{
    GpInput *input = rows->input;
    GpWord words[MOST + 1];
    float values[MOST];
    size_t count = 0;
    while (count <= MOST && gp_input_word(input, &words[count]))
        count++;
    int64_t integer;
    const bool may_begin = rows->has_promises ? rows->promised == 0 : rows->count == 0;
    if (count == 1 && may_begin && gp_word_integer(&words[0], &integer))
        return begin_block(rows, integer);
    if (rows->has_promises && rows->promised == 0)
        return gp_input_fail(input, GP_ERROR_FORMAT,
                             "expected the end of the file after the %zu points that were promised",
                             rows->count);
    if (rows->columns == 0)
        rows->columns = count;
    if (count != rows->columns)
        return gp_input_fail(input, GP_ERROR_FORMAT, "expected %zu numbers, as before, found %zu",
                             rows->columns, count);
    for (size_t i = 0; i < count && i < MOST; i++) {
        char shown[44];
        if (!gp_word_number(&words[i], &values[i]))
            return gp_input_fail(input, GP_ERROR_FORMAT, "expected a finite number, found '%s'",
                                 gp_word_show(&words[i], shown));
    }
    if (count > MOST)
        return true; /* find_layout refuses it */
    gp_bytes_append(&rows->values, values, count * sizeof(float));
    rows->count++;
    rows->promised -= rows->has_promises;
    return true;
}

static const float *value_of(const Rows *rows, size_t row, size_t column)
{
    return (const float *)rows->values.data + row * rows->columns + column;
}

static bool is_byte(float value)
{
    return value >= 0 && value <= 255 && value == (float)(int)value;
}

/* Whether three columns can be nothing but a colour of 256 steps. */
static bool are_bytes(const Rows *rows, size_t column)
{
    bool above_one = false;
    for (size_t row = 0; row < rows->count; row++) {
        for (size_t i = 0; i < 3; i++) {
            const float value = *value_of(rows, row, column + i);
            if (!is_byte(value))
                return false;
            above_one |= value > 1;
        }
    }
    return above_one;
}

/* After the first row, whose count all others must have. */
static bool find_counts(const Rows *rows, GpPointsColumns columns)
{
    static const struct {
        const char *numbers;
        unsigned allowed; /* bit n: n numbers */
    } counts[] = {
        [GP_POINTS_XYZ] = { "3, 4, 6 or 9", 1 << 3 | 1 << 4 | 1 << 6 | 1 << 9 },
        [GP_POINTS_XYZN] = { "6 or 9", 1 << 6 | 1 << 9 },
        [GP_POINTS_XYZRGB] = { "6", 1 << 6 },
        [GP_POINTS_PTS] = { "3, 4, 6 or 7", 1 << 3 | 1 << 4 | 1 << 6 | 1 << 7 },
    };
    return rows->columns == 0 || (counts[columns].allowed >> rows->columns & 1) ||
           gp_input_fail(rows->input, GP_ERROR_FORMAT, "expected %s numbers in a line, found %s%zu",
                         counts[columns].numbers, rows->columns > MOST ? "more than " : "",
                         rows->columns > MOST ? (size_t)MOST : rows->columns);
}

static Layout find_layout(const Rows *rows, GpPointsColumns columns)
{
    const size_t count = rows->columns;
    switch (columns) {
    case GP_POINTS_PTS:
        return (Layout){ .color = count == 6 ? 3 : count == 7 ? 4 : NONE };
    case GP_POINTS_XYZRGB:
        return (Layout){ .color = 3 };
    case GP_POINTS_XYZN:
        return (Layout){ .normal = 3, .color = count == 9 ? 6 : NONE };
    default:
        break;
    }
    if (count < 6)
        return (Layout){ .normal = NONE };
    const bool color_first = are_bytes(rows, 3);
    if (count == 6)
        return color_first ? (Layout){ .color = 3 } : (Layout){ .normal = 3 };
    return color_first ? (Layout){ .color = 3, .normal = 6 } : (Layout){ .normal = 3, .color = 6 };
}

static void copy_colors(const Rows *rows, size_t column, GpPointsBuilder *points)
{
    bool all_bytes = true;
    for (size_t row = 0; row < rows->count; row++) {
        for (size_t i = 0; i < 3; i++)
            all_bytes = all_bytes && is_byte(*value_of(rows, row, column + i));
    }
    for (size_t row = 0; row < rows->count; row++) {
        uint8_t color[3];
        for (size_t i = 0; i < 3; i++) {
            const float value = *value_of(rows, row, column + i);
            if (!all_bytes && !(value >= 0 && value <= 1)) {
                rows->input->result = gp_fail(
                    rows->input->error, GP_ERROR_FORMAT,
                    "%s: point %zu: expected colours of integers in 0..255 in all lines, or "
                    "of numbers in 0..1, found %g",
                    rows->input->path, row, (double)value);
                return;
            }
            color[i] = (uint8_t)(all_bytes ? value : value * 255 + 0.5F);
        }
        gp_bytes_append(&points->colors, color, sizeof color);
    }
}

static void split(const Rows *rows, Layout layout, GpPointsBuilder *points)
{
    points->has_normals = layout.normal != NONE;
    points->has_colors = layout.color != NONE;
    gp_bytes_reserve(&points->positions, rows->count * 3 * sizeof(float));
    for (size_t row = 0; row < rows->count; row++)
        gp_bytes_append(&points->positions, value_of(rows, row, 0), 3 * sizeof(float));
    for (size_t row = 0; points->has_normals && row < rows->count; row++)
        gp_bytes_append(&points->normals, value_of(rows, row, layout.normal), 3 * sizeof(float));
    if (points->has_colors)
        copy_colors(rows, layout.color, points);
}

void gp_points_read_text(GpInput *input, GpPointsColumns columns, GpPointsBuilder *points)
{
    Rows rows = { .input = input, .promised = -1 };
    while (input->result == GP_OK && gp_input_line(input)) {
        GpWord word;
        char *begin = input->next;
        if (gp_input_word(input, &word) && word.size >= 2 && word.text[0] == '/' &&
            word.text[1] == '/')
            continue;
        input->next = begin;
        if (read_row(&rows))
            find_counts(&rows, columns);
    }
    if (rows.promised > 0)
        gp_input_fail(input, GP_ERROR_FORMAT, "the file ends, but %lld more points are expected",
                      (long long)rows.promised);
    if (input->result == GP_OK && rows.values.failed)
        points->positions.failed = true;
    else if (input->result == GP_OK)
        split(&rows, find_layout(&rows, columns), points);
    gp_free(rows.values.data);
}
