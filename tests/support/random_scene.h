/* Scenes under one light, made at random: models lie, stand and float, turned any way, on a floor
 * that may be tilted; the light may be near or far, around or narrow, a point or not. */
#ifndef TESTS_RANDOM_SCENE_H
#define TESTS_RANDOM_SCENE_H

#include "tests/support/random.h"

#include <stdbool.h>
#include <stddef.h>

/* Writes the scene as JSON. in least, most: sides of the picture, in pixels; large: as below */
void random_scene(Random *random, int least, int most, bool large, char *text, size_t size);

/* The name of a model, of less than a thousand triangles; large: or of more, or a file of the data
 * folder where there is one. */
const char *random_model(Random *random, bool large);

#endif
