/* Files that stand in the program: what pages are made of, and sources that they show. Put there
 * when the program is built, by page_files.sh. */
#ifndef APPS_INSPECT_PAGE_FILES_H
#define APPS_INSPECT_PAGE_FILES_H

#include <stddef.h>

typedef struct PageFile {
    const char *path; /* from the repository's root; NULL ends the list */
    const char *begin, *end;
} PageFile;

/* By path. */
extern const PageFile page_files[];

/* Bytes of a file; a zero byte follows them. */
static inline size_t page_file_size(const PageFile *file)
{
    return (size_t)(file->end - file->begin);
}

#endif
