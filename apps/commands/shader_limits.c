#include "apps/commands/shader_limits.h"

#include "apps/base/json.h"
#include "pipeline/shader/profile.h"

#include <stddef.h>
#include <stdio.h>

/* A resource: where the counts hold what a shader uses, and the limits what a profile allows. */
typedef struct Resource {
    const char *key, *name;
    size_t used, limit;
} Resource;

/* clang-format off */
#define RESOURCE(member, name)                                                                     \
    { #member, name, offsetof(GpShaderCounts, member), offsetof(GpProfileLimits, member) }
/* clang-format on */

static const Resource resources[] = {
    RESOURCE(slots, "instruction slots"), RESOURCE(arithmetic_slots, "  arithmetic"),
    RESOURCE(texture_slots, "  texture"), RESOURCE(temporaries, "registers"),
    RESOURCE(constants, "constants"),     RESOURCE(inputs, "inputs"),
    RESOURCE(samplers, "samplers"),       RESOURCE(dependent_reads, "dependent reads"),
};

static int number_at(const void *numbers, size_t offset)
{
    return *(const int *)((const char *)numbers + offset);
}

static json_t *limits_json(GpProfile profile, const GpShaderCounts *counts)
{
    json_t *object = json_pack("{s:s, s:b}", "profile", gp_profile_name(profile), "gradients",
                               counts->gradients);
    for (size_t i = 0; i < GP_COUNT(resources); i++) {
        const Resource *resource = &resources[i];
        int limit = number_at(gp_profile_limits(profile), resource->limit);
        json_object_set_new(object, resource->key,
                            json_pack("{s:i, s:o}", "used", number_at(counts, resource->used),
                                      "limit",
                                      limit == GP_UNLIMITED ? json_null() : json_integer(limit)));
    }
    return object;
}

void shader_limits_add(json_t *object, const GpProgram *program)
{
    GpShaderCounts vertex = { 0 }, pixel = { 0 };
    if (!program->count || !program->count(program, &vertex, &pixel))
        return;
    json_object_set_new(object, "vertex_shader", limits_json(program->vertex_profile, &vertex));
    if (program->code[0]->pixel)
        json_object_set_new(object, "pixel_shader", limits_json(program->pixel_profile, &pixel));
}

/* in   width: of the column; 0 for the last one, which needs no padding */
static void print_cell(const json_t *shader, const char *key, int width)
{
    const json_t *resource = json_object_get(shader, key);
    const json_t *limit = json_object_get(resource, "limit");
    char text[48];
    long long used = json_whole_of(resource, "used");
    if (json_is_integer(limit))
        snprintf(text, sizeof text, "%lld of %lld", used, (long long)json_integer_value(limit));
    else
        snprintf(text, sizeof text, "%lld", used);
    printf("  %*s", -width, text);
}

void shader_limits_print(const json_t *vertex, const json_t *pixel)
{
    const json_t *shaders[] = { vertex, pixel };
    if (!vertex && !pixel) {
        puts("    shaders not counted: this build lacks their counting code");
        return;
    }
    printf("    %-20s", "shader");
    for (size_t s = 0; s < GP_COUNT(shaders); s++)
        if (shaders[s])
            printf("  %*s", s ? 0 : -14, json_text_of(shaders[s], "profile"));
    for (size_t i = 0; i < GP_COUNT(resources); i++) {
        printf("\n    %-20s", resources[i].name);
        for (size_t s = 0; s < GP_COUNT(shaders); s++)
            if (shaders[s])
                print_cell(shaders[s], resources[i].key, s ? 0 : 14);
    }
    putchar('\n');
}
