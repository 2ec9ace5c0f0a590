#include "apps/commands/command.h"

#include <string.h>

enum { FIRST_KEY = 0x200 };

typedef struct Parse {
    const CommandSyntax *syntax;
    char *args;
    int count; /* of positional arguments */
} Parse;

static int key_of(const CommandOption *options, int i)
{
    return options[i].letter ? options[i].letter : FIRST_KEY + i;
}

static const CommandOption *find(const CommandOption *options, int key)
{
    for (int i = 0; options && options[i].name; i++)
        if (key_of(options, i) == key)
            return &options[i];
    return NULL;
}

static void set(struct argp_state *state, const CommandOption *option, const char *text, char *args)
{
    const bool given = true;
    char what[40];
    snprintf(what, sizeof what, "--%s", option->name);
    const double real = option->type == OPTION_REAL ? options_real(state, what, text) : 0;
    switch (option->type) {
    case OPTION_FLAG:
        memcpy(args + option->offset, &given, sizeof given);
        break;
    case OPTION_TEXT:
        memcpy(args + option->offset, &text, sizeof text);
        break;
    case OPTION_REAL:
        memcpy(args + option->offset, &real, sizeof real);
        break;
    }
}

static void take_positional(struct argp_state *state, Parse *parse, const char *text)
{
    const CommandSyntax *syntax = parse->syntax;
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
    const CommandOption *option = find(syntax->options, key);
    if (option) {
        set(state, option, text, parse->args);
        return 0;
    }
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = parse->args;
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
        return ARGP_ERR_UNKNOWN;
    }
}

void command_parse(const CommandSyntax *syntax, int argc, char **argv, void *args)
{
    const CommandOption *options = syntax->options;
    struct argp_option own[COMMAND_MAX_OPTIONS + 1] = { { .name = NULL } };
    for (int i = 0; options && options[i].name; i++) {
        GP_ASSERT(i < COMMAND_MAX_OPTIONS);
        own[i] = (struct argp_option){ .name = options[i].name,
                                       .key = key_of(options, i),
                                       .arg = options[i].argument,
                                       .doc = options[i].help };
    }
    const struct argp_child children[] = { { syntax->shared, 0, NULL, 0 }, { .argp = NULL } };
    const struct argp parser = { own,          parse_key, syntax->arguments, syntax->help, children,
                                 options_help, NULL };
    Parse parse = { .syntax = syntax, .args = args };
    options_parse(&parser, argc, argv, &parse);
}
