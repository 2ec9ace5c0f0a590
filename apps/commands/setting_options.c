#include "apps/commands/setting_options.h"

#include <stdio.h>

void setting_options(const SettingField *fields, SettingOptions *options)
{
    int i = 0;
    for (; fields[i].name; i++) {
        GP_ASSERT(i < SETTING_MAX_FIELDS);
        const SettingField *field = &fields[i];
        if (field->type == SETTING_NAME)
            setting_list_names(field, options->names[i], sizeof options->names[i]);
        options->option[i] = (struct argp_option){
            .name = field->name,
            .key = field->letter ? field->letter : SETTING_FIRST_KEY + i,
            .arg = field->type == SETTING_NAME ? options->names[i] : field->argument,
            .doc = field->help,
        };
    }
    options->count = i;
}

const SettingField *setting_of_key(const SettingField *fields, int key)
{
    for (int i = 0; fields[i].name; i++)
        if (key == (fields[i].letter ? fields[i].letter : SETTING_FIRST_KEY + i))
            return &fields[i];
    return NULL;
}

void setting_take(struct argp_state *state, const SettingField *fields, const SettingField *field,
                  const char *text, void *setting)
{
    char words[SETTING_MAX_TEXT];
    GpError error = { "" };
    int length = snprintf(words, sizeof words, "%s", text ? text : "");
    for (int i = 1; i < setting_words(field) && state->next < state->argc; i++)
        length +=
            snprintf(words + length, sizeof words - (size_t)length, " %.*s",
                     (int)(sizeof words - 2) / SETTING_MAX_VECTOR, state->argv[state->next++]);
    if (setting_set(fields, setting, field->name, setting_words(field) > 1 ? words : text, &error))
        argp_error(state, "%s", error.text);
}
