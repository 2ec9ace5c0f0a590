#include "apps/commands/command.h"

#include "apps/base/text.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MAX_TABLES = 5,
    MAX_OPTIONS = 64,
    KEY_USAGE = 0x100, /* options without a letter */
    KEY_VERSION,
    FIRST_KEY = 0x200, /* and SETTING_MAX_FIELDS for each table */
};

/* Negative numbers are arguments, which their commands know what to say of. */
#define DIGIT(digit)                                                                               \
    {                                                                                              \
        .key = digit, .arg = "", .flags = OPTION_HIDDEN | OPTION_ARG_OPTIONAL                      \
    }

static const struct argp_option help_options[] = {
    DIGIT('0'),
    DIGIT('1'),
    DIGIT('2'),
    DIGIT('3'),
    DIGIT('4'),
    DIGIT('5'),
    DIGIT('6'),
    DIGIT('7'),
    DIGIT('8'),
    DIGIT('9'),
    { "help", 'h', NULL, 0, "Show this help", -1 },
    { "usage", KEY_USAGE, NULL, 0, "Show a short usage line", -1 },
    { "version", KEY_VERSION, NULL, 0, "Show the version", -1 },
    { .name = NULL },
};

typedef struct Parse {
    const CommandSyntax *syntax;
    CommandOptions *tables[MAX_TABLES];
    int table_count;
    char *args;
    int count; /* of positional arguments */
} Parse;

/* --- options ---------------------------------------------------------------------------------- */

static int key_of(const Parse *parse, int table, int i)
{
    const SettingField *field = &parse->tables[table]->fields[i];
    return field->letter ? field->letter : FIRST_KEY + table * SETTING_MAX_FIELDS + i;
}

/* "plain|hardware"; "NAME" where that is more than a line of the help holds, which argp cannot
 * break. */
static const char *name_argument(const SettingField *field, char text[96])
{
    setting_list_names(field, text, 96);
    return strlen(text) > 62 ? "NAME" : text;
}

/* What argp is told of them; text: what it refers to. */
static void list_options(const Parse *parse, struct argp_option options[MAX_OPTIONS],
                         char text[MAX_OPTIONS][96])
{
    size_t count = 0;
    for (int table = 0; table < parse->table_count; table++) {
        const SettingField *fields = parse->tables[table]->fields;
        for (int i = 0; fields[i].name; i++, count++) {
            GP_ASSERT(i < SETTING_MAX_FIELDS && count < MAX_OPTIONS - GP_COUNT(help_options));
            options[count] = (struct argp_option){
                .name = fields[i].name,
                .key = key_of(parse, table, i),
                .arg = fields[i].names && !fields[i].argument
                           ? name_argument(&fields[i], text[count])
                           : fields[i].argument,
                .doc = fields[i].help,
            };
        }
    }
    memcpy(options + count, help_options, sizeof help_options);
}

/* Words of a text; an empty one counts as one, which is wrong. */
static int count_words(const char *text)
{
    int count = 0;
    for (text += strspn(text, " "); *text; text += strspn(text, " ")) {
        text += strcspn(text, " ");
        count++;
    }
    return count ? count : 1;
}

/* Sets the member of a field from argp's argument and, of a vector, the words that follow it where
 * it has not all. */
static void set(struct argp_state *state, CommandOptions *table, int i, const char *text)
{
    const SettingField *field = &table->fields[i];
    Text words = { .data = NULL };
    GpError error = { "" };
    if (setting_words(field) > 1) {
        text_add(&words, "%s", text);
        for (int word = count_words(text); word < setting_words(field) && state->next < state->argc;
             word++)
            text_add(&words, " %s", state->argv[state->next++]);
        if (words.failed)
            argp_failure(state, EXIT_INTERNAL, 0, "out of memory");
        text = words.data;
    }
    if (setting_set(table->fields, table->object, field->name, text, &error))
        argp_error(state, "%s", error.text);
    text_free(&words);
    table->given |= 1u << i;
}

static bool take_option(struct argp_state *state, const Parse *parse, int key, const char *text)
{
    for (int table = 0; table < parse->table_count; table++)
        for (int i = 0; parse->tables[table]->fields[i].name; i++)
            if (key_of(parse, table, i) == key) {
                set(state, parse->tables[table], i, text);
                return true;
            }
    return false;
}

/* --- arguments -------------------------------------------------------------------------------- */

static void take_positional(struct argp_state *state, Parse *parse, const char *text)
{
    const CommandSyntax *syntax = parse->syntax;
    if (!text[0])
        argp_error(state, "an argument is empty: expected a name or a number");
    if (syntax->take)
        syntax->take(state, parse->args, text);
    else if (parse->count == syntax->most)
        argp_error(state, "unexpected argument '%s'", text);
    else
        memcpy(parse->args + syntax->offset + (size_t)parse->count * sizeof text, &text,
               sizeof text);
    parse->count++;
}

static error_t parse_key(int key, char *text, struct argp_state *state)
{
    Parse *parse = state->input;
    const CommandSyntax *syntax = parse->syntax;
    switch (key) {
    case 'h':
        argp_state_help(state, stdout, ARGP_HELP_STD_HELP);
        return 0;
    case KEY_USAGE:
        argp_state_help(state, stdout, ARGP_HELP_USAGE | ARGP_HELP_EXIT_OK);
        return 0;
    case KEY_VERSION:
        puts("glasspipe " GP_VERSION);
        exit(EXIT_DONE);
    case '0' ... '9':
        take_positional(state, parse, state->argv[state->next - 1]);
        return 0;
    case ARGP_KEY_ARG:
        take_positional(state, parse, text);
        return 0;
    case ARGP_KEY_END:
        if (parse->count < syntax->least)
            argp_error(state, "expected %s", syntax->expected);
        if (syntax->check)
            syntax->check(state, parse->args);
        return 0;
    default:
        return take_option(state, parse, key, text) ? 0 : ARGP_ERR_UNKNOWN;
    }
}

/* Drops argp's note about arguments of short options. */
static char *filter_help(int key, const char *text, void *args)
{
    (void)args;
    return key == ARGP_KEY_HELP_DUP_ARGS_NOTE ? NULL : (char *)text;
}

void command_parse(const CommandSyntax *syntax, CommandOptions *more, int argc, char **argv,
                   void *args)
{
    CommandOptions own = { .fields = syntax->options, .object = args };
    CommandOptions shared[] = { { .fields = options_common, .object = args },
                                { .fields = options_run, .object = args },
                                { .fields = options_frame, .object = args } };
    Parse parse = { .syntax = syntax, .args = args };
    for (int i = 0; i <= (int)syntax->shared; i++)
        parse.tables[parse.table_count++] = &shared[i];
    if (own.fields)
        parse.tables[parse.table_count++] = &own;
    if (more)
        parse.tables[parse.table_count++] = more;

    struct argp_option options[MAX_OPTIONS];
    char text[MAX_OPTIONS][96];
    list_options(&parse, options, text);
    const struct argp parser = { .options = options,
                                 .parser = parse_key,
                                 .args_doc = syntax->arguments,
                                 .doc = syntax->help,
                                 .help_filter = filter_help };
    argp_err_exit_status = EXIT_USAGE;
    /* argp's own help has no -h, hence ARGP_NO_HELP; negative numbers keep their place among
     * arguments. */
    if (argp_parse(&parser, argc, argv, ARGP_NO_HELP | ARGP_IN_ORDER, NULL, &parse))
        exit(report(EXIT_INTERNAL, "out of memory"));
}

long command_number(struct argp_state *state, const char *what, const char *text, long low,
                    long high)
{
    char *end;
    errno = 0;
    long value = strtol(text, &end, 10);
    bool digits = text[0] >= '0' && text[0] <= '9' && *end == '\0';
    if (!digits || errno || value < low || value > high)
        argp_error(state, "%s: '%s' is not a whole number in [%ld, %ld]", what, text, low, high);
    return value;
}
