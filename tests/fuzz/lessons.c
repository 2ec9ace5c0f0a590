/* Lessons of `glasspipe inspect`, and the paths in them, by which they name values of what was
 * recorded. */
#include "apps/inspect/lesson.h"
#include "apps/inspect/lesson_answer.h"
#include "tests/fuzz/targets.h"

#include <string.h>

/* A record with a value of each kind, and numbers of any size. */
static const char recorded[] =
    "{ \"draw\": 0, \"primitive\": 1, \"covered\": 12, \"null\": null,"
    "  \"vertices\": [ { \"vertex\": 0, \"reuse\": 2, \"position\": [0, 0.5, -1e38, 1] },"
    "                  { \"vertex\": 2, \"reuse\": 1, \"position\": [3e38, 1, 2, 3e-39] } ],"
    "  \"clip\": { \"corners\": 3, \"inside\": true, \"many\": [1e30, 2e30, 3e30, 4e30, 5e30, "
    "6e30, 7e30, 8e30,"
    "             1e31, 2e31, 3e31, 4e31, 5e31, 6e31, 7e31, 8e31] },"
    "  \"test\": [ { \"name\": \"depth\", \"passed\": true }, { \"name\": \"stencil\", \"passed\": "
    "false } ] }";

static bool run_lesson(const uint8_t *data, size_t size)
{
    static json_t *told;
    char text[LESSON_ANSWER_TEXT], hash[17];
    Lesson lesson;
    GpError error = { "" };
    if (!told)
        told = json_loads(recorded, 0, NULL);
    fuzz_claim(told != NULL, "the record is JSON");
    if (!fuzz_accepted(lesson_open(fuzz_file(".lesson.json", data, size), &lesson, &error), &error))
        return false;
    if (fuzz_accepted(lesson_answer(&lesson, told, text, &error), &error)) {
        fuzz_claim(memchr(text, '\0', sizeof text) != NULL, "an answer ends");
        lesson_hash(&lesson, text, hash);
    }
    lesson_close(&lesson);
    return true;
}

#define LESSON(answer)                                                                             \
    "{ \"title\": \"t\", \"learn\": \"l\", \"unit\": \"u\", \"pixel\": [9, 6], \"triangle\": 1,"   \
    " \"question\": \"q\", \"why\": \"w\", \"look\": [\"a\"], \"answer\": { " answer " } }"

static void seeds_lesson(const FuzzSeeds *to)
{
    fuzz_seed_text(to, "whole", LESSON("\"from\": \"clip.corners\", \"form\": \"whole\""));
    fuzz_seed_text(to, "set", LESSON("\"from\": \"clip.many.*\", \"form\": \"set\""));
    fuzz_seed_text(to, "decimal",
                   LESSON("\"from\": \"vertices.reuse=2.position.1\", \"form\": \"decimal\","
                          " \"times\": 255, \"places\": 2"));
    fuzz_seed_text(to, "choice",
                   LESSON("\"from\": \"test.name=depth.passed\", \"form\": \"choice\", \"choices\":"
                          " [ { \"value\": \"true\", \"text\": \"a\" }, { \"value\": \"false\","
                          " \"text\": \"b\" } ]"));
    fuzz_seed_text(to, "count",
                   LESSON("\"from\": \"vertices.*\", \"form\": \"whole\", \"count\": true"));
}

const FuzzTarget fuzz_lesson = { "lesson", 2048, run_lesson, seeds_lesson, fuzz_mutate_json };
