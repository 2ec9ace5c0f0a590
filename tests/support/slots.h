/* What shaders cost, as tables: slots at most, what they take today. */
#ifndef TESTS_SLOTS_H
#define TESTS_SLOTS_H

#include "pipeline/shader/counts.h"
#include "tests/support/unit.h"

typedef struct SlotsRow {
    const GpProgram *program;
    int vertex, pixel; /* slots at most */
} SlotsRow;

/* clang-format off */
#define SLOTS_ROW(name, vertex, pixel) { &name##_program, vertex, pixel }
/* clang-format on */

/* Prints what each takes. Fails the running test where one takes more than its row says or does not
 * keep to its profile; skips it where the counting build is not there. */
static inline void check_slots(const SlotsRow *rows, size_t count)
{
    int failed = 0;
    for (size_t i = 0; i < count; i++) {
        const GpProgram *program = rows[i].program;
        GpShaderCounts vertex = { 0 }, pixel = { 0 };
        GpError error = { "" };
        if (gp_program_check(program, &error))
            fail_msg("%s", error.text);
        if (!program->count)
            skip();
        program->count(program, &vertex, &pixel);
        print_message("# %s: %d slots, %d registers; %d slots, %d registers\n", program->name,
                      vertex.slots, vertex.temporaries, pixel.slots, pixel.temporaries);
        failed += vertex.slots > rows[i].vertex || pixel.slots > rows[i].pixel;
    }
    assert_int_equal(failed, 0);
}

#endif
