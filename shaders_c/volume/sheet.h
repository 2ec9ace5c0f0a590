/* Sheets of a volume, put under those before them.
 *
 * A sheet holds, of what each pixel's ray meets in it, the extinction e and colour times
 * extinction. Its opacity is 1 - exp(-e), as that of so much matter in any order of its parts.
 * DEVIATES: paper 003 adds opacities, as hardware that blends could; that is the other program.
 */
#ifndef SHADERS_VOLUME_SHEET_H
#define SHADERS_VOLUME_SHEET_H

#include "pipeline/shader/program.h"

enum { SHEETS_AT_ONCE = 3 };

/* Textures 0, 1, 2: a pixel's own place in three sheets, front to back. To be blended under what is
 * there: colour multiplied by opacity, opacity. */
extern const GpProgram sheets_program, sheets_of_alphas_program;

/* Texture 0: the sum of all sheets, to be blended over a picture. */
extern const GpProgram sheets_over_program;

/* Texture 0: that sum. Depth becomes 0 where hardly anything would be seen behind it, and stays
 * elsewhere. */
extern const GpProgram sheets_opaque_program;

#endif
