/* Surfels that do not show: none of them leaves a texel, however near the eye, whose nearest plane
 * makes those beside it larger than the picture. */
#include "apps/points/drawing/splats.h"

#include "tests/support/devices.h"
#include "tests/support/surfel_shapes.h"
#include "tests/support/unit.h"

#include <string.h>

enum { SIDE = 64 };

/* How many texels of a picture of the ball of radius 1 show something. */
static int texels_shown(const Surfels *ball, const Camera *camera, SplatMethod method)
{
    const bool filters = method >= SPLAT_TERNARY && method < SPLAT_ROUND;
    GpError error = { "" };
    Frame frame = { .color = NULL };
    const SplatRun run = { .filter = filters ? SPLAT_EWA : method,
                           .count = ball->count,
                           .radius = ball->surfels[0].radius };
    const SplatSource source = { .surfels = ball->surfels, .runs = &run, .run_count = 1 };
    const SplatView view = { .camera = *camera, .width = SIDE, .height = SIDE };
    SplatSetting setting = SPLAT_DEFAULTS;
    setting.method = method;
    if (splats_build(&source, &view, &setting, &frame, &error))
        fail_msg("%s", error.text);
    run_list(&frame.list);
    int shown = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        shown += frame.color->level[0].texels[4 * i + 3] != 0;
    frame_free(&frame);
    return shown;
}

static void nothing_shows_of_what_is_behind_or_turned_away(void **state)
{
    static const SplatMethod methods[] = { SPLAT_EWA,     SPLAT_RECONSTRUCTION, SPLAT_LOW_PASS,
                                           SPLAT_TERNARY, SPLAT_PERSPECTIVE,    SPLAT_QUADS,
                                           SPLAT_ROUND,   SPLAT_PIXELS };
    /* It turns its back on the ball; it is inside. */
    static const Camera cameras[] = {
        { .eye = { 0, 0, -1.05 },
          .at = { 0, 0, -3 },
          .up = { 0, 1, 0 },
          .fovy = 60,
          .near = 1e-3,
          .far = 10 },
        { .eye = { 0, 0, 0.2 },
          .at = { 0, 0, -1 },
          .up = { 0, 1, 0 },
          .fovy = 60,
          .near = 1e-3,
          .far = 10 },
    };
    (void)state;
    Surfels ball = { 0 };
    shape_sphere(&ball, 2000);
    for (size_t m = 0; m < sizeof methods / sizeof *methods; m++)
        for (size_t c = 0; c < sizeof cameras / sizeof *cameras; c++) {
            const int shown = texels_shown(&ball, &cameras[c], methods[m]);
            if (shown > 0)
                fail_msg("method %d, eye %zu: %d texels", (int)methods[m], c, shown);
        }
    surfels_free(&ball);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_shows_of_what_is_behind_or_turned_away),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
