/* Volumes splatted for tests: a small field, a view, a picture, and how far it is from the
 * truth. */
#ifndef TESTS_SPLATTED_VOLUME_H
#define TESTS_SPLATTED_VOLUME_H

#include "apps/volumes/drawing/splat.h"

enum { SPLATTED_SIDE = 64 }; /* pixels */

typedef struct SplattedVolume {
    Field field;
    Transfer transfer;
    VolumeSplats splats;
    VolumeView view;
    uint32_t rays;       /* of the truth of the method, a side of a pixel; 0: 2 */
    VolumeTarget target; /* beside the frame's own colour: its depth, or NULL */
} SplattedVolume;

/* A builtin field by its name, a transfer function by its name, seen from a direction at so many
 * times its longest side. errors fail the running test */
void splatted_open(const char *field, const char *transfer, const double direction[3], double sides,
                   SplattedVolume *volume);

/* The same with a field of the caller's, which becomes the volume's. */
void splatted_take(Field *field, const char *transfer, const double direction[3], double sides,
                   SplattedVolume *volume);

void splatted_look(SplattedVolume *volume, const double direction[3], double sides);
void splatted_close(SplattedVolume *volume);

/* Appends the volume's passes to a frame that is empty, onto a picture of floats, cleared. */
void splatted_build(const SplattedVolume *volume, const VolumeSplatSetting *setting, Frame *frame);

/* Draws it. out rgba: SPLATTED_SIDE squared pixels */
void splatted_draw(const SplattedVolume *volume, const VolumeSplatSetting *setting, float *rgba);

/* What the setting means, and what the data are: apps/truth. */
void splatted_truth_of_method(const SplattedVolume *volume, const VolumeSplatSetting *setting,
                              float *rgba);
void splatted_truth_of_data(const SplattedVolume *volume, float *rgba);

/* Of red, green and blue. */
double splatted_psnr(const float *a, const float *b);
double splatted_difference(const float *a, const float *b); /* mean */

#endif
