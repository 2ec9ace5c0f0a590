/* A folder of its own for every test, emptied afterwards; files are put there by plain stdio, so
 * that the code under test has no part in it. */
#ifndef TESTS_FOLDER_H
#define TESTS_FOLDER_H

#include "tests/support/unit.h"

#include <dirent.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[64];

/* A path in the folder; one of four buffers in turn. */
static inline const char *in_folder(const char *name)
{
    static char paths[4][400];
    static unsigned turn;
    char *path = paths[turn++ % 4];
    snprintf(path, sizeof paths[0], "%s/%s", folder, name);
    return path;
}

/* Counts what is in the folder, and removes it on demand. */
static inline int folder_count(bool remove_all)
{
    int count = 0;
    DIR *list = opendir(folder);
    assert_non_null(list);
    for (struct dirent *entry; (entry = readdir(list));) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0)
            continue;
        count++;
        if (remove_all)
            assert_int_equal(remove(in_folder(entry->d_name)), 0);
    }
    closedir(list);
    return count;
}

static inline int folder_set_up(void **state)
{
    (void)state;
    strcpy(folder, "/tmp/glasspipe-test-XXXXXX");
    return mkdtemp(folder) ? 0 : -1;
}

static inline int folder_tear_down(void **state)
{
    (void)state;
    folder_count(true);
    return rmdir(folder);
}

static inline const char *put_file(const char *name, const void *bytes, size_t size)
{
    const char *path = in_folder(name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
    return path;
}

/* Reads a file of the folder as text, cut where there is no room; returns its length. */
static inline size_t get_text(const char *name, char *text, size_t size)
{
    FILE *file = fopen(in_folder(name), "rb");
    if (!file)
        fail_msg("%s is not there", name);
    const size_t length = fread(text, 1, size - 1, file);
    fclose(file);
    text[length] = '\0';
    return length;
}

static inline const char *put_text(const char *name, const char *text)
{
    return put_file(name, text, strlen(text));
}

#endif
