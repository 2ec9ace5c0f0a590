/* Bricks: which parts of a volume a transfer function shows at all. */
#ifndef APPS_VOLUMES_BRICKS_H
#define APPS_VOLUMES_BRICKS_H

#include "apps/volumes/transfer.h"

enum { BRICK_SIDE = 4 /* steps between samples */, BRICK_WAYS = 8, BRICKS_FAR = 127 };

/* A zeroed one is empty. Brick (x, y, z) is the box from sample 4 (x, y, z) to sample 4 (x + 1, y +
 * 1, z + 1), both included, or the volume's last. */
typedef struct Bricks {
    uint32_t count[3];   /* along x, y, z; 0 where the volume is one sample thin */
    uint8_t (*range)[2]; /* [z][y][x]: least and most value */
} Bricks;

/* errors GP_ERROR_MEMORY; owns: the caller, until bricks_free */
GpResult bricks_make(const Field *field, Bricks *bricks, GpError *error);
void bricks_free(Bricks *bricks);

static inline size_t bricks_total(const Bricks *bricks)
{
    return (size_t)bricks->count[0] * bricks->count[1] * bricks->count[2];
}

/* Which bricks a transfer function shows. One that shows nothing has an opacity of 0 wherever
 * values are linear between its samples, and wherever they are less than 1 beyond them.
 * out  shown: [z][y][x], 1 or 0 */
void bricks_show(const Bricks *bricks, const Transfer *transfer, uint8_t *shown);

/* How far all is alike, for who comes through brick (x, y, z) and goes on along a way: bit i of it,
 * axis i falls. The side of the largest cube of bricks that begins with this one and goes that way,
 * at most BRICKS_FAR, and beyond the volume all is alike: n bricks that show nothing are BRICKS_FAR
 * + n; a number up to BRICKS_FAR is of bricks that all show something.
 * in   shown: of bricks_show
 * out  runs: [z][y][x]
 * errors GP_ERROR_MEMORY */
GpResult bricks_runs(const Bricks *bricks, const uint8_t *shown, unsigned way, uint8_t *runs,
                     GpError *error);

#endif
