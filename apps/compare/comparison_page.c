#include "apps/compare/comparison_page.h"

#include "apps/base/page.h"
#include "apps/compare/comparison_views.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* Views lie in one cell of a grid; the chosen one is shown, the slider cuts the first away. */
static const char style[] =
    ".verdict { font-size: 17px; font-weight: 600 }\n"
    ".good { color: var(--good) } .bad { color: var(--bad) }\n"
    ".choice { display: inline-block; margin: 0 4px 8px 0; padding: 4px 14px; cursor: pointer;\n"
    "          border: 1px solid var(--line); border-radius: 999px; background: var(--sheet) }\n"
    "input[name=view] { position: absolute; opacity: 0 }\n"
    "input[name=view]:checked + .choice { color: var(--ground); background: var(--ink);\n"
    "                                     border-color: var(--ink) }\n"
    "input[name=view]:focus-visible + .choice { outline: 3px solid var(--soft) }\n"
    ".stage { --at: 50%; position: relative; display: grid; overflow: hidden; border-radius: 6px;\n"
    "         touch-action: pan-y;\n"
    "         background: repeating-conic-gradient(#8a8f98 0 25%, #767b84 0 50%) 0 0/16px 16px }\n"
    ".stage img { grid-area: 1/1; width: 100%; display: none; image-rendering: pixelated }\n"
    ".stage::after { content: \"\"; display: none; position: absolute; inset: 0 auto 0 var(--at);\n"
    "                width: 2px; margin-left: -1px; background: #fff;\n"
    "                box-shadow: 0 0 0 1px #000 }\n"
    "#slide:checked ~ .stage::after, #slide:checked ~ .stage .first,\n"
    "#slide:checked ~ .stage .second, #first:checked ~ .stage .first,\n"
    "#second:checked ~ .stage .second, #difference:checked ~ .stage .difference,\n"
    "#flip:checked ~ .stage .flip { display: block }\n"
    "#slide:checked ~ .stage .first { clip-path: inset(0 calc(100% - var(--at)) 0 0); z-index: 1 "
    "}\n"
    "#slide:checked ~ .stage .second { clip-path: inset(0 0 0 var(--at)) }\n"
    "#slider { width: 100%; margin: 8px 0 0; accent-color: var(--ink) }\n"
    ".views { max-width: 100% } .sides { display: flex; justify-content: space-between }\n"
    ".tiles { display: grid; gap: 16px;\n"
    "         grid-template-columns: repeat(auto-fit, minmax(min(200px, 45%), 1fr)) }\n"
    ".tiles img { display: block; width: 100%; image-rendering: pixelated; border-radius: 6px }\n"
    "kbd { padding: 0 6px; border: 1px solid var(--line); border-radius: 4px;\n"
    "      background: var(--sheet); font-size: 13px }\n";

/* Keys 1 to 5 choose a view, the arrows move the slider, space flips between the pictures. */
static const char script[] =
    "<script>\n"
    "const views = [...document.getElementsByName('view')], stage = "
    "document.querySelector('.stage');\n"
    "const slider = document.getElementById('slider');\n"
    "const show = id => { document.getElementById(id).checked = true };\n"
    "const slide = value => { slider.value = value; "
    "stage.style.setProperty('--at', slider.value / 10 + '%') };\n"
    "slider.oninput = () => { show('slide'); slide(slider.value) };\n"
    "stage.onpointerdown = stage.onpointermove = event => {\n"
    "  if (!event.buttons) return;\n"
    "  const box = stage.getBoundingClientRect();\n"
    "  show('slide'); slide(1000 * (event.clientX - box.left) / box.width);\n"
    "  event.preventDefault() };\n"
    "document.onkeydown = event => {\n"
    "  if (event.ctrlKey || event.altKey || event.metaKey) return;\n"
    "  const view = views['12345'.indexOf(event.key)], step = { ArrowLeft: -20, ArrowRight: 20 };\n"
    "  if (view) view.checked = true;\n"
    "  else if (event.key == ' ') show(document.getElementById('first').checked ? 'second' : "
    "'first');\n"
    "  else if (event.key in step) { show('slide'); slide(+slider.value + step[event.key]) }\n"
    "  else return;\n"
    "  event.preventDefault() };\n"
    "</script>\n";

/* --- pictures --------------------------------------------------------------------------------- */

static GpResult add_picture(const Picture *picture, const char *attributes, Text *page,
                            GpError *error)
{
    GpFile png = { .data = NULL };
    GpResult result = picture_encode_png(picture, &png, error);
    if (!result)
        page_add_png(page, &png, attributes);
    gp_file_free(&png);
    return result;
}

/* All views of a comparison: both pictures, borrowed, the difference, the map. */
typedef struct Views {
    Picture picture[4];
    double scale; /* of the difference */
} Views;

static const char *const view_names[4] = { "first", "second", "difference", "flip" };

static GpResult open_views(const Picture pictures[2], const Comparison *comparison, Views *views,
                           GpError *error)
{
    views->picture[0] = pictures[0];
    views->picture[1] = pictures[1];
    GpResult result =
        view_difference(pictures, comparison->report.max, &views->picture[2], &views->scale, error);
    return result ? result : view_flip(comparison, &views->picture[3], error);
}

static void close_views(Views *views)
{
    picture_free(&views->picture[2]);
    picture_free(&views->picture[3]);
}

/* --- the viewer ------------------------------------------------------------------------------- */

static void add_choice(const char *id, const char *label, bool checked, Text *page)
{
    text_add(page,
             "<input type=\"radio\" name=\"view\" id=\"%s\"%s><label class=\"choice\" for=\"%s\">"
             "%s</label>\n",
             id, checked ? " checked" : "", id, label);
}

/* A small picture is shown by whole multiples of its pixels, a large one at most at its size. */
static uint32_t shown_width(uint32_t width)
{
    const uint32_t times = 768 / width;
    return times > 1 ? times * width : width;
}

static GpResult add_viewer(const char *const names[2], const Views *views, Text *page,
                           GpError *error)
{
    text_add(page, "<div class=\"views\" style=\"width: %upx\">\n",
             shown_width(views->picture[0].width));
    add_choice("slide", "Slider", true, page);
    add_choice("first", "First", false, page);
    add_choice("second", "Second", false, page);
    add_choice("difference", "Difference", false, page);
    add_choice("flip", "FLIP", false, page);
    text_add(page, "<div class=\"stage\">\n");
    for (int i = 0; i < 4; i++) {
        char attributes[64];
        snprintf(attributes, sizeof attributes, " class=\"%s\" alt=\"%s\" draggable=\"false\"",
                 view_names[i], view_names[i]);
        if (add_picture(&views->picture[i], attributes, page, error))
            return GP_ERROR_MEMORY;
        text_add(page, "\n");
    }
    text_add(page, "</div>\n<input type=\"range\" id=\"slider\" min=\"0\" max=\"1000\" "
                   "aria-label=\"slider between the pictures\">\n");
    text_add_escaped(
        page, "<div class=\"sides note\"><span>first: %s</span><span>second: %s</span></div>",
        names[0], names[1]);
    text_add(page, "\n<p class=\"note\">Keys: <kbd>1</kbd> to <kbd>5</kbd> choose, <kbd>left</kbd> "
                   "<kbd>right</kbd> slide, <kbd>space</kbd> flips between the pictures.");
    if (views->scale > 0)
        text_add(page, " Differences are shown times %.4g.", views->scale);
    text_add(page, " FLIP goes from black, 0, to pale yellow, 1.</p>\n</div>\n");
    return GP_OK;
}

/* --- the worst tile --------------------------------------------------------------------------- */

static GpResult add_tile(const Comparison *comparison, const Views *views, Text *page,
                         GpError *error)
{
    static const char *const labels[4] = { "first", "second", "difference", "FLIP" };
    const CompareReport *report = &comparison->report;
    text_add(page,
             "<h2>The worst tile</h2>\n<p>Of the tiles of %dx%d pixels the one at (%u, %u) has the "
             "largest sum of squared differences; %" PRIu64
             " of its pixels differ.</p>\n<div class=\"tiles\">\n",
             COMPARE_TILE, COMPARE_TILE, report->tile_x, report->tile_y, report->tile_differing);
    for (int i = 0; i < 4; i++) {
        Picture part = { .values = NULL };
        GpResult result = view_part(&views->picture[i], report->tile_x, report->tile_y,
                                    COMPARE_TILE, &part, error);
        text_add(page, "<figure>");
        if (!result)
            result = add_picture(&part, " alt=\"\"", page, error);
        text_add(page, "<figcaption>%s</figcaption></figure>\n", labels[i]);
        picture_free(&part);
        if (result)
            return result;
    }
    text_add(page, "</div>\n");
    return GP_OK;
}

/* --- figures ---------------------------------------------------------------------------------- */

static void add_row(const char *name, const char *value, const char *note, Text *page)
{
    text_add(page, "<tr>");
    page_add_cell(page, "td", "", name);
    page_add_cell(page, "td", " class=\"n\"", value);
    page_add_cell(page, "td", " class=\"note\"", note);
    text_add(page, "</tr>\n");
}

static void add_figures(const Comparison *comparison, Text *page)
{
    const CompareReport *r = &comparison->report;
    const struct {
        const char *name, *format;
        double value;
        const char *note;
    } rows[] = {
        { "largest difference", "%.6g", r->max, "of a channel; 1 is the whole range" },
        { "mean difference", "%.6g", r->mean, "over pixels and channels" },
        { "PSNR", "%.4f dB", r->psnr, "for a peak of 1" },
        { "SSIM", "%.6f", r->ssim, "of the luminance; 1 is alike" },
        { "FLIP, mean", "%.6f", comparison->flip.mean, "what an eye would notice; 0 is alike" },
        { "FLIP, largest", "%.6f", comparison->flip.max, "of a pixel" },
    };
    char text[64];
    text_add(page, "<h2>Figures</h2>\n<div class=\"wide\"><table>\n");
    snprintf(text, sizeof text, "%" PRIu64 " of %" PRIu64, r->differing, r->pixels);
    add_row("differing pixels", text, "with another bit", page);
    for (size_t i = 0; i < GP_COUNT(rows); i++) {
        snprintf(text, sizeof text, rows[i].format, rows[i].value);
        add_row(rows[i].name, text, rows[i].note, page);
    }
    text_add(page, "</table></div>\n");
}

/* --- the page --------------------------------------------------------------------------------- */

static GpResult add_sizes(const char *const names[2], const Picture pictures[2], Text *page,
                          GpError *error)
{
    text_add(page, "<div class=\"tiles\">\n");
    for (int i = 0; i < 2; i++) {
        text_add(page, "<figure>");
        if (add_picture(&pictures[i], " alt=\"\"", page, error))
            return GP_ERROR_MEMORY;
        text_add_escaped(page, "<figcaption>%s: %s, %ux%u</figcaption></figure>\n",
                         i ? "second" : "first", names[i], pictures[i].width, pictures[i].height);
    }
    text_add(page, "</div>\n");
    return GP_OK;
}

static GpResult add_all(const char *const names[2], const Picture pictures[2],
                        const Comparison *comparison, Text *page, GpError *error)
{
    if (comparison->other_sizes)
        return add_sizes(names, pictures, page, error);
    Views views = { .scale = 0 };
    GpResult result = open_views(pictures, comparison, &views, error);
    if (!result)
        result = add_viewer(names, &views, page, error);
    if (!result && !comparison->report.same)
        result = add_tile(comparison, &views, page, error);
    close_views(&views);
    add_figures(comparison, page);
    text_add(page, "%s", script);
    return result;
}

GpResult comparison_page(const char *const names[2], const Picture pictures[2],
                         const Comparison *comparison, const ComparisonSettings *settings,
                         Text *page, GpError *error)
{
    Text verdict = { .data = NULL };
    char title[256];
    const char *alpha = comparison_alpha(comparison);
    snprintf(title, sizeof title, "%.100s against %.100s", names[0], names[1]);
    comparison_say(comparison, settings, &verdict);
    page_begin(page, title, style);
    text_add_escaped(page, "<h1>%s</h1>\n<p class=\"verdict %s\">%s%s%s</p>\n", title,
                     comparison->failed ? "bad" : "good", verdict.data ? verdict.data : "",
                     alpha[0] ? "; " : "", alpha);
    GpResult result = add_all(names, pictures, comparison, page, error);
    page_end(page);
    page->failed |= verdict.failed;
    text_free(&verdict);
    if (!result && page->failed)
        result = gp_fail(error, GP_ERROR_MEMORY, "out of memory");
    return result;
}
