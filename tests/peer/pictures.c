/* What the peer check shows to the eye. */
#include "tests/peer/peer.h"

#include "apps/frame/picture.h"

#include <stdio.h>
#include <sys/stat.h>

static void put(const GpSurface *surface, size_t x, size_t y, uint8_t r, uint8_t g, uint8_t b)
{
    uint8_t *bgra = surface->level[0].texels + y * surface->level[0].pitch + x * 4;
    bgra[0] = b;
    bgra[1] = g;
    bgra[2] = r;
    bgra[3] = 255;
}

static void draw_sides(const GpSurface *surface, const PeerPicture *ours, const PeerPicture *theirs)
{
    for (size_t i = 0; i < PEER_PIXELS; i++) {
        const uint8_t *a = ours->rgba[i], *b = theirs->rgba[i];
        size_t x = i % PEER_SIZE, y = i / PEER_SIZE;
        put(surface, x, y, a[0], a[1], a[2]);
        put(surface, PEER_SIZE + x, y, b[0], b[1], b[2]);
    }
}

static void draw_difference(const GpSurface *surface, const PeerPicture *ours,
                            const PeerPicture *theirs)
{
    for (size_t i = 0; i < PEER_PIXELS; i++) {
        const uint8_t *a = ours->rgba[i], *b = theirs->rgba[i];
        size_t x = i % PEER_SIZE, y = i / PEER_SIZE;
        uint8_t grey = (uint8_t)((a[0] + a[1] + a[2]) / 12);
        int most = 0;
        for (int c = 0; c < 3; c++) {
            int difference = a[c] > b[c] ? a[c] - b[c] : b[c] - a[c];
            most = difference > most ? difference : most;
        }
        if (a[3] != b[3])
            put(surface, x, y, 255, 255, 255);
        else if (most > 1)
            put(surface, x, y, 255, 40, 40);
        else if (most == 1)
            put(surface, x, y, 80, 140, 255);
        else
            put(surface, x, y, grey, grey, grey);
    }
}

typedef void DrawFn(const GpSurface *surface, const PeerPicture *ours, const PeerPicture *theirs);

static GpResult write_one(const char *name, const char *suffix, uint32_t width, DrawFn *fill,
                          const PeerPicture *ours, const PeerPicture *theirs, GpError *error)
{
    char path[256];
    GpSurface *surface;
    GpSurfaceDesc desc = { .format = GP_A8R8G8B8, .width = width, .height = PEER_SIZE };
    GpResult result = gp_surface_create(&desc, &surface, error);
    if (result)
        return result;
    snprintf(path, sizeof path, "out/peer/%s_%s.png", name, suffix);
    fill(surface, ours, theirs);
    result = picture_write_surface(path, surface, false, NULL, error);
    gp_surface_destroy(&surface);
    return result;
}

GpResult peer_write_pictures(const char *name, const PeerPicture *ours, const PeerPicture *theirs,
                             GpError *error)
{
    mkdir("out", 0777); /* that they exist already is fine; that they do not will show below */
    mkdir("out/peer", 0777);
    GpResult result = write_one(name, "sides", 2 * PEER_SIZE, draw_sides, ours, theirs, error);
    if (!result)
        result = write_one(name, "difference", PEER_SIZE, draw_difference, ours, theirs, error);
    return result;
}
