/* What may be set of meshes of which all fragments count: how they are drawn, of what, and how they
 * are looked at. */
#ifndef APPS_TECHNIQUES_FRAGMENTS_OPTIONS_H
#define APPS_TECHNIQUES_FRAGMENTS_OPTIONS_H

#include "apps/base/orbit.h"
#include "apps/fragments/convex/convex.h"
#include "apps/techniques/settings.h"

typedef enum FragmentMethod {
    FRAGMENTS_SORTED,
    FRAGMENTS_CONVEX,
    FRAGMENTS_DP,
    FRAGMENTS_DDP,
    FRAGMENTS_KBUFFER,
    FRAGMENTS_STENCIL,
    FRAGMENTS_BUCKET1,
    FRAGMENTS_BUCKET2,
    FRAGMENTS_ADAPTIVE,
    FRAGMENTS_MDT,
    FRAGMENTS_ABUFFER,
    FRAGMENTS_CPU,
    FRAGMENTS_WEIGHTED,
    FRAGMENT_METHODS
} FragmentMethod;

/* Which convex pieces: turned over or not, as printed, joined. */
typedef enum FragmentPieces {
    FRAGMENT_PIECES_BOTH,
    FRAGMENT_PIECES_OUTWARD,
    FRAGMENT_PIECES_MERGED
} FragmentPieces;

typedef enum FragmentColor { FRAGMENT_NORMALS, FRAGMENT_MATERIAL } FragmentColor;

/* The setting of the technique. */
typedef struct FragmentOptions {
    FragmentMethod method;
    uint32_t kept;   /* of kbuffer and stencil */
    uint32_t hazard; /* of kbuffer */
    /* of convex: */
    FragmentPieces pieces;
    double tolerance;
    ConvexOrder order;

    /* aside of the key */
    double alpha;
    double sigma;       /* above 0: glass */
    bool is_as_printed; /* of glass */
    FragmentColor color;
    const char *camera; /* a file; NULL: the orbit */
    const char *cache;  /* a file for convex pieces; NULL: none */
    Orbit orbit;
    bool measures;
} FragmentOptions;

extern const SettingField fragment_settings[];
extern const FragmentOptions fragment_option_defaults;

/* As a technique's imply and check. */
void fragment_options_imply(void *options, uint32_t given);

GpResult fragment_options_check(const void *options, uint32_t given, const char *extension,
                                GpError *error);

#endif
