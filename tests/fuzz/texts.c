/* Small texts: polynomials, transfer functions, options of techniques. */
#include "apps/base/polynomial.h"
#include "apps/techniques/registry.h"
#include "apps/volumes/transfer.h"
#include "tests/fuzz/targets.h"

#include <stdio.h>
#include <string.h>

enum { MOST = 400 };

/* A text ends at the first zero byte. */
static const char *text_of(const uint8_t *data, size_t size)
{
    static char text[MOST + 1];
    size = size < MOST ? size : MOST;
    memcpy(text, data, size);
    text[size] = '\0';
    return text;
}

/* --- polynomials ------------------------------------------------------------------------------ */

static bool run_polynomial(const uint8_t *data, size_t size)
{
    static Polynomial polynomial;
    GpError error = { "" };
    return fuzz_accepted(polynomial_parse(text_of(data, size), &polynomial, &error), &error);
}

static void seeds_polynomial(const FuzzSeeds *to)
{
    fuzz_seed_text(to, "quartic", "x^4 - 5x^2 + y^4 - 5 y^2 + z^4 - 5*z^2 + 11.8");
    fuzz_seed_text(to, "heart", "(x^2 + 9/4 y^2 + z^2 - 1)^3 = x^2 z^3 + 9/80 y^2 z^3");
    fuzz_seed_text(to, "signs", "-(-x)(1e3 - .5y)/2");
}

/* --- transfer functions ----------------------------------------------------------------------- */

static bool run_transfer(const uint8_t *data, size_t size)
{
    static uint8_t samples[8] = { 0, 1, 2, 3, 100, 101, 254, 255 };
    static Transfer transfer;
    const Field field = { { 2, 2, 2 }, { 1, 1, 1 }, samples, -1000, 3000 };
    GpError error = { "" };
    const GpResult result = transfer_open(fuzz_file(".txt", data, size), &field, &transfer, &error);
    if (!fuzz_accepted(result, &error))
        return false;
    float table[FIELD_VALUES][4];
    transfer_table(&transfer, table);
    for (int v = 0; v < FIELD_VALUES; v++)
        for (int c = 0; c < 4; c++)
            fuzz_claim(table[v][c] >= 0 && table[v][c] <= 1, "colours are in [0, 1]");
    return true;
}

static void seeds_transfer(const FuzzSeeds *to)
{
    fuzz_seed_text(to, "ramp", "# value r g b a\n0 0 0 0 0\n127.5 1 0 .5 1e-3\n255 1 1 1 1\n");
    fuzz_seed_text(to, "one", "3 1 1 1 1\n");
}

/* --- options ---------------------------------------------------------------------------------- */

/* The first byte is the technique. What is accepted is printed, and read again to the same. */
static bool run_options(const uint8_t *data, size_t size)
{
    size_t count = 0;
    while (technique_registry[count])
        count++;
    if (size == 0)
        return false;
    const Technique *technique = technique_registry[data[0] % count];
    void *setting = NULL, *again = NULL;
    GpError error = { "" };
    const GpResult result =
        technique_setting(technique, text_of(data + 1, size - 1), &setting, &error);
    if (!fuzz_accepted(result, &error))
        return false;
    static char text[2][4096];
    setting_print(technique->settings, setting, technique->defaults, text[0], sizeof text[0]);
    fuzz_claim(technique_setting(technique, text[0], &again, &error) == GP_OK,
               "what is printed can be read");
    setting_print(technique->settings, again, technique->defaults, text[1], sizeof text[1]);
    fuzz_claim(strcmp(text[0], text[1]) == 0, "what is read is what was printed");
    if (technique->check)
        fuzz_accepted(technique->check(setting, ~0u, "png", &error), &error);
    gp_free(setting);
    gp_free(again);
    return true;
}

/* Every field of every technique, in the middle of its range. */
static void seeds_options(const FuzzSeeds *to)
{
    for (int i = 0; technique_registry[i]; i++) {
        const Technique *technique = technique_registry[i];
        const char letter = (char)i;
        to->take(to->user, technique->name, &letter, 1);
        for (const SettingField *field = technique->settings; field->name; field++) {
            char text[MOST], name[64];
            const double middle = (field->low + field->high) / 2;
            int length = snprintf(text, sizeof text, "%c--%s", 1, field->name);
            text[0] = letter;
            if (field->aside)
                continue;
            if (field->type == SETTING_NAME)
                length +=
                    snprintf(text + length, sizeof text - (size_t)length, " %s", field->names[0]);
            else if (field->type == SETTING_INTEGER)
                length += snprintf(text + length, sizeof text - (size_t)length, " %.0f", middle);
            else if (field->type == SETTING_NUMBER)
                length += snprintf(text + length, sizeof text - (size_t)length, " %g", middle);
            else if (field->type != SETTING_FLAG)
                continue;
            snprintf(name, sizeof name, "%.20s-%.30s", technique->name, field->name);
            to->take(to->user, name, text, (size_t)length);
        }
    }
}

const FuzzTarget fuzz_polynomial = { "polynomial", MOST, run_polynomial, seeds_polynomial, NULL };
const FuzzTarget fuzz_transfer = { "transfer", 2048, run_transfer, seeds_transfer, NULL };
const FuzzTarget fuzz_options = { "options", MOST, run_options, seeds_options, NULL };
