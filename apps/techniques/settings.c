#include "apps/techniques/settings.h"

#include "apps/base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a member may hold. */
typedef union Value {
    int name;
    uint32_t integer, size[2];
    double number, vector[SETTING_MAX_VECTOR];
    bool flag;
    const char *text;
} Value;

/* --- members ---------------------------------------------------------------------------------- */

size_t setting_bytes(const SettingField *field)
{
    static const size_t bytes[] = {
        [SETTING_NAME] = sizeof(int),          [SETTING_INTEGER] = sizeof(uint32_t),
        [SETTING_NUMBER] = sizeof(double),     [SETTING_FLAG] = sizeof(bool),
        [SETTING_SIZE] = 2 * sizeof(uint32_t), [SETTING_VECTOR] = sizeof(double),
        [SETTING_TEXT] = sizeof(char *),
    };
    return bytes[field->type] * (field->type == SETTING_VECTOR ? (size_t)field->count : 1);
}

static Value load(const SettingField *field, const void *setting)
{
    Value value;
    memcpy(&value, (const char *)setting + field->offset, setting_bytes(field));
    return value;
}

static void store(const SettingField *field, void *setting, const Value *value)
{
    memcpy((char *)setting + field->offset, value, setting_bytes(field));
}

static const SettingField *find(const SettingField *fields, const char *name, size_t length)
{
    for (const SettingField *field = fields; field->name; field++)
        if (strlen(field->name) == length && memcmp(field->name, name, length) == 0)
            return field;
    return NULL;
}

const SettingField *setting_find(const SettingField *fields, const char *name)
{
    return find(fields, name, strlen(name));
}

bool setting_is_given(const SettingField *fields, uint32_t given, const char *name)
{
    return given >> (setting_find(fields, name) - fields) & 1;
}

int setting_words(const SettingField *field)
{
    if (field->type == SETTING_VECTOR)
        return field->count;
    return field->type != SETTING_FLAG;
}

/* --- reading ---------------------------------------------------------------------------------- */

static bool read_name(const SettingField *field, const char *text, int *value)
{
    for (int i = 0; field->names[i]; i++) {
        if (strcmp(field->names[i], text) == 0) {
            *value = i;
            return true;
        }
    }
    return false;
}

/* Nothing is 0 pixels wide. */
static double least_of(const SettingField *field)
{
    return field->type == SETTING_SIZE && field->low < 1 ? 1 : field->low;
}

/* Decimal in one of the usual forms: no spaces, hexadecimal digits, infinities. */
static bool read_number(const SettingField *field, const char *text, double *value)
{
    bool whole = field->type == SETTING_INTEGER || field->type == SETTING_SIZE;
    const char *digits = whole ? "0123456789" : "0123456789+-.eE";
    char *end;
    double read = strtod(text, &end);
    if (end == text || *end || text[strspn(text, digits)])
        return false;
    *value = read;
    return read >= least_of(field) && read <= field->high;
}

/* A word of a list, copied; the words end at any of these. One without room is no number. */
static const char *next_word(const char *at, const char *ends, char word[32])
{
    const size_t length = strcspn(at, ends);
    snprintf(word, 32, "%.*s%s", (int)(length < 32 ? length : 28), at, length < 32 ? "" : "...");
    return at + length;
}

static bool read_size(const SettingField *field, const char *text, uint32_t size[2])
{
    const char *at = text;
    char word[32];
    for (int i = 0; i < 2; i++) {
        double number;
        at = next_word(at, "x", word);
        if (!read_number(field, word, &number) || *at != (i ? '\0' : 'x'))
            return false;
        size[i] = (uint32_t)number;
        at++;
    }
    return true;
}

/* out  wrong: the first word that is none, or is one too many, on failure */
static bool read_vector(const SettingField *field, const char *text, double *vector, char wrong[32])
{
    const char *at = text;
    for (int i = 0; i < field->count; i++) {
        at = next_word(at + strspn(at, " "), " ", wrong);
        if (!read_number(field, wrong, &vector[i]))
            return false;
    }
    at += strspn(at, " ");
    next_word(at, " ", wrong);
    return *at == '\0';
}

/* "plain, hardware or soft", or with the same between all */
static void list_names(const SettingField *field, const char *between, const char *last, char *list,
                       size_t size)
{
    size_t used = 0;
    list[0] = '\0';
    for (int i = 0; field->names[i] && used < size; i++)
        used += (size_t)snprintf(list + used, size - used, "%s%s",
                                 i == 0                ? ""
                                 : field->names[i + 1] ? between
                                                       : last,
                                 field->names[i]);
}

void setting_list_names(const SettingField *field, char *list, size_t size)
{
    list_names(field, "|", "|", list, size);
}

/* What a field expects, in words. */
static void describe(const SettingField *field, char *text, size_t size)
{
    static const char *const numbers[] = { "", "a number", "two numbers", "three numbers",
                                           "four numbers" };
    char low[32], high[32];
    text_of_number(least_of(field), low);
    text_of_number(field->high, high);
    if (field->names)
        list_names(field, ", ", " or ", text, size);
    else if (field->type == SETTING_SIZE)
        snprintf(text, size, "WIDTHxHEIGHT, such as 1024x768, each from %s to %s", low, high);
    else
        snprintf(text, size, "%s from %s to %s",
                 field->type == SETTING_INTEGER ? "a whole number" : numbers[setting_words(field)],
                 low, high);
}

/* A flag takes everything, and so does a text without names. */
static GpResult read_value(const SettingField *field, const char *text, Value *value,
                           GpError *error)
{
    char expected[240], word[32];
    const char *wrong = text;
    double number = 0;
    bool good = true;
    switch (field->type) {
    case SETTING_NAME:
        good = read_name(field, text, &value->name);
        break;
    case SETTING_INTEGER:
        good = read_number(field, text, &number);
        value->integer = good ? (uint32_t)number : 0;
        break;
    case SETTING_NUMBER:
        good = read_number(field, text, &value->number);
        break;
    case SETTING_FLAG:
        value->flag = true;
        break;
    case SETTING_SIZE:
        good = read_size(field, text, value->size);
        break;
    case SETTING_VECTOR:
        good = read_vector(field, text, value->vector, word);
        wrong = word;
        break;
    case SETTING_TEXT:
        good = !field->names || read_name(field, text, &value->name);
        value->text = text;
        break;
    }
    if (good)
        return GP_OK;
    describe(field, expected, sizeof expected);
    return gp_fail(error, GP_ERROR_INVALID, "--%s: expected %s, not '%.100s'", field->name,
                   expected, wrong);
}

GpResult setting_set(const SettingField *fields, void *setting, const char *name, const char *text,
                     GpError *error)
{
    const SettingField *field = setting_find(fields, name);
    if (!field)
        return gp_fail(error, GP_ERROR_INVALID, "no option '--%.100s'", name);
    Value value;
    GpResult result = read_value(field, text, &value, error);
    if (!result)
        store(field, setting, &value);
    return result;
}

/* --- keys ------------------------------------------------------------------------------------- */

/* One option of a key, its value copied. */
typedef struct Option {
    const SettingField *field;
    char value[SETTING_MAX_TEXT];
} Option;

/* Reads the option that begins at *at and moves *at behind it and the spaces that follow. */
static GpResult next_option(const SettingField *fields, const char **at, Option *option,
                            GpError *error)
{
    const char *word = *at, *name = word + 2;
    size_t length = strcspn(word, " ");
    if (strncmp(word, "--", 2) != 0)
        return gp_fail(error, GP_ERROR_INVALID, "expected an option, not '%.*s'",
                       (int)(length < 100 ? length : 100), word);
    size_t name_length = strcspn(name, " =");
    option->field = find(fields, name, name_length);
    if (!option->field || option->field->aside)
        return gp_fail(error, GP_ERROR_INVALID, "no option '--%.*s'",
                       (int)(name_length < 100 ? name_length : 100), name);
    const char *value = name + name_length, *end;
    value += *value == '=' ? 1 : strspn(value, " ");
    end = value;
    for (int i = 0; i < setting_words(option->field); i++)
        end += strspn(end, i ? " " : ""), end += strcspn(end, " ");
    size_t value_length = (size_t)(end - value);
    if ((value_length == 0 && setting_words(option->field)) || value_length >= sizeof option->value)
        return gp_fail(error, GP_ERROR_INVALID, "--%s: expected a value", option->field->name);
    snprintf(option->value, sizeof option->value, "%.*s", (int)value_length, value);
    *at = end + strspn(end, " ");
    return GP_OK;
}

/* All options are read before the first is set, so that a mistake changes nothing. */
GpResult setting_parse(const SettingField *fields, void *setting, const char *text, GpError *error)
{
    text += strspn(text, " ");
    for (int setting_them = 0; setting_them < 2; setting_them++) {
        for (const char *at = text; *at;) {
            Option option;
            Value value;
            GpResult result = next_option(fields, &at, &option, error);
            if (!result)
                result = read_value(option.field, option.value, &value, error);
            if (result)
                return result;
            if (setting_them)
                store(option.field, setting, &value);
        }
    }
    return GP_OK;
}

/* A value as it would be typed, after a space; nothing of a flag. */
static void print_value(const SettingField *field, const Value *value, Text *text)
{
    char number[32];
    switch (field->type) {
    case SETTING_NAME:
        text_add(text, " %s", field->names[value->name]);
        break;
    case SETTING_INTEGER:
        text_add(text, " %u", value->integer);
        break;
    case SETTING_SIZE:
        text_add(text, " %ux%u", value->size[0], value->size[1]);
        break;
    case SETTING_NUMBER:
    case SETTING_VECTOR:
        for (int i = 0; i < setting_words(field); i++) {
            text_of_number(value->vector[i], number);
            text_add(text, " %s", number);
        }
        break;
    case SETTING_FLAG:
    case SETTING_TEXT:
        break;
    }
}

/* Numbers beside their range say that something is to be chosen. */
static bool is_left_out(const SettingField *field, const Value *value, const void *defaults)
{
    if (!defaults && field->type == SETTING_FLAG)
        return !value->flag;
    if (!defaults && field->type == SETTING_INTEGER)
        return value->integer < field->low || value->integer > field->high;
    if (!defaults && field->type == SETTING_NUMBER)
        return value->number < field->low || value->number > field->high;
    if (!defaults)
        return false;
    const Value usual = load(field, defaults);
    return memcmp(value, &usual, setting_bytes(field)) == 0;
}

void setting_print(const SettingField *fields, const void *setting, const void *defaults,
                   char *text, size_t size)
{
    Text key = { .data = NULL };
    for (const SettingField *field = fields; field->name; field++) {
        const Value value = load(field, setting);
        if (field->aside || is_left_out(field, &value, defaults))
            continue;
        text_add(&key, "%s--%s", key.length ? " " : "", field->name);
        print_value(field, &value, &key);
    }
    snprintf(text, size, "%s", key.data ? key.data : "");
    text_free(&key);
}
