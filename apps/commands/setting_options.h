/* A technique's settings as options of its command. */
#ifndef APPS_COMMANDS_SETTING_OPTIONS_H
#define APPS_COMMANDS_SETTING_OPTIONS_H

#include "apps/techniques/settings.h"

#include <argp.h>

enum { SETTING_FIRST_KEY = 0x400 };

typedef struct SettingOptions {
    struct argp_option option[SETTING_MAX_FIELDS]; /* the first `count` */
    char names[SETTING_MAX_FIELDS][96];            /* "plain|hardware": what they refer to */
    int count;
} SettingOptions;

/* Options of a table's fields, with keys SETTING_FIRST_KEY + index, or their letters. */
void setting_options(const SettingField *fields, SettingOptions *options);

/* The field of such a key, or NULL. */
const SettingField *setting_of_key(const SettingField *fields, int key);

/* Sets the member of a field from argp's argument and, of a vector, the words that follow it; a
 * usage error where they are wrong. */
void setting_take(struct argp_state *state, const SettingField *fields, const SettingField *field,
                  const char *text, void *setting);

#endif
