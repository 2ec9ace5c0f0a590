/* Tables of the publications, to be measured again: rows as they were printed, and a function that
 * measures one. */
#ifndef APPS_TECHNIQUES_PAPER_TABLE_H
#define APPS_TECHNIQUES_PAPER_TABLE_H

#include "apps/techniques/timed_setting.h"

enum { PAPER_MAX_COLUMNS = 12 };

typedef enum PaperNumber {
    PAPER_BOTH = 1, /* printed, and measured here */
    PAPER_MEASURED,
    PAPER_GIVEN, /* what the row is about: a size */
} PaperNumber;

typedef struct PaperColumn {
    const char *name; /* "raster"; NULL ends a table */
    PaperNumber number;
    int digits; /* behind the point, of what is measured; 0: a whole number */
} PaperColumn;

typedef struct PaperRow {
    const char *name;                  /* as printed; NULL ends a table */
    const char *scene;                 /* that is drawn here: a path; NULL: it is not at hand */
    bool reduced;                      /* of fewer triangles than what was printed */
    double printed[PAPER_MAX_COLUMNS]; /* by columns; what is given too; below 0: there was none */
} PaperRow;

struct PaperTable {
    const char *id;     /* "4.1" */
    const char *title;  /* in the words of the publication, translated */
    const char *source; /* where it was printed, and on what it was measured */
    const char *note;   /* what the columns are, a line */
    /* where the order of columns here is another than the printed one, and why: lines, NULL at the
     * end; NULL: nothing to say */
    const char *const *reasons;
    const PaperColumn *columns;
    const PaperRow *rows;

    /* Measures a row, whose scene is open, by frames of the technique. out measured: by columns
     * errors those of technique_time */
    GpResult (*measure)(const struct PaperTable *table, const PaperRow *row,
                        const Technique *technique, void *scene, const TechniqueClock *clock,
                        double measured[PAPER_MAX_COLUMNS], GpError *error);
    const void *content; /* of the technique's own, for measure */
};

#endif
