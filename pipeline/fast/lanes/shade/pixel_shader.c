/* One call of a pixel shader: as many packets as a block has. */
#include "pipeline/fast/lanes/shade/pixel_shader.h"

#include "pipeline/fast/lanes/shade/framebuffer_fetch.h"
#include "pipeline/fast/lanes/shade/records.h"
#include "pipeline/fast/lanes/texture/sample.h"

static void set_pixels(const Tile *tile, const FastPacketBlock *packets, flt *pixel)
{
    for (int p = 0; p < packets->count; p++) {
        pixel[2 * p] = flt_from_itg(block_x(packets, p) + tile->x0);
        pixel[2 * p + 1] = flt_from_itg(block_y(packets, p) + tile->y0);
    }
}

/* Triangles of a gathered packet in a queue face one way. */
static void set_faces(const Tile *tile, const FastPacketBlock *packets, float *face)
{
    const FastTriangleRecord *records = tile->records->record;
    for (int p = 0; p < packets->count; p++, face += GP_LANES)
        if (packets->packets)
            flt_store(face, flt_set(records[packets->packets[p].record].face));
        else
            for (int lane = 0; lane < GP_LANES; lane++)
                face[lane] = records[packets->gathered[p].record[lane]].face;
}

/* Of a shader that gives what it reads and no more: it is not asked. Sheets take 3 % less, with
 * AVX-512 8 %. */
static void show_texels(const GpShaderCall *call, int slot)
{
    for (int p = 0; p < call->packets; p++)
        fast_fetch_framebuffer(call, slot, p, GP_LANES, call->color + p * 4 * GP_LANES);
}

void fast_run_pixel_shader(Tile *tile, const FastDraw *d, const FastPacketBlock *packets)
{
    const GpProgram *program = d->draw->program;
    FastShaderBlock *block = tile->block;
    block->at = *packets;
    if (program->uses_pixel)
        set_pixels(tile, packets, (flt *)(void *)block->pixel);
    if (program->uses_face)
        set_faces(tile, packets, block->face);
    for (unsigned left = program->local_reads; left; left &= left - 1)
        fast_begin_fetch(tile, d->draw->textures, __builtin_ctz(left));
    GpShaderCall call = {
        .uniforms = d->draw->uniforms,
        .packets = packets->count,
        .in = packets->in ? packets->in : block->in,
        .interpolants = packets->interpolants,
        .layers = packets->layers,
        .textures = d->draw->textures,
        .read_texture = fast_read_texture,
        .executor = (void *)d->samplers, /* only read */
        .read_local = fast_fetch_framebuffer,
        .local = tile,
        .pixel = block->pixel,
        .face = block->face,
        .color = block->color,
        .depth = program->writes_depth ? block->shader_depth : NULL,
        .killed = program->may_discard ? block->killed : NULL,
        /* named, or gcc clears all by one slow instruction: small blocks of points wait for it (2
         * to 4 % with AVX2) */
        .position = NULL,
        .varying = NULL,
        .point_size = NULL,
        .used = NULL,
    };
    if (d->shown_slot)
        show_texels(&call, d->shown_slot - 1);
    else
        d->code->pixel(&call);
}
