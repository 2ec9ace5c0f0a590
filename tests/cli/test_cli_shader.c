/* glasspipe shader: a file of one's own, compiled and drawn. Each test has a cache of its own. */
#include "pipeline/list/isa.h"
#include "tests/support/program.h"

#include <sys/stat.h>

static const char clay[] =
    "#include <glasspipe/effect.h>\n"
    "typedef struct Varying { float3 normal; } Varying;\n"
    "vertex_shader(clay_vs, EffectUniforms, EffectVertex, Varying)\n"
    "{\n"
    "    *position = m4x4(in->position, c->view_projection);\n"
    "    out->normal = in->normal;\n"
    "}\n"
    "pixel_shader(clay_ps, EffectUniforms, Varying)\n"
    "{\n"
    "    return rgba(mul(in->normal, max(dp3(in->normal, u3(c->light)), c->values[1])), 1);\n"
    "}\n"
    "#define BOTH .vertex_profile = GP_VS_2_0, .pixel_profile = GP_PS_2_0, \\\n"
    "    .inputs = { EFFECT_INPUTS }, .varyings = { { \"normal\", 3, GP_PERSPECTIVE } }\n"
    "program(clay, clay_vs, clay_ps, BOTH)\n";

static const char second[] = "program(other, clay_vs, clay_ps, BOTH)\n";

/* The compiler and the checks of what it made are real, so each text is compiled seldom. */
#define DRAW    "CC=%s XDG_CACHE_HOME=$PWD/cache glasspipe shader --size 48x32 "
#define CC_HERE "${CC:-gcc}"

static bool skipped(void)
{
    if (system("command -v ${CC:-gcc} >/dev/null 2>&1 && [ -z \"$EMULATOR\" ]") == 0)
        return false;
    skip();
    return true;
}

static void a_file_is_drawn_and_counted_and_compiled_once(void **state)
{
    (void)state;
    static char first[sizeof out];
    if (skipped())
        return;
    write_file("clay.c", clay);
    assert_int_equal(shell(DRAW "clay.c", CC_HERE), 0);
    strcpy(first, out);
    expect_matches(out, "instruction slots +5 of 256 +[0-9]+ of 96");
    expect_matches(out, "hash A8R8G8B8 48x32 [0-9a-f]{16}");
    expect_files("cache clay.c clay.png scene.json");

    /* From the cache, on every width, and by the reference: the compiler is not called. */
    assert_int_equal(shell(DRAW "clay.c", CC_HERE), 0);
    assert_string_equal(out, first);
    assert_int_equal(shell("ls cache/glasspipe/*.so | wc -l"), 0);
    assert_string_equal(out, "1\n");
    for (int lanes = 4; lanes <= 16; lanes *= 2)
        if (gp_isa_of_lanes(lanes)) {
            assert_int_equal(shell("GP_ISA=%s " DRAW "clay.c", gp_isa_of_lanes(lanes), CC_HERE), 0);
            assert_string_equal(out, first);
        }
    assert_int_equal(shell(DRAW "clay.c --executor reference", CC_HERE), 0);
    assert_string_equal(out, first);

    /* What the options give arrives, and so does an edit. */
    assert_int_equal(shell(DRAW "clay.c --values 0,1", CC_HERE), 0);
    assert_string_not_equal(out, first);
    assert_int_equal(shell(DRAW "clay.c --on builtin:cube", CC_HERE), 0);
    assert_string_not_equal(out, first);
    assert_int_equal(shell(DRAW "clay.c --json", CC_HERE), 0);
    json_t *object = parse_output();
    assert_non_null(json_object_get(json_object_get(object, "pixel_shader"), "slots"));
    json_decref(object);
}

static void of_several_programs_one_is_chosen(void **state)
{
    (void)state;
    if (skipped())
        return;
    char both[4096];
    snprintf(both, sizeof both, "%s%s", clay, second);
    write_file("two.c", both);
    expect_refused(3, "shader two.c", "two.c: choose one by --program: clay, other");
    expect_refused(3, "shader two.c --program clya", "no program clya; there is clay, other");
    assert_int_equal(shell(DRAW "two.c --program other", CC_HERE), 0);
}

static void what_is_wrong_is_said_with_its_line(void **state)
{
    (void)state;
    if (skipped())
        return;
    write_file("none.c", "int x;\n");
    expect_refused(3, "shader none.c", "none.c: no line begins with program(NAME, ...)");
    expect_refused(3, "shader missing.c", "missing.c: no such file");
    expect_refused(2, "shader scene.json --values 1,x", "--values: expected up to 8 numbers");
    expect_refused(2, "shader scene.json --values 1e39", "--values: expected up to 8 numbers");
    expect_refused(2, "shader scene.json --from 0 90", "--from: expected");

    write_file("wrong.c", "#include <glasspipe/effect.h>\n\nfloat3 f(float3 a) { return a + b; }\n"
                          "program(wrong, x, y)\n");
    assert_int_equal(shell(DRAW "wrong.c", CC_HERE), 3);
    assert_string_equal(out, "");
    expect_matches(err, "wrong\\.c:3:[0-9]+: error:.*'?b'?");
    expect_contains(err, "glasspipe: wrong.c: not compiled, for the reason above");
    assert_null(strstr(err, "to be counted")); /* said once: not as C++ as well */

    write_file("clay.c", clay);
    assert_int_equal(shell(DRAW "clay.c", "no-such-compiler"), 3);
    expect_contains(err, "no C compiler: no-such-compiler not found");
    expect_files("cache clay.c none.c scene.json wrong.c");
}

/* A program's own uniforms, and an input that no model has. */
static void what_a_model_cannot_give_is_refused(void **state)
{
    (void)state;
    if (skipped())
        return;
    write_file("own.c",
               "#include <glasspipe/shader.h>\n"
               "typedef struct Own { float scale; } Own;\n"
               "typedef struct Vertex { float3 position; } Vertex;\n"
               "typedef struct None { } None;\n"
               "vertex_shader(own_vs, Own, Vertex, None) { *position = rgba(in->position, 1); }\n"
               "depth_program(own, own_vs, .inputs = { { GP_POSITION, 3 } })\n");
    assert_int_equal(shell(DRAW "own.c", CC_HERE), 3);
    expect_contains(err, "its uniforms have 4 bytes; expected EffectUniforms");
    write_file("tangent.c",
               "#include <glasspipe/effect.h>\n"
               "typedef struct Vertex { float3 position, tangent; } Vertex;\n"
               "typedef struct None { } None;\n"
               "vertex_shader(own_vs, EffectUniforms, Vertex, None)\n"
               "{ *position = rgba(add(in->position, in->tangent), 1); }\n"
               "depth_program(own, own_vs, .inputs = { { GP_POSITION, 3 }, { GP_TANGENT, 3 } })\n");
    assert_int_equal(shell(DRAW "tangent.c", CC_HERE), 3);
    expect_contains(err, "inputs[1] is tangent; a model has position");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(a_file_is_drawn_and_counted_and_compiled_once),
        PROGRAM_TEST(of_several_programs_one_is_chosen),
        PROGRAM_TEST(what_is_wrong_is_said_with_its_line),
        PROGRAM_TEST(what_a_model_cannot_give_is_refused),
    };
    return cmocka_run_group_tests_name("cli_shader", tests, find_program, NULL);
}
