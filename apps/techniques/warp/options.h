/* What may be set of depth images: how they are drawn, of what, and how they are looked at. */
#ifndef APPS_TECHNIQUES_WARP_OPTIONS_H
#define APPS_TECHNIQUES_WARP_OPTIONS_H

#include "apps/base/orbit.h"
#include "apps/techniques/settings.h"

typedef enum WarpMethod {
    WARP_AUTO, /* by what the image is */
    WARP_LAYERS,
    WARP_DIRECT,
    WARP_SURFACE,
    WARP_PLANAR_PRINTED,
    WARP_CYLINDER_PRINTED,
    WARP_RELIEF,
    WARP_DMESH,
    WARP_SIMPLIFIED,
    WARP_DISPLACEMENT,
    WARP_RELIEF_TEXTURE,
    WARP_PARALLAX,
    WARP_BUMP,
    WARP_POLYGONS,
    WARP_METHODS
} WarpMethod;

/* Where surfaces end. */
typedef enum WarpCut {
    WARP_CUT_AUTO, /* by slopes; as printed: nowhere */
    WARP_CUT_SLOPES,
    WARP_CUT_RELATIVE,
    WARP_CUT_NONE
} WarpCut;

typedef enum WarpKind { WARP_PLANAR, WARP_CYLINDER, WARP_BOX, WARP_KINDS } WarpKind;

/* The setting of the technique. */
typedef struct WarpOptions {
    WarpMethod method;
    WarpKind kind;           /* of what is captured of a mesh */
    uint32_t source_size[2]; /* of that */
    uint32_t step;           /* pixels from vertex to vertex; 0: by the footprint */
    WarpCut cut;
    double tolerance;          /* as DirectSetting has it */
    uint32_t entries;          /* as PlanarSetting has it */
    uint32_t search, halvings; /* of rays, as ReliefSetting has them */
    bool unlimited;            /* parallax */
    double share;              /* of simplified: as DmeshDetail has it; 0: 0.1 */
    uint32_t field;            /* of displacement: as DisplacementField has its size */
    double turn;               /* of the view about the source, in degrees */

    /* aside of the key */
    const char *source; /* a camera's file; NULL: in front of the model */
    const char *color;  /* "file", "waves:K", or a name; NULL: the file's, where it has any */
    bool unlit;
    const char *detail;     /* a picture of heights; NULL: none */
    double detail_depth;    /* by which its white stands out; 0: a fiftieth of the model */
    uint32_t detail_repeat; /* across an image; 0: 4 */
    const char *camera;     /* a file; NULL: the orbit, or a turn about the source */
    Orbit orbit;            /* of the view, where its azimuth is not NaN */
    const char *truth;      /* a mesh or a depth image; NULL: the mesh that was captured */
    bool measures;
} WarpOptions;

extern const SettingField warp_settings[];
extern const WarpOptions warp_option_defaults;
extern const char *const warp_ups[]; /* names of OrbitUp */

/* As a technique's imply and check. */
void warp_options_imply(void *options, uint32_t given);
GpResult warp_options_check(const void *options, uint32_t given, const char *extension,
                            GpError *error);

/* What the method auto is of images of a kind. */
WarpMethod warp_auto_method(WarpKind kind, bool has_detail);

/* What a method is called, and whether it draws images of a kind. */
const char *warp_method_name(WarpMethod method);
bool warp_method_draws(WarpMethod method, WarpKind kind);

#endif
