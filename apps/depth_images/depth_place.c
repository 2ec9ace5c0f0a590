/* Where an image was taken from, as a line of words and numbers. */
#include "apps/base/vector.h"
#include "apps/depth_images/depth_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A word with its numbers, which lie one behind the other. */
typedef struct PlaceField {
    const char *word;
    double *number;
    int count;
} PlaceField;

enum { FIELDS = 5 };

static void fields_of(DepthImage *image, PlaceField fields[FIELDS])
{
    if (image->is_cylinder) {
        DepthCylinder *c = &image->cylinder;
        const PlaceField all[FIELDS] = { { "center", c->center, 3 },
                                         { "axis", c->axis, 3 },
                                         { "zero", c->zero, 3 },
                                         { "radius", &c->radius, 1 },
                                         { "height", &c->height, 1 } };
        memcpy(fields, all, sizeof all);
        return;
    }
    DepthPlane *p = &image->plane;
    const PlaceField all[FIELDS] = { { "eye", p->eye, 3 },
                                     { "right", p->right, 3 },
                                     { "up", p->up, 3 },
                                     { "forward", p->forward, 3 },
                                     { "window", &p->left, 4 } }; /* left bottom width height */
    memcpy(fields, all, sizeof all);
}

_Static_assert(offsetof(DepthPlane, height) == offsetof(DepthPlane, left) + 3 * sizeof(double),
               "a window is four numbers in a row");

static const char *kind_of(const DepthImage *image)
{
    return image->is_cylinder         ? "cylinder"
           : image->plane.is_parallel ? "plane parallel"
                                      : "plane perspective";
}

void depth_place_write(const DepthImage *image, char text[DEPTH_TEXT])
{
    DepthImage copy = *image;
    PlaceField fields[FIELDS];
    fields_of(&copy, fields);
    int at = snprintf(text, DEPTH_TEXT, "%s", kind_of(image));
    for (int f = 0; f < FIELDS; f++) {
        at += snprintf(text + at, DEPTH_TEXT - (size_t)at, " %s", fields[f].word);
        for (int i = 0; i < fields[f].count; i++)
            at += snprintf(text + at, DEPTH_TEXT - (size_t)at, " %.17g", fields[f].number[i]);
    }
}

/* --- reading ---------------------------------------------------------------------------------- */

/* Moves over a word of one or two parts, and the blank behind it. */
static bool take_word(const char **text, const char *word)
{
    const size_t length = strlen(word);
    if (strncmp(*text, word, length) != 0 || ((*text)[length] != ' ' && (*text)[length] != '\0'))
        return false;
    *text += length + ((*text)[length] == ' ');
    return true;
}

static bool take_number(const char **text, double *number)
{
    char *end;
    *number = strtod(*text, &end);
    if (end == *text || (*end != ' ' && *end != '\0') || !isfinite(*number) ||
        fabs(*number) > 1e100)
        return false;
    *text = end + (*end == ' ');
    return true;
}

static bool is_frame(const double a[3], const double b[3])
{
    const double near = 1e-6;
    return fabs(vector_dot(a, a) - 1) < near && fabs(vector_dot(b, b) - 1) < near &&
           fabs(vector_dot(a, b)) < near;
}

/* What is wrong with a place; NULL: nothing. */
static const char *fault_of(const DepthImage *image)
{
    if (image->is_cylinder) {
        const DepthCylinder *c = &image->cylinder;
        return !is_frame(c->axis, c->zero) ? "unit vectors axis and zero, square to each other"
               : !(c->radius > 0)          ? "a radius above 0"
               : !(c->height > 0)          ? "a height above 0"
                                           : NULL;
    }
    const DepthPlane *p = &image->plane;
    double back[3];
    vector_cross(p->right, p->up, back);
    for (int k = 0; k < 3; k++)
        back[k] += p->forward[k];
    return !is_frame(p->right, p->up) || vector_extent(back) > 1e-6
               ? "unit vectors right, up and forward, square to each other, right x up = -forward"
           : !(p->width > 0 && p->height > 0) ? "a window with a width and a height above 0"
                                              : NULL;
}

GpResult depth_place_read(const char *text, DepthImage *image, GpError *error)
{
    DepthImage read = *image;
    const char *at = text;
    read.is_cylinder = take_word(&at, "cylinder");
    if (!read.is_cylinder) {
        read.plane = (DepthPlane){ .is_parallel = take_word(&at, "plane parallel") };
        if (!read.plane.is_parallel && !take_word(&at, "plane perspective"))
            return gp_fail(error, GP_ERROR_FORMAT,
                           "expected \"cylinder\", \"plane perspective\" or \"plane parallel\"");
    }
    PlaceField fields[FIELDS];
    fields_of(&read, fields);
    for (int f = 0; f < FIELDS; f++) {
        bool is_there = take_word(&at, fields[f].word);
        for (int i = 0; is_there && i < fields[f].count; i++)
            is_there = take_number(&at, &fields[f].number[i]);
        if (!is_there)
            return gp_fail(error, GP_ERROR_FORMAT, "expected \"%s\" with %d finite number%s",
                           fields[f].word, fields[f].count, fields[f].count > 1 ? "s" : "");
    }
    const char *fault = *at ? "nothing behind its last number" : fault_of(&read);
    if (fault)
        return gp_fail(error, GP_ERROR_FORMAT, "expected %s", fault);
    *image = read;
    return GP_OK;
}
