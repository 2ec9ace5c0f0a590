#include "apps/commands/pass_list.h"

#include "apps/base/json.h"
#include "pipeline/list/pass_target.h"

#include <stdio.h>

static json_t *formats_of(const GpPass *pass)
{
    json_t *formats = json_array();
    for (int i = 0; i <= GP_MAX_TARGETS; i++) {
        const GpSurface *surface = gp_pass_target(pass, i);
        if (surface)
            json_array_append_new(formats, json_string(gp_format_info(surface->format)->name));
    }
    return formats;
}

json_t *pass_list_json(const GpList *list)
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

void pass_list_print(const json_t *passes)
{
    printf("pass  %-20s %-10s %5s  %5s  targets\n", "name", "size", "draws", "group");
    size_t p, t;
    const json_t *pass, *target;
    json_array_foreach(passes, p, pass)
    {
        char size[32];
        snprintf(size, sizeof size, "%lldx%lld", json_whole_of(pass, "width"),
                 json_whole_of(pass, "height"));
        printf("%4lld  %-20s %-10s %5lld  %5lld ", json_whole_of(pass, "pass"),
               json_text_of(pass, "name"), size, json_whole_of(pass, "draws"),
               json_whole_of(pass, "group"));
        json_array_foreach(json_object_get(pass, "targets"), t, target)
            printf(" %s", json_string_value(target));
        putchar('\n');
    }
}
