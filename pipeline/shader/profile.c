/* Profiles: the table of limits. */
#include "pipeline/shader/profile.h"

typedef struct Profile {
    const char *name;
    GpProfile software;
    GpProfileLimits limits;
} Profile;

enum { MANY = GP_UNLIMITED };

/* The devices behind the columns: vs_2_0 and ps_2_0 are Radeon 9500-9800, ps_2_a GeForce FX, ps_2_b
 * Radeon X800, 3_0 GeForce 6800. ps_2_b lifts the division of slots but not the order of dependent
 * reads. The software profiles lift every count and keep the instructions of their model. */
/* clang-format off */
static const Profile profiles[GP_PROFILES] = {
    /*                     name         software        slots  arith   tex temps const  in samp order  grad  texldl vPos */
    [GP_PROFILE_NONE] = { "none",      GP_PROFILE_NONE, { MANY, MANY, MANY, MANY, MANY, MANY, 16, MANY, true,  true,  true  } },
    [GP_VS_2_0]       = { "vs_2_0",    GP_VS_2_SW,      {  256, MANY, MANY,   12,  256,   16,  0, MANY, false, false, false } },
    [GP_VS_3_0]       = { "vs_3_0",    GP_VS_3_SW,      {  512, MANY, MANY,   32,  256,   16,  4, MANY, false, true,  false } },
    [GP_VS_2_SW]      = { "vs_2_sw",   GP_VS_2_SW,      { MANY, MANY, MANY, MANY, MANY, MANY,  0, MANY, false, false, false } },
    [GP_VS_3_SW]      = { "vs_3_sw",   GP_VS_3_SW,      { MANY, MANY, MANY, MANY, MANY, MANY, 16, MANY, false, true,  false } },
    [GP_PS_2_0]       = { "ps_2_0",    GP_PS_2_SW,      {   96,   64,   32,   12,   32,   10, 16,    3, false, false, false } },
    [GP_PS_2_A]       = { "ps_2_a",    GP_PS_2_SW,      {  512, MANY, MANY,   22,   32,   10, 16, MANY, true,  false, false } },
    [GP_PS_2_B]       = { "ps_2_b",    GP_PS_2_SW,      {  512, MANY, MANY,   32,   32,   10, 16,    3, false, false, false } },
    [GP_PS_3_0]       = { "ps_3_0",    GP_PS_3_SW,      {  512, MANY, MANY,   32,  224,   10, 16, MANY, true,  true,  true  } },
    [GP_PS_2_SW]      = { "ps_2_sw",   GP_PS_2_SW,      { MANY, MANY, MANY, MANY, MANY, MANY, 16, MANY, true,  false, false } },
    [GP_PS_3_SW]      = { "ps_3_sw",   GP_PS_3_SW,      { MANY, MANY, MANY, MANY, MANY, MANY, 16, MANY, true,  true,  true  } },
};
/* clang-format on */

static const Profile *profile_of(GpProfile profile)
{
    GP_ASSERT((unsigned)profile < GP_PROFILES);
    return &profiles[profile];
}

const char *gp_profile_name(GpProfile profile)
{
    return profile_of(profile)->name;
}

const GpProfileLimits *gp_profile_limits(GpProfile profile)
{
    return &profile_of(profile)->limits;
}

GpProfile gp_profile_software(GpProfile profile)
{
    return profile_of(profile)->software;
}

bool gp_profile_is_vertex(GpProfile profile)
{
    return profile >= GP_VS_2_0 && profile <= GP_VS_3_SW;
}

bool gp_profile_is_pixel(GpProfile profile)
{
    return profile >= GP_PS_2_0 && profile <= GP_PS_3_SW;
}
