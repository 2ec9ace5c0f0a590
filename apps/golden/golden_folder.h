/* All scenes of a folder, drawn side by side. */
#ifndef APPS_GOLDEN_GOLDEN_FOLDER_H
#define APPS_GOLDEN_GOLDEN_FOLDER_H

#include "apps/golden/golden.h"
#include "apps/items/items.h"

/* A scene by its name, its file's without folder and extension, and what came of it. */
typedef struct GoldenScene {
    char *name;
    GoldenResult result;
} GoldenScene;

/* A zeroed one is empty. Owned by whoever opened it, until golden_folder_free. */
typedef struct GoldenFolder {
    GoldenScene *scenes; /* [count], by name */
    uint32_t count;
    uint32_t states[GOLDEN_STATES]; /* how many came out so */
    uint32_t unwritten;             /* how many of the broken have a report that was not written */
    double seconds;                 /* wall clock of all together */
} GoldenFolder;

/* Lists the scenes of a folder: its files *.json and, so that no stored hash is left behind,
 * *.hash.
 * in     only: the scene of this name; NULL: all
 * errors GP_ERROR_IO (no folder), GP_ERROR_FORMAT (no scenes in it, or none of this name),
 *        GP_ERROR_MEMORY */
GpResult golden_folder_open(const char *path, const char *only, GoldenFolder *folder,
                            GpError *error);
void golden_folder_free(GoldenFolder *folder); /* zeroes it */

/* Runs all scenes as items, each drawn by one thread where there are more of them than threads; a
 * scene that fails stops no other.
 * order  results do not depend on who draws
 * returns items_run's code */
int golden_folder_run(const GoldenTask *task, const ItemRun *run, GoldenFolder *folder,
                      GpError *error);

/* The results as JUnit's XML, which build servers read: a test case for each scene; differing and
 * missing are failures, broken is an error. in: path: the folder's name for the reader */
void golden_folder_junit(const GoldenFolder *folder, const char *path, Text *xml);

#endif
