/* Why one pixel differs between the two renderers. */
#include "tests/peer/peer.h"

#include <math.h>

static int color_difference(const uint8_t a[4], const uint8_t b[4])
{
    int most = 0;
    for (int c = 0; c < 3; c++) {
        int difference = a[c] > b[c] ? a[c] - b[c] : b[c] - a[c];
        most = difference > most ? difference : most;
    }
    return most;
}

static double color_error(const uint8_t code[4], const double exact[3])
{
    double most = 0;
    for (int c = 0; c < 3; c++)
        most = fmax(most, fabs((double)code[c] - exact[c]));
    return most;
}

static PeerCause explain_other_triangle(const PeerScene *scene, const PeerTruth *truth,
                                        PeerDifference *d)
{
    uint32_t exact = d->exact_triangle, other = d->their_triangle;
    int x = d->x, y = d->y;
    PeerEdge a = peer_nearest_edge_of(scene, truth, exact, x, y);
    PeerEdge b = peer_nearest_edge_of(scene, truth, other, x, y);
    d->edge = a.distance <= b.distance ? a : b;
    d->depth_gap = peer_evaluate(scene, truth, other, PEER_SNAPPED, x, y, NULL) -
                   truth->depth[y * PEER_SIZE + x];

    if (!peer_covers(scene, truth, other, x, y))
        return d->edge.distance <= PEER_EDGE_REACH ? PEER_EDGE : PEER_UNKNOWN;
    double their_gap = peer_evaluate(scene, truth, other, PEER_UNSNAPPED, x, y, NULL) -
                       peer_evaluate(scene, truth, exact, PEER_UNSNAPPED, x, y, NULL);
    double may_err = PEER_DEPTH_REACH * (peer_plane_rounding(scene, truth, exact) +
                                         peer_plane_rounding(scene, truth, other));
    if (their_gap <= may_err)
        return PEER_TIE;
    /* or the nearest triangle does not cover the sample in theirs */
    return a.distance <= PEER_EDGE_REACH ? PEER_EDGE : PEER_UNKNOWN;
}

/* Holds both renderers against the triangle that each shows. */
static void measure(const PeerScene *scene, const PeerTruth *truth, const PeerPicture *ours,
                    const PeerPicture *theirs, PeerDifference *d)
{
    size_t pixel = (size_t)d->y * PEER_SIZE + (size_t)d->x;
    double rgb[3];
    double depth = peer_evaluate(scene, truth, d->exact_triangle, PEER_SNAPPED, d->x, d->y, rgb);
    d->our_color = color_error(ours->rgba[pixel], rgb);
    d->our_depth = fabs((double)ours->depth[pixel] - depth);

    depth = peer_evaluate(scene, truth, d->their_triangle, PEER_UNSNAPPED, d->x, d->y, rgb);
    d->their_color = color_error(theirs->rgba[pixel], rgb);
    d->their_depth = fabs((double)theirs->depth[pixel] - depth) /
                     peer_plane_rounding(scene, truth, d->their_triangle);
}

PeerDifference peer_explain(const PeerScene *scene, const PeerTruth *truth, const PeerPicture *ours,
                            const PeerPicture *theirs, int x, int y)
{
    size_t pixel = (size_t)y * PEER_SIZE + (size_t)x;
    PeerDifference d = { .x = x,
                         .y = y,
                         .ours_covers = ours->rgba[pixel][3] != 0,
                         .theirs_covers = theirs->rgba[pixel][3] != 0,
                         .exact_triangle = truth->triangle[pixel],
                         .their_triangle = theirs->triangle[pixel] };
    if (d.ours_covers != d.theirs_covers) {
        d.cause = PEER_ONE_ONLY;
        d.edge = peer_nearest_edge(scene, truth, x, y);
        return d;
    }
    if (!d.ours_covers)
        return d;
    if (d.exact_triangle == PEER_NOTHING) { /* both cover what nothing covers */
        d.cause = PEER_UNKNOWN;
        return d;
    }
    d.color = color_difference(ours->rgba[pixel], theirs->rgba[pixel]);
    measure(scene, truth, ours, theirs, &d);
    if (d.our_color > PEER_COLOR_REACH)
        d.cause = PEER_OURS;
    else if (d.their_triangle != d.exact_triangle)
        d.cause = explain_other_triangle(scene, truth, &d);
    else if (d.color > 1)
        d.cause = PEER_SHADING;
    return d;
}
