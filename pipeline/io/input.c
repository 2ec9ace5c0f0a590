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

bool gp_word_is(const GpWord *word, const char *text)
{
    return word->size == strlen(text) && memcmp(word->text, text, word->size) == 0;
}

bool gp_word_is_any_case(const GpWord *word, const char *text)
{
    return word->size == strlen(text) && strncasecmp(word->text, text, word->size) == 0;
}

/* The grammar first: strtof also takes nan, inf and hexadecimal. */
static bool is_decimal(const char *at, const char *end)
{
    if (at < end && (*at == '+' || *at == '-'))
        at++;
    size_t digits = 0;
    for (; at < end && is_digit(*at); at++)
        digits++;
    if (at < end && *at == '.') {
        for (at++; at < end && is_digit(*at); at++)
            digits++;
    }
    if (digits == 0)
        return false;
    if (at < end && (*at == 'e' || *at == 'E')) {
        at++;
        if (at < end && (*at == '+' || *at == '-'))
            at++;
        if (at == end)
            return false;
        while (at < end && is_digit(*at))
            at++;
    }
    return at == end;
}

bool gp_word_number(const GpWord *word, float *value)
{
    if (!is_decimal(word->text, word->text + word->size))
        return false;
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
