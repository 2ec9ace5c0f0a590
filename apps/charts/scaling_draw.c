#include "apps/charts/scaling_draw.h"

#include "apps/charts/plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    WIDTH = 1240,
    HEIGHT = 730,
    POWERS_BELOW = 72, /* below a box: the powers that were measured, */
    POWERS_ROW = 18,   /* a row each */
    LEGEND_Y = 118,
    NAME_LEFT = 66, /* of the time axis, from its box */
    STRIP = 52,     /* above the scale of times, for names of scenes */
    STRIP_ROWS = 3,
    STRIP_ROW = 15,
    MAX_NAMES = 14, /* of lines: as many as there are markers */
};

static const PlotBox boxes[TECHNIQUE_PANELS] = { { 104, 158, 612, 630 }, { 700, 158, 1208, 630 } };

enum { ANY_LINE = -1 };

static const double letter_width = 6.6; /* about, of small words */
static const double degrees = 180 / 3.14159265358979323846;

/* What all parts of a panel share. */
typedef struct Panel {
    const Scaling *scaling;
    const TechniquePanel *table;
    int number;
    PlotBox box;
    PlotScale x, y;
} Panel;

/* Of the bar, too, where there is one. */
static void add_times(PlotRange *times, const Timing *time)
{
    plot_range_add(times, time->ms);
    if (time->low_ms > 0 && isfinite(time->high_ms)) {
        plot_range_add(times, time->low_ms);
        plot_range_add(times, time->high_ms);
    }
}

/* Times have one scale in all panels, so that they can be compared. */
static Panel make_panel(const Scaling *scaling, int number)
{
    PlotRange amounts = { 0 }, times = { 0 };
    for (uint32_t i = 0; i < scaling->count; i++) {
        const ScalingPoint *point = &scaling->points[i];
        if (scaling_has_place(point))
            add_times(&times, &point->time);
        if (scaling_has_place(point) && point->panel == number)
            plot_range_add(&amounts, point->amount);
    }
    Panel panel = { .scaling = scaling,
                    .table = &scaling->technique->scaling->panels[number],
                    .number = number,
                    .box = boxes[number] };
    panel.x = plot_scale(amounts, panel.box.left, panel.box.right);
    panel.x.doubles = panel.table->doubles;
    panel.y = plot_scale(times, panel.box.bottom, panel.box.top + STRIP);
    return panel;
}

/* --- lines ------------------------------------------------------------------------------------ */

/* Different names of lines, in the table's order. */
static int list_names(const TechniqueScaling *table, const char *names[MAX_NAMES])
{
    int count = 0;
    for (int p = 0; p < TECHNIQUE_PANELS; p++)
        for (const TechniqueLine *line = table->panels[p].lines; line->name; line++) {
            GP_ASSERT(count < MAX_NAMES);
            plot_series(names, &count, line->name);
        }
    return count;
}

/* The next point of a line, or of any; NULL where there is none. in point: NULL: the first */
static const ScalingPoint *next_point(const Panel *panel, int line, const ScalingPoint *point)
{
    const Scaling *scaling = panel->scaling;
    for (uint32_t i = point ? (uint32_t)(point - scaling->points) + 1 : 0; i < scaling->count;
         i++) {
        point = &scaling->points[i];
        if (point->panel == panel->number && (line == ANY_LINE || point->line == line) &&
            scaling_has_place(point))
            return point;
    }
    return NULL;
}

static void add_tooltip(const Panel *panel, const ScalingPoint *point, Text *svg)
{
    text_add_escaped(svg, "<title>%s\n%s\n%s\n%.10g %s\n", panel->table->lines[point->line].name,
                     point->scene, point->options, point->amount, panel->table->axis);
    plot_tooltip_times(svg, &point->time);
    text_add(svg, "</title>");
}

/* The middle half of the frames' times. */
static void draw_bar(const Panel *panel, const ScalingPoint *point, int series, Text *svg)
{
    const Timing *time = &point->time;
    const double x = plot_place(&panel->x, point->amount), cap = 3;
    if (!(time->low_ms > 0 && time->low_ms < time->high_ms && isfinite(time->high_ms)))
        return;
    text_add(svg, "<path d=\"M%.1f %.1fh%.1fm-%.1f 0V%.1fm-%.1f 0h%.1f\" stroke=\"%s\"/>", x - cap,
             plot_place(&panel->y, time->low_ms), 2 * cap, cap,
             plot_place(&panel->y, time->high_ms), cap, 2 * cap, plot_color(series));
}

static void draw_line(const Panel *panel, int line, Text *svg)
{
    const char *names[MAX_NAMES];
    int count = list_names(panel->scaling->technique->scaling, names);
    const int series = plot_series(names, &count, panel->table->lines[line].name);
    const char *step = "M";
    text_add(svg, "<path fill=\"none\" stroke=\"%s\" stroke-width=\"1.8\" d=\"",
             plot_color(series));
    for (const ScalingPoint *point = NULL; (point = next_point(panel, line, point)); step = "L")
        text_add(svg, "%s%.1f %.1f", step, plot_place(&panel->x, point->amount),
                 plot_place(&panel->y, point->time.ms));
    text_add(svg, "\"/>\n");
    for (const ScalingPoint *point = NULL; (point = next_point(panel, line, point));) {
        text_add(svg, "<g>");
        add_tooltip(panel, point, svg);
        draw_bar(panel, point, series, svg);
        plot_marker(svg, plot_place(&panel->x, point->amount),
                    plot_place(&panel->y, point->time.ms), series, false);
        text_add(svg, "</g>\n");
    }
}

/* Whether a point lies where a name of this width would run, ending at `end`, below a line in the
 * direction of a unit vector. */
static bool covers_point(const Panel *panel, const double end[2], const double along[2],
                         double width)
{
    const double below = 9, reach = 14;
    for (const ScalingPoint *point = NULL; (point = next_point(panel, ANY_LINE, point));) {
        double x = plot_place(&panel->x, point->amount) - end[0];
        double y = plot_place(&panel->y, point->time.ms) - end[1];
        double back = -(x * along[0] + y * along[1]), aside = y * along[0] - x * along[1];
        if (back > -reach && back < width + reach && fabs(aside - below) < reach)
            return true;
    }
    return false;
}

/* From the lower left corner to the scale's right or upper end; its name runs along it, below, as
 * far out as there is room. */
static void draw_slope(const Panel *panel, const TechniqueSlope *slope, Text *svg)
{
    const PlotScale *x = &panel->x, *y = &panel->y;
    double most = fmin(x->high / x->low, pow(y->high / y->low, 1 / slope->power));
    double length[2] = { plot_place(x, x->low * most) - x->begin,
                         plot_place(y, y->low * pow(most, slope->power)) - y->begin };
    svg_dots(svg, x->begin, y->begin, x->begin + length[0], y->begin + length[1]);

    double whole = hypot(length[0], length[1]), width = letter_width * (double)strlen(slope->name);
    double along[2] = { length[0] / whole, length[1] / whole }, end[2];
    for (double share = 1; share > 0; share -= 0.1) {
        double reach = share * whole - 10;
        end[0] = x->begin + reach * along[0];
        end[1] = y->begin + reach * along[1];
        if (!covers_point(panel, end, along, width))
            break;
    }
    char turned[256];
    snprintf(turned, sizeof turned, "%s dy=\"13\" transform=\"rotate(%.1f %.1f %.1f)\"",
             svg_small_words, atan2(along[1], along[0]) * degrees, end[0], end[1]);
    svg_words(svg, end[0], end[1], "end", turned, slope->name);
}

/* --- scenes ----------------------------------------------------------------------------------- */

/* Names of scenes above their points, in rows, where a panel has more than one amount for a
 * setting. What finds no room is left out. */
static void draw_scenes(const Panel *panel, Text *svg)
{
    double used[STRIP_ROWS] = { 0 };
    for (const ScalingPoint *point = NULL; (point = next_point(panel, 0, point));) {
        char name[64];
        int row = 0;
        text_stem(point->scene, name, sizeof name);
        double x = plot_place(&panel->x, point->amount),
               width = letter_width * (double)strlen(name);
        double end = fmin(x + width / 2, panel->box.right - 4);
        while (row < STRIP_ROWS && used[row] > end - width)
            row++;
        if (row == STRIP_ROWS || !strchr(panel->table->lines[0].scenes, '|'))
            continue;
        used[row] = end;
        double y = panel->box.top + STRIP_ROW * (row + 1);
        svg_line(svg, x, y + 4, x, panel->box.bottom, svg_grid);
        svg_words(svg, end, y, "end", svg_small_words, name);
    }
}

/* --- all of it -------------------------------------------------------------------------------- */

static void draw_panel(const Panel *panel, Text *svg)
{
    const PlotBox box = panel->box;
    char name[96];
    text_add(svg, "<g fill=\"%s\">\n", svg_soft);
    snprintf(name, sizeof name, "%s (logarithmic)", panel->table->axis);
    plot_axes(svg, box, &panel->x, name, &panel->y, "time in milliseconds (median, logarithmic)",
              box.left - NAME_LEFT);
    for (const TechniqueSlope *slope = panel->table->slopes; slope->name; slope++)
        draw_slope(panel, slope, svg);
    draw_scenes(panel, svg);
    text_add(svg, "</g>\n");
    svg_words(svg, box.left, box.top - 12, "start", " font-size=\"15\" font-weight=\"bold\"",
              panel->table->title);
    for (int line = 0; panel->table->lines[line].name; line++)
        draw_line(panel, line, svg);
}

static void draw_legend(const Scaling *scaling, Text *svg)
{
    const char *names[MAX_NAMES];
    int count = list_names(scaling->technique->scaling, names);
    double x = PLOT_MARGIN + 8;
    for (int i = 0; i < count; i++) {
        plot_marker(svg, x, LEGEND_Y - 4, i, false);
        svg_words(svg, x + 14, LEGEND_Y, "start", " font-size=\"13\"", names[i]);
        x += 50 + 1.1 * letter_width * (double)strlen(names[i]);
    }
}

/* To two digits, and none of them "-0.00". */
static double rounded(double power)
{
    return round(100 * power) / 100 + 0.0;
}

/* What the lines' slopes are, as they were measured. returns how many rows */
static int draw_powers(const Panel *panel, Text *svg)
{
    static const char style[] = " font-size=\"12\"";
    double y = panel->box.bottom + POWERS_BELOW;
    int rows = 1;
    svg_words(
        svg, panel->box.left, y, "start", style,
        "Measured: time grows as this power of the amount; in brackets, from point to point:");
    for (int line = 0; panel->table->lines[line].name; line++) {
        char words[160];
        ScalingPower power;
        if (!scaling_power(panel->scaling, panel->number, line, &power))
            continue;
        snprintf(words, sizeof words, "%s: %.2f (%.2f to %.2f)", panel->table->lines[line].name,
                 rounded(power.power), rounded(power.least), rounded(power.most));
        svg_words(svg, panel->box.left, y + POWERS_ROW * rows++, "start", style, words);
    }
    return rows;
}

void scaling_draw(const Scaling *scaling, Text *svg)
{
    Text panels = { .data = NULL };
    int most_rows = 0;
    for (int number = 0; number < TECHNIQUE_PANELS; number++) {
        Panel panel = make_panel(scaling, number);
        draw_panel(&panel, &panels);
        const int rows = draw_powers(&panel, &panels);
        most_rows = rows > most_rows ? rows : most_rows;
    }
    const int height = HEIGHT + POWERS_ROW * most_rows;
    plot_begin(svg, WIDTH, height, scaling->technique->scaling->title);
    plot_machine(
        svg, 0, "",
        &(PlotMachine){ scaling->machine, scaling->isa, scaling->threads, scaling->others });
    draw_legend(scaling, svg);
    text_add(svg, "%s", panels.data ? panels.data : "");
    svg->failed |= panels.failed;
    text_free(&panels);
    plot_end(svg, height,
             "How to read: low is better. A line that rises less steeply than a dotted one grows "
             "by less than that. Bars: the middle half of the frames' times.");
}
