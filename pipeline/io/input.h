/* Lines, words, numbers and bytes of files of meshes and points, for their readers (internal). */
#ifndef GP_IO_INPUT_H
#define GP_IO_INPUT_H

#include "pipeline/io/file.h"

#include <string.h>

/* Largest count of vertices, faces or corners that a file may promise. */
#define GP_INPUT_COUNT_MAX ((int64_t)0x7fffffff)

/* A word: size bytes without white space. Not terminated, but something that ends a number follows
 * it (white space or the zero byte after a file). */
typedef struct GpWord {
    char *text;
    size_t size;
} GpWord;

/* Walks through a file, by lines and words or by bytes. The first fault is kept: readers go on with
 * whatever they have and look at result before it matters. */
typedef struct GpInput {
    const char *path; /* for messages, which go to error */
    GpError *error;
    GpResult result;
    char *begin, *next, *end; /* next: what was not yet walked over */
    char *line_end;           /* end of the present line, without its newline */
    size_t number;            /* of the present line, from 1; 0 in bytes: place counts instead */
    const char *place;        /* of the bytes taken last */
} GpInput;

/* Reads a file, to be walked through from its start.
 * errors those of gp_file_read; GP_ERROR_FORMAT: it is empty
 * owns   the caller frees the file, when the input is no longer needed */
GpResult gp_input_open(const char *path, GpFile *file, GpInput *input, GpError *error);

/* "path: line 12: .." or "path: byte 34: ..", unless there was a fault before. returns false */
bool gp_input_fail(GpInput *input, GpResult result, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The next size bytes; NULL where there are fewer. */
static inline const char *gp_input_take(GpInput *input, size_t size)
{
    input->place = input->next;
    if (size > (size_t)(input->end - input->next))
        return NULL;
    input->next += size;
    return input->place;
}

/* Steps to the next line that holds more than white space, comments excluded: a line whose first
 * word starts with '#'. False at the end of the text. */
bool gp_input_line(GpInput *input);

/* Next word of the present line; false at its end. */
bool gp_input_word(GpInput *input, GpWord *word);

/* Next word of the text across lines, for formats where lines mean nothing; false at the end. */
bool gp_input_any_word(GpInput *input, GpWord *word);

bool gp_word_is_any_case(const GpWord *word, const char *text); /* ASCII letters of any case */

/* Exactly. In line, as most words are told from others by their length. */
static inline bool gp_word_is(const GpWord *word, const char *text)
{
    return word->size == strlen(text) && memcmp(word->text, text, word->size) == 0;
}

/* A decimal number, [+-] digits [. digits] [e [+-] digits], that is finite as a float. Hexadecimal,
 * nan and inf are no numbers. */
bool gp_word_number(const GpWord *word, float *value);

/* A decimal integer of magnitude below 2.88e18. */
bool gp_word_integer(const GpWord *word, int64_t *value);

/* At most 40 bytes of a word for a message, without control characters. */
const char *gp_word_show(const GpWord *word, char shown[44]);

#endif
