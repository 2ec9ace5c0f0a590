#include "tests/support/random_scene.h"

#include "pipeline/base/base.h"
#include "pipeline/io/file.h"

#include <stdio.h>

const char *random_model(Random *random, bool large)
{
    enum { SMALL = 4 };
    static const char *const models[] = {
        "builtin:cube",   "builtin:cylinder", "builtin:ball",          "builtin:disc",
        "builtin:sphere", "builtin:cone",     "builtin:torus",         "builtin:knot",
        "builtin:teapot", "meshes/bunny.ply", "meshes/rocker_arm.ply", "meshes/fandisk.ply",
    };
    char path[512];
    const int last = (large ? (int)GP_COUNT(models) : SMALL) - 1;
    const char *model = models[random_int(random, 0, last)];
    return model[0] == 'm' && gp_data_find(model, path, sizeof path, NULL) ? models[0] : model;
}

static int print_light(Random *random, char *text, size_t size)
{
    const double x = random_between(random, -3, 3), y = random_between(random, 0.6, 4),
                 z = random_between(random, -3, 3);
    switch (random_int(random, 0, 4)) {
    case 0:
        return snprintf(text, size, "\"direction\": [%.3f, %.3f, %.3f]", x, y, z);
    case 1: /* to all sides */
        return snprintf(text, size, "\"position\": [%.3f, %.3f, %.3f]", x, y, z);
    case 2:
        return snprintf(text, size,
                        "\"position\": [%.3f, %.3f, %.3f], \"at\": [0, 0.3, 0], \"cone\": %.1f", x,
                        y, z, random_between(random, 15, 50));
    case 3:
        return snprintf(text, size,
                        "\"position\": [%.3f, %.3f, %.3f], \"at\": [0, 0.3, 0], \"size\": %.3f", x,
                        y, z, random_between(random, 0.05, 0.6));
    default:
        return snprintf(text, size, "\"position\": [%.3f, %.3f, %.3f], \"at\": [0, 0.3, 0]", x, y,
                        z);
    }
}

static int print_transform(Random *random, double tilt, double scale, double lift, char *text,
                           size_t size)
{
    return snprintf(text, size,
                    "\"transform\": { \"rotate\": [%.3f, %.3f, 1, %.2f], \"scale\": %.3f, "
                    "\"translate\": [%.3f, %.3f, %.3f] }",
                    random_between(random, -1, 1), random_between(random, -1, 1), tilt, scale,
                    lift > 0 ? random_between(random, -0.8, 0.8) : 0, lift,
                    lift > 0 ? random_between(random, -0.8, 0.8) : 0);
}

void random_scene(Random *random, int least, int most, bool large, char *text, size_t size)
{
    const int width = random_int(random, least, most), height = random_int(random, least, most);
    size_t used = (size_t)snprintf(
        text, size,
        "{ \"size\": [%d, %d], \"camera\": { \"eye\": [%.3f, %.3f, %.3f], \"at\": [0, 0.3, 0], "
        "\"fovy\": %.1f, \"near\": 0.05, \"far\": 50 }, \"lights\": [ { ",
        width, height, random_between(random, -3, 3), random_between(random, 0.8, 3),
        random_between(random, 1.2, 3), random_between(random, 20, 60));
    used += (size_t)print_light(random, text + used, size - used);
    used += (size_t)snprintf(text + used, size - used,
                             " } ], \"objects\": [ { \"mesh\": \"builtin:plane\", ");
    const double tilt = random_int(random, 0, 1) ? random_between(random, -30, 30) : 0;
    used += (size_t)print_transform(random, tilt, 2, 0, text + used, size - used);
    const int objects = random_int(random, 1, 4);
    for (int i = 0; i < objects; i++) {
        const double reach = random_between(random, 0.3, 1);
        used += (size_t)snprintf(
            text + used, size - used, " }, { \"mesh\": \"%s\", \"fit\": [%.3f, %.3f, %.3f, %.3f], ",
            random_model(random, large), random_between(random, -0.8, 0.8),
            random_between(random, 0.1, 1), random_between(random, -0.8, 0.8), reach);
        used += (size_t)print_transform(random, random_between(random, -180, 180), 1, 0,
                                        text + used, size - used);
    }
    snprintf(text + used, size - used, " } ] }\n");
}
