/* Transfer functions: what colour a value has, and how much light it takes.
 *
 * Straight lines between stops, the first and the last value going on outwards; colour is not
 * multiplied by opacity. The opacity is that of a slab one unit of space thick that has this value
 * everywhere (field.h: the distance of the closest samples), so that the extinction is
 * -ln(1 - opacity).
 */
#ifndef APPS_VOLUMES_TRANSFER_H
#define APPS_VOLUMES_TRANSFER_H

#include "apps/volumes/field.h"

enum { TRANSFER_MAX_STOPS = 256 };

typedef struct TransferStop {
    double value;   /* of a field, 0..255 */
    double rgba[4]; /* 0..1 each */
} TransferStop;

typedef struct Transfer {
    uint32_t count;                         /* at least 1 */
    TransferStop stops[TRANSFER_MAX_STOPS]; /* by rising value */
} Transfer;

/* Reads a transfer function: a file of lines "value r g b a", # before a comment; or one built in,
 * by its name (transfer_names). Values are 0 to 255 where the volume has bytes; where it has not,
 * the first of the file stands for the volume's least sample and the last for its greatest.
 * out    transfer: its values are the field's; untouched on failure
 * errors GP_ERROR_FORMAT with "path: line 3: ..." and what was expected; those of gp_data_find */
GpResult transfer_open(const char *name, const Field *field, Transfer *transfer, GpError *error);

/* A sensible one for a field, from its histogram. */
void transfer_choose(const Field *field, Transfer *transfer);

/* Names of those built in, NULL at the end. */
extern const char *const transfer_names[];

/* What a slab of this opacity takes of the light on a way of length 1, as an exponent: -ln(1 -
 * opacity). Opacities beyond 1 - 2^-24 count as that: nothing is seen through so much, and it stays
 * finite. */
double transfer_extinction(double opacity);

/* Colour and opacity of a value: in double, exact but for rounding. */
void transfer_at(const Transfer *transfer, double value, double rgba[4]);

/* The same of all 256 values, as floats. */
void transfer_table(const Transfer *transfer, float table[FIELD_VALUES][4]);

#endif
