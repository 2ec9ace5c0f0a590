/* Trials: shaders run on made-up values, with memory that shows what was written, textures that
 * note who reads them, and a second run in which one input differs. */
#include "pipeline/shader/trial.h"

#include <string.h>

enum { MAX_LANES = 16, MAX_COLORS = 4 * GP_MAX_TARGETS };

/* As pipeline/shader/entry_points.h leaves a size that is not written. */
static const uint32_t UNSET = 0x7fa5a5a5u;

/* What inputs and texels are about. Loops that are left when no lane needs them any more are
 * entered at one of these. */
static const float levels[] = { 0.0f, 1.0f, -1.0f, 0.375f, 100.0f };

typedef struct Packet {
    _Alignas(64) float in[GP_MAX_INPUTS * MAX_LANES]; /* of a vertex or of a pixel */
    _Alignas(64) float position[4 * MAX_LANES];
    _Alignas(64) float varying[GP_MAX_VARYINGS * MAX_LANES];
    _Alignas(64) float size[MAX_LANES];
    _Alignas(64) float pixel[2 * MAX_LANES];
    _Alignas(64) float face[MAX_LANES];
    _Alignas(64) float color[MAX_COLORS * MAX_LANES];
    _Alignas(64) float depth[MAX_LANES];
    _Alignas(64) int32_t killed[MAX_LANES];
} Packet;

/* A shader that runs, and what is noted of it. */
typedef struct Run {
    const GpProgram *program;
    const GpProgramCode *code;
    const void *uniforms;
    GpTrial *trial;
    GpShaderCounts *seen; /* of this shader */
    float level;
    uint64_t moved; /* components of the input that differ from the other runs */
    uint64_t far;   /* of these, those that differ by so much */
    float reach;
    uint64_t digest;  /* of all that the shader gave */
    uint64_t written; /* components written in all lanes */
    Packet packet;
} Run;

/* --- what is noted ---------------------------------------------------------------------------- */

static void digest(Run *run, const void *values, size_t bytes)
{
    for (size_t i = 0; i < bytes; i++)
        run->digest = (run->digest ^ ((const uint8_t *)values)[i]) * 0x100000001b3u;
}

static void note_slot(Run *run, int slot, uint16_t *slots)
{
    const uint16_t bit = gp_slot_bit(slot);
    *slots |= bit;
    if (!bit)
        run->trial->wrong_slot = slot;
}

/* A texel of what is about the coordinate, so that what is made of it follows the inputs. */
static void read_texture(const GpShaderCall *call, const GpTextureRead *read)
{
    Run *run = call->executor;
    note_slot(run, read->slot, &run->seen->sampler_slots);
    run->seen->implicit_lod |= read->mode == GP_LOD_IMPLICIT || read->mode == GP_LOD_BIAS;
    run->seen->explicit_lod |= read->mode == GP_LOD_EXPLICIT;
    run->seen->gradients |= read->mode == GP_LOD_GRADIENT;
    digest(run, read->coord, (size_t)read->lanes * 4 * sizeof(float));
    for (int i = 0; i < 4 * read->lanes; i++)
        read->texel[i] = run->level + 0.5f * read->coord[i % (2 * read->lanes)];
}

static void read_local(const GpShaderCall *call, int slot, int packet, int lanes, float *texel)
{
    Run *run = call->local;
    (void)packet;
    note_slot(run, slot, &run->seen->local_slots);
    for (int i = 0; i < 4 * lanes; i++)
        texel[i] = run->level;
}

static void note_used(Run *run, uint32_t used)
{
    GpShaderCounts *seen = run->seen;
    seen->discards |= (used & GP_USED_DISCARD) != 0;
    seen->writes_depth |= (used & GP_USED_DEPTH) != 0;
    seen->reads_pixel |= (used & GP_USED_PIXEL) != 0;
    seen->reads_face |= (used & GP_USED_FACE) != 0;
    seen->needs_quads |= (used & GP_USED_DERIVATIVES) != 0;
    seen->gradients |= (used & GP_USED_DERIVATIVES) != 0;
    run->trial->fused |= (used & GP_USED_FUSED) != 0;
}

/* --- memory ----------------------------------------------------------------------------------- */

static void unset(float *values, int count)
{
    for (int i = 0; i < count; i++)
        memcpy(&values[i], &UNSET, sizeof UNSET);
}

/* Bit c: component c was written in all lanes. */
static uint64_t written_components(const float *values, int components, int lanes)
{
    uint64_t written = 0;
    for (int c = 0; c < components; c++) {
        bool all = true;
        for (int lane = 0; lane < lanes; lane++)
            all = all && memcmp(&values[c * lanes + lane], &UNSET, sizeof UNSET) != 0;
        written |= (uint64_t)all << c;
    }
    return written;
}

/* Inputs about the level, all different; those that move, elsewhere. */
static void fill_inputs(Run *run, int components)
{
    const int lanes = run->code->lanes;
    for (int c = 0; c < components; c++)
        for (int lane = 0; lane < lanes; lane++) {
            const float scale = 1 + (float)c / 8 + (float)lane / 64;
            const float reach = run->far >> c & 1 ? run->reach : 1;
            const float step = run->moved >> c & 1 ? reach * (0.75f + 0.25f * (float)lane) : 0;
            run->packet.in[c * lanes + lane] = run->level * scale + step;
        }
}

static GpShaderCall call_of(Run *run, uint32_t *used)
{
    Packet *packet = &run->packet;
    *used = 0;
    run->digest = 0xcbf29ce484222325u;
    return (GpShaderCall){
        .uniforms = run->uniforms,
        .packets = 1,
        .in = packet->in,
        .read_texture = read_texture,
        .read_local = read_local,
        .executor = run,
        .local = run,
        .pixel = packet->pixel,
        .face = packet->face,
        .depth = packet->depth,
        .killed = packet->killed,
        .used = used,
    };
}

/* --- runs ------------------------------------------------------------------------------------- */

static void run_vertices(Run *run)
{
    const int lanes = run->code->lanes;
    Packet *packet = &run->packet;
    uint32_t used;
    GpShaderCall call = call_of(run, &used);
    call.position = packet->position;
    call.varying = packet->varying;
    call.point_size = packet->size;
    fill_inputs(run, run->program->input_components);
    unset(packet->position, 4 * lanes);
    unset(packet->varying, GP_MAX_VARYINGS * lanes);
    unset(packet->size, lanes);
    run->code->vertex(&call);
    note_used(run, used);
    run->written = written_components(packet->varying, run->program->varying_components, lanes);
    run->seen->writes_point_size |= written_components(packet->size, 1, lanes) != 0;
    run->digest = 0xcbf29ce484222325u; /* the position alone */
    digest(run, packet->position, 4 * (size_t)lanes * sizeof(float));
}

static void run_pixels(Run *run)
{
    const int lanes = run->code->lanes, colors = run->program->color_components;
    Packet *packet = &run->packet;
    uint32_t used;
    GpShaderCall call = call_of(run, &used);
    call.color = packet->color;
    fill_inputs(run, run->program->pixel_input_components);
    unset(packet->color, colors * lanes);
    for (int lane = 0; lane < lanes; lane++) {
        packet->pixel[lane] = (float)(8 + lane % 4 % 2 + 2 * (lane / 4));
        packet->pixel[lanes + lane] = (float)(4 + lane % 4 / 2);
        packet->face[lane] = run->level < 0 ? -1.0f : 1.0f;
    }
    run->code->pixel(&call);
    note_used(run, used);
    run->written = written_components(packet->color, colors, lanes);
    digest(run, packet->color, (size_t)(colors * lanes) * sizeof(float));
    digest(run, packet->depth, (size_t)lanes * sizeof(float));
    digest(run, packet->killed, (size_t)lanes * sizeof(int32_t));
}

/* Whether other values of some components of the input make another result. */
static bool follows(Run *run, void (*again)(Run *), uint64_t components)
{
    if (!components)
        return false;
    const uint64_t before = run->digest;
    run->moved = components;
    again(run);
    const bool other = run->digest != before;
    run->moved = 0;
    run->digest = before;
    return other;
}

static uint64_t low_bits(int count)
{
    return count >= 64 ? ~(uint64_t)0 : ((uint64_t)1 << count) - 1;
}

/* Components of the vertex struct that are declared as GP_POSITION. */
static uint64_t position_inputs(const GpProgram *program)
{
    int first = 0;
    for (size_t i = 0; i < GP_COUNT(program->inputs) && program->inputs[i].components; i++) {
        const GpInputDecl *input = &program->inputs[i];
        if (input->semantic == GP_POSITION)
            return low_bits(input->components) << first;
        first += input->components;
    }
    return 0;
}

static void try_vertices(Run *run, GpTrial *trial)
{
    const uint64_t position = position_inputs(run->program);
    const uint64_t others = low_bits(run->program->input_components) & ~position;
    run->seen = &trial->vertex;
    run_vertices(run);
    trial->vertex.outputs_written &= run->written;
    trial->writes_position &=
        written_components(run->packet.position, 4, run->code->lanes) == low_bits(4);
    trial->position_moves |= follows(run, run_vertices, position);
    if (!follows(run, run_vertices, others))
        return;
    trial->other_input_moves = true;
    /* they may have brought into view what was left out before, wherever it was */
    run->moved = others;
    run_vertices(run);
    trial->position_moves |= follows(run, run_vertices, others | position);
    /* a small step is lost where the uniforms are those of an eye at the end of a large model */
    run->far = position;
    for (run->reach = 0x1p20f; !trial->position_moves && run->reach < 0x1p41f;
         run->reach *= 0x1p20f) {
        run->moved = others;
        run_vertices(run);
        trial->position_moves = follows(run, run_vertices, others | position);
    }
    run->far = 0;
}

static void try_pixels(Run *run, GpTrial *trial)
{
    const int varyings = run->program->varying_components;
    run->seen = &trial->pixel;
    run_pixels(run);
    trial->pixel.outputs_written &= run->written;
    uint64_t missing = low_bits(varyings) & ~trial->vertex.outputs_written;
    for (; missing; missing &= missing - 1)
        if (follows(run, run_pixels, missing & -missing))
            trial->pixel.inputs_read |= missing & -missing;
}

/* Bits left in the upper halves of AVX's registers make all that is compiled for SSE slow: on Zen 5
 * 1.5 to 5 times, in this thread and those begun by it. gcc leaves such bits where a shader is not
 * optimized, is checked while it runs, or ends with the call of a function that has no use for
 * those registers. */
#ifdef __x86_64__
__attribute__((target("avx"))) static void clear_upper_halves(void)
{
    __builtin_ia32_vzeroupper();
}
#endif

static void leave_lanes(void)
{
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx"))
        clear_upper_halves();
#endif
}

GpTrial gp_program_trial(const GpProgram *program, const GpProgramCode *code, const void *uniforms)
{
    GpTrial trial = { .writes_position = true };
    trial.vertex.outputs_written = low_bits(program->varying_components);
    trial.pixel.outputs_written = low_bits(program->color_components);
    Run run = { .program = program, .code = code, .uniforms = uniforms, .trial = &trial };
    for (size_t i = 0; i < GP_COUNT(levels); i++) {
        run.level = levels[i];
        try_vertices(&run, &trial);
    }
    for (size_t i = 0; i < GP_COUNT(levels) && code->pixel; i++) {
        run.level = levels[i];
        try_pixels(&run, &trial);
    }
    leave_lanes();
    return trial;
}
