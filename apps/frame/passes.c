#include "apps/frame/passes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

uint32_t passes_find(const GpList *list, const char *name)
{
    for (uint32_t p = 0; p < list->pass_count; p++)
        if (list->passes[p].name && strcmp(list->passes[p].name, name) == 0)
            return p;
    char *end;
    unsigned long number = strtoul(name, &end, 10);
    bool decimal = name[0] >= '0' && name[0] <= '9' && *end == '\0';
    return decimal && number < list->pass_count ? (uint32_t)number : list->pass_count;
}

/* Surface of a pass by the part of the name behind the dot; NULL where there is none. */
static GpSurface *target_of(const GpPass *pass, const char *suffix)
{
    if (strcmp(suffix, "depth") == 0)
        return pass->depth.surface;
    bool digit = suffix[0] >= '0' && suffix[0] < '0' + GP_MAX_TARGETS && suffix[1] == '\0';
    return digit ? pass->color[suffix[0] - '0'].surface : NULL;
}

GpResult passes_find_target(const GpList *list, const char *target, GpSurface **surface,
                            uint32_t *pass, GpError *error)
{
    char name[256];
    const char *suffix = "0";
    snprintf(name, sizeof name, "%s", target);
    uint32_t index = passes_find(list, name);
    char *dot = strrchr(name, '.');
    if (index == list->pass_count && dot) {
        *dot = '\0';
        suffix = dot + 1;
        index = passes_find(list, name);
    }
    if (index == list->pass_count)
        return gp_fail(error, GP_ERROR_INVALID,
                       "%s: the scene has no pass of this name or number; see --list-passes",
                       target);
    GpSurface *found = target_of(&list->passes[index], suffix);
    if (!found)
        return gp_fail(error, GP_ERROR_INVALID, "%s: pass %u has no such target; see --list-passes",
                       target, index);
    *surface = found;
    *pass = index;
    return GP_OK;
}

/* --- the table
 * ------------------------------------------------------------------------------------ */

static json_t *formats_of(const GpPass *pass)
{
    json_t *formats = json_array();
    for (int i = 0; i < GP_MAX_TARGETS + 1; i++) {
        const GpSurface *surface =
            i < GP_MAX_TARGETS ? pass->color[i].surface : pass->depth.surface;
        if (surface)
            json_array_append_new(formats, json_string(gp_format_info(surface->format)->name));
    }
    return formats;
}

json_t *passes_json(const GpList *list)
{
    uint32_t *group = gp_alloc(list->pass_count, sizeof *group);
    if (!group)
        return NULL;
    gp_list_groups(list, group);
    json_t *passes = json_array();
    for (uint32_t p = 0; p < list->pass_count; p++) {
        const GpPass *pass = &list->passes[p];
        uint32_t width, height;
        gp_pass_size(pass, &width, &height);
        json_array_append_new(
            passes, json_pack("{s:I, s:s, s:I, s:I, s:I, s:I, s:o}", "pass", (json_int_t)p, "name",
                              pass->name ? pass->name : "", "width", (json_int_t)width, "height",
                              (json_int_t)height, "draws", (json_int_t)pass->draw_count, "group",
                              (json_int_t)group[p], "targets", formats_of(pass)));
    }
    gp_free(group);
    return passes;
}

static long long integer(const json_t *object, const char *key)
{
    return (long long)json_integer_value(json_object_get(object, key));
}

void passes_print(const json_t *passes)
{
    printf("pass  %-20s %-10s %5s  %5s  targets\n", "name", "size", "draws", "group");
    size_t p, t;
    const json_t *pass, *target;
    json_array_foreach(passes, p, pass)
    {
        char size[32];
        snprintf(size, sizeof size, "%lldx%lld", integer(pass, "width"), integer(pass, "height"));
        printf("%4lld  %-20s %-10s %5lld  %5lld ", integer(pass, "pass"),
               json_string_value(json_object_get(pass, "name")), size, integer(pass, "draws"),
               integer(pass, "group"));
        json_array_foreach(json_object_get(pass, "targets"), t, target)
            printf(" %s", json_string_value(target));
        putchar('\n');
    }
}
