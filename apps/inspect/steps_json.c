#include "apps/inspect/steps_json.h"

#include "apps/base/json.h"
#include "apps/inspect/sources.h"

#include <stdio.h>
#include <string.h>
#include <xxhash.h>

static bool is_mask(GpStepCode code)
{
    return code >= GP_STEP_LESS && code <= GP_STEP_NOT;
}

static bool looks_at_quad(GpStepCode code)
{
    return code == GP_STEP_DSX || code == GP_STEP_DSY ||
           (code >= GP_STEP_TEXLD && code <= GP_STEP_TEXLDD);
}

static json_t *part_json(const GpStepPart *part, bool with_value, int lane)
{
    json_t *list = json_pack("[i, i, i, i]", (int)part->source, part->index, part->component,
                             (int)part->negated);
    if (part->source == GP_STEP_NUMBER) /* its index is its bits, which nobody needs */
        json_array_set_new(list, 1, json_integer(0));
    if (with_value || part->source == GP_STEP_NUMBER || part->source == GP_STEP_UNIFORM)
        json_array_append_new(list, json_number((double)part->value[lane]));
    return list;
}

static json_t *step_json(const GpShaderStep *step)
{
    json_t *operands = json_array();
    for (int i = 0; i < step->operands; i++) {
        json_t *parts = json_array();
        for (int c = 0; c < step->operand[i].width; c++)
            json_array_append_new(parts, part_json(&step->operand[i].part[c], false, 0));
        json_array_append_new(operands, parts);
    }
    const char *file = strncmp(step->file, "./", 2) == 0 ? step->file + 2 : step->file;
    return json_pack("{s:s, s:s, s:i, s:i, s:i, s:i, s:o}", "op", gp_step_names[step->code], "file",
                     file, "line", source_statement_line(source_find(file), step->line), "slots",
                     step->slots, "slot", step->slot, "width", step->width, "operands", operands);
}

/* Names of what is watched, and which step each is where one is. */
static json_t *watches_json(const GpTraceSteps *steps)
{
    json_t *list = json_array();
    for (int i = 0; i < steps->watches; i++) {
        const GpStepOperand *value = &steps->watch[i].value;
        const bool is_step = value->part[0].source == GP_STEP_RESULT;
        json_array_append_new(list, json_pack("[s, i, i]", steps->watch[i].name, value->width,
                                              is_step ? value->part[0].index : -1));
    }
    return list;
}

/* --- listings --------------------------------------------------------------------------------- */

static uint64_t hash_text(const char *text, uint64_t hash)
{
    return XXH3_64bits_withSeed(text, strlen(text), hash);
}

static uint64_t hash_operand(const GpStepOperand *operand, uint64_t hash)
{
    uint32_t words[4][3];
    memset(words, 0, sizeof words);
    for (int c = 0; c < operand->width; c++) {
        const GpStepPart *part = &operand->part[c];
        const bool is_constant = part->source == GP_STEP_NUMBER || part->source == GP_STEP_UNIFORM;
        words[c][0] = (uint32_t)part->source << 8 | (uint32_t)part->component << 1 | part->negated;
        words[c][1] = (uint32_t)part->index;
        words[c][2] = is_constant ? gp_float_bits(part->value[0]) : 0;
    }
    return XXH3_64bits_withSeed(words, sizeof words, hash + (uint64_t)operand->width);
}

/* Of all that a listing says. */
static uint64_t hash_listing(const GpTraceSteps *steps)
{
    uint64_t hash = (uint64_t)steps->steps;
    for (int i = 0; i < steps->steps; i++) {
        const GpShaderStep *step = &steps->step[i];
        const int words[] = { (int)step->code, step->slots, step->slot, step->line, step->width };
        hash = XXH3_64bits_withSeed(words, sizeof words, hash_text(step->file, hash));
        for (int k = 0; k < step->operands; k++)
            hash = hash_operand(&step->operand[k], hash);
    }
    for (int i = 0; i < steps->watches; i++) {
        const GpStepPart *first = &steps->watch[i].value.part[0];
        const int words[] = { steps->watch[i].value.width, (int)first->source, first->index };
        hash = XXH3_64bits_withSeed(words, sizeof words, hash_text(steps->watch[i].name, hash));
    }
    return hash;
}

static json_t *listing_json(const GpTraceSteps *steps)
{
    json_t *all = json_array();
    for (int i = 0; i < steps->steps; i++)
        json_array_append_new(all, step_json(&steps->step[i]));
    return json_pack("{s:o, s:o}", "steps", all, "watches", watches_json(steps));
}

/* -1: there is no room. */
static int listing_number(StepListings *listings, const GpTraceSteps *steps)
{
    char key[24];
    snprintf(key, sizeof key, "%016llx", (unsigned long long)hash_listing(steps));
    if (!listings->all) {
        listings->all = json_array();
        listings->numbers = json_object();
    }
    const json_t *known = json_object_get(listings->numbers, key);
    if (known)
        return (int)json_integer_value(known);
    if (listings->steps + steps->steps > STEP_LISTINGS_MOST)
        return -1;
    const int number = (int)json_array_size(listings->all);
    listings->steps += steps->steps;
    json_object_set_new(listings->numbers, key, json_integer(number));
    json_array_append_new(listings->all, listing_json(steps));
    return number;
}

/* --- values ----------------------------------------------------------------------------------- */

static json_t *lanes_json(const GpStepOperand *operand)
{
    json_t *components = json_array();
    for (int c = 0; c < operand->width; c++)
        json_array_append_new(components, json_floats(operand->part[c].value, 4));
    return components;
}

static json_t *watched_json(const GpTraceSteps *steps)
{
    json_t *watched = json_array();
    for (int i = 0; i < steps->watches; i++)
        for (int c = 0; c < steps->watch[i].value.width; c++) {
            const float value = steps->watch[i].value.part[c].value[steps->lane];
            json_array_append_new(watched, json_number((double)value));
        }
    return watched;
}

json_t *steps_json(StepListings *listings, const GpTraceSteps *steps)
{
    const int number = steps->steps > STEP_LISTINGS_MOST ? -1 : listing_number(listings, steps);
    if (number < 0)
        return json_pack("{s:i, s:b, s:o, s:o}", "left_out", steps->steps, "agrees",
                         (int)steps->agrees, "watches", watches_json(steps), "watched",
                         watched_json(steps));
    json_t *values = json_array(), *lanes = json_object(), *outputs = json_array();
    for (int i = 0; i < steps->steps; i++) {
        const GpShaderStep *step = &steps->step[i];
        for (int c = 0; c < step->width; c++) {
            const float value = step->value[c][steps->lane];
            json_array_append_new(values, is_mask(step->code)
                                              ? json_integer(gp_float_bits(value) != 0)
                                              : json_number((double)value));
        }
        if (looks_at_quad(step->code) && step->operands) {
            char key[16];
            snprintf(key, sizeof key, "%d", i);
            json_object_set_new(lanes, key, lanes_json(&step->operand[0]));
        }
    }
    for (int i = 0; i < steps->outputs; i++)
        json_array_append_new(outputs, part_json(&steps->output[i].part, true, steps->lane));
    return json_pack("{s:i, s:b, s:o, s:o, s:o, s:o}", "listing", number, "agrees",
                     (int)steps->agrees, "values", values, "lanes", lanes, "outputs", outputs,
                     "watched", watched_json(steps));
}

void step_listings_free(StepListings *listings)
{
    json_decref(listings->numbers);
    json_decref(listings->all);
    *listings = (StepListings){ .all = NULL };
}
