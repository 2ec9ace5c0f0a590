#include "apps/base/page.h"

#include <string.h>

static const char style[] =
    ":root { color-scheme: light dark; --ink: #1f2430; --soft: #5b6472; --line: #d5dae1;\n"
    "        --ground: #f7f8fa; --sheet: #ffffff; --good: #1a7f37; --bad: #b3261e }\n"
    "@media (prefers-color-scheme: dark) {\n"
    "  :root { --ink: #e4e8ee; --soft: #9aa5b4; --line: #3a414d; --ground: #14171c;\n"
    "          --sheet: #1c2027; --good: #5cc47c; --bad: #ff8a80 } }\n"
    "body { margin: 0 auto; padding: 24px; max-width: 1280px; color: var(--ink);\n"
    "       background: var(--ground); font: 15px/1.5 system-ui, sans-serif }\n"
    "h1 { font-size: 26px } h2 { font-size: 21px; margin: 48px 0 12px }\n"
    "a { color: inherit }\n"
    ".wide { overflow-x: auto }\n"
    "table { border-collapse: collapse; margin: 16px 0; background: var(--sheet) }\n"
    "th, td { padding: 4px 12px; border-bottom: 1px solid var(--line); text-align: left }\n"
    "td.n, th.n { text-align: right; font-variant-numeric: tabular-nums }\n"
    "code { font-size: 13px } .note, figcaption, summary { color: var(--soft) }\n"
    "figure { margin: 0 } figcaption { font-size: 13px }\n";

void page_begin(Text *page, const char *title, const char *more_style)
{
    text_add(page, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                   "<meta name=\"viewport\" content=\"width=device-width\">\n");
    text_add_escaped(page, "<title>%s</title>\n", title);
    text_add(page, "<style>\n%s%s</style>\n</head>\n<body>\n", style, more_style);
}

void page_end(Text *page)
{
    text_add(page, "</body>\n</html>\n");
}

/* A block of whole groups at a time. */
void page_add_base64(Text *page, const unsigned char *bytes, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    char block[4096 + 1];
    size_t length = 0;
    for (size_t i = 0; i < size; i += 3) {
        const size_t left = size - i;
        unsigned bits = (unsigned)bytes[i] << 16;
        bits |= left > 1 ? (unsigned)bytes[i + 1] << 8 : 0;
        bits |= left > 2 ? bytes[i + 2] : 0u;
        block[length++] = digits[bits >> 18];
        block[length++] = digits[bits >> 12 & 63];
        block[length++] = left > 1 ? digits[bits >> 6 & 63] : '=';
        block[length++] = left > 2 ? digits[bits & 63] : '=';
        if (length == sizeof block - 1 || left <= 3) {
            block[length] = '\0';
            text_add(page, "%s", block);
            length = 0;
        }
    }
}

void page_add_png(Text *page, const GpFile *png, const char *attributes)
{
    text_add(page, "<img%s src=\"data:image/png;base64,", attributes);
    page_add_base64(page, (const unsigned char *)png->data, png->size);
    text_add(page, "\">");
}

void page_add_cell(Text *page, const char *element, const char *attributes, const char *content)
{
    text_add(page, "<%s%s>", element, attributes);
    text_add_escaped(page, "%s</%s>", content, element);
}
