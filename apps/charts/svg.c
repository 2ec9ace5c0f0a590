#include "apps/charts/svg.h"

const char svg_ink[] = "#1f2430", svg_soft[] = "#5b6472", svg_grid[] = "#e9ecf0",
           svg_frame[] = "#aab2bd";

/* Colours of paper, and what they are where the page is dark: ink, lines, beaten points, and those
 * of the series (plot.c) that would not stand out. Others are light enough for both. */
static const char *const dark[][2] = {
    { "#ffffff", "var(--sheet)" }, { "#1f2430", "var(--ink)" }, { "#5b6472", "var(--soft)" },
    { "#e9ecf0", "#2a303a" },      { "#aab2bd", "#626c7a" },    { "#d3d8df", "#3d4552" },
    { "#9ea7b3", "#6d7785" },      { "#222222", "#dfe3ea" },    { "#332288", "#9a8cf0" },
    { "#882255", "#dd6ea8" },      { "#117733", "#4fbf78" },    { "#661100", "#d08068" },
    { "#0072b2", "#3fa2e0" },      { "#d55e00", "#f0833a" },    { "#009e73", "#2cc295" },
};

void svg_add_dark_style(Text *style)
{
    text_add(style, "@media (prefers-color-scheme: dark) {\n");
    for (size_t i = 0; i < GP_COUNT(dark); i++)
        text_add(style, "  svg [fill=\"%s\"] { fill: %s } svg [stroke=\"%s\"] { stroke: %s }\n",
                 dark[i][0], dark[i][1], dark[i][0], dark[i][1]);
    text_add(style, "}\n");
}

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
