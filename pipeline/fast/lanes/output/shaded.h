/* What comes out of the pixel shader. */
#ifndef GP_FAST_SHADED_H
#define GP_FAST_SHADED_H

#include "pipeline/fast/lanes/memory/packet.h"

/* Shaded packets on their way into the targets. */
typedef struct FastShaded {
    FastPacketBlock block;
    const unsigned *live;     /* of each packet, the lanes that passed all tests */
    const unsigned *replaced; /* of those, the ones that replace (replace.h); else unused */
    const flt *color;         /* [packet][target][channel] */
    int stride; /* vectors from packet to packet; 0: all have the first one's colour */
} FastShaded;

#endif
