#include "apps/techniques/settings.h"

#include "apps/base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a member may hold. */
typedef union Value {
    int name;
    uint32_t integer;
    double number;
} Value;

/* --- members ---------------------------------------------------------------------------------- */

static Value load(const SettingField *field, const void *setting)
{
    const void *member = (const char *)setting + field->offset;
    Value value = { .number = 0 };
    if (field->type == SETTING_NAME)
        memcpy(&value.name, member, sizeof value.name);
    else if (field->type == SETTING_INTEGER)
        memcpy(&value.integer, member, sizeof value.integer);
    else
        memcpy(&value.number, member, sizeof value.number);
    return value;
}

static void store(const SettingField *field, void *setting, Value value)
{
    void *member = (char *)setting + field->offset;
    if (field->type == SETTING_NAME)
        memcpy(member, &value.name, sizeof value.name);
    else if (field->type == SETTING_INTEGER)
        memcpy(member, &value.integer, sizeof value.integer);
    else
        memcpy(member, &value.number, sizeof value.number);
}

static bool same(const SettingField *field, Value a, Value b)
{
    if (field->type == SETTING_NAME)
        return a.name == b.name;
    return field->type == SETTING_INTEGER ? a.integer == b.integer : a.number == b.number;
}

static const SettingField *find(const SettingField *fields, const char *name, size_t length)
{
    for (const SettingField *field = fields; field->name; field++)
        if (strlen(field->name) == length && memcmp(field->name, name, length) == 0)
            return field;
    return NULL;
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

/* Decimal in one of the usual forms: no spaces, hexadecimal digits, infinities. */
static bool read_number(const SettingField *field, const char *text, double *value)
{
    bool whole = field->type == SETTING_INTEGER;
    const char *digits = whole ? "0123456789" : "0123456789+-.eE";
    char *end;
    double read = strtod(text, &end);
    if (end == text || *end || text[strspn(text, digits)])
        return false;
    *value = read;
    return read >= field->low && read <= field->high;
}

/* "plain, hardware or soft" */
static void list_names(const SettingField *field, char *list, size_t size)
{
    size_t used = 0;
    list[0] = '\0';
    for (int i = 0; field->names[i] && used < size; i++) {
        const char *between = i == 0 ? "" : field->names[i + 1] ? ", " : " or ";
        used += (size_t)snprintf(list + used, size - used, "%s%s", between, field->names[i]);
    }
}

static GpResult refuse(const SettingField *field, const char *text, GpError *error)
{
    char names[240];
    if (field->type == SETTING_NAME) {
        list_names(field, names, sizeof names);
        return gp_fail(error, GP_ERROR_INVALID, "--%s: expected %s, not '%.100s'", field->name,
                       names, text);
    }
    char low[32], high[32];
    text_of_number(field->low, low);
    text_of_number(field->high, high);
    return gp_fail(error, GP_ERROR_INVALID, "--%s: expected a %s from %s to %s, not '%.100s'",
                   field->name, field->type == SETTING_INTEGER ? "whole number" : "number", low,
                   high, text);
}

static GpResult read_value(const SettingField *field, const char *text, Value *value,
                           GpError *error)
{
    double number = 0;
    bool good = field->type == SETTING_NAME ? read_name(field, text, &value->name)
                                            : read_number(field, text, &number);
    if (!good)
        return refuse(field, text, error);
    if (field->type == SETTING_INTEGER)
        value->integer = (uint32_t)number;
    else if (field->type == SETTING_NUMBER)
        value->number = number;
    return GP_OK;
}

GpResult setting_set(const SettingField *fields, void *setting, const char *name, const char *text,
                     GpError *error)
{
    const SettingField *field = find(fields, name, strlen(name));
    if (!field)
        return gp_fail(error, GP_ERROR_INVALID, "no option '--%.100s'", name);
    Value value;
    GpResult result = read_value(field, text, &value, error);
    if (!result)
        store(field, setting, value);
    return result;
}

/* --- texts of options ------------------------------------------------------------------------- */

/* One option of a text, its value copied. */
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
    if (!option->field)
        return gp_fail(error, GP_ERROR_INVALID, "no option '--%.*s'",
                       (int)(name_length < 100 ? name_length : 100), name);
    const char *value = name + name_length;
    value += *value == '=' ? 1 : strspn(value, " ");
    size_t value_length = strcspn(value, " ");
    if (value_length == 0 || value_length >= sizeof option->value)
        return gp_fail(error, GP_ERROR_INVALID, "--%s: expected a value", option->field->name);
    snprintf(option->value, sizeof option->value, "%.*s", (int)value_length, value);
    value += value_length;
    *at = value + strspn(value, " ");
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
                store(option.field, setting, value);
        }
    }
    return GP_OK;
}

void setting_print(const SettingField *fields, const void *setting, const void *defaults,
                   char *text, size_t size)
{
    size_t used = 0;
    GP_ASSERT(size > 0);
    text[0] = '\0';
    for (const SettingField *field = fields; field->name && used < size; field++) {
        Value value = load(field, setting);
        if (same(field, value, load(field, defaults)))
            continue;
        char number[32] = "";
        if (field->type != SETTING_NAME)
            text_of_number(field->type == SETTING_INTEGER ? value.integer : value.number, number);
        used += (size_t)snprintf(text + used, size - used, "%s--%s %s", used ? " " : "",
                                 field->name, number[0] ? number : field->names[value.name]);
    }
}

/* --- argp ------------------------------------------------------------------------------------- */

void setting_options(const SettingField *fields, struct argp_option *options)
{
    int count = 0;
    for (; fields[count].name; count++) {
        GP_ASSERT(count < SETTING_MAX_FIELDS);
        options[count] = (struct argp_option){ .name = fields[count].name,
                                               .key = SETTING_FIRST_KEY + count,
                                               .arg = fields[count].argument,
                                               .doc = fields[count].help };
    }
    options[count] = (struct argp_option){ .name = NULL };
}

const SettingField *setting_of_key(const SettingField *fields, int key)
{
    for (int i = 0; fields[i].name; i++)
        if (SETTING_FIRST_KEY + i == key)
            return &fields[i];
    return NULL;
}
