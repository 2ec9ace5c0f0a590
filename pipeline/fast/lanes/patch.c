/* Patches: pixels of one triangle or point on their way through the shader, in order. */
#include "pipeline/fast/lanes/patch.h"

#include "pipeline/compare.h"
#include "pipeline/fast/lanes/interpolate.h"

#include <string.h>

/* --- interpolation ------------------------------------------------------------------------------ */

/* Edge values of a large triangle: exact in binary64, rounded once. */
static flt wide_edge(const FastWide *wide, int i, itg x, itg y)
{
    dbl value = (double)wide->edge.c[i] + (dbl_from_itg(x) * (double)wide->edge.a[i] +
                                           dbl_from_itg(y) * (double)wide->edge.b[i]);
    return __builtin_convertvector(value, flt);
}

static Shares patch_shares(const Tile *tile, const FastRecord *r, itg x, itg y)
{
    flt edge1, edge2;
    if (r->kind == FAST_SMALL) {
        edge1 = flt_from_itg((itg)((utg)(x * r->a1 + y * r->b1) + (uint32_t)r->c1));
        edge2 = flt_from_itg((itg)((utg)(x * r->a2 + y * r->b2) + (uint32_t)r->c2));
    } else {
        edge1 = wide_edge(&tile->wide[r->wide], 0, x, y);
        edge2 = wide_edge(&tile->wide[r->wide], 1, x, y);
    }
    return shares_of(edge1, edge2, flt_set(r->inverse_area), flt_set(r->ratio1),
                     flt_set(r->ratio2));
}

static void interpolate_triangle(const Tile *tile, const FastDraw *d, const FastRecord *r, itg x,
                                 itg y, flt *in)
{
    Shares shares = patch_shares(tile, r, x, y);
    for (int c = 0; c < d->modes.components; c++)
        if (d->needs.varyings >> c & 1)
            in[c] = blend_corners(d->modes.mode[c], &shares, flt_set(r->corner[0][c]),
                                  flt_set(r->corner[1][c]), flt_set(r->corner[2][c]));
}

static void interpolate_sprite(const Tile *tile, const FastDraw *d, const FastRecord *r, itg x,
                               itg y, flt *in)
{
    const FastWide *wide = &tile->wide[r->wide];
    for (int c = 0; c < d->modes.components; c++)
        in[c] = flt_set(r->corner[0][c]);
    if (d->modes.sprite < 0)
        return;
    flt *at = in + d->modes.sprite;
    at[0] = flt_from_itg(x * GP_SUBPIXELS - wide->sprite.left) * wide->sprite.per_step;
    at[1] = flt_from_itg(y * GP_SUBPIXELS - wide->sprite.top) * wide->sprite.per_step;
}

static void fill_call(Tile *tile, const FastDraw *d, const FastPatch *patches, int count)
{
    const GpProgram *program = d->draw->program;
    flt *in = (flt *)(void *)tile->in;
    flt *pixel = (flt *)(void *)tile->pixel;
    for (int p = 0; p < count; p++) {
        const FastRecord *record = &tile->records[patches[p].record];
        itg x = patch_x(&patches[p]), y = patch_y(&patches[p]);
        if (record->kind == FAST_SPRITE)
            interpolate_sprite(tile, d, record, x, y, in + p * d->modes.components);
        else
            interpolate_triangle(tile, d, record, x, y, in + p * d->modes.components);
        if (program->uses_pixel || program->local_reads) {
            pixel[2 * p] = flt_from_itg(x + tile->x0);
            pixel[2 * p + 1] = flt_from_itg(y + tile->y0);
        }
        if (program->uses_face)
            flt_store(tile->face + p * GP_LANES, flt_set(record->face));
    }
}

/* --- after the shader --------------------------------------------------------------------------- */

/* Lanes of a shaded patch that pass the tests which had to wait. */
static unsigned late_tests(Tile *tile, const FastDraw *d, const FastPatch *patch, int number,
                           const float *depth)
{
    const GpState *state = &d->draw->state;
    const itg x = patch_x(patch), y = patch_y(patch);
    unsigned live = patch->live;
    for (int lane = 0; lane < GP_LANES; lane++) {
        if (!(live >> lane & 1))
            continue;
        bool lives = !d->draw->program->may_discard || !tile->killed[number * GP_LANES + lane];
        if (lives && d->needs.alpha_test) {
            int targets = gp_program_targets(d->draw->program);
            float alpha = tile->color[(number * targets * 4 + 3) * GP_LANES + lane];
            lives = gp_compare_floats(state->alpha_test.test, alpha,
                                      gp_float_from_unorm(state->alpha_test.reference, 8));
        }
        if (lives && d->late_depth) {
            float z = d->draw->program->writes_depth ? tile->shader_depth[number * GP_LANES + lane]
                                                     : depth[lane];
            z = z < d->viewport.min_depth   ? d->viewport.min_depth
                : z > d->viewport.max_depth ? d->viewport.max_depth
                                            : z;
            lives = FAST(depth_stencil)(tile, d, fast_at(x[lane], y[lane]), 1, flt_set(z),
                                        tile->records[patch->record].face > 0);
        }
        if (!lives)
            live &= ~(1u << lane);
    }
    return live;
}

void FAST(shade_patches)(Tile *tile, const FastDraw *d, const FastPatch *patches, int count,
                         const float *depths)
{
    fill_call(tile, d, patches, count);
    FAST(run_pixel_shader)(tile, d, count);
    int targets = gp_program_targets(d->draw->program);
    const flt *color = (const flt *)(const void *)tile->color;
    bool late = d->draw->program->may_discard || d->needs.alpha_test || d->late_depth;
    for (int p = 0; p < count; p++) {
        unsigned live = patches[p].live;
        if (late)
            live = late_tests(tile, d, &patches[p], p, depths + p * GP_LANES);
        if (live && d->needs.color)
            FAST(merge_patch)(tile, d, &patches[p], live, color + p * targets * 4);
    }
}

/* --- the queue ---------------------------------------------------------------------------------- */

static void queue(Tile *tile, FastPatch patch, flt depth)
{
    if (tile->patch_count == FAST_BLOCK)
        FAST(flush_patches)(tile);
    tile->patches[tile->patch_count] = patch;
    flt_store(tile->patch_depth + tile->patch_count * GP_LANES, depth);
    tile->patch_count++;
}

void FAST(queue_row)(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live, flt depth)
{
    queue(tile, (FastPatch){ record, live, (uint8_t)x, (uint8_t)y, .quads = false }, depth);
}

void FAST(queue_quads)(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live, flt depth)
{
    queue(tile, (FastPatch){ record, live, (uint8_t)x, (uint8_t)y, .quads = true }, depth);
}

void FAST(flush_patches)(Tile *tile)
{
    if (tile->patch_count)
        FAST(shade_patches)
    (tile, tile->draw, tile->patches, (int)tile->patch_count, tile->patch_depth);
    tile->patch_count = 0;
}
