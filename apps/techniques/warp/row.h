/* A way of drawing depth images, as a row of the table of methods. */
#ifndef APPS_TECHNIQUES_WARP_ROW_H
#define APPS_TECHNIQUES_WARP_ROW_H

#include "apps/depth_images/drawing/detail.h"
#include "apps/depth_images/drawing/view.h"
#include "apps/techniques/warp/options.h"

/* How an image is drawn. */
typedef struct WarpUse {
    const WarpOptions *options;
    WarpDetail detail; /* on it */
    bool one_sided;    /* it shows one side of a solid, of which others show the rest */
} WarpUse;

typedef struct WarpRow {
    size_t bytes; /* of what is kept of an image */
    GpResult (*open)(const DepthImage *image, const WarpOptions *options, void *made,
                     GpError *error);
    void (*close)(void *made); /* of a zeroed one too */
    GpResult (*add)(void *made, const WarpUse *use, const WarpView *view, const WarpTarget *target,
                    Frame *frame, GpError *error);
    /* What of a view the method cannot do, a sentence; NULL: nothing. NULL: never */
    const char *(*warning)(const DepthImage *image, const WarpView *view);
} WarpRow;

/* Those of a method whose functions are name_open and name_close. */
#define WARP_ROW_KEEPS(name)                                                                       \
    static GpResult open_##name(const DepthImage *image, const WarpOptions *options, void *made,   \
                                GpError *error)                                                    \
    {                                                                                              \
        (void)options;                                                                             \
        return name##_open(image, made, error);                                                    \
    }                                                                                              \
    static void close_##name(void *made)                                                           \
    {                                                                                              \
        name##_close(made);                                                                        \
    }                                                                                              \
    struct name##_follows

/* rows.c: this project's, and what was printed; rivals.c: the others */
extern const WarpRow warp_layers, warp_direct, warp_surface, warp_planar, warp_cylinder;
extern const WarpRow warp_relief, warp_dmesh, warp_simplified, warp_displacement,
    warp_relief_texture, warp_parallax, warp_bump;

#endif
