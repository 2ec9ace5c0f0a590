#include "pipeline/io/ply/ply_items.h"

#include <math.h>
#include <stdio.h>

void gp_ply_fail(const PlyItems *items, const char *expected)
{
    static const char *const names[] = { "vertex", "face", "element" };
    gp_input_fail(items->input, GP_ERROR_FORMAT, "%s %zu: expected %s", names[items->element->kind],
                  items->item, expected);
}

static bool read_word(const PlyItems *items, GpWord *word)
{
    if (gp_input_any_word(items->input, word))
        return true;
    gp_ply_fail(items, "a number, but the file ends");
    return false;
}

static double value_of_word(const PlyItems *items, PlyType type, const GpWord *word)
{
    float number;
    int64_t integer;
    char shown[44], expected[96];
    if (type >= PLY_FLOAT32 && gp_word_number(word, &number))
        return (double)number;
    if (type < PLY_FLOAT32 && gp_word_integer(word, &integer))
        return (double)integer;
    snprintf(expected, sizeof expected, "%s, found '%s'",
             type >= PLY_FLOAT32 ? "a finite number" : "an integer", gp_word_show(word, shown));
    gp_ply_fail(items, expected);
    return 0;
}

static uint64_t load(const char *bytes, size_t size, bool is_big)
{
    return is_big ? gp_load_big(bytes, size) : gp_load_little(bytes, size);
}

static double value_of_bytes(PlyType type, const char *bytes, bool is_big)
{
    switch (type) {
    case PLY_INT8:
        return (int8_t)load(bytes, 1, is_big);
    case PLY_UINT8:
        return (double)load(bytes, 1, is_big);
    case PLY_INT16:
        return (int16_t)load(bytes, 2, is_big);
    case PLY_UINT16:
        return (double)load(bytes, 2, is_big);
    case PLY_INT32:
        return (int32_t)load(bytes, 4, is_big);
    case PLY_UINT32:
        return (double)load(bytes, 4, is_big);
    case PLY_FLOAT32:
        return (double)gp_bits_float((uint32_t)load(bytes, 4, is_big));
    default:
        break;
    }
    union {
        uint64_t u;
        double d;
    } pun = { load(bytes, 8, is_big) };
    return pun.d;
}

double gp_ply_value(const PlyItems *items, PlyType type)
{
    GpWord word;
    if (items->header->encoding == PLY_ASCII)
        return read_word(items, &word) ? value_of_word(items, type, &word) : 0;
    const char *bytes = gp_input_take(items->input, gp_ply_size(type));
    if (bytes)
        return value_of_bytes(type, bytes, items->header->encoding == PLY_BIG);
    gp_ply_fail(items, "more bytes, but the file ends");
    return 0;
}

size_t gp_ply_length(const PlyItems *items, const PlyProperty *property)
{
    double value = gp_ply_value(items, property->count_type);
    double left = (double)(items->input->end - items->input->next);
    size_t size = items->header->encoding == PLY_ASCII ? 1 : gp_ply_size(property->type);
    if (value >= 0 && value * (double)size <= left)
        return (size_t)value;
    gp_ply_fail(items, "a list length that fits into the file");
    return 0;
}

void gp_ply_skip(const PlyItems *items, const PlyProperty *property)
{
    GpWord word;
    size_t length = property->is_list ? gp_ply_length(items, property) : 1;
    for (size_t i = 0; i < length && items->input->result == GP_OK; i++) {
        if (items->header->encoding == PLY_ASCII)
            read_word(items, &word);
        else
            gp_ply_value(items, property->type);
    }
}

float gp_ply_number(const PlyItems *items, PlyType type)
{
    float value = (float)gp_ply_value(items, type);
    if (isfinite(value))
        return value;
    gp_ply_fail(items, "a finite number");
    return 0;
}

uint8_t gp_ply_color(const PlyItems *items, PlyType type)
{
    double value = gp_ply_value(items, type);
    if (type >= PLY_FLOAT32) {
        if (!isfinite(value))
            gp_ply_fail(items, "a finite number");
        double scaled = value * 255 + 0.5;
        return (uint8_t)(scaled > 255 ? 255 : scaled >= 0 ? scaled : 0); /* 0 for NaN */
    }
    if (!(value >= 0 && value <= (type == PLY_UINT16 ? 65535 : 255))) {
        gp_ply_fail(items, "a colour in 0..255");
        return 0;
    }
    return (uint8_t)(type == PLY_UINT16 ? value / 257 + 0.5 : value);
}

/* --- many items at once ----------------------------------------------------------------------- */

static bool is_color(PlyRole role)
{
    return role >= PLY_RED && role <= PLY_ALPHA;
}

static void copy_bytes(const char *from, size_t row, size_t count, PlyColumn column)
{
    uint8_t *to = column.to;
    for (size_t i = 0; i < count; i++)
        to[i * column.stride] = (uint8_t)from[i * row];
}

/* returns whether all are finite */
static bool copy_floats(const char *from, size_t row, size_t count, PlyColumn column)
{
    const uint32_t exponent = 0x7f800000;
    float *to = column.to;
    uint32_t infinite = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, from + i * row, sizeof bits);
        to[i * column.stride] = gp_bits_float(bits);
        infinite |= (bits & exponent) == exponent;
    }
    return !infinite;
}

/* Bytes of an item, whose properties are all such as gp_ply_read_block copies; 0: they are not. */
static size_t row_bytes(const PlyItems *items, const PlyColumn column[PLY_VERTEX_ROLES])
{
    size_t row = 0;
    for (size_t i = items->element->first; i < items->element->end; i++) {
        const PlyProperty *property = &items->header->property[i];
        const PlyRole role = property->role;
        if (property->is_list || (role < PLY_VERTEX_ROLES && column[role].to &&
                                  property->type != (is_color(role) ? PLY_UINT8 : PLY_FLOAT32)))
            return 0;
        row += gp_ply_size(property->type);
    }
    return row;
}

size_t gp_ply_read_block(const PlyItems *items, const PlyColumn column[PLY_VERTEX_ROLES])
{
    GpInput *input = items->input;
    const size_t row = gp_ply_is_native(items) ? row_bytes(items, column) : 0;
    const size_t count = gp_ply_block(items);
    if (!row || count > (size_t)(input->end - input->next) / row)
        return 0;
    const char *from = input->next;
    bool valid = true;
    for (size_t i = items->element->first; i < items->element->end; i++) {
        const PlyProperty *property = &items->header->property[i];
        const PlyRole role = property->role;
        if (role < PLY_VERTEX_ROLES && column[role].to && is_color(role))
            copy_bytes(from, row, count, column[role]);
        else if (role < PLY_VERTEX_ROLES && column[role].to)
            valid &= copy_floats(from, row, count, column[role]);
        from += gp_ply_size(property->type);
    }
    if (valid)
        input->next += count * row;
    return valid ? count : 0;
}

/* --- all items -------------------------------------------------------------------------------- */

void gp_ply_items(GpInput *input, const PlyHeader *header, PlyItemFn read, void *context)
{
    bool is_ascii = header->encoding == PLY_ASCII;
    input->number = is_ascii ? input->number + 1 : 0;
    PlyItems items = { .input = input, .header = header };
    for (size_t i = 0; i < header->element_count; i++) {
        items.element = &header->element[i];
        items.item = 0;
        while (items.item < items.element->count && input->result == GP_OK)
            items.item += read(&items, context);
    }
    GpWord word;
    bool is_left = is_ascii ? gp_input_any_word(input, &word) : input->next < input->end;
    input->number = 0;
    input->place = input->next;
    if (is_left)
        gp_input_fail(input, GP_ERROR_FORMAT,
                      "expected the end of the file after its last element");
}
