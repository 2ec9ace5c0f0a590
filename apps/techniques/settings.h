/* Settings of a technique as a table: the same fields serve the command's options, the sweeps of
 * charts and the text by which a chart names its points.
 *
 * A setting is a plain struct of the technique's own; a field says how one member is called and
 * what it may hold. A setting as text is what a user would type: "--method hardware --map 2048". It
 * is the key of a chart's point, and has the fields that say how a frame is made; those that say of
 * what, or how the result is looked at, lie aside of it.
 */
#ifndef APPS_TECHNIQUES_SETTINGS_H
#define APPS_TECHNIQUES_SETTINGS_H

#include "pipeline/base/base.h"

typedef enum SettingType {
    SETTING_NAME = 1, /* an enumeration that counts from 0: number of a name */
    SETTING_INTEGER,  /* uint32_t in low..high */
    SETTING_NUMBER,   /* double in low..high */
    SETTING_FLAG,     /* bool: there, or not; without a value */
    SETTING_SIZE,     /* uint32_t[2], each in 1..high: WIDTHxHEIGHT */
    SETTING_VECTOR,   /* double[count], each in low..high: so many words */
    SETTING_TEXT,     /* const char *, borrowed; one of the names, if any; aside of the key */
} SettingType;

typedef struct SettingField {
    const char *name;     /* "map": the option --map; NULL ends a table */
    const char *argument; /* "N", for the help; NULL: the names, or none */
    const char *help;
    SettingType type;
    size_t offset;
    double low, high;         /* of integers, numbers and vectors, both included */
    const char *const *names; /* of SETTING_NAME and SETTING_TEXT, NULL at the end */
    int count;                /* of SETTING_VECTOR: at most SETTING_MAX_VECTOR */
    char letter;              /* 'n': the option -n too; 0: none */
    bool aside;               /* no part of the key */
    bool for_pictures;        /* of use only where the result is written as a picture */
} SettingField;

enum { SETTING_MAX_FIELDS = 32, SETTING_MAX_TEXT = 256, SETTING_MAX_VECTOR = 4 };

/* Room for a key. */
typedef char SettingText[SETTING_MAX_TEXT];

/* The field of a name, or NULL. */
const SettingField *setting_find(const SettingField *fields, const char *name);

/* Whether the field of a name is among those of a set: bit i stands for fields[i]. */
bool setting_is_given(const SettingField *fields, uint32_t given, const char *name);

/* Words of the field's value: 0 of a flag, `count` of a vector, else 1. */
int setting_words(const SettingField *field);

/* Bytes of the field's member. */
size_t setting_bytes(const SettingField *field);

/* Sets one member from text, the words of a vector with spaces between; a flag, whatever it is.
 * errors GP_ERROR_INVALID, with what was expected, in argp's style: "--map: expected a whole number
 *        from 16 to 8192, not '3x'" */
GpResult setting_set(const SettingField *fields, void *setting, const char *name, const char *text,
                     GpError *error);

/* Sets every member that a key names: "--map 1024 --bias 0.001"; "--map=1024" works too.
 * errors GP_ERROR_INVALID: as above, an option without value, none of the key; nothing is then
 *      set */
GpResult setting_parse(const SettingField *fields, void *setting, const char *text, GpError *error);

/* The key of a setting: the members that differ from `defaults`, in the table's order; numbers with
 * as many digits as restore them. Empty where none differs.
 * in   defaults: NULL: all members are printed but flags that are not set, and numbers beside their
 *      range, by which a setting says that they are to be chosen
 * in   size: of text; longer texts are cut */
void setting_print(const SettingField *fields, const void *setting, const void *defaults,
                   char *text, size_t size);

/* "plain|hardware|soft". */
void setting_list_names(const SettingField *field, char *list, size_t size);

#endif
