#include "pipeline/io/mesh/mesh_text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

GpText gp_text_begin(const char *path, char *data, size_t size, GpError *error)
{
    return (GpText){ .path = path, .error = error, .next = data, .end = data + size };
}

GpResult gp_text_fail(const GpText *text, GpResult result, const char *format, ...)
{
    char reason[400];
    va_list args;
    va_start(args, format);
    vsnprintf(reason, sizeof reason, format, args);
    va_end(args);
    return gp_fail(text->error, result, "%s: line %zu: %s", text->path, text->number, reason);
}

bool gp_text_line(GpText *text)
{
    if (text->line_end)
        text->next = text->line_end < text->end ? text->line_end + 1 : text->end;
    while (text->next < text->end) {
        char *newline = memchr(text->next, '\n', (size_t)(text->end - text->next));
        text->line_end = newline ? newline : text->end;
        text->number++;
        char *first = skip_space(text->next, text->line_end);
        if (first < text->line_end && *first != '#')
            return true;
        text->next = newline ? newline + 1 : text->end;
    }
    text->line_end = text->end;
    return false;
}

static bool word_before(GpText *text, char *end, GpWord *word)
{
    char *first = skip_space(text->next, end);
    char *last = first;
    while (last < end && !is_space(*last))
        last++;
    *word = (GpWord){ .text = first, .size = (size_t)(last - first) };
    text->next = last;
    return last > first;
}

bool gp_text_word(GpText *text, GpWord *word)
{
    return word_before(text, text->line_end, word);
}

bool gp_text_any_word(GpText *text, GpWord *word)
{
    for (; text->next < text->end && is_space(*text->next); text->next++) {
        if (*text->next == '\n')
            text->number++;
    }
    return word_before(text, text->end, word);
}

bool gp_word_is(const GpWord *word, const char *text)
{
    return word->size == strlen(text) && memcmp(word->text, text, word->size) == 0;
}

static char lower(char c)
{
    return (char)(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
}

bool gp_word_is_any_case(const GpWord *word, const char *text)
{
    if (word->size != strlen(text))
        return false;
    for (size_t i = 0; i < word->size; i++) {
        if (lower(word->text[i]) != lower(text[i]))
            return false;
    }
    return true;
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
