/* Text that grows, for files that are made in memory and then written at once. */
#ifndef APPS_BASE_TEXT_H
#define APPS_BASE_TEXT_H

#include "pipeline/base/base.h"

/* A zeroed one is empty. Additions after memory ran out are dropped; text_write then says so. */
typedef struct Text {
    char *data; /* terminated; NULL where nothing was added */
    size_t length, room;
    bool failed;
} Text;

void text_add(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Bytes of the character of UTF-8 that a text begins with; 0: there is none. Names of files hold
 * any bytes. */
int text_utf8_bytes(const char *text);

/* Adds what may be no UTF-8, with U+FFFD for each byte that is none. */
void text_add_utf8(Text *text, const char *bytes);

/* For the content and the quoted attributes of XML and HTML: what stands for %s is escaped, & < > "
 * ', and control characters, which XML cannot hold, become spaces, and what is no UTF-8 U+FFFD.
 * in   format: with %s %d %u %f %g, their width and precision, and %% */
void text_add_escaped(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A field of CSV as RFC 4180 wants it: quoted where it holds a comma, a quote or a line's end.
 * in   end: what follows it, "," or "\n" */
void text_add_csv(Text *text, const char *field, const char *end);
void text_add_csv_number(Text *text, double value); /* and a comma */

/* Writes it to a file as gp_file_write does. errors those, and GP_ERROR_MEMORY */
GpResult text_write(const char *path, const Text *text, GpError *error);

/* The same to PATH.EXTENSION, and frees it. errors also GP_ERROR_IO: the path is too long */
GpResult text_write_as(const char *path, const char *extension, Text *text, GpError *error);

void text_free(Text *text); /* zeroes it */

/* The shortest decimal form that strtod restores to the same bits. */
void text_of_number(double value, char text[32]);

/* Reads a whole number of plain digits, without sign or spaces, and goes on behind it; false, and
 * nothing changes, where there is none or it is above `most'. */
bool text_take_whole(const char **at, uint32_t most, uint32_t *value);

/* Goes on behind a word that is there; false where it is not. */
bool text_take_word(const char **at, const char *word);

/* A number as people write it: "12,346", "0.0005", "1.2 x 10^-9" far from everyday. */
void text_for_people(double value, int digits, char text[32]);

/* The name of a file without folders and extension; cut where it does not fit. */
void text_stem(const char *path, char *name, size_t size);

/* Copies what fits and ends; where that is not UTF-8, which JSON and XML want, `?` stands for its
 * bytes beyond ASCII. */
void text_copy(char *to, size_t size, const char *from);

#endif
