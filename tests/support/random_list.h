/* Random lists of passes from a seed: every state, format, primitive and program in turn, odd
 * sizes, degenerate and huge triangles, NaN positions, passes that read earlier ones or draw on
 * them. */
#ifndef TESTS_RANDOM_LIST_H
#define TESTS_RANDOM_LIST_H

#include "pipeline/list/list.h"
#include "tests/shaders/exercise.h"

enum {
    RANDOM_PASSES = 6,
    RANDOM_DRAWS = 4,
    RANDOM_SURFACES = RANDOM_PASSES * (GP_MAX_TARGETS + 2) + 3,
    RANDOM_RECTS = 4,
};

/* Everything of one random list. Too large for a stack; allocate it. */
typedef struct RandomList {
    GpList list;
    GpPass passes[RANDOM_PASSES];
    GpDraw draws[RANDOM_PASSES][RANDOM_DRAWS];
    ExerciseUniforms uniforms[RANDOM_PASSES][RANDOM_DRAWS];
    float *vertices[RANDOM_PASSES][RANDOM_DRAWS];
    uint32_t *indices[RANDOM_PASSES][RANDOM_DRAWS];
    GpSurface *surfaces[RANDOM_SURFACES]; /* those of the passes, in order, then three textures */
    int surface_count;

    /* of random_variety.h alone */
    GpRect rects[RANDOM_PASSES][RANDOM_RECTS];
    void *kept_geometry[RANDOM_PASSES][RANDOM_DRAWS][4], *kept_memory[RANDOM_SURFACES];
} RandomList;

/* Builds the list of a seed; always valid (gp_list_check). largest: of width and height.
 * returns false when memory is short */
bool random_list_create(uint64_t seed, uint32_t largest, RandomList *random);
void random_list_destroy(RandomList *random);

/* One hash of every attachment, in order: a mix of the surfaces' own. */
uint64_t random_list_hash(const RandomList *random);

#endif
