/* make check-peer: glasspipe against Mesa's llvmpipe, an independent rasterizer; see peer.h.
 *
 * Run from the root of the repository. Every scene is drawn three times: by glasspipe, exactly, and
 * by llvmpipe, twice over: from its own vertex arithmetic, and from glasspipe's clip positions. All
 * pixels are compared, and each that differs has to have a cause. Pictures go to out/peer. */
#include "tests/peer/peer.h"

#include "pipeline/io/file.h"

#include <math.h>
#include <stdio.h>

enum { CODES = 6, LISTED = 6 };

/* What comparing two pictures found. */
typedef struct Findings {
    uint32_t ours, theirs, exact, both; /* pixels covered */
    uint32_t not_exact;                 /* coverage of glasspipe is not the exact coverage */
    uint32_t difference[CODES];         /* pixels by difference in codes; the last: that or more */
    uint32_t over_one;                  /* more than 1/255 apart, same triangle or not */
    int most;
    uint32_t cause[PEER_CAUSES];
    double edge; /* farthest that a ONE_ONLY or EDGE sample lies from its edge, 1/256 pixel */
    double our_color, our_depth, their_color, their_depth;
    PeerDifference listed[PEER_CAUSES][LISTED];
} Findings;

/* Most pixels that may differ, for a reason each. Measured with Mesa 22.3 on x86-64 with AVX2, with
 * SSE2 only, and without SSE, which is the way of other processors too.
 *
 * One only: from the same clip positions both rasterizers work in exact integers on the same
 * numbers. From its own vertices llvmpipe's y runs up, which rounds otherwise in the viewport: one
 * corner in 200 snaps to the neighbouring 1/256. Of some 4000 samples along an outline about
 * 4000 * 2 / 200 / 256 = 0.2 change. Measured: 0 in all scenes.
 *
 * Edges: the same inside the outline, where up to a hundred times as many edges pass. Measured: 20
 * with 1,000,000 triangles. From the same positions 0, except for two reasons: without SSE llvmpipe
 * rounds ties of the snap (one coordinate in 64) away from zero and not to even, 5; and it cuts
 * triangles at the window's border and snaps the new corners, 3.
 *
 * Ties: surfaces that meet at a silhouette, where llvmpipe's depth is off by its slope times up to
 * half a sub-pixel step. Measured: 4, on the bunny.
 *
 * Over one: how many of all these may show a colour more than 1/255 away. Most do not, for meshes
 * are smooth and the other triangle is a neighbour. Measured: 0 in all scenes. */
typedef struct Bounds {
    double one_only, edges, ties, over_one;
} Bounds;

static const Bounds bounds_of[] = {
    [PEER_OWN_VERTICES] = { .one_only = 3, .edges = 32, .ties = 8, .over_one = 3 },
    [PEER_SAME_VERTICES] = { .one_only = 0, .edges = 8, .ties = 8, .over_one = 3 },
};

/* Pixels that may differ by 1/255, of all: llvmpipe's planes start from corners before snapping, up
 * to half a step off, which turns a rounding where the colour is close to one. Measured: 1 in 234
 * on the bunny, whose slopes are steep; 1 in 1000 on the tori. */
static const double most_off_by_one = 0.006;

/* Half a step of binary32 below 1: glasspipe's depth is the exact one, correctly rounded, and so no
 * looser bound is right. What exceeds it is the binary64 of the exact picture itself. */
static const double our_depth_reach = 0x1p-25 * (1 + 0x1p-20);

/* Half a code, and what binary32 adds to it. Measured: 0.5005. */
static const double our_color_reach = 0.501;

typedef struct Tally {
    int passed, failed, skipped;
} Tally;

static void check(Tally *tally, const char *what, double value, double bound)
{
    bool ok = value <= bound;
    printf("    %-6s %-62s %.6g, at most %.6g\n", ok ? "ok" : "FAILED", what, value, bound);
    tally->passed += ok;
    tally->failed += !ok;
}

/* --- comparing -------------------------------------------------------------------------------- */

static void add(Findings *f, const PeerDifference *d)
{
    f->ours += d->ours_covers;
    f->theirs += d->theirs_covers;
    f->exact += d->exact_triangle != PEER_NOTHING;
    f->not_exact += d->ours_covers != (d->exact_triangle != PEER_NOTHING);
    if (d->cause != PEER_AGREES && f->cause[d->cause] < LISTED)
        f->listed[d->cause][f->cause[d->cause]] = *d;
    f->cause[d->cause]++;
    if (d->cause == PEER_ONE_ONLY || d->cause == PEER_EDGE)
        f->edge = fmax(f->edge, d->edge.distance);
    if (!d->ours_covers || !d->theirs_covers)
        return;
    f->both++;
    f->difference[d->color < CODES ? d->color : CODES - 1]++;
    f->over_one += d->color > 1;
    f->most = d->color > f->most ? d->color : f->most;
    f->our_color = fmax(f->our_color, d->our_color);
    f->our_depth = fmax(f->our_depth, d->our_depth);
    f->their_color = fmax(f->their_color, d->their_color);
    f->their_depth = fmax(f->their_depth, d->their_depth);
}

static Findings compare(const PeerScene *scene, const PeerTruth *truth, const PeerPicture *ours,
                        const PeerPicture *theirs)
{
    Findings f = { 0 };
    for (int y = 0; y < PEER_SIZE; y++)
        for (int x = 0; x < PEER_SIZE; x++) {
            PeerDifference d = peer_explain(scene, truth, ours, theirs, x, y);
            add(&f, &d);
        }
    return f;
}

static void print_listed(const Findings *f, PeerCause cause, const char *title)
{
    if (f->cause[cause])
        printf("    %s: %u\n", title, f->cause[cause]);
    for (uint32_t i = 0; i < f->cause[cause] && i < LISTED; i++) {
        const PeerDifference *d = &f->listed[cause][i];
        printf("      (%d, %d)", d->x, d->y);
        if (cause == PEER_ONE_ONLY)
            printf(" %s only", d->ours_covers ? "glasspipe" : "llvmpipe");
        else
            printf(" colours %d apart, triangle %u, llvmpipe %u, depth %+.2g", d->color,
                   d->exact_triangle, d->their_triangle, d->depth_gap);
        printf(", edge |%lld| / sqrt(%lld) = %.3f\n", (long long)d->edge.value,
               (long long)d->edge.length2, d->edge.distance);
    }
}

static void print_findings(const Findings *f)
{
    printf("    covered: glasspipe %u, llvmpipe %u, exactly %u, by both %u\n", f->ours, f->theirs,
           f->exact, f->both);
    printf(
        "    difference in 1/255: 0 in %u pixels, 1 in %u, 2 in %u, 3 in %u, 4 in %u, more in %u;"
        " largest %d\n",
        f->difference[0], f->difference[1], f->difference[2], f->difference[3], f->difference[4],
        f->difference[5], f->most);
    print_listed(f, PEER_ONE_ONLY, "covered by one only (nearest edge, in 1/256 pixel)");
    print_listed(f, PEER_EDGE, "on the other side of an edge (corners snapped differently)");
    print_listed(f, PEER_TIE, "depth ties (llvmpipe's planes put the farther triangle in front)");
    print_listed(f, PEER_SHADING, "shaded differently");
    print_listed(f, PEER_OURS, "where glasspipe's colour is wrong");
    print_listed(f, PEER_UNKNOWN, "without a known cause");
}

static void check_glasspipe(const Findings *f, Tally *tally)
{
    check(tally, "pixels that glasspipe does not cover as it should", f->not_exact, 0);
    check(tally, "glasspipe: colour, codes from the exact one", f->our_color, our_color_reach);
    check(tally, "glasspipe: depth, distance from the exact one", f->our_depth, our_depth_reach);
}

static void check_against(const Findings *f, PeerVertices vertices, Tally *tally)
{
    const Bounds *bounds = &bounds_of[vertices];
    check(tally, "pixels covered by one only", f->cause[PEER_ONE_ONLY], bounds->one_only);
    check(tally, "pixels on the other side of an edge", f->cause[PEER_EDGE], bounds->edges);
    check(tally, "samples of these two: distance from an edge, 1/256 pixel", f->edge,
          PEER_EDGE_REACH);
    check(tally, "pixels where a depth tie goes the other way", f->cause[PEER_TIE], bounds->ties);
    check(tally, "pixels of the same triangle more than 1/255 apart", f->cause[PEER_SHADING], 0);
    check(tally, "pixels that differ without a cause", f->cause[PEER_UNKNOWN], 0);
    check(tally, "pixels more than 1/255 apart at all", f->over_one, bounds->over_one);
    check(tally, "share of pixels 1/255 apart", f->difference[1] / (double)f->both,
          most_off_by_one);
    check(tally, "llvmpipe: colour, codes from that of its unsnapped planes", f->their_color,
          PEER_COLOR_REACH);
    check(tally, "llvmpipe: depth, roundings from that of its unsnapped planes", f->their_depth,
          PEER_DEPTH_REACH);
}

/* --- scenes ----------------------------------------------------------------------------------- */

/* A check that cannot fail proves nothing: glasspipe's viewport moved by the smallest step there is
 * has to break the bounds of coverage and of colour.
 * in   theirs: from glasspipe's clip positions: any pixel covered by one only is too much */
static GpResult check_power(const PeerScene *scene, const PeerTruth *truth,
                            const PeerPicture *theirs, Tally *tally, GpError *error)
{
    PeerPicture moved;
    GpResult result = peer_picture_create(false, &moved);
    if (result)
        return gp_fail(error, result, "no memory for a picture");
    result = peer_draw_glasspipe(scene, 0x1p-8f, &moved, error);
    if (!result) {
        Findings f = compare(scene, truth, &moved, theirs);
        bool noticed[2] = { f.cause[PEER_ONE_ONLY] > 0, f.cause[PEER_OURS] > 0 };
        printf("  a planted fault, glasspipe moved right by 1/256 pixel: covered by one only: %u;"
               " wrong colour: %u\n",
               f.cause[PEER_ONE_ONLY], f.cause[PEER_OURS]);
        for (int i = 0; i < 2; i++) {
            printf("    %-6s noticed in %s\n", noticed[i] ? "ok" : "FAILED",
                   i == 0 ? "coverage" : "colour");
            tally->passed += noticed[i];
            tally->failed += !noticed[i];
        }
    }
    peer_picture_free(&moved);
    return result;
}

/* Compares with llvmpipe from vertices of the kind `first` and those after it; leaves in *theirs
 * what it drew from glasspipe's positions. */
static GpResult compare_both_ways(PeerGl *gl, PeerVertices first, const PeerScene *scene,
                                  const PeerTruth *truth, const PeerPicture *ours,
                                  PeerPicture *theirs, Tally *tally, GpError *error)
{
    static const char *const title[] = {
        [PEER_OWN_VERTICES] = "llvmpipe from its own vertices, y up",
        [PEER_SAME_VERTICES] = "llvmpipe from glasspipe's clip positions, y down",
    };
    for (int v = (int)first; v <= PEER_SAME_VERTICES; v++) {
        GpResult result = peer_draw_gl(gl, scene, (PeerVertices)v, theirs, error);
        if (result)
            return result;
        Findings f = compare(scene, truth, ours, theirs);
        printf("  %s\n", title[v]);
        print_findings(&f);
        if (v == (int)first)
            check_glasspipe(&f, tally);
        check_against(&f, (PeerVertices)v, tally);
    }
    return GP_OK;
}

static void check_scene(PeerGl *gl, const char *name, PeerVertices first, PeerScene *scene,
                        Tally *tally)
{
    PeerPicture ours = { 0 }, theirs = { 0 };
    PeerTruth truth = { 0 };
    GpError error = { "" };
    printf("%s: %u triangles\n", name, scene->index_count / 3);
    GpResult result = peer_picture_create(false, &ours);
    if (!result)
        result = peer_picture_create(true, &theirs);
    if (!result)
        result = peer_draw_truth(scene, &truth);
    if (!result)
        result = peer_draw_glasspipe(scene, 0, &ours, &error);
    if (!result)
        result = compare_both_ways(gl, first, scene, &truth, &ours, &theirs, tally, &error);
    if (!result)
        result = check_power(scene, &truth, &theirs, tally, &error);
    if (!result)
        result = peer_write_pictures(name, &ours, &theirs, &error);
    if (result) {
        printf("    FAILED %s: %s %s\n", name, gp_result_name(result), error.text);
        tally->failed++;
    }
    peer_picture_free(&ours);
    peer_picture_free(&theirs);
    peer_truth_free(&truth);
    peer_scene_free(scene);
}

static void check_bunny(PeerGl *gl, Tally *tally)
{
    char path[1024];
    PeerScene scene;
    GpError error = { "" };
    if (gp_data_find("meshes/bunny.ply", path, sizeof path, &error)) {
        printf("bunny: skipped: %s\n", error.text);
        tally->skipped++;
    } else if (peer_bunny(path, &scene, &error)) {
        printf("bunny: FAILED: %s\n", error.text);
        tally->failed++;
    } else
        check_scene(gl, "bunny", PEER_OWN_VERTICES, &scene, tally);
}

static void check_tori(PeerGl *gl, Tally *tally)
{
    static const struct {
        const char *name;
        uint32_t around, across;
        double distance;
    } tori[] = {
        { "torus_1000000", 1000, 500, 3.6 }, /* about one visible triangle a pixel */
        { "torus_10000", 100, 50, 3.6 },
        { "torus_50", 5, 5, 3.6 },              /* edges of some 400 pixels */
        { "torus_close_40000", 200, 100, 1.6 }, /* cut by the window's borders */
    };
    for (size_t i = 0; i < GP_COUNT(tori); i++) {
        PeerScene scene;
        if (!peer_torus(tori[i].around, tori[i].across, tori[i].distance, &scene))
            check_scene(gl, tori[i].name, PEER_OWN_VERTICES, &scene, tally);
        else {
            printf("%s: FAILED: out of memory\n", tori[i].name);
            tally->failed++;
        }
    }
}

/* With y up OpenGL's rule for samples on horizontal edges is upside down: only y down compares. */
static void check_lattice(PeerGl *gl, Tally *tally)
{
    PeerScene scene;
    if (!peer_lattice(&scene))
        check_scene(gl, "lattice", PEER_SAME_VERTICES, &scene, tally);
    else {
        printf("lattice: FAILED: out of memory\n");
        tally->failed++;
    }
}

int main(void)
{
    PeerGl *gl;
    GpError error = { "" };
    Tally tally = { 0 };
    GpResult result = peer_gl_open(&gl, &error);
    if (result == GP_ERROR_UNSUPPORTED) {
        printf("skipped: %s\n", error.text);
        tally.skipped++;
    } else if (result) {
        printf("FAILED: %s\n", error.text);
        tally.failed++;
    } else {
        printf("glasspipe against %s, %d x %d, phong, depth test on, no culling\n",
               peer_gl_name(gl), PEER_SIZE, PEER_SIZE);
        check_bunny(gl, &tally);
        check_tori(gl, &tally);
        check_lattice(gl, &tally);
        peer_gl_close(&gl);
    }
    printf("%d passed, %d failed, %d skipped\n", tally.passed, tally.failed, tally.skipped);
    return tally.failed ? 1 : 0;
}
