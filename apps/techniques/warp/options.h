/* What may be set of depth images: how they are drawn, of what, and how they are looked at. */
#ifndef APPS_TECHNIQUES_WARP_OPTIONS_H
#define APPS_TECHNIQUES_WARP_OPTIONS_H

#include "apps/base/orbit.h"
#include "apps/techniques/settings.h"

typedef enum WarpMethod {
    WARP_AUTO, /* by what the image is */
    WARP_POLYGONS,
    WARP_METHODS
} WarpMethod;

typedef enum WarpKind { WARP_PLANAR, WARP_CYLINDER } WarpKind;

/* The setting of the technique. */
typedef struct WarpOptions {
    WarpMethod method;
    uint32_t source_size[2]; /* of what is captured */
    double turn;             /* of the view about the source, in degrees */

    /* aside of the key */
    WarpKind kind;      /* of what is captured */
    const char *source; /* a camera's file; NULL: in front of the model */
    const char *color;  /* "file", "waves:K", or a name; NULL: the file's, where it has any */
    bool unlit;
    const char *camera; /* a file; NULL: the orbit, or a turn about the source */
    Orbit orbit;        /* of the view, where its azimuth is not NaN */
    const char *truth;  /* a mesh or a depth image; NULL: the mesh that was captured */
    bool measures;
} WarpOptions;

extern const SettingField warp_settings[];
extern const WarpOptions warp_option_defaults;

/* As a technique's imply and check. */
void warp_options_imply(void *options, uint32_t given);
GpResult warp_options_check(const void *options, uint32_t given, const char *extension,
                            GpError *error);

/* What a method is called. */
const char *warp_method_name(WarpMethod method);

#endif
