/* The scene format: what the reader says of itself (render --schema), the man page, and what is
 * accepted, held against each other. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

#include <math.h>

static json_t *schema;

static json_t *definition(const char *name)
{
    json_t *all = json_object_get(schema, "definitions");
    return strcmp(name, "scene") == 0 ? schema : json_object_get(all, name);
}

static int read_schema(void)
{
    json_decref(schema);
    assert_int_equal(shell("glasspipe render --schema"), 0);
    schema = parse_output();
    return 0;
}

/* --- the man page ----------------------------------------------------------------------------- */

static const char *string_of(const json_t *object, const char *key)
{
    const char *text = json_string_value(json_object_get(object, key));
    return text ? text : "";
}

static void append(char *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void append(char *text, const char *format, ...)
{
    const size_t used = strlen(text);
    va_list args;
    va_start(args, format);
    vsnprintf(text + used, 1000 - used, format, args);
    va_end(args);
}

static void append_value(char *text, const json_t *value)
{
    size_t i;
    json_t *one;
    if (json_is_string(value))
        append(text, "%s", json_string_value(value));
    else if (json_is_boolean(value))
        append(text, "%s", json_is_true(value) ? "true" : "false");
    else if (json_is_number(value))
        append(text, "%.7g", json_number_value(value));
    else {
        json_array_foreach(value, i, one)
        {
            append(text, i ? ", " : "[");
            append_value(text, one);
        }
        append(text, "]");
    }
}

static void append_number(char *text, const json_t *type, const char *noun)
{
    append(text, "%s%s, %.7g to %.7g",
           strcmp(string_of(type, "type"), "integer") == 0 ? "whole " : "", noun,
           json_number_value(json_object_get(type, "minimum")),
           json_number_value(json_object_get(type, "maximum")));
}

static void append_type(char *text, const json_t *type);

static void append_array(char *text, const json_t *type)
{
    const json_t *items = json_object_get(type, "items");
    const json_t *least = json_object_get(type, "minItems"),
                 *most = json_object_get(type, "maxItems");
    const int count = (int)json_integer_value(most);
    if (least && json_object_get(items, "minimum")) {
        append(text, "%d ", count);
        append_number(text, items, "numbers");
        return;
    }
    if (least)
        append(text, "%d of ", count);
    else if (most)
        append(text, "list of up to %d of ", count);
    else
        append(text, "list of ");
    append_type(text, items);
}

/* A schema in words, as the man page has it under each key. */
static void append_type(char *text, const json_t *type)
{
    size_t i;
    json_t *one, *names = json_object_get(type, "enum"), *value = json_object_get(type, "default");
    const char *name = string_of(type, "type");
    json_array_foreach(json_object_get(type, "anyOf"), i, one)
    {
        append(text, i ? " or " : "");
        append_type(text, one);
    }
    if (json_object_get(type, "$ref"))
        append(text, "object %s", strrchr(string_of(type, "$ref"), '/') + 1);
    else if (json_object_get(type, "const"))
        append(text, "false");
    else if (strcmp(name, "boolean") == 0)
        append(text, "true or false");
    else if (names)
        json_array_foreach(names, i, one)
            append(text, "%s%s", i ? ", " : "one of ", json_string_value(one));
    else if (strcmp(name, "string") == 0)
        append(text, "text");
    else if (strcmp(name, "array") == 0)
        append_array(text, type);
    else if (name[0])
        append_number(text, type, "number");
    if (value) {
        append(text, "; default ");
        append_value(text, value);
    }
}

/* The schema of a section: of "material phong" that alternative. */
static json_t *section_of(const char *title)
{
    size_t i;
    json_t *one;
    if (strncmp(title, "material ", 9) != 0)
        return definition(title);
    json_array_foreach(json_object_get(definition("material"), "anyOf"), i,
                       one) if (strcmp(string_of(one, "title"), title + 9) == 0) return one;
    return NULL;
}

static bool is_required(const json_t *object, const char *key)
{
    size_t i;
    json_t *one;
    json_array_foreach(json_object_get(object, "required"), i,
                       one) if (strcmp(json_string_value(one), key) == 0) return true;
    return false;
}

/* The keys of a section, crossed off. returns how many */
static int check_section(const char *title, char **rest)
{
    json_t *section = section_of(title), *left, *value;
    if (!section)
        fail_msg("the man page has a section '%s', the format has not", title);
    const char *key;
    left = json_copy(json_object_get(section, "properties"));
    const int count = (int)json_object_size(left);
    for (char *line; *rest && strncmp(*rest, ".S", 2) != 0;) {
        line = strsep(rest, "\n");
        if (strncmp(line, ".B ", 3) != 0)
            continue;
        char expected[1000] = "";
        value = json_object_get(left, line + 3);
        if (!value)
            fail_msg("%s: the man page has a key '%s', the format has not", title, line + 3);
        append_type(expected, value);
        append(expected, "%s", is_required(section, line + 3) ? "; required" : "");
        const char *told = strsep(rest, "\n");
        if (strcmp(told, expected) != 0)
            fail_msg("%s, %s: the man page says\n%s\nand the format is\n%s", title, line + 3, told,
                     expected);
        json_object_del(left, line + 3);
    }
    json_object_foreach(left, key, value)
        fail_msg("%s: '%s' is missing in the man page", title, key);
    json_decref(left);
    return count;
}

static void the_man_page_has_every_key_with_its_type_range_and_default(void **state)
{
    (void)state;
    static char page[1 << 16];
    int sections = 0, keys = 0;
    read_schema();
    read_man_page("glasspipe-scene.5", page, sizeof page);
    for (char *rest = page; rest;) {
        char *line = strsep(&rest, "\n");
        if (strncmp(line, ".SS ", 4) != 0)
            continue;
        keys += check_section(line + 4, &rest);
        sections++;
    }
    /* all but quad_material, which has the same programs */
    const size_t definitions = json_object_size(json_object_get(schema, "definitions"));
    const size_t programs = json_array_size(json_object_get(definition("material"), "anyOf"));
    assert_int_equal(sections, 1 + definitions - 2 + programs);
    assert_true(keys > 100);
}

static void the_man_page_has_the_names_of_everything_built_in(void **state)
{
    (void)state;
    static char page[1 << 16];
    read_schema();
    read_man_page("glasspipe-scene.5", page, sizeof page);
    json_t *object = json_object_get(definition("object"), "properties");
    json_t *mesh = json_array_get(json_object_get(json_object_get(object, "mesh"), "anyOf"), 1);
    json_t *lists[] = { mesh, json_object_get(object, "points"),
                        json_object_get(json_object_get(definition("texture"), "properties"),
                                        "image") };
    static const char *const keys[] = { "mesh", "points", "image" };
    const char *at = strstr(page, ".SH BUILTINS");
    for (int k = 0; k < 3; k++) {
        char expected[400], *text = expected;
        size_t i;
        json_t *name;
        text += sprintf(text, ".B %s\n", keys[k]);
        json_array_foreach(json_object_get(lists[k], "examples"), i, name) text +=
            sprintf(text, "%s%s", i ? ", " : "", json_string_value(name) + 8);
        assert_true(i >= 2);
        expect_contains(at, expected);
    }
}

/* --- what is accepted ------------------------------------------------------------------------- */

static bool fits(const json_t *type, const json_t *value);

static bool has_type(const char *type, const json_t *value)
{
    return strcmp(type, "number") == 0    ? json_is_number(value)
           : strcmp(type, "integer") == 0 ? json_is_integer(value)
           : strcmp(type, "string") == 0  ? json_is_string(value)
           : strcmp(type, "boolean") == 0 ? json_is_boolean(value)
           : strcmp(type, "array") == 0   ? json_is_array(value)
                                          : json_is_object(value);
}

static bool object_fits(const json_t *type, json_t *value)
{
    const char *key;
    size_t i;
    json_t *one, *known = json_object_get(type, "properties");
    json_object_foreach(value, key, one) if (!json_object_get(known, key) ||
                                             !fits(json_object_get(known, key), one)) return false;
    json_array_foreach(json_object_get(type, "required"), i,
                       one) if (!json_object_get(value, json_string_value(one))) return false;
    int count = 0;
    json_array_foreach(json_object_get(type, "oneOf"), i, one) count +=
        json_object_get(
            value, json_string_value(json_array_get(json_object_get(one, "required"), 0))) != NULL;
    return i == 0 || count == 1;
}

/* Whether a value fits a schema: of draft 7 as much as the scene's has. */
static bool fits(const json_t *type, const json_t *value)
{
    size_t i;
    json_t *one, *choices = json_object_get(type, "anyOf"), *names = json_object_get(type, "enum");
    bool found = !choices && !names;
    if (json_object_get(type, "$ref"))
        return fits(definition(strrchr(string_of(type, "$ref"), '/') + 1), value);
    json_array_foreach(choices, i, one) found = found || fits(one, value);
    json_array_foreach(names, i, one) found = found || json_equal(one, value);
    if (!found || choices)
        return found;
    const json_t *low = json_object_get(type, "minimum"), *most = json_object_get(type, "maxItems");
    if (!has_type(string_of(type, "type"), value) ||
        (json_object_get(type, "const") && !json_is_false(value)))
        return false;
    if (low && (json_number_value(value) < json_number_value(low) ||
                json_number_value(value) > json_number_value(json_object_get(type, "maximum"))))
        return false;
    if (most &&
        (json_array_size(value) > (size_t)json_integer_value(most) ||
         json_array_size(value) < (size_t)json_integer_value(json_object_get(type, "minItems"))))
        return false;
    json_array_foreach(value, i, one) if (!fits(json_object_get(type, "items"), one)) return false;
    return !json_is_object(value) || object_fits(type, (json_t *)value);
}

static void every_scene_of_the_project_fits_the_schema(void **state)
{
    (void)state;
    char path[PATH_MAX + 300];
    int count = 0;
    read_schema();
    snprintf(path, sizeof path, "%s/../../scenes", man_pages);
    DIR *folder = opendir(path);
    assert_non_null(folder);
    for (struct dirent *entry; (entry = readdir(folder));) {
        if (!strstr(entry->d_name, ".json"))
            continue;
        snprintf(path, sizeof path, "%s/../../scenes/%s", man_pages, entry->d_name);
        json_t *text = json_load_file(path, 0, NULL);
        assert_non_null(text);
        if (!fits(schema, text))
            fail_msg("%s does not fit the schema", entry->d_name);
        json_decref(text);
        count++;
    }
    closedir(folder);
    assert_true(count > 20);
}

/* Both take a scene, or both refuse it. */
static void expect_both(const char *text, const char *refusal)
{
    json_t *value = json_loads(text, 0, NULL);
    assert_non_null(value);
    write_file("one.json", text);
    const int code = shell("glasspipe render one.json --list-passes");
    if (code != (refusal ? 3 : 0) || fits(schema, value) != !refusal)
        fail_msg("%s\nexit code %d, %s the schema; %s", text, code,
                 fits(schema, value) ? "fits" : "does not fit", err);
    if (refusal)
        expect_contains(err, refusal);
    json_decref(value);
}

static void what_the_schema_refuses_is_refused_with_a_sentence(void **state)
{
    (void)state;
    read_schema();
    expect_both("{ \"$schema\": \"scene.schema.json\", \"objects\": [] }", NULL);
    expect_both("{ \"size\": [512] }", "size: expected 2 whole numbers in [1, 8192]");
    expect_both("{ \"size\": [512, 0] }", "size[1]: expected a whole number in [1, 8192]");
    expect_both(
        "{ \"targets\": [ { \"format\": \"rgb\" } ] }",
        "expected one of a8r8g8b8, x8r8g8b8, r8, g16r16f, a16b16g16r16f, r32f, a32b32g32r32f");
    expect_both("{ \"targets\": [ { \"format\": \"d16\" } ] }", "expected one of a8r8g8b8");
    expect_both("{ \"depth\": { \"format\": \"r8\" } }", "expected one of d16, d24s8, d32f");
    expect_both("{ \"lights\": [ { } ] }", "expected a position or a direction");
    expect_both("{ \"colour\": 1 }", "colour: unknown key");
#define OBJECT(text) "{ \"objects\": [ { \"mesh\": \"builtin:quad\", " text " } ] }"
    expect_both(OBJECT("\"material\": { \"program\": \"phong\", \"textures\": "
                       "[ { \"image\": \"builtin:uv\" } ] }"),
                "objects[0].material.textures: program phong reads no texture");
    expect_both(OBJECT("\"material\": { \"program\": \"textured\", \"textures\": "
                       "[ { \"image\": \"builtin:uv\" }, { \"image\": \"builtin:uv\" } ] }"),
                "program textured reads one texture");
    expect_both(OBJECT("\"material\": { \"program\": \"textured\" }"), "reads texture 0");
    expect_both(OBJECT("\"material\": { \"program\": \"textured\", \"textures\": "
                       "[ { \"image\": \"builtin:uv\", \"min\": \"cubic\" } ] }"),
                "expected one of point, linear");
    expect_both(OBJECT("\"material\": { \"program\": \"textured\", \"textures\": "
                       "[ { \"image\": \"builtin:uv\", \"address\": [\"wrap\", \"clamp\"] } ] }"),
                NULL);
    expect_both(OBJECT("\"material\": { \"program\": \"unlit\", \"shininess\": 3 }"),
                "shininess: unknown key");
    expect_both(OBJECT("\"transform\": { \"scale\": \"2\" }"), "scale: expected 3 numbers");
    expect_both(OBJECT("\"points\": \"builtin:grid\""),
                "expected a mesh, points, a volume or a depth image");
    expect_both(OBJECT("\"volume\": \"builtin:ball:8\""),
                "expected a mesh, points, a volume or a depth image");
    expect_both(OBJECT("\"method\": \"ewa\", \"subdivide\": 2"), NULL);
    expect_both(OBJECT("\"method\": \"ewa\", \"subdivide\": 9"),
                "objects[0].subdivide: expected a whole number in [0, 8]");
    expect_both(OBJECT("\"method\": \"ternary\""), "method: expected one of adaptive, ewa,");
    expect_both(OBJECT("\"state\": { \"blend\": [ { \"op\": \"sum\" } ] }"),
                "blend[0].op: expected one of off, add,");
}

/* A schema cannot tell these. */
static void what_a_program_does_not_use_is_refused(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        { "\"color\": [1, 0, 0, 1]", "objects[0].color: program phong does not use it" },
        { "\"tile\": [2, 2]", "objects[0].tile: program phong does not use it" },
        { "\"size\": 2", "objects[0].size: program phong does not use it" },
        { "\"sample\": 9", "objects[0].sample: of splats: expected a method" },
        { "\"pixels\": [64, 64]", "objects[0].pixels: of depth images: expected one" },
        { "\"step\": 2", "objects[0].step: of volumes: expected a volume" },
        { "\"method\": \"ewa\", \"lit\": true", "objects[0].lit: of volumes: expected a volume" },
        { "\"method\": \"ewa\", \"tile\": [2, 2]",
          "objects[0].tile: splats have none of their own" },
    };
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        char text[200];
        snprintf(text, sizeof text, OBJECT("%s"), rows[i][0]);
        write_file("one.json", text);
        expect_refused(3, "render one.json", rows[i][1]);
    }
    write_file("use.json", "{ \"passes\": [ { \"name\": \"a\" }, { \"name\": \"b\", \"targets\": "
                           "[ { \"use\": \"a\", \"format\": \"r8\" } ] } ] }");
    expect_refused(3, "render use.json", "targets[0].format: a target that is used again has its");
}

/* --- files of a scene ------------------------------------------------------------------------- */

/* The models differ, so that the number of primitives tells which was read. */
static void files_are_looked_for_beside_the_scene_first(void **state)
{
    (void)state;
    static const char one[] = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    static const char two[] = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n";
    assert_int_equal(shell("mkdir -p sub/models models data/models"), 0);
    write_file("sub/one.json", "{ \"objects\": [ { \"mesh\": \"models/m.off\" } ] }");
    expect_refused(3, "render sub/one.json", "neither beside the scene, here nor in");
    write_file("data/models/m.off", one);
    assert_int_equal(shell("GLASSPIPE_DATA=data glasspipe explain sub/one.json"), 0);
    expect_contains(out, ": 1 triangles");
    write_file("models/m.off", two);
    assert_int_equal(shell("GLASSPIPE_DATA=data glasspipe explain sub/one.json"), 0);
    expect_contains(out, ": 2 triangles");
    write_file("sub/models/m.off", one);
    assert_int_equal(shell("GLASSPIPE_DATA=data glasspipe explain sub/one.json"), 0);
    expect_contains(out, ": 1 triangles");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(the_man_page_has_every_key_with_its_type_range_and_default),
        PROGRAM_TEST(the_man_page_has_the_names_of_everything_built_in),
        PROGRAM_TEST(every_scene_of_the_project_fits_the_schema),
        PROGRAM_TEST(what_the_schema_refuses_is_refused_with_a_sentence),
        PROGRAM_TEST(what_a_program_does_not_use_is_refused),
        PROGRAM_TEST(files_are_looked_for_beside_the_scene_first),
    };
    return cmocka_run_group_tests_name("scene format", tests, find_program, NULL);
}
