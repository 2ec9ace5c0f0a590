/* A mesh that has been opened, how it is seen, and what is known of its fragments. */
#ifndef APPS_TECHNIQUES_FRAGMENTS_MODEL_H
#define APPS_TECHNIQUES_FRAGMENTS_MODEL_H

#include "apps/fragments/convex/convex.h"
#include "apps/fragments/drawing/count.h"
#include "apps/fragments/drawing/geometry.h"
#include "apps/techniques/fragments/options.h"
#include "apps/techniques/technique.h"
#include "apps/truth/fragments.h"
#include "pipeline/io/mesh/mesh_file.h"

typedef struct FragmentModel {
    GpMesh file;
    float (*colors)[4];
    FragmentGeometry geometry;
    FragmentMesh mesh;   /* of these three */
    ConvexModel convex;  /* of the mesh; without pieces: not made yet */
    ConvexSetting made;  /* how it was made */
    GpError cache_fault; /* why its cache was of no use; else empty */
    ConvexFacts *facts;  /* of its last picture */
    FragmentView view;
    FragmentCount count; /* of the view; without layers: not counted yet */
    FragmentTruth truth; /* likewise, without a picture */
    /* Hears how far convex pieces are; NULL: nobody does. */
    void (*progress)(const void *user, uint32_t done, uint32_t total, const char *text);
    const void *user;
} FragmentModel;

/* As a technique's open and close. */
GpResult fragment_model_open(const TechniqueInput *input, void **model, GpError *error);
void fragment_model_close(void *model);

/* Looks from elsewhere: what is known of the view is forgotten. */
void fragment_model_look(FragmentModel *model, const Camera *camera);

/* Makes convex pieces, where they are not made yet, or were made otherwise.
 * errors those of convex_open */
GpResult fragment_model_convex(FragmentModel *model, const FragmentOptions *options,
                               GpError *error);

/* Counts once. errors those of fragment_count */
GpResult fragment_model_count(FragmentModel *model, GpDevice *device, GpError *error);

/* Finds the truth once. errors GP_ERROR_MEMORY */
GpResult fragment_model_truth(FragmentModel *model, int threads, GpError *error);

#endif
