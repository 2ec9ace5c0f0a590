/* What every technique's data promise: names that are found, settings that can be read, tables that
 * are whole. */
#include "apps/techniques/registry.h"
#include "tests/support/unit.h"

#include <stdio.h>

static void every_technique_can_read_its_own_sweeps(void **state)
{
    (void)state;
    assert_null(technique_find(technique_registry, "no such technique"));
    assert_null(experiment_find(technique_registry, "no such experiment", NULL));
    for (const Technique *const *one = technique_registry; *one; one++) {
        const Technique *technique = *one, *found = NULL;
        assert_ptr_equal(technique_find(technique_registry, technique->name), technique);
        assert_string_equal(technique->experiments->name, technique->name);
        void *setting = gp_alloc(1, technique->setting_bytes);
        for (const Experiment *experiment = technique->experiments; experiment->name; experiment++)
            for (const TechniqueSweep *sweep = experiment->sweep; sweep->method; sweep++) {
                assert_ptr_equal(experiment_find(technique_registry, experiment->name, &found),
                                 experiment);
                assert_ptr_equal(found, technique);
                size_t count = technique_expand(sweep->options, NULL, 0);
                char(*texts)[SETTING_MAX_TEXT] = gp_alloc(count, sizeof *texts);
                technique_expand(sweep->options, texts, count);
                for (size_t k = 0; k < count; k++) {
                    GpError error = { "" };
                    memcpy(setting, technique->defaults, technique->setting_bytes);
                    if (setting_parse(technique->settings, setting, texts[k], &error))
                        fail_msg("%s, %s: %s", technique->name, texts[k], error.text);
                }
                gp_free(texts);
            }
        gp_free(setting);
    }
}

static void expect_sentence(const TechniqueWord *words, const char *word)
{
    const char *sentence = technique_word(words, word);
    if (!sentence)
        fail_msg("'%s' has no sentence", word);
    if (strlen(sentence) < 20 || sentence[strlen(sentence) - 1] != '.')
        fail_msg("'%s': no sentence: %s", word, sentence);
}

/* Whoever reads a chart was not there. */
static void every_name_in_a_chart_has_its_sentence(void **state)
{
    (void)state;
    for (const Technique *const *one = technique_registry; *one; one++) {
        for (const Experiment *experiment = (*one)->experiments; experiment->name; experiment++) {
            assert_true(experiment->truth && strlen(experiment->truth) > 40);
            assert_true(!experiment->difference || (experiment->over && experiment->under));
            expect_sentence(experiment->words, experiment->error_name);
            for (int i = 0; experiment->metrics && experiment->metrics[i]; i++)
                expect_sentence(experiment->words, experiment->metrics[i]);
            for (const TechniqueSweep *sweep = experiment->sweep; sweep->method; sweep++)
                expect_sentence(experiment->words, sweep->method);
        }
        const TechniqueScaling *scaling = (*one)->scaling;
        for (int p = 0; scaling && p < TECHNIQUE_PANELS; p++) {
            expect_sentence(scaling->words, scaling->panels[p].axis);
            for (const TechniqueLine *line = scaling->panels[p].lines; line->name; line++)
                expect_sentence(scaling->words, line->name);
        }
    }
}

/* A key of a chart needs no more than a word for each part, and none that a file may hold. */
static void fields_are_whole(void **state)
{
    (void)state;
    for (const Technique *const *one = technique_registry; *one; one++) {
        char text[SETTING_MAX_TEXT];
        const SettingField *field = (*one)->settings;
        setting_print(field, (*one)->defaults, (*one)->defaults, text, sizeof text);
        assert_string_equal(text, "");
        for (; field->name; field++) {
            assert_ptr_equal(setting_find((*one)->settings, field->name), field);
            assert_in_range(field - (*one)->settings, 0, SETTING_MAX_FIELDS - 1);
            assert_in_range(field->type, SETTING_NAME, SETTING_TEXT);
            assert_true(field->help && field->help[0]);
            assert_true(field->aside || field->type != SETTING_TEXT);
            assert_true((field->type == SETTING_NAME) == (field->names != NULL));
            assert_true(field->argument || field->names || field->type == SETTING_FLAG);
            assert_in_range(setting_words(field), 0, SETTING_MAX_VECTOR);
            assert_true(field->low <= field->high);
        }
    }
}

static void tables_are_whole(void **state)
{
    (void)state;
    size_t count = 0;
    for (const Technique *const *one = technique_registry; *one; one++)
        for (const PaperTable *const *table = (*one)->tables; table && *table; table++, count++) {
            const Technique *technique = NULL;
            int columns = 0;
            assert_ptr_equal(paper_table_find(technique_registry, (*table)->id, &technique),
                             *table);
            assert_ptr_equal(technique, *one);
            while ((*table)->columns[columns].name)
                columns++;
            assert_in_range(columns, 1, PAPER_MAX_COLUMNS);
            assert_non_null((*table)->rows[0].name);
            for (const PaperRow *row = (*table)->rows; row->name; row++)
                for (int i = 0; i < columns; i++)
                    if ((row->printed[i] != 0) != ((*table)->columns[i].number != PAPER_MEASURED))
                        fail_msg("table %s, %s: %s", (*table)->id, row->name,
                                 (*table)->columns[i].name);
        }
    assert_int_equal(count, 15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_technique_can_read_its_own_sweeps),
        cmocka_unit_test(every_name_in_a_chart_has_its_sentence),
        cmocka_unit_test(fields_are_whole),
        cmocka_unit_test(tables_are_whole),
    };
    return cmocka_run_group_tests_name("registry", tests, NULL, NULL);
}
