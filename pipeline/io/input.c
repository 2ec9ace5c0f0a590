#include "pipeline/io/input.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static bool is_space(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static char *skip_space(char *at, const char *end)
{
    while (at < end && is_space(*at))
        at++;
    return at;
}

GpResult gp_input_open(const char *path, GpFile *file, GpInput *input, GpError *error)
{
    const GpResult result = gp_file_read(path, file, error);
    if (result != GP_OK)
        return result;
    if (file->size == 0) {
        gp_file_free(file);
        return gp_fail(error, GP_ERROR_FORMAT, "%s: the file is empty", path);
    }
    *input = (GpInput){ .path = path,
                        .error = error,
                        .begin = file->data,
                        .next = file->data,
                        .end = file->data + file->size };
    return GP_OK;
}

bool gp_input_fail(GpInput *input, GpResult result, const char *format, ...)
{
    if (input->result != GP_OK)
        return false;
    char reason[400];
    va_list args;
    va_start(args, format);
    vsnprintf(reason, sizeof reason, format, args);
    va_end(args);
    bool has_lines = input->number > 0;
    input->result =
        gp_fail(input->error, result, "%s: %s %zu: %s", input->path, has_lines ? "line" : "byte",
                has_lines ? input->number : (size_t)(input->place - input->begin), reason);
    return false;
}

bool gp_input_line(GpInput *input)
{
    if (input->line_end)
        input->next = input->line_end < input->end ? input->line_end + 1 : input->end;
    while (input->next < input->end) {
        char *newline = memchr(input->next, '\n', (size_t)(input->end - input->next));
        input->line_end = newline ? newline : input->end;
        input->number++;
        char *first = skip_space(input->next, input->line_end);
        if (first < input->line_end && *first != '#')
            return true;
        input->next = newline ? newline + 1 : input->end;
    }
    input->line_end = input->end;
    return false;
}

static bool word_before(GpInput *input, char *end, GpWord *word)
{
    char *first = skip_space(input->next, end);
    char *last = first;
    while (last < end && !is_space(*last))
        last++;
    *word = (GpWord){ .text = first, .size = (size_t)(last - first) };
    input->next = last;
    return last > first;
}

bool gp_input_word(GpInput *input, GpWord *word)
{
    return word_before(input, input->line_end, word);
}

bool gp_input_any_word(GpInput *input, GpWord *word)
{
    for (; input->next < input->end && is_space(*input->next); input->next++) {
        if (*input->next == '\n')
            input->number++;
    }
    return word_before(input, input->end, word);
}

bool gp_word_is_any_case(const GpWord *word, const char *text)
{
    return word->size == strlen(text) && strncasecmp(word->text, text, word->size) == 0;
}

/* The digits of a number as an integer, times a power of ten. */
typedef struct Decimal {
    bool is_negative, is_short; /* is_short: digits, an integer of binary64, are all of them */
    uint64_t digits;
    int exponent;
} Decimal;

/* Any digits; of those that are kept, `step` is added to the exponent. returns how many there
 * are */
static size_t take_digits(const char **at, const char *end, int step, Decimal *decimal)
{
    const uint64_t most = ((1ull << 53) - 9) / 10;
    const char *first = *at;
    for (; *at < end && is_digit(**at); ++*at) {
        decimal->is_short = decimal->is_short && decimal->digits <= most;
        if (!decimal->is_short)
            continue;
        decimal->digits = 10 * decimal->digits + (uint64_t)(**at - '0');
        decimal->exponent += step;
    }
    return (size_t)(*at - first);
}

/* The grammar, which strtof does not keep: it also takes nan, inf and hexadecimal. */
static bool read_decimal(const char *at, const char *end, Decimal *decimal)
{
    *decimal = (Decimal){ .is_negative = at < end && *at == '-', .is_short = true };
    if (at < end && (*at == '+' || *at == '-'))
        at++;
    size_t digits = take_digits(&at, end, 0, decimal);
    if (at < end && *at == '.') {
        at++;
        digits += take_digits(&at, end, -1, decimal);
    }
    if (digits == 0)
        return false;
    if (at < end && (*at == 'e' || *at == 'E')) {
        const bool is_signed = ++at < end && (*at == '+' || *at == '-');
        const bool is_negative = is_signed && *at == '-';
        at += is_signed;
        Decimal power = { .is_short = true };
        if (take_digits(&at, end, 0, &power) == 0)
            return false;
        decimal->is_short = decimal->is_short && power.digits < 1000;
        decimal->exponent += is_negative ? -(int)(power.digits % 1000) : (int)(power.digits % 1000);
    }
    return at == end;
}

/* One operation of binary64 on two numbers that it holds is rounded as it should be, and rounding
 * that to binary32 goes wrong only from the middle between two floats, or among subnormal ones.
 * Texts of meshes are read
 * in two thirds of the time.
 * source William Clinger, "How to Read Floating Point Numbers Accurately", PLDI 1990
 * returns whether this is so */
static bool round_decimal(const Decimal *decimal, float *value)
{
    static const double powers[] = { 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
    const int most = (int)GP_COUNT(powers) - 1;
    if (!decimal->is_short || decimal->exponent > most || decimal->exponent < -most)
        return false;
    union {
        double number;
        uint64_t bits;
    } pun = { .number = (double)decimal->digits };
    if (decimal->exponent < 0)
        pun.number /= powers[-decimal->exponent];
    else
        pun.number *= powers[decimal->exponent];
    const uint64_t beyond = (1u << 29) - 1, middle = 1u << 28;
    const bool is_normal = pun.number >= 0x1p-126 || decimal->digits == 0;
    *value = (float)(decimal->is_negative ? -pun.number : pun.number);
    return is_normal && (pun.bits & beyond) != middle;
}

bool gp_word_number(const GpWord *word, float *value)
{
    Decimal decimal;
    if (!read_decimal(word->text, word->text + word->size, &decimal))
        return false;
    if (!round_decimal(&decimal, value))
        *value = strtof(word->text, NULL);
    return isfinite(*value);
}

bool gp_word_integer(const GpWord *word, int64_t *value)
{
    size_t at = word->size > 0 && (word->text[0] == '-' || word->text[0] == '+') ? 1 : 0;
    int64_t magnitude = 0;
    if (at == word->size)
        return false;
    for (; at < word->size; at++) {
        if (!is_digit(word->text[at]) || magnitude > INT64_MAX / 32)
            return false;
        magnitude = magnitude * 10 + (word->text[at] - '0');
    }
    *value = word->text[0] == '-' ? -magnitude : magnitude;
    return true;
}

const char *gp_word_show(const GpWord *word, char shown[44])
{
    size_t size = word->size < 40 ? word->size : 40;
    for (size_t i = 0; i < size; i++)
        shown[i] = (char)(word->text[i] < ' ' || word->text[i] > '~' ? '?' : word->text[i]);
    strcpy(shown + size, size < word->size ? "..." : "");
    return shown;
}
