/* Settings of a technique as a table: the same fields serve the command's options, the sweeps of
 * charts and the text by which a chart names its points.
 *
 * A setting is a plain struct of the technique's own; a field says how one member is called and what
 * it may hold. A setting as text is what a user would type: "--method hardware --map 2048".
 */
#ifndef APPS_TECHNIQUES_SETTINGS_H
#define APPS_TECHNIQUES_SETTINGS_H

#include "pipeline/base/base.h"

#include <argp.h>

typedef enum SettingType {
    SETTING_NAME = 1, /* int: number of a name */
    SETTING_INTEGER,  /* uint32_t in low..high */
    SETTING_NUMBER,   /* double in low..high */
} SettingType;

typedef struct SettingField {
    const char *name;     /* "map": the option --map; NULL ends a table */
    const char *argument; /* "N", for the help */
    const char *help;
    SettingType type;
    size_t offset;
    double low, high;         /* of integers and numbers, both included */
    const char *const *names; /* of SETTING_NAME, NULL at the end */
} SettingField;

enum { SETTING_MAX_FIELDS = 24, SETTING_MAX_TEXT = 256, SETTING_FIRST_KEY = 0x400 };

/* Sets one member from text.
 * errors GP_ERROR_INVALID, with what was expected, in argp's style: "--map: expected a whole number
 *        from 16 to 8192, not '3x'" */
GpResult setting_set(const SettingField *fields, void *setting, const char *name, const char *text,
                     GpError *error);

/* Sets every member that a text of options names: "--map 1024 --bias 0.001"; "--map=1024" works too.
 * errors GP_ERROR_INVALID: as above, an option without value, no such option */
GpResult setting_parse(const SettingField *fields, void *setting, const char *text, GpError *error);

/* The text of a setting: the members that differ from `defaults`, in the table's order; numbers with
 * as many digits as restore them. Empty where none differs.
 * in   size: of text; longer texts are cut */
void setting_print(const SettingField *fields, const void *setting, const void *defaults,
                   char *text, size_t size);

/* Fills argp options with keys SETTING_FIRST_KEY + index, and the empty one at the end.
 * in   options: at least one more than there are fields */
void setting_options(const SettingField *fields, struct argp_option *options);

/* The field of such a key, or NULL. */
const SettingField *setting_of_key(const SettingField *fields, int key);

#endif
