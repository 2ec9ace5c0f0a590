#include "apps/charts/svg.h"

const char svg_ink[] = "#1f2430", svg_soft[] = "#5b6472", svg_grid[] = "#e9ecf0",
           svg_frame[] = "#aab2bd";

const char svg_bold[] = " font-weight=\"bold\"";
const char svg_small_words[] =
    " font-size=\"11\" stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\" "
    "stroke-linejoin=\"round\"";

void svg_line(Text *svg, double x1, double y1, double x2, double y2, const char *color)
{
    text_add(svg, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n", x1, y1,
             x2, y2, color);
}

void svg_dots(Text *svg, double x1, double y1, double x2, double y2)
{
    text_add(svg,
             "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" "
             "stroke-dasharray=\"2 4\"/>\n",
             x1, y1, x2, y2, svg_soft);
}

void svg_rectangle(Text *svg, double x, double y, double width, double height, const char *fill,
                   const char *stroke)
{
    text_add(svg,
             "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\" "
             "stroke=\"%s\"/>\n",
             x, y, width, height, fill, stroke);
}

void svg_words(Text *svg, double x, double y, const char *anchor, const char *more,
               const char *content)
{
    if (!content[0])
        return;
    text_add(svg, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>", x, y, anchor, more);
    text_add_escaped(svg, "%s</text>\n", content);
}
