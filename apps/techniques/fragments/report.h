/* What there is to say of a picture of fragments. */
#ifndef APPS_TECHNIQUES_FRAGMENTS_REPORT_H
#define APPS_TECHNIQUES_FRAGMENTS_REPORT_H

#include "apps/techniques/fragments/model.h"

/* As a technique's report. */
GpResult fragment_report(void *model, const void *options, const Frame *frame, GpDevice *device,
                         TechniqueReport *report, GpError *error);

/* Pixels of which a channel is more than 1/255 off the truth, which has been found. */
typedef struct FragmentError {
    uint64_t wrong;
    uint64_t wrong_beyond_edges; /* those with no edge within 1/256 pixel of their centre */
    /* of these those at which rounded corners may change what is in front */
    uint64_t wrong_at_crossings;
} FragmentError;

FragmentError fragment_error(const FragmentModel *model, const GpSurface *picture);

/* How much brighter than the truth each pixel is in the channel that is most off, as a heat map has
 * it: 0 where none is wrong, else from a third to 1, which is a tenth of white or more.
 * out  off: [height][width] */
void fragment_difference(const FragmentModel *model, const GpSurface *picture, float *off);

/* What a frame needs: passes; how often all triangles are read; and the bytes of all surfaces
 * but the picture. */
typedef struct FragmentWork {
    uint32_t passes, readings;
    uint64_t bytes;
} FragmentWork;

FragmentWork fragment_work(const FragmentModel *model, const Frame *frame);

/* The work of a frame that was built last, and how far a picture is off, for JSON; NULL: nobody
 * asks. */
void fragment_tell_work(const FragmentModel *model, const Frame *frame, json_t *members);
void fragment_tell_error(const FragmentModel *model, const GpSurface *picture, json_t *members);

#endif
