/* What may be set of volumes: how they are drawn, of what, and how they are looked at. */
#ifndef APPS_TECHNIQUES_VOLUME_OPTIONS_H
#define APPS_TECHNIQUES_VOLUME_OPTIONS_H

#include "apps/base/orbit.h"
#include "apps/techniques/settings.h"
#include "apps/volumes/drawing/raycast.h"
#include "apps/volumes/drawing/slices.h"
#include "apps/volumes/drawing/splat_setting.h"

typedef enum VolumeMethod {
    VOLUME_RAYCAST,
    VOLUME_SLICES,
    VOLUME_SPLAT,
    VOLUME_METHODS
} VolumeMethod;

/* The setting of the technique. */
typedef struct VolumeOptions {
    VolumeMethod method;
    RaycastSetting rays;
    SlicesSetting slices;
    VolumeSplatSetting splats;

    /* aside of the key */
    const char *transfer; /* a file or a name; NULL: chosen from the histogram */
    const char *camera;   /* a file; NULL: the orbit */
    Orbit orbit;
    bool lit;
    bool measures;
} VolumeOptions;

extern const SettingField volume_settings[];
extern const VolumeOptions volume_option_defaults;

/* As a technique's imply and check. */
void volume_options_imply(void *options, uint32_t given);

GpResult volume_options_check(const void *options, uint32_t given, const char *extension,
                              GpError *error);

#endif
