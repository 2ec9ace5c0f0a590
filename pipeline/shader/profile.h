/* Profiles: what a shader of a 2005 machine could be (CONVENTIONS.md, "Profiles"). */
#ifndef GP_PROFILE_H
#define GP_PROFILE_H

#include "pipeline/shader/counts.h"

#include <limits.h>

enum { GP_UNLIMITED = INT_MAX };

typedef struct GpProfileLimits {
    int slots, arithmetic_slots, texture_slots;
    int temporaries;
    int constants; /* float4 */
    int inputs;    /* vertex inputs, or interpolants read */
    int samplers;
    int dependent_reads;  /* the highest order */
    bool gradients;       /* dsx, dsy, texldd */
    bool explicit_lod;    /* texldl */
    bool pixel_registers; /* vPos, vFace */
} GpProfileLimits;

/* The limits of a profile; GP_PROFILE_NONE has those of the software profiles. Never NULL. */
const GpProfileLimits *gp_profile_limits(GpProfile profile);

/* True for vertex profiles (false: pixel profiles and GP_PROFILE_NONE), and for pixel profiles. */
bool gp_profile_is_vertex(GpProfile profile);
bool gp_profile_is_pixel(GpProfile profile);

/* The software profile of the same kind and model, which sets no counts; itself for those. */
GpProfile gp_profile_software(GpProfile profile);

#endif
