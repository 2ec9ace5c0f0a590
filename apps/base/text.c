#include "apps/base/text.h"

#include "pipeline/io/file.h"

#include <jansson.h>
#include <stdarg.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Makes room for `more` characters and the terminator. */
static bool reserve(Text *text, size_t more)
{
    size_t needed = text->length + more + 1;
    if (text->failed || needed <= text->room)
        return !text->failed;
    size_t room = needed < 2 * text->room ? 2 * text->room : needed;
    char *data = gp_alloc(room, 1);
    text->failed = !data;
    if (!data)
        return false;
    if (text->data)
        memcpy(data, text->data, text->length);
    gp_free(text->data);
    text->data = data;
    text->room = room;
    return true;
}

void text_add(Text *text, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    int length = vsnprintf(NULL, 0, format, args);
    va_end(args);
    GP_ASSERT(length >= 0);
    if (!reserve(text, (size_t)length))
        return;
    va_start(args, format);
    vsnprintf(text->data + text->length, (size_t)length + 1, format, args);
    va_end(args);
    text->length += (size_t)length;
}

/* By the table of well-formed sequences: the second byte alone tells of too long ones, of
 * surrogates and of what is beyond U+10FFFF. source Unicode 15, table 3-7 */
int text_utf8_bytes(const char *text)
{
    const unsigned char *at = (const unsigned char *)text;
    const unsigned lead = at[0];
    const int bytes = lead < 0x80                    ? lead > 0
                      : lead >= 0xc2 && lead <= 0xdf ? 2
                      : lead >= 0xe0 && lead <= 0xef ? 3
                      : lead >= 0xf0 && lead <= 0xf4 ? 4
                                                     : 0;
    const unsigned low = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    const unsigned high = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    if (bytes > 1 && (at[1] < low || at[1] > high))
        return 0;
    for (int i = 2; i < bytes; i++)
        if ((at[i] & 0xc0) != 0x80)
            return 0;
    return bytes;
}

/* Adds a character as it is; returns its bytes. */
static size_t add_character(Text *text, const char *at)
{
    const int bytes = text_utf8_bytes(at);
    if (bytes)
        text_add(text, "%.*s", bytes, at);
    else
        text_add(text, "\xef\xbf\xbd");
    return bytes ? (size_t)bytes : 1;
}

void text_add_utf8(Text *text, const char *bytes)
{
    while (*bytes)
        bytes += add_character(text, bytes);
}

static void add_plain(Text *text, const char *plain)
{
    static const char special[] = "&<>\"'";
    static const char *const entities[] = { "&amp;", "&lt;", "&gt;", "&quot;", "&#39;" };
    while (*plain) {
        const char *found = strchr(special, *plain);
        const bool is_control = (unsigned char)*plain < ' ' && *plain != '\n';
        if (found || is_control)
            text_add(text, "%s", found ? entities[found - special] : " ");
        plain += found || is_control ? 1 : add_character(text, plain);
    }
}

void text_add_escaped(Text *text, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    for (size_t length; *format; format += length) {
        char directive[16];
        length = strcspn(format, "%");
        text_add(text, "%.*s", (int)length, format);
        format += length;
        length = *format ? strcspn(format + 1, "%sdufg") + 2 : 0;
        GP_ASSERT(length < sizeof directive);
        snprintf(directive, sizeof directive, "%.*s", (int)length, format);
        switch (length ? directive[length - 1] : '\0') {
        case 's':
            add_plain(text, va_arg(args, const char *));
            break;
        case 'd':
            text_add(text, directive, va_arg(args, int));
            break;
        case 'u':
            text_add(text, directive, va_arg(args, unsigned));
            break;
        case 'f':
        case 'g':
            text_add(text, directive, va_arg(args, double));
            break;
        default:
            GP_ASSERT(length == 0 || strcmp(directive, "%%") == 0);
            text_add(text, "%s", length ? "%" : "");
        }
    }
    va_end(args);
}

void text_add_csv(Text *text, const char *field, const char *end)
{
    if (!field[strcspn(field, ",\"\r\n")]) {
        text_add(text, "%s%s", field, end);
        return;
    }
    text_add(text, "\"");
    for (; *field; field++)
        text_add(text, *field == '"' ? "\"\"" : "%c", *field);
    text_add(text, "\"%s", end);
}

void text_add_csv_number(Text *text, double value)
{
    char number[32];
    text_of_number(value, number);
    text_add(text, "%s,", number);
}

GpResult text_write(const char *path, const Text *text, GpError *error)
{
    if (text->failed)
        return gp_fail(error, GP_ERROR_MEMORY, "%.200s: out of memory", path);
    return gp_file_write(path, text->data, text->length, error);
}

GpResult text_write_as(const char *path, const char *extension, Text *text, GpError *error)
{
    char name[4096];
    GpResult result = snprintf(name, sizeof name, "%s.%s", path, extension) < (int)sizeof name
                          ? text_write(name, text, error)
                          : gp_fail(error, GP_ERROR_IO, "%.200s: the path is too long", path);
    text_free(text);
    return result;
}

void text_free(Text *text)
{
    gp_free(text->data);
    *text = (Text){ .data = NULL };
}

void text_of_number(double value, char text[32])
{
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, 32, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            return;
    }
}

bool text_take_whole(const char **at, uint32_t most, uint32_t *value)
{
    const char *digit = *at;
    uint64_t read = 0;
    for (; *digit >= '0' && *digit <= '9' && read <= most; digit++)
        read = 10 * read + (uint64_t)(*digit - '0');
    if (digit == *at || read > most)
        return false;
    *value = (uint32_t)read;
    *at = digit;
    return true;
}

bool text_take_word(const char **at, const char *word)
{
    const size_t length = strlen(word);
    const bool is_there = strncmp(*at, word, length) == 0;
    *at += is_there ? length : 0;
    return is_there;
}

/* Rounds to so many digits, but no whole number; drops the zeros behind the point. */
static void print_plain(double value, int digits, char text[32])
{
    const int before = (int)floor(log10(value)) + 1;
    snprintf(text, 32, "%.*f", digits > before ? digits - before : 0, value);
    if (!strchr(text, '.'))
        return;
    size_t length = strlen(text);
    while (text[length - 1] == '0')
        length--;
    text[text[length - 1] == '.' ? length - 1 : length] = '\0';
}

static void group_thousands(char text[32])
{
    char plain[32];
    strcpy(plain, text);
    const size_t whole = strcspn(plain, ".");
    size_t used = 0;
    for (size_t i = 0; plain[i] && used < 30; i++) {
        if (i > 0 && i < whole && (whole - i) % 3 == 0)
            text[used++] = ',';
        text[used++] = plain[i];
    }
    text[used] = '\0';
}

void text_for_people(double value, int digits, char text[32])
{
    const double size = fabs(value);
    char plain[32];
    if (!(size >= 1e-6 && size < 1e12)) {
        snprintf(text, 32, "%.*g", digits, value); /* 0, and what is no number */
        char *power = strchr(text, 'e');
        if (power) {
            const int exponent = atoi(power + 1);
            snprintf(power, (size_t)(text + 32 - power), " x 10^%d", exponent);
        }
        return;
    }
    print_plain(size, digits, plain);
    group_thousands(plain);
    snprintf(text, 32, "%s%.30s", value < 0 ? "-" : "", plain);
}

void text_stem(const char *path, char *name, size_t size)
{
    const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
    const char *dot = strrchr(base, '.');
    snprintf(name, size, "%.*s", dot && dot > base ? (int)(dot - base) : (int)strlen(base), base);
}

void text_copy(char *to, size_t size, const char *from)
{
    snprintf(to, size, "%s", from);
    json_t *checked = json_string(to);
    for (char *c = to; !checked && *c; c++)
        if ((unsigned char)*c > 127)
            *c = '?';
    json_decref(checked);
}
