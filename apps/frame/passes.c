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

GpSurface *pass_target(const GpPass *pass, const char *name)
{
    if (strcmp(name, "depth") == 0)
        return pass->depth.surface;
    bool digit = name[0] >= '0' && name[0] < '0' + GP_MAX_TARGETS && name[1] == '\0';
    return digit ? pass->color[name[0] - '0'].surface : NULL;
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
        return gp_fail(error, GP_ERROR_INVALID, "%s: the scene has no pass of this name or number",
                       target);
    GpSurface *found = pass_target(&list->passes[index], suffix);
    if (!found)
        return gp_fail(error, GP_ERROR_INVALID, "%s: pass %u has no such target", target, index);
    *surface = found;
    *pass = index;
    return GP_OK;
}
