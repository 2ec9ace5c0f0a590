/* Pieces of pictures, as SVG: see plot.h for whole ones. */
#ifndef APPS_CHARTS_SVG_H
#define APPS_CHARTS_SVG_H

#include "apps/base/text.h"

extern const char svg_ink[], svg_soft[], svg_grid[], svg_frame[]; /* colours */

/* A style sheet that turns pictures on white to dark ones where the reader has it so; of the page's
 * variables it takes --sheet, --ink and --soft. */
void svg_add_dark_style(Text *style);

void svg_line(Text *svg, double x1, double y1, double x2, double y2, const char *color);

/* The same in dots, to compare with. */
void svg_dots(Text *svg, double x1, double y1, double x2, double y2);

/* fill, stroke: colours, or "none" */
void svg_rectangle(Text *svg, double x, double y, double width, double height, const char *fill,
                   const char *stroke);

/* anchor: start, middle or end; more: further attributes; no content: nothing */
void svg_words(Text *svg, double x, double y, const char *anchor, const char *more,
               const char *content);

/* Further attributes: of words that lie over lines, which have a white edge; of what stands out. */
extern const char svg_small_words[], svg_bold[];

#endif
