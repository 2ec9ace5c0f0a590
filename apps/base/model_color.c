#include "apps/base/model_color.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const uint8_t *model_color(const char *name)
{
    static const struct {
        const char *name;
        uint8_t color[3];
    } colors[] = {
        { "white", { 255, 255, 255 } }, { "grey", { 160, 160, 160 } },
        { "clay", { 200, 150, 110 } },  { "gold", { 230, 180, 70 } },
        { "jade", { 110, 180, 140 } },  { "black", { 0, 0, 0 } },
    };
    for (size_t i = 0; i < GP_COUNT(colors); i++)
        if (strcmp(colors[i].name, name) == 0)
            return colors[i].color;
    return NULL;
}

GpResult model_waves(const char *color, double *waves, GpError *error)
{
    *waves = 0;
    if (!color || strcmp(color, "file") == 0 || model_color(color))
        return GP_OK;
    if (strncmp(color, "waves:", 6) == 0) {
        char *end;
        *waves = strtod(color + 6, &end);
        if (end != color + 6 && !*end && isfinite(*waves) && *waves > 0)
            return GP_OK;
        return gp_fail(error, GP_ERROR_INVALID, "--color: expected a number above 0, not '%.40s'",
                       color + 6);
    }
    return gp_fail(
        error, GP_ERROR_INVALID,
        "--color: expected file, white, grey, clay, gold, jade, black or such as waves:40, "
        "not '%.40s'",
        color);
}
