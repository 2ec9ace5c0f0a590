/* Shaders run step by step give the bits of the code that draws: every program of shaders_c, found
 * by its declaration in a header, on inputs about several values, with textures that answer by
 * coordinate. */
#include "apps/inspect/page_files.h"
#include "apps/inspect/uniforms.h"
#include "pipeline/shader/steps.h"
#include "tests/support/random.h"
#include "tests/support/unit.h"

#include <dlfcn.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>

enum { LANES = 4, MOST_WORDS = 4096, COLORS = 4 * GP_MAX_TARGETS };

static const float levels[] = { 0.0f, 1.0f, -1.0f, 0.375f, 100.0f };

/* --- a call that answers by itself ------------------------------------------------------------ */

typedef struct Packet {
    _Alignas(64) float in[GP_MAX_INPUTS * LANES];
    _Alignas(64) float position[4 * LANES];
    _Alignas(64) float varying[GP_MAX_VARYINGS * LANES];
    _Alignas(64) float size[LANES];
    _Alignas(64) float pixel[2 * LANES];
    _Alignas(64) float face[LANES];
    _Alignas(64) float color[COLORS * LANES];
    _Alignas(64) float depth[LANES];
    _Alignas(64) int32_t killed[LANES];
} Packet;

static void read_texture(const GpShaderCall *call, const GpTextureRead *read)
{
    const float *level = call->executor;
    for (int i = 0; i < 4 * read->lanes; i++) {
        const float at = read->coord[i % (2 * read->lanes)];
        read->texel[i] = *level + (at > -8 && at < 8 ? 0.5f * at : 0.25f);
    }
}

static void read_local(const GpShaderCall *call, int slot, int packet, int lanes, float *texel)
{
    const float *level = call->executor;
    (void)packet;
    for (int i = 0; i < 4 * lanes; i++)
        texel[i] = *level + 0.125f * (float)(slot + i % lanes);
}

static void fill(Packet *packet, Random *random, float level)
{
    memset(packet, 0x5a, sizeof *packet);
    for (size_t i = 0; i < GP_COUNT(packet->in); i++)
        packet->in[i] = level + random_float(random, -1, 1);
    for (int lane = 0; lane < LANES; lane++) {
        packet->pixel[lane] = (float)(8 + lane % 2);
        packet->pixel[LANES + lane] = (float)(4 + lane / 2);
        packet->face[lane] = level < 0 ? -1 : 1;
    }
}

static GpShaderCall call_of(Packet *packet, const void *uniforms, float *level)
{
    return (GpShaderCall){ .uniforms = uniforms,
                           .packets = 1,
                           .in = packet->in,
                           .read_texture = read_texture,
                           .read_local = read_local,
                           .executor = level,
                           .local = level,
                           .position = packet->position,
                           .varying = packet->varying,
                           .point_size = packet->size,
                           .pixel = packet->pixel,
                           .face = packet->face,
                           .color = packet->color,
                           .depth = packet->depth,
                           .killed = packet->killed };
}

/* --- what the steps say ----------------------------------------------------------------------- */

typedef struct Told {
    int steps, outputs;
    bool in_order,
        has_lines; /* operands come from earlier steps; each has its place in the source */
} Told;

static void take_step(void *user, const GpShaderStep *step)
{
    Told *told = user;
    told->in_order = told->in_order && step->number == told->steps;
    for (int i = 0; i < step->operands; i++)
        for (int c = 0; c < step->operand[i].width; c++) {
            const GpStepPart *part = &step->operand[i].part[c];
            if (part->source == GP_STEP_RESULT)
                told->in_order = told->in_order && part->index < step->number;
        }
    told->has_lines = told->has_lines && step->line > 0 && strstr(step->file, "shaders_c/");
    told->steps++;
}

static void take_output(void *user, const GpStepOutput *output)
{
    Told *told = user;
    (void)output;
    told->outputs++;
}

/* Bits alike in the first count floats, any NaN being one. */
static bool same(const float *a, const float *b, int count)
{
    for (int i = 0; i < count; i++)
        if (memcmp(&a[i], &b[i], sizeof a[i]) != 0 && !(isnan(a[i]) && isnan(b[i])))
            return false;
    return true;
}

static void hold(const GpProgram *program, const void *uniforms, float level, bool vertex,
                 Random *random)
{
    const GpProgramCode *code = gp_program_code(program, 4);
    Packet drawn, stepped;
    Told told = { .in_order = true, .has_lines = true };
    const GpStepListener listener = { .step = take_step, .output = take_output, .user = &told };
    fill(&drawn, random, level);
    memcpy(&stepped, &drawn, sizeof stepped);
    const GpShaderCall call = call_of(&drawn, uniforms, &level);
    (vertex ? code->vertex : code->pixel)(&call);
    const GpShaderCall again = call_of(&stepped, uniforms, &level);
    assert_true(gp_program_steps(program, vertex, &again, &listener));
    const bool fits =
        vertex ? same(drawn.position, stepped.position, 4 * LANES) &&
                     same(drawn.varying, stepped.varying, program->varying_components * LANES) &&
                     (!program->writes_point_size || same(drawn.size, stepped.size, LANES))
               : same(drawn.color, stepped.color, program->color_components * LANES) &&
                     (!program->writes_depth || same(drawn.depth, stepped.depth, LANES)) &&
                     (!program->may_discard ||
                      memcmp(drawn.killed, stepped.killed, sizeof drawn.killed) == 0);
    if (!fits || !told.in_order || !told.has_lines)
        fail_msg("%s, %s shader, about %g: %s", program->name, vertex ? "vertex" : "pixel",
                 (double)level,
                 !fits ? "steps end in other bits" : "its steps have no order or no place");
}

/* Ones: floats of 1, and whole numbers of 1, which may count a loop's turns. */
static bool set_uniforms(const GpProgram *program, uint32_t words[MOST_WORDS])
{
    if (program->uniform_bytes > MOST_WORDS * 4 || !uniforms_are_known(program))
        return false;
    for (size_t i = 0; i < MOST_WORDS; i++)
        words[i] = gp_float_bits(1);
    const GpDraw draw = { .program = program, .uniforms = words };
    json_t *told = uniforms_tell(&draw);
    size_t i;
    const json_t *one;
    json_array_foreach(told, i, one)
    {
        const json_t *value = json_array_get(json_object_get(one, "value"), 0);
        const json_t *first = json_is_array(value) ? json_array_get(value, 0) : value;
        const json_int_t word = json_integer_value(json_object_get(one, "word"));
        for (json_int_t k = 0; k < json_integer_value(json_object_get(one, "words")); k++)
            words[word + k] =
                json_is_integer(first) ? 1 : gp_float_bits(0.5f + 0.25f * (float)(k % 5));
    }
    json_decref(told);
    return true;
}

/* --- every program ---------------------------------------------------------------------------- */

/* The next program that a header declares, "extern const GpProgram one, two;"; NULL at the end. */
static const GpProgram *next_program(const char **at)
{
    static const char declares[] = "extern const GpProgram ";
    while (*at) {
        char name[128];
        *at += strspn(*at, ", \n");
        if (strncmp(*at, declares, sizeof declares - 1) == 0)
            *at += sizeof declares - 1;
        snprintf(name, sizeof name, "%.*s", (int)strcspn(*at, "[,; \n"), *at);
        const GpProgram *program = name[0] && name[0] != '*' ? dlsym(RTLD_DEFAULT, name) : NULL;
        *at += strcspn(*at, ",;");
        if (**at != ',')
            *at = strstr(*at, declares);
        if (program && strcmp(program->name, name) == 0)
            return program;
    }
    return NULL;
}

static int each_program(void (*visit)(const GpProgram *program))
{
    int count = 0;
    for (const PageFile *file = page_files; file->path; file++) {
        const size_t length = strlen(file->path);
        if (strcmp(file->path + length - 2, ".h") != 0)
            continue;
        const char *at = strstr(file->begin, "extern const GpProgram ");
        for (const GpProgram *program = next_program(&at); program; program = next_program(&at)) {
            visit(program);
            count++;
        }
    }
    return count;
}

static void hold_program(const GpProgram *program)
{
    static uint32_t uniforms[MOST_WORDS];
    Random random = { 20 };
    if (!program->step)
        return;
    if (!set_uniforms(program, uniforms))
        return; /* as the next test tells */
    for (size_t i = 0; i < GP_COUNT(levels); i++) {
        hold(program, uniforms, levels[i], true, &random);
        if (program->code[0]->pixel)
            hold(program, uniforms, levels[i], false, &random);
    }
}

static void steps_of_every_program_end_in_the_bits_that_are_drawn(void **state)
{
    (void)state;
    assert_true(each_program(hold_program) > 100);
}

/* --- what shaders watch ----------------------------------------------------------------------- */

typedef struct Watched {
    int count;
    float exponent[LANES], weight[LANES];
} Watched;

static void take_watch(void *user, const GpStepWatch *watch)
{
    Watched *watched = user;
    float *to = strcmp(watch->name, "weight") == 0 ? watched->weight : watched->exponent;
    assert_int_equal(watch->value.width, 1);
    memcpy(to, watch->value.part[0].value, sizeof watched->weight);
    watched->count++;
}

static void ignore_step(void *user, const GpShaderStep *step)
{
    (void)user, (void)step;
}

static void ignore_output(void *user, const GpStepOutput *output)
{
    (void)user, (void)output;
}

/* A splat watches its exponent and its weight; what it gives is its colour by that weight. */
static void what_a_shader_watches_has_the_values_that_it_computes_with(void **state)
{
    static uint32_t uniforms[MOST_WORDS];
    const GpProgram *program = dlsym(RTLD_DEFAULT, "splat_color_program");
    (void)state;
    if (!program || !program->step)
        skip();
    assert_true(set_uniforms(program, uniforms));
    Packet packet;
    Random random = { 7 };
    Watched watched = { 0 };
    float level = 0;
    const GpStepListener listener = {
        .step = ignore_step, .output = ignore_output, .watched = take_watch, .user = &watched
    };
    fill(&packet, &random, level);
    const GpShaderCall call = call_of(&packet, uniforms, &level);
    assert_true(gp_program_steps(program, false, &call, &listener));
    assert_int_equal(watched.count, 2);
    for (int lane = 0; lane < LANES; lane++)
        for (int c = 0; c < 4; c++) { /* conic 3, place 2, color 4 */
            const float product = packet.in[(5 + c) * LANES + lane] * watched.weight[lane];
            assert_memory_equal(&packet.color[c * LANES + lane], &product, sizeof product);
        }
    assert_true(watched.exponent[0] != watched.exponent[1]);
}

static char unknown[4096];

static void note_unknown(const GpProgram *program)
{
    if (!uniforms_are_known(program))
        snprintf(unknown + strlen(unknown), sizeof unknown - strlen(unknown), " %s", program->name);
}

static void uniforms_of_every_program_have_names(void **state)
{
    (void)state;
    each_program(note_unknown);
    if (unknown[0])
        fail_msg("not understood:%s", unknown);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(uniforms_of_every_program_have_names),
        cmocka_unit_test(steps_of_every_program_end_in_the_bits_that_are_drawn),
        cmocka_unit_test(what_a_shader_watches_has_the_values_that_it_computes_with),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
