/* Fragments of draws that come again (draws/repeat.h): found and interpolated once for a tile, and
 * kept for all passes that draw them, each of which only shades, tests and blends.
 *
 * They are kept as packets that are rows of the tile: the first fragments of neighbouring pixels
 * side by side, then the second ones, and so on. So what stood in small triangles, a few lanes of
 * each packet, fills packets, and their pixels lie in order in every plane: peeling and dual
 * peeling of a scan take less than half as long. Where there is no more room, what is there is
 * drawn, and later passes find it again. */
#ifndef GP_FAST_REPEATED_H
#define GP_FAST_REPEATED_H

#include "pipeline/fast/lanes/memory/packet.h"

/* Of one draw: where its blocks of packets begin, and how many packets there are. */
typedef struct FastKept {
    size_t begin;
    uint32_t count;
    bool is_whole; /* all that the draw has in the tile */
} FastKept;

typedef struct FastRepeated {
    void *memory;
    size_t bytes, used;
    FastKept kept[FAST_REPEATED + 1]; /* by FastDraw.repeated */
    bool finds;                       /* the present draw's fragments are being found */

    /* of that draw, its blocks of packets */
    char *blocks;
    size_t block_bytes;

    /* of each pixel, where in the memory the number of the packet for its next fragment is */
    uint32_t link[FAST_PIXELS];
} FastRepeated;

/* Bytes of memory without which no draw can be kept. */
size_t fast_least_repeated_bytes(void);

/* Forgets what another tile kept. */
void fast_begin_repeated(Tile *tile);

/* Begins the present draw, one that comes again: draws it where its fragments are kept.
 * returns whether they are not, and are to be found */
bool fast_find_repeated_fragments(Tile *tile);

/* Keeps fragments of the present draw. */
void fast_keep_repeated(Tile *tile, const FastPacketBlock *block);

/* Ends the draw, if its fragments were found: draws them. */
void fast_end_repeated(Tile *tile);

#endif
