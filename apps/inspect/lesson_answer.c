#include "apps/inspect/lesson_answer.h"

#include "apps/base/json.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- the record ------------------------------------------------------------------------------- */

/* The fragments of the pixel, and the number of the one that is looked at among them; -1: none. */
static json_t *fragments_of(const Lesson *lesson, const RecordPass *pass, int *chosen)
{
    const Fragments *fragments = &pass->fragments;
    const uint32_t pixel = (uint32_t)lesson->y * fragments->width + (uint32_t)lesson->x;
    json_t *list = json_array();
    int last = -1;
    *chosen = -1;
    for (size_t i = 0; i < fragments->count; i++) {
        const Fragment *one = &fragments->all[i];
        if (one->pixel != pixel)
            continue;
        const int number = (int)json_array_size(list);
        if (lesson->draw < 0 && lesson->triangle < 0 && one->verdict == FRAGMENT_WRITTEN)
            *chosen = number;
        if ((lesson->draw >= 0 || lesson->triangle >= 0) &&
            (lesson->draw < 0 || lesson->draw == (int)one->draw) &&
            (lesson->triangle < 0 || lesson->triangle == (int)one->primitive) && *chosen < 0)
            *chosen = number;
        last = number;
        json_array_append_new(list, json_pack("{s:i, s:i, s:s}", "draw", (int)one->draw,
                                              "primitive", (int)one->primitive, "verdict",
                                              fragment_verdict_names[one->verdict]));
    }
    if (*chosen < 0 && lesson->draw < 0 && lesson->triangle < 0)
        *chosen = last;
    return list;
}

static const json_t *counters_of(const RecordPass *pass, long long draw)
{
    size_t i;
    json_t *stop;
    json_array_foreach(pass->stops, i, stop)
    {
        const long long first = json_whole_of(stop, "first");
        if (draw >= first && draw < first + json_whole_of(stop, "count"))
            return json_object_get(stop, "counters");
    }
    return NULL;
}

/* Pixels that a triangle covers. */
static int covered_by(const Fragments *fragments, long long draw, long long primitive)
{
    int covered = 0;
    for (size_t i = 0; i < fragments->count; i++)
        covered += fragments->all[i].draw == draw && fragments->all[i].primitive == primitive &&
                   fragments->all[i].verdict < FRAGMENT_CULLED;
    return covered;
}

static bool is_of(const json_t *event, long long draw, long long primitive)
{
    return json_whole_of(event, "draw") == draw && json_whole_of(event, "primitive") == primitive;
}

static void add_event(json_t *told, json_t *event)
{
    const char *kind = json_text_of(event, "kind");
    json_t *list = json_object_get(told, kind);
    if (json_is_array(list))
        json_array_append(list, event);
    else
        json_object_set(told, kind, event);
}

static void add_events(const Histories *histories, const Lesson *lesson, long long draw,
                       long long primitive, json_t *told)
{
    const uint32_t number =
        histories->number[(uint32_t)lesson->y * histories->width + (uint32_t)lesson->x];
    Text list = { .data = NULL };
    text_add(&list, "[%s]", histories->pixel[number - 1].events.data);
    json_t *events = list.failed ? NULL : json_loads(list.data, 0, NULL);
    size_t i;
    json_t *event;
    json_array_foreach(events, i, event)
    {
        if (is_of(event, draw, primitive))
            add_event(told, event);
    }
    json_decref(events);
    text_free(&list);
}

static GpResult no_fragment(const Lesson *lesson, GpError *error)
{
    return gp_fail(error, GP_ERROR_FORMAT,
                   "%.100s.lesson.json: no fragment%s is recorded at the pixel %d, %d",
                   lesson->name,
                   lesson->draw >= 0 || lesson->triangle >= 0 ? " of this draw and triangle" : "",
                   lesson->x, lesson->y);
}

GpResult lesson_record(const Lesson *lesson, const Record *record, json_t **told, GpError *error)
{
    const uint32_t number = lesson->pass < 0 ? record->pass_count - 1 : (uint32_t)lesson->pass;
    if (number >= record->pass_count)
        return gp_fail(error, GP_ERROR_FORMAT, "%.100s.lesson.json: pass: the scene has no pass %u",
                       lesson->name, number);
    const RecordPass *pass = &record->passes[number];
    const Histories *histories = &pass->histories;
    if (lesson->x >= (int32_t)histories->width || lesson->y >= (int32_t)histories->height ||
        !histories_want(histories, lesson->x, lesson->y))
        return no_fragment(lesson, error);
    int chosen;
    json_t *fragments = fragments_of(lesson, pass, &chosen);
    const json_t *fragment = json_array_get(fragments, chosen < 0 ? SIZE_MAX : (size_t)chosen);
    const long long draw = json_whole_of(fragment, "draw");
    const long long primitive = json_whole_of(fragment, "primitive");
    char key[64];
    snprintf(key, sizeof key, "%lld/%lld", draw, primitive);
    const json_t *place = fragment ? json_object_get(histories->primitives, key) : NULL;
    if (!place) {
        json_decref(fragments);
        return no_fragment(lesson, error);
    }
    json_t *made = json_copy(json_array_get(histories->told, (size_t)json_integer_value(place)));
    if (!made) {
        json_decref(fragments);
        return gp_fail(error, GP_ERROR_MEMORY, "no memory for a lesson");
    }
    for (int i = 0; i < 3; i++)
        json_object_set_new(made, (const char *[]){ "texture", "test", "output" }[i], json_array());
    json_object_set_new(made, "fragments", fragments);
    json_object_set_new(made, "covered",
                        json_integer(covered_by(&pass->fragments, draw, primitive)));
    json_object_set(made, "counters", (json_t *)counters_of(pass, draw));
    add_events(histories, lesson, draw, primitive, made);
    *told = made;
    return GP_OK;
}

/* --- paths ------------------------------------------------------------------------------------ */

static bool has(const json_t *element, const char *member, size_t length, const char *value,
                size_t value_length)
{
    char key[64], text[64];
    snprintf(key, sizeof key, "%.*s", (int)length, member);
    const json_t *of = json_object_get(element, key);
    if (json_is_string(of))
        snprintf(text, sizeof text, "%s", json_string_value(of));
    else if (json_is_boolean(of))
        snprintf(text, sizeof text, "%s", json_is_true(of) ? "true" : "false");
    else if (json_is_number(of))
        text_of_number(json_number_value(of), text);
    else
        return false;
    return strlen(text) == value_length && strncmp(text, value, value_length) == 0;
}

static void find(json_t *at, const char *path, json_t *found);

/* Elements of a list that a word names. */
static void find_elements(json_t *list, const char *word, size_t length, const char *rest,
                          json_t *found)
{
    const char *equals = memchr(word, '=', length);
    char *end;
    const unsigned long number = strtoul(word, &end, 10);
    size_t i;
    json_t *element;
    json_array_foreach(list, i, element)
    {
        const size_t name = equals ? (size_t)(equals - word) : 0;
        if (equals ? has(element, word, name, equals + 1, length - name - 1)
                   : (length == 1 && *word == '*') || (end == word + length && number == i))
            find(element, rest, found);
    }
}

/* Adds the values that a path names, seen from here. */
static void find(json_t *at, const char *path, json_t *found)
{
    if (!*path) {
        json_array_append(found, at);
        return;
    }
    const size_t length = strcspn(path, ".");
    const char *rest = path + length + (path[length] == '.');
    if (json_is_array(at)) {
        find_elements(at, path, length, rest, found);
        return;
    }
    char key[64];
    snprintf(key, sizeof key, "%.*s", (int)length, path);
    json_t *member = json_object_get(at, key);
    if (member)
        find(member, rest, found);
}

/* --- normal forms ----------------------------------------------------------------------------- */

static double in_units(const LessonAnswer *answer, const json_t *value)
{
    const double scaled = json_number_value(value) * answer->times * pow(10, answer->places);
    return copysign(floor(fabs(scaled) + 0.5), scaled) + 0.0;
}

static int by_size(const void *a, const void *b)
{
    const double one = *(const double *)a, other = *(const double *)b;
    return (one > other) - (one < other);
}

static bool write_numbers(const LessonAnswer *answer, const json_t *found,
                          char text[LESSON_ANSWER_TEXT])
{
    enum { MOST = 16 };
    double all[MOST];
    const size_t count = json_array_size(found);
    if (count > (answer->form == LESSON_SET ? MOST : 1))
        return false;
    for (size_t i = 0; i < count; i++) {
        if (!json_is_number(json_array_get(found, i)))
            return false;
        all[i] = in_units(answer, json_array_get(found, i));
    }
    qsort(all, count, sizeof *all, by_size);
    size_t at = 0;
    for (size_t i = 0; i < count && at < LESSON_ANSWER_TEXT; i++)
        if (!i || all[i] != all[i - 1])
            at += (size_t)snprintf(text + at, LESSON_ANSWER_TEXT - at, "%s%.0f", i ? " " : "",
                                   all[i] == 0 ? 0 : all[i]);
    return at < LESSON_ANSWER_TEXT;
}

/* "none" where what is recorded is null. */
static bool write_choice(const LessonAnswer *answer, const json_t *found,
                         char text[LESSON_ANSWER_TEXT])
{
    const json_t *value = json_array_get(found, 0);
    if (json_array_size(found) != 1)
        return false;
    if (json_is_number(value))
        text_of_number(json_number_value(value), text);
    else
        snprintf(text, LESSON_ANSWER_TEXT, "%s",
                 json_is_string(value) ? json_string_value(value)
                 : json_is_true(value) ? "true"
                 : json_is_null(value) ? "none"
                                       : "false");
    size_t i;
    json_t *choice;
    json_array_foreach(answer->choices, i, choice)
    {
        if (strcmp(json_text_of(choice, "value"), text) == 0)
            return true;
    }
    return false;
}

GpResult lesson_answer(const Lesson *lesson, const json_t *told, char text[LESSON_ANSWER_TEXT],
                       GpError *error)
{
    const LessonAnswer *answer = &lesson->answer;
    json_t *found = json_array();
    find((json_t *)told, answer->from, found);
    const size_t count = json_array_size(found);
    bool right = count > 0;
    if (answer->count)
        snprintf(text, LESSON_ANSWER_TEXT, "%zu", count);
    else
        right = right && (answer->choices ? write_choice(answer, found, text)
                                          : write_numbers(answer, found, text));
    json_decref(found);
    return right
               ? GP_OK
               : gp_fail(error, GP_ERROR_FORMAT,
                         "%.100s.lesson.json: answer.from: %.100s names %zu values, or none of the "
                         "form %s",
                         lesson->name, answer->from, count, lesson_form_names[answer->form]);
}

void lesson_hash(const Lesson *lesson, const char *text, char hash[17])
{
    const char *const parts[] = { lesson->name, "\n", text };
    uint64_t state = 0xcbf29ce484222325u;
    for (size_t i = 0; i < GP_COUNT(parts); i++)
        for (const char *at = parts[i]; *at; at++)
            state = (state ^ (uint8_t)*at) * 0x100000001b3u;
    snprintf(hash, 17, "%016llx", (unsigned long long)state);
}

/* --- telling ---------------------------------------------------------------------------------- */

static json_t *list_or_empty(json_t *list)
{
    return list ? json_incref(list) : json_array();
}

/* What is asked for is hidden, where nothing else is said. */
static json_t *hidden(const Lesson *lesson)
{
    return lesson->hide ? json_incref(lesson->hide) : json_pack("[s]", lesson->answer.from);
}

GpResult lesson_tell(const Lesson *lesson, const Record *record, Blobs *blobs, json_t **told,
                     GpError *error)
{
    const LessonAnswer *answer = &lesson->answer;
    char text[LESSON_ANSWER_TEXT], hash[17];
    json_t *values;
    GpResult result = lesson_record(lesson, record, &values, error);
    if (result)
        return result;
    result = lesson_answer(lesson, values, text, error);
    if (!result) {
        lesson_hash(lesson, text, hash);
        *told = json_pack(
            "{s:o, s:s, s:s, s:s, s:i, s:i, s:i, s:o, s:o, s:s, s:o, s:o, s:o, s:s, s:i, s:o, s:s, "
            "s:o, s:o, s:o, s:i, s:i}",
            "name", json_text(lesson->name), "title", lesson->title, "learn", lesson->learn, "unit",
            lesson->unit, "pass", lesson->pass < 0 ? (int)record->pass_count - 1 : lesson->pass,
            "x", lesson->x, "y", lesson->y, "draw", json_incref(json_object_get(values, "draw")),
            "triangle", json_incref(json_object_get(values, "primitive")), "question",
            lesson->question, "look", list_or_empty(lesson->look), "hide", hidden(lesson), "hint",
            json_text(lesson->hint), "form", lesson_form_names[answer->form], "places",
            answer->places, "choices", list_or_empty(answer->choices), "hash", hash, "previous",
            json_text(lesson->previous), "next", json_text(lesson->next), "index",
            json_text(lesson->index), "why", blobs_add_json(blobs, json_string(lesson->why)),
            "step", lesson->step);
    }
    json_decref(values);
    if (!result && !*told)
        result = gp_fail(error, GP_ERROR_MEMORY, "no memory for a lesson");
    return result;
}
