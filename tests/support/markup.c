#include "tests/support/markup.h"

#include "tests/support/unit.h"

#include "pipeline/base/base.h"

#include <ctype.h>
#include <stdio.h>

int markup_count(const char *text, const char *part)
{
    int count = 0;
    for (const char *at = text; (at = strstr(at, part)); at++)
        count++;
    return count;
}

/* Behind an element's name: attributes NAME="..." until > or />. Returns the > */
static const char *check_attributes(const char *at)
{
    while (isspace((unsigned char)*at)) {
        at += strspn(at, " \n");
        at += strspn(at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-");
        if (*at != '=')
            continue;
        assert_int_equal(at[1], '"');
        at += 2 + strcspn(at + 2, "\"<");
        assert_int_equal(*at++, '"');
    }
    at += *at == '/';
    if (*at != '>')
        fail_msg("not an element's end: %.40s", at);
    return at;
}

static void check_entity(const char *at)
{
    static const char *const known[] = { "&amp;", "&lt;", "&gt;", "&quot;", "&#39;" };
    for (size_t i = 0; i < GP_COUNT(known); i++)
        if (strncmp(at, known[i], strlen(known[i])) == 0)
            return;
    fail_msg("a bare &: %.40s", at);
}

void markup_check(const char *text)
{
    char open[32][32];
    int depth = 0;
    for (const char *at = text; *at; at++) {
        if (*at == '&')
            check_entity(at);
        if (*at != '<')
            continue;
        bool closes = at[1] == '/';
        const char *name = at + 1 + closes;
        size_t length = strcspn(name, " \n/>");
        if (*name == '!') {
            at = strchr(at, '>');
            continue;
        }
        at = check_attributes(name + length);
        bool single = at[-1] == '/' || strncmp(name, "meta", length) == 0 ||
                      strncmp(name, "img", length) == 0 || strncmp(name, "input", length) == 0;
        if (closes) {
            assert_true(depth-- > 0);
            if (strncmp(open[depth], name, length) != 0 || open[depth][length])
                fail_msg("</%.*s> closes <%s>", (int)length, name, open[depth]);
        } else if (!single) {
            assert_true(length > 0 && length < sizeof open[0] && depth < 32);
            snprintf(open[depth++], sizeof open[0], "%.*s", (int)length, name);
        }
    }
    assert_int_equal(depth, 0);
}
