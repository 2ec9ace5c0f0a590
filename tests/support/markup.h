/* Whether SVG and HTML are well formed. */
#ifndef TESTS_MARKUP_H
#define TESTS_MARKUP_H

/* How often a text holds a part. */
int markup_count(const char *text, const char *part);

/* Every element is closed in turn, but for those of HTML that have no end; no bare < or &. A test
 * fails where it is not so. */
void markup_check(const char *text);

#endif
