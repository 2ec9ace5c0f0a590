/* Unit vectors as two small numbers: on an octahedron, and as angles. */
#ifndef APPS_POINTS_NORMAL_CODES_H
#define APPS_POINTS_NORMAL_CODES_H

#include <stdint.h>

enum { NORMAL_STEPS = 511 }; /* codes of the octahedron run from 0 to this */

/* The nearest of the four codes around a vector.
 * source Cigolle et al., "A survey of efficient representations for independent unit vectors",
 *        JCGT 2014, "precise" */
void normal_encode(const double normal[3], uint32_t code[2]);
void normal_decode(const uint32_t code[2], double normal[3]);

/* Where cells of theta and phi end. */
typedef struct AngleBorders {
    double theta[256];  /* cosines */
    double phi[128][2]; /* cosines, sines; of the upper half plane */
} AngleBorders;

void angle_borders(AngleBorders *borders);

/* The cells of theta and phi, of 256 each, that a vector is in; decoded to their middles. */
void angles_encode(const AngleBorders *borders, const double normal[3], uint8_t code[2]);
void angles_decode(const uint8_t code[2], double normal[3]);

#endif
