/* Lane vectors: GP_LANES floats or integers that go through the same operation side by side.
 *
 * The same source is compiled for several widths and instruction sets; every operation here gives
 * the same bits in each lane whatever the width, compiler or machine: IEEE add, sub, mul, div and
 * sqrt, selections by masks, and integer arithmetic that wraps. Masks are integer vectors, all ones
 * for true. Only the files of
 * pipeline/base/lanes hold intrinsics.
 */
#ifndef GP_LANES_H
#define GP_LANES_H

#include "pipeline/base/lanes/arithmetic.h"
#include "pipeline/base/lanes/channels.h"
#include "pipeline/base/lanes/memory.h"
#include "pipeline/base/lanes/shuffle.h"
#include "pipeline/base/lanes/types.h"

#endif
