#include "apps/charts/svg.h"

const char svg_ink[] = "#1f2430", svg_soft[] = "#5b6472", svg_grid[] = "#e9ecf0",
           svg_frame[] = "#aab2bd";

const char svg_bold[] = " font-weight=\"bold\"";
const char svg_small_words[] =
    " font-size=\"11\" stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\" "
    "stroke-linejoin=\"round\"";

void svg_begin(Text *svg, int width, int height, const char *title)
{
    text_add(svg,
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" "
             "height=\"%d\" role=\"img\" font-family=\"system-ui, 'DejaVu Sans', sans-serif\" "
             "font-size=\"12\">\n<title>",
             width, height, width, height);
    text_add_escaped(svg, title);
    text_add(svg,
             "</title>\n<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n"
             "<g fill=\"%s\">\n",
             svg_ink);
}

void svg_end(Text *svg)
{
    text_add(svg, "</g>\n</svg>\n");
}

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
    text_add_escaped(svg, content);
    text_add(svg, "</text>\n");
}
