/* Patches: pixels of one triangle or point on their way through the shader, in order. */
#include "pipeline/fast/lanes/shade/patch.h"

#include "pipeline/resources/compare.h"
#include "pipeline/fast/lanes/output/depth.h"
#include "pipeline/fast/lanes/shade/interpolate.h"
#include "pipeline/fast/lanes/shade/mix.h"
#include "pipeline/fast/lanes/raster/sprite.h"

/* --- edges -------------------------------------------------------------------------------------- */

/* Whether c + a x + b y fits wherever in the tile a lane may be: it is greatest at a corner. */
static bool fits_everywhere(int64_t c, int64_t a, int64_t b)
{
    const int64_t across = a * FAST_PITCH, down = b * (FAST_TILE + 1);
    const int64_t ends[4] = { c, c + across, c + down, c + across + down };
    for (int i = 0; i < 4; i++)
        if (ends[i] < INT32_MIN || ends[i] > INT32_MAX)
            return false;
    return true;
}

/* The edges of a large triangle are often small in one tile, or have zeros at the end: those of
 * rectangles along the pixels have fifteen. */
bool FAST(narrow_edge)(const FastWide *wide, int i, Edge *edge)
{
    int64_t c = wide->edge.c[i], a = wide->edge.a[i], b = wide->edge.b[i];
    int zeros = c | a | b ? __builtin_ctzll((uint64_t)(c | a | b)) : 0;
    zeros = zeros < 24 ? zeros : 24;
    if (!fits_everywhere(c >> zeros, a >> zeros, b >> zeros))
        return false;
    *edge = (Edge){ (int32_t)(c >> zeros), (int32_t)(a >> zeros), (int32_t)(b >> zeros),
                    (float)(1 << zeros) };
    return true;
}

/* Both edges in 32 bits, where they fit. */
static bool narrow_edges(const Tile *tile, const FastRecord *r, Edge edge[2])
{
    edge[0] = (Edge){ r->c1, fast_gain_right(r->gain1), fast_gain_down(r->gain1), 1 };
    edge[1] = (Edge){ r->c2, fast_gain_right(r->gain2), fast_gain_down(r->gain2), 1 };
    const FastWide *wide = &tile->wide[r->wide];
    return r->kind == FAST_SMALL ||
           (FAST(narrow_edge)(wide, 0, &edge[0]) && FAST(narrow_edge)(wide, 1, &edge[1]));
}

/* --- barycentrics -------------------------------------------------------------------------------- */

GP_INLINE void set_shares(const FastRecord *r, bool perspective, int p, const flt screen[2],
                          BlockShares *shares)
{
    shares->screen[0][p] = screen[0];
    shares->screen[1][p] = screen[1];
    if (perspective)
        correct_shares(shares, p, flt_set(r->ratio1), flt_set(r->ratio2));
}

/* The scale is exact, so the product is that of the whole edge. */
GP_INLINE void small_shares(const FastRecord *r, const Edge edge[2], bool perspective,
                            const FastPatch *patches, int count, BlockShares *shares)
{
    const itg column = patch_columns(patches->wide), row = patch_rows(patches->wide);
    utg across[2];
    flt scale[2];
    GP_UNROLL
    for (int i = 0; i < 2; i++) {
        across[i] = (utg)(column * edge[i].a + row * edge[i].b) + (uint32_t)edge[i].c;
        scale[i] = flt_set(r->inverse_area * edge[i].unit);
    }
    for (int p = 0; p < count; p++) {
        flt screen[2];
        GP_UNROLL
        for (int i = 0; i < 2; i++) {
            const uint32_t first =
                (uint32_t)edge[i].a * patches[p].x + (uint32_t)edge[i].b * patches[p].y;
            screen[i] = flt_from_itg((itg)(across[i] + first)) * scale[i];
        }
        set_shares(r, perspective, p, screen, shares);
    }
}

/* Edges that need more bits: exact in binary64, rounded once. */
GP_INLINE void wide_shares(const FastRecord *r, const FastWide *wide, bool perspective,
                           const FastPatch *patches, int count, BlockShares *shares)
{
    const dbl column = dbl_from_itg(patch_columns(patches->wide));
    const dbl row = dbl_from_itg(patch_rows(patches->wide));
    for (int p = 0; p < count; p++) {
        flt screen[2];
        GP_UNROLL
        for (int i = 0; i < 2; i++) {
            const double a = (double)wide->edge.a[i], b = (double)wide->edge.b[i];
            const double first = (double)wide->edge.c[i] + (a * patches[p].x + b * patches[p].y);
            const dbl edge = first + (column * a + row * b);
            screen[i] = __builtin_convertvector(edge, flt) * r->inverse_area;
        }
        set_shares(r, perspective, p, screen, shares);
    }
}

static void find_shares(const Tile *tile, const FastRecord *r, bool perspective,
                        const FastPatch *patches, int count, BlockShares *shares)
{
    Edge edge[2];
    if (!narrow_edges(tile, r, edge))
        wide_shares(r, &tile->wide[r->wide], perspective, patches, count, shares);
    else if (perspective)
        small_shares(r, edge, true, patches, count, shares);
    else
        small_shares(r, edge, false, patches, count, shares);
}

/* --- interpolation ------------------------------------------------------------------------------ */

/* Up to four components of a run at once: more of them would leave no registers for shares. */
enum { AT_ONCE = 4 };

GP_INLINE void blend_components(const FastRecord *r, const flt share[2][FAST_BLOCK],
                                const uint8_t *component, int components, int count, int stride,
                                flt *in)
{
    flt v0[AT_ONCE], to1[AT_ONCE], to2[AT_ONCE];
    GP_UNROLL
    for (int i = 0; i < components; i++) {
        v0[i] = flt_set(r->corner[0][component[i]]);
        to1[i] = flt_set(r->corner[1][component[i]]) - v0[i];
        to2[i] = flt_set(r->corner[2][component[i]]) - v0[i];
    }
    for (int p = 0; p < count; p++, in += stride) {
        const flt l1 = share[0][p], l2 = share[1][p];
        GP_UNROLL
        for (int i = 0; i < components; i++)
            in[component[i]] = v0[i] + (l1 * to1[i] + l2 * to2[i]);
    }
}

static void blend_run(const FastRecord *r, const flt share[2][FAST_BLOCK], uint64_t components,
                      int count, int stride, flt *in)
{
    while (components) {
        uint8_t component[AT_ONCE];
        int found = 0;
        for (; components && found < AT_ONCE; components &= components - 1)
            component[found++] = (uint8_t)__builtin_ctzll(components);
        if (found == 1)
            blend_components(r, share, component, 1, count, stride, in);
        else if (found == 2)
            blend_components(r, share, component, 2, count, stride, in);
        else if (found == 3)
            blend_components(r, share, component, 3, count, stride, in);
        else
            blend_components(r, share, component, AT_ONCE, count, stride, in);
    }
}

static void repeat_run(const FastRecord *r, uint64_t components, int count, int stride, flt *in)
{
    for (; components; components &= components - 1) {
        const int c = __builtin_ctzll(components);
        for (int p = 0; p < count; p++)
            in[c + p * stride] = flt_set(r->corner[0][c]);
    }
}

/* A run: patches of one triangle and one shape. What does not change in it is found once. */
static void interpolate_run(const Tile *tile, const FastDraw *d, const FastPatch *patches,
                            int count, flt *in)
{
    const FastRecord *r = &tile->records[patches->record];
    const int stride = d->modes.components;
    /* where both ratios are 1, so is w, and the shares are the same */
    const bool flat_on = r->ratio1 == 1.0f && r->ratio2 == 1.0f;
    const uint64_t perspective = flat_on ? 0 : d->varyings_by[GP_PERSPECTIVE];
    const uint64_t screen =
        (d->varyings_by[GP_PERSPECTIVE] ^ perspective) | d->varyings_by[GP_LINEAR_SCREEN];
    BlockShares shares;
    find_shares(tile, r, perspective != 0, patches, count, &shares);
    blend_run(r, (const flt(*)[FAST_BLOCK])shares.perspective, perspective, count, stride, in);
    blend_run(r, (const flt(*)[FAST_BLOCK])shares.screen, screen, count, stride, in);
    repeat_run(r, d->varyings_by[GP_FLAT], count, stride, in);
}

/* Patches from `first` on that share a triangle and a shape. */
static int run_length(const FastPatch *first, int count)
{
    int length = 1;
    while (length < count && first[length].record == first->record &&
           first[length].wide == first->wide && !first[length].mixed)
        length++;
    return length;
}

static void interpolate_sprite(const Tile *tile, const FastDraw *d, const FastPatch *patch, flt *in)
{
    const FastRecord *record = &tile->records[patch->record];
    FAST(interpolate_sprite)(tile, d, record, patch_x(patch), patch_y(patch), in);
}

static void interpolate_patches(Tile *tile, const FastDraw *d, const FastPatch *patches, int count)
{
    const int stride = d->modes.components;
    flt *in = (flt *)(void *)tile->in;
    for (int p = 0, length; p < count; p += length) {
        length = 1;
        if (patches[p].mixed)
            FAST(interpolate_mixes)(tile, d, &tile->mixes[p], 1, in + p * stride);
        else if (tile->records[patches[p].record].kind == FAST_SPRITE)
            interpolate_sprite(tile, d, &patches[p], in + p * stride);
        else {
            length = run_length(&patches[p], count - p);
            interpolate_run(tile, d, &patches[p], length, in + p * stride);
        }
    }
}

/* What the program asks of the pixels besides interpolants. */
static void place_patches(Tile *tile, const GpProgram *program, const FastPatch *patches, int count)
{
    flt *pixel = (flt *)(void *)tile->pixel;
    if (program->uses_pixel)
        for (int p = 0; p < count; p++) {
            const FastMix *mix = &tile->mixes[p];
            itg x = patches[p].mixed ? mix->x : patch_x(&patches[p]);
            itg y = patches[p].mixed ? mix->y : patch_y(&patches[p]);
            pixel[2 * p] = flt_from_itg(x + tile->x0);
            pixel[2 * p + 1] = flt_from_itg(y + tile->y0);
        }
    if (program->uses_face)
        for (int p = 0; p < count; p++)
            flt_store(tile->face + p * GP_LANES, flt_set(tile->records[patches[p].record].face));
}

/* --- after the shader --------------------------------------------------------------------------- */

static msk compare_lanes(GpCompare test, flt a, float b)
{
    msk less = (msk)(a < b), equal = (msk)(a == b), greater = (msk)(a > b);
    msk accepted = accepted_lanes(test, less, equal, greater);
    if (gp_compare_accepts(test, GP_IS_UNORDERED))
        accepted |= ~(less | equal | greater);
    return accepted;
}

unsigned FAST(test_patch)(Tile *tile, const FastDraw *d, const FastPatch *patch, unsigned live,
                          flt z)
{
    uint32_t at = fast_at(patch->x, patch->y);
    const bool front = tile->records[patch->record].face > 0;
    if (!patch->wide || patch->wide == GP_LANES)
        return msk_bits(
            FAST(test_depth_stencil)(tile, d, at, !patch->wide, mask_of(live), z, front));
    const itg row = lane_row(patch->wide);
    msk passed = itg_set(0);
    for (int r = 0; has_row(patch, r); r++, at += FAST_PITCH - patch->wide)
        passed |=
            FAST(test_depth_stencil)(tile, d, at, false, (msk)(row == r) & mask_of(live), z, front);
    return msk_bits(passed);
}

/* Lanes of shaded patch p that pass the tests which had to wait. */
static unsigned late_tests(Tile *tile, const FastDraw *d, const FastPatch *patch, int p,
                           const float *depth)
{
    const GpAlphaTest *alpha = &d->draw->state.alpha_test;
    const int targets = gp_program_targets(d->draw->program);
    unsigned live = patch->live;
    if (d->draw->program->may_discard)
        live &= ~msk_bits((msk)flt_load((const float *)(const void *)tile->killed + p * GP_LANES));
    if (d->needs.alpha_test)
        live &= msk_bits(compare_lanes(alpha->test,
                                       flt_load(tile->color + (p * targets * 4 + 3) * GP_LANES),
                                       gp_float_from_unorm(alpha->reference, 8)));
    if (d->late_depth && live) {
        bool replaced = d->draw->program->writes_depth;
        flt z = flt_load((replaced ? tile->shader_depth : depth) + p * GP_LANES);
        live = FAST(test_patch)(tile, d, patch, live, z);
    }
    return live;
}

void FAST(shade_inputs)(Tile *tile, const FastDraw *d, const FastPatch *patches, int count,
                        const float *depths)
{
    unsigned live[FAST_BLOCK];
    place_patches(tile, d->draw->program, patches, count);
    FAST(run_pixel_shader)(tile, d, patches, count);
    const bool late = d->draw->program->may_discard || d->needs.alpha_test || d->late_depth;
    uint32_t fragments = 0;
    for (int p = 0; p < count; p++) {
        fragments += (uint32_t)__builtin_popcount(patches[p].live);
        live[p] = late ? late_tests(tile, d, &patches[p], p, depths) : patches[p].live;
    }
    tile->fragments_shaded += fragments;
    if (FAST(only_adds)(tile, d))
        FAST(add_patches)(tile, d, patches, live, count, (const flt *)(const void *)tile->color);
    else if (d->needs.color)
        FAST(merge_patches)(tile, d, patches, live, count, (const flt *)(const void *)tile->color);
}

void FAST(shade_patches)(Tile *tile, const FastDraw *d, const FastPatch *patches, int count,
                         const float *depths)
{
    interpolate_patches(tile, d, patches, count);
    FAST(shade_inputs)(tile, d, patches, count, depths);
}

/* --- the queue ---------------------------------------------------------------------------------- */

FastPatch *FAST(new_patch)(Tile *tile)
{
    if (tile->patch_count == FAST_BLOCK || tile->layer_count)
        FAST(flush_patches)(tile);
    return &tile->patches[tile->patch_count++];
}

static void queue(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live, int32_t wide,
                  flt depth)
{
    FastPatch *patch = FAST(new_patch)(tile);
    set_patch(patch, record, x, y, live, wide);
    if (tile->draw->late_depth)
        flt_store(tile->patch_depth + (patch - tile->patches) * GP_LANES, depth);
}

void FAST(queue_row)(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live, flt depth)
{
    queue(tile, record, x, y, live, GP_LANES, depth);
}

void FAST(queue_quads)(Tile *tile, uint32_t record, int32_t x, int32_t y, unsigned live, flt depth)
{
    queue(tile, record, x, y, live, 0, depth);
}

void FAST(flush_patches)(Tile *tile)
{
    const int count = (int)tile->patch_count;
    if (!count && !tile->layer_count)
        return;
    FastPhase before = fast_turn_to(tile, FAST_SHADING);
    if (tile->layer_count)
        FAST(shade_layers)(tile);
    else if (tile->draw->draw->geometry.primitive == GP_POINTS) /* come with their inputs */
        FAST(shade_inputs)(tile, tile->draw, tile->patches, count, tile->patch_depth);
    else
        FAST(shade_patches)(tile, tile->draw, tile->patches, count, tile->patch_depth);
    tile->patch_count = 0;
    fast_turn_to(tile, before);
}
