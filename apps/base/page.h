/* Pages of HTML that hold all they need: style and pictures inside, light or dark as the reader has
 * it, nothing from a network. */
#ifndef APPS_BASE_PAGE_H
#define APPS_BASE_PAGE_H

#include "apps/base/text.h"
#include "pipeline/io/file.h"

/* All that stands before the content. in: more_style: of this page alone */
void page_begin(Text *page, const char *title, const char *more_style);
void page_end(Text *page);

/* Bytes as base64 (RFC 4648), which nothing has to escape. */
void page_add_base64(Text *page, const unsigned char *bytes, size_t size);

/* An <img> of a PNG file's bytes. in: attributes: as HTML has them, with a blank before, or "" */
void page_add_png(Text *page, const GpFile *png, const char *attributes);

/* A cell of a table, its content escaped. in: attributes: as above */
void page_add_cell(Text *page, const char *element, const char *attributes, const char *content);

#endif
