#include "apps/base/mesh_places.h"

/* A vertex, and what it is sorted by. */
typedef struct Keyed {
    uint32_t key, vertex;
} Keyed;

/* Keys rise as numbers do, and -0 is 0. */
static uint32_t key_of(float number)
{
    const uint32_t bits = gp_float_bits(number + 0.0f);
    return bits >> 31 ? ~bits : bits | 1u << 31;
}

/* --- sorting by digits ------------------------------------------------------------------------ */

enum { DIGIT_BITS = 11, DIGITS = 1 << DIGIT_BITS };

static uint32_t digit_of(const Keyed *keyed, int shift)
{
    return keyed->key >> shift & (DIGITS - 1);
}

/* Those of one digit stay in their order. */
static void sort_by_digit(const Keyed *from, uint32_t count, int shift, Keyed *to)
{
    uint32_t next[DIGITS] = { 0 }, sum = 0;
    for (uint32_t i = 0; i < count; i++)
        next[digit_of(&from[i], shift)]++;
    for (int digit = 0; digit < DIGITS; digit++) {
        const uint32_t first = sum;
        sum += next[digit];
        next[digit] = first;
    }
    for (uint32_t i = 0; i < count; i++)
        to[next[digit_of(&from[i], shift)]++] = from[i];
}

/* --- places ----------------------------------------------------------------------------------- */

/* By x, then y, then z: the last first. Returns which of the two arrays has them. */
static Keyed *sort_vertices(const float *positions, uint32_t count, Keyed *one, Keyed *other)
{
    for (uint32_t i = 0; i < count; i++)
        one[i].vertex = i;
    for (size_t axis = 3; axis-- > 0;) {
        for (uint32_t i = 0; i < count; i++)
            one[i].key = key_of(positions[3 * (size_t)one[i].vertex + axis]);
        for (int shift = 0; shift < 32; shift += DIGIT_BITS) {
            Keyed *sorted = other;
            sort_by_digit(one, count, shift, sorted);
            other = one;
            one = sorted;
        }
    }
    return one;
}

static bool is_same_place(const float *a, const float *b)
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

GpResult mesh_places(const float *positions, uint32_t vertex_count, uint32_t *place_of)
{
    Keyed *room = gp_alloc(vertex_count, 2 * sizeof *room);
    if (!room)
        return GP_ERROR_MEMORY;
    const Keyed *sorted = sort_vertices(positions, vertex_count, room, room + vertex_count);
    uint32_t number = 0;
    for (uint32_t i = 0; i < vertex_count; i++) {
        const float *position = positions + 3 * (size_t)sorted[i].vertex;
        number += i > 0 && !is_same_place(positions + 3 * (size_t)sorted[i - 1].vertex, position);
        place_of[sorted[i].vertex] = number;
    }
    gp_free(room);
    return GP_OK;
}
