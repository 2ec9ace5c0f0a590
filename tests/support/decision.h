/* Tables of decisions in which every condition is shown to decide alone (modified
 * condition/decision coverage): of two rows that differ in it, one way goes the other. A row spells
 * its conditions in the order of the unit's source: T, F, or - where none asks. */
#ifndef TESTS_DECISION_H
#define TESTS_DECISION_H

#include "tests/support/unit.h"

#include <stdbool.h>

enum { MOST_ROWS = 16 };

typedef struct Decision {
    const char *name;
    int rows;
    const char *conditions[MOST_ROWS];
    bool outcome[MOST_ROWS];
} Decision;

/* Notes what a unit decided; fails the running test where that is not as expected. */
static inline void decided(Decision *decision, const char *conditions, bool expected, bool outcome)
{
    if (outcome != expected)
        fail_msg("%s, %s: expected %d", decision->name, conditions, expected);
    assert_true(decision->rows < MOST_ROWS);
    decision->conditions[decision->rows] = conditions;
    decision->outcome[decision->rows++] = outcome;
}

/* Whether two rows differ in condition i, in what was decided, and in no other condition asked. */
static inline bool shows(const Decision *decision, size_t i, int a, int b)
{
    const char *one = decision->conditions[a], *other = decision->conditions[b];
    if (decision->outcome[a] == decision->outcome[b] || one[i] != 'T' || other[i] != 'F')
        return false;
    for (size_t k = 0; one[k]; k++)
        if (k != i && one[k] != other[k] && one[k] != '-' && other[k] != '-')
            return false;
    return true;
}

/* Fails the running test where the rows noted leave a condition of which nothing shows that it
 * decides. */
static inline void every_condition_decides(const Decision *decision)
{
    for (size_t i = 0; decision->conditions[0][i]; i++) {
        bool shown = false;
        for (int a = 0; a < decision->rows; a++)
            for (int b = 0; b < decision->rows; b++)
                shown = shown || shows(decision, i, a, b);
        if (!shown)
            fail_msg("%s: nothing shows that condition %zu decides", decision->name, i);
    }
}

#endif
