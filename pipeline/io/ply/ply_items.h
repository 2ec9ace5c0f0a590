/* The body of a PLY file (internal): its elements' items, one after the other, with properties of
 * any type. */
#ifndef GP_IO_PLY_ITEMS_H
#define GP_IO_PLY_ITEMS_H

#include "pipeline/io/bytes.h"
#include "pipeline/io/ply/ply_header.h"

/* Where a reader is. */
typedef struct PlyItems {
    GpInput *input;
    const PlyHeader *header;
    const PlyElement *element; /* the present one */
    size_t item;               /* of it */
} PlyItems;

/* Reads or skips each property of the present item, in their order, and of any of those that follow
 * it.
 * returns how many items that were */
typedef size_t (*PlyItemFn)(const PlyItems *items, void *context);

/* Calls read for every item until a fault. What follows the last item is one. */
void gp_ply_items(GpInput *input, const PlyHeader *header, PlyItemFn read, void *context);

/* Whether values are stored as the machine has them. */
static inline bool gp_ply_is_native(const PlyItems *items)
{
    return items->header->encoding == (GP_BIG_ENDIAN_MACHINE ? PLY_BIG : PLY_LITTLE);
}

/* Where a role's values go: bytes of colours, floats of all else; so many values lie from one
 * item's to the next. NULL: they are skipped. */
typedef struct PlyColumn {
    void *to;
    size_t stride;
} PlyColumn;

/* The present item and those after it that are read together: at most PLY_BLOCK, while any are
 * left. */
enum { PLY_BLOCK = 512 };
static inline size_t gp_ply_block(const PlyItems *items)
{
    const size_t left = items->element->count - items->item;
    return left < PLY_BLOCK ? left : PLY_BLOCK;
}

/* Reads a block as columns, where its items are rows of single values that are stored as they are
 * wanted: most files' bulk.
 * in   column: of each role, with room for the block
 * returns how many items that were, or 0: they must be read value by value, or have a fault */
size_t gp_ply_read_block(const PlyItems *items, const PlyColumn column[PLY_VERTEX_ROLES]);

/* The next value. After a fault, 0. */
double gp_ply_value(const PlyItems *items, PlyType type); /* a floating-point one may be anything */
float gp_ply_number(const PlyItems *items, PlyType type); /* finite */

/* A colour in 256 steps: integers of 0..255, of 0..65535 in ushorts, or floats of 0..1, which are
 * clamped. */
uint8_t gp_ply_color(const PlyItems *items, PlyType type);

/* The length of a list, whose entries fit into the file; 0 after a fault. */
size_t gp_ply_length(const PlyItems *items, const PlyProperty *property);

void gp_ply_skip(const PlyItems *items, const PlyProperty *property);

/* "path: line 5: vertex 2: expected ..." */
void gp_ply_fail(const PlyItems *items, const char *expected);

#endif
