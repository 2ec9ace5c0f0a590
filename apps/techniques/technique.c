#include "apps/techniques/technique.h"

#include <stdio.h>
#include <string.h>

GpResult technique_open(const Technique *technique, const char *path, uint32_t width,
                        uint32_t height, void **scene, GpError *error)
{
    const TechniqueInput input = {
        .path = path, .width = width, .height = height, .setting = technique->defaults
    };
    return technique->open(&input, scene, error);
}

GpResult technique_setting(const Technique *technique, const char *options, void **setting,
                           GpError *error)
{
    void *parsed = gp_alloc(1, technique->setting_bytes);
    if (!parsed)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    memcpy(parsed, technique->defaults, technique->setting_bytes);
    GpResult result = setting_parse(technique->settings, parsed, options, error);
    if (result)
        gp_free(parsed);
    else
        *setting = parsed;
    return result;
}

GpResult technique_build(const Technique *technique, void *scene, const char *options,
                         GpDevice *device, Frame *frame, GpError *error)
{
    void *setting;
    GpResult result = technique_setting(technique, options, &setting, error);
    if (result)
        return result;
    result = technique->build(scene, setting, device, frame, error);
    gp_free(setting);
    return result;
}

/* --- sweeps ----------------------------------------------------------------------------------- */

/* A word of a sweep's text: what all combinations have, "--map=" or nothing, and the list. */
typedef struct Word {
    const char *begin, *list, *end;
    size_t count; /* of alternatives */
} Word;

static size_t split(const char *options, Word *words, size_t room)
{
    size_t count = 0;
    for (const char *at = options + strspn(options, " "); *at; at += strspn(at, " ")) {
        GP_ASSERT(count < room);
        Word word = { .begin = at, .list = at, .count = 1 };
        at += strcspn(at, " ");
        word.end = at;
        const char *equals = memchr(word.begin, '=', (size_t)(at - word.begin));
        if (equals)
            word.list = equals + 1;
        for (const char *c = word.list; c < word.end; c++)
            word.count += *c == '|';
        words[count++] = word;
    }
    return count;
}

/* Appends a word with one of its alternatives; returns the length of the text. */
static size_t append(const Word *word, size_t alternative, char *text, size_t length)
{
    const char *value = word->list, *end;
    for (; alternative > 0; alternative--)
        value = strchr(value, '|') + 1;
    for (end = value; end < word->end && *end != '|'; end++)
        ;
    length +=
        (size_t)snprintf(text + length, SETTING_MAX_TEXT - length, "%s%.*s%.*s", length ? " " : "",
                         (int)(word->list - word->begin), word->begin, (int)(end - value), value);
    GP_ASSERT(length < SETTING_MAX_TEXT);
    return length;
}

size_t technique_expand(const char *options, SettingText *texts, size_t room)
{
    Word words[2 * SETTING_MAX_FIELDS];
    size_t count = split(options, words, GP_COUNT(words)), total = 1;
    for (size_t i = 0; i < count; i++)
        total *= words[i].count;
    for (size_t k = 0; k < total && k < room; k++) {
        size_t length = 0, period = total, rest = k;
        texts[k][0] = '\0';
        for (size_t i = 0; i < count; i++) {
            period /= words[i].count;
            length = append(&words[i], rest / period, texts[k], length);
            rest %= period;
        }
    }
    return total;
}

GpResult technique_expand_all(const char *options, SettingText **texts, size_t *count,
                              GpError *error)
{
    *count = technique_expand(options, NULL, 0);
    *texts = gp_alloc(*count, sizeof **texts);
    if (!*texts)
        return gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    technique_expand(options, *texts, *count);
    return GP_OK;
}

const char *technique_word(const TechniqueWord *words, const char *word)
{
    for (; words && words->word; words++)
        if (strcmp(words->word, word) == 0)
            return words->sentence;
    return NULL;
}
