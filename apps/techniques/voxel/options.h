/* The options of `glasspipe voxelize` beside those of its settings. */
#ifndef APPS_TECHNIQUES_VOXEL_OPTIONS_H
#define APPS_TECHNIQUES_VOXEL_OPTIONS_H

#include "apps/techniques/voxel/pictures/picture.h"

#include <argp.h>

/* Begin with the picture that is voxel_picture_defaults, and zeros. */
typedef struct VoxelOptions {
    bool is_placed, wants_report, wants_points;
    double box[4]; /* scale, offset */
    double twist;  /* degrees */
    const char *with, *scan;
    bool has_combine, has_move, has_picture; /* some option of those was given */
    int combine;
    VoxelPlace place;
    VoxelPicture picture;
} VoxelOptions;

/* As TechniqueResult has them. */
extern const struct argp_option voxel_options[];
error_t voxel_options_parse(int key, char *text, struct argp_state *state, void *options);

/* Whether the options go together, and with an output that is a picture or not.
 * errors GP_ERROR_INVALID, with the reason */
GpResult voxel_options_check(const VoxelOptions *options, bool to_picture, GpError *error);

#endif
