#include "apps/charts/chart_words.h"

#include "apps/techniques/registry.h"

#include <stdio.h>
#include <string.h>

static const TechniqueWord common[] = {
    { "setting", "A method with its options. Each was drawn, held against the exact result, and "
                 "timed." },
    { "method", "One way to make the picture or the volume; its sentence stands with its chart." },
    { "options", "What else was set, as it is typed behind the technique's command; each has its "
                 "sentence with the chart. What does not stand there is as usual." },
    { "frame", "One picture, or one volume, from nothing to done." },
    { "ms", "Milliseconds that one frame took, from its begin to its end: the median of those that "
            "were drawn, so that as many took longer as took less." },
    { "middle half",
      "The bar through a point: a quarter of the frames took less time than its lesser "
      "end, and a quarter more than its greater one." },
    { "best", "No other setting is both faster and nearer to the exact result. Best settings have "
              "colours, and a line joins them: the least error that can be had within a time." },
    { "beaten", "Grey: another setting is as fast and as near to the exact result, and better in "
                "one of the two." },
    { "logarithmic", "Equal steps along an axis are equal factors: from 1 to 10 is as far as from "
                     "10 to 100." },
    { "processor", "In a point's numbers: milliseconds of work of all threads together." },
    { "measured on", "The processor, its widest instructions that were used, and the threads that "
                     "shared the work. Where other programs were at work, the chart says so: its "
                     "times are then longer than those of a machine at rest." },
    { .word = NULL },
};

/* --- the list --------------------------------------------------------------------------------- */

static void add_word(const char *word, const char *sentence, Text *page)
{
    text_add_escaped(page, "<dt>%s</dt><dd>%s</dd>\n", word, sentence);
}

static void begin(const char *title, Text *page)
{
    text_add_escaped(page, "<details open=\"open\"><summary>%s</summary>\n<dl>\n", title);
}

static void end(Text *page)
{
    text_add(page, "</dl></details>\n");
}

void chart_add_common_words(Text *page)
{
    begin("Words of all charts", page);
    for (const TechniqueWord *word = common; word->word; word++)
        add_word(word->word, word->sentence, page);
    end(page);
}

/* --- a chart's -------------------------------------------------------------------------------- */

static void add_known(const TechniqueWord *words, const char *word, const char *otherwise,
                      Text *page)
{
    const char *sentence = technique_word(words, word);
    if (sentence || otherwise)
        add_word(word, sentence ? sentence : otherwise, page);
}

/* Of the sweep, or of one of one's own, where settings name methods. */
static bool is_method(const Experiment *experiment, const Technique *technique, const char *word)
{
    for (const TechniqueSweep *row = experiment->sweep; row->method; row++)
        if (strcmp(row->method, word) == 0)
            return true;
    for (const SettingField *field = technique->settings; field->name; field++)
        for (int i = 0; field->names && field->names[i]; i++)
            if (strcmp(field->names[i], word) == 0)
                return true;
    return false;
}

/* Words of the subject, which the other sentences use. */
static void add_terms(const Experiment *experiment, const Technique *technique, Text *page)
{
    for (const TechniqueWord *word = experiment->words; word && word->word; word++) {
        bool is_metric = strcmp(experiment->error_name, word->word) == 0;
        for (int i = 0; experiment->metrics && experiment->metrics[i]; i++)
            is_metric |= strcmp(experiment->metrics[i], word->word) == 0;
        if (!is_metric && !is_method(experiment, technique, word->word))
            add_word(word->word, word->sentence, page);
    }
}

/* Once each, in the chart's order. Those of a sweep of one's own are named by what they set. */
static void add_methods(const Chart *chart, const Experiment *experiment, Text *page)
{
    for (uint32_t i = 0; i < chart->count; i++) {
        const char *method = chart->points[i].method;
        bool is_new = true;
        for (uint32_t k = 0; k < i && is_new; k++)
            is_new = strcmp(chart->points[k].method, method) != 0;
        if (is_new)
            add_known(experiment->words, method,
                      "The settings of these names, which stand with the options below.", page);
    }
}

/* Whether any setting has the option: "map" of "--map 512". */
static bool has_option(const Chart *chart, const char *name)
{
    char option[64];
    const int length = snprintf(option, sizeof option, "--%s", name);
    for (uint32_t i = 0; i < chart->count; i++)
        for (const char *at = chart->points[i].options; (at = strstr(at, option)); at += length)
            if (!at[length] || strchr(" =", at[length]))
                return true;
    return false;
}

static void add_options(const Chart *chart, const Technique *technique, Text *page)
{
    for (const SettingField *field = technique->settings; field->name; field++)
        if (has_option(chart, field->name))
            text_add_escaped(page, "<dt><code>--%s</code></dt><dd>%s.</dd>\n", field->name,
                             field->help);
}

void chart_add_words(const Chart *chart, const Technique *const *techniques, Text *page)
{
    const Technique *technique = NULL;
    const Experiment *experiment = experiment_find(techniques, chart->technique, &technique);
    if (!experiment)
        return;
    begin("What the words mean", page);
    if (experiment->truth)
        add_word("exact result", experiment->truth, page);
    add_known(experiment->words, chart->error_name, NULL, page);
    for (int i = 0; i < chart->metric_count; i++)
        add_known(experiment->words, chart->metrics[i], NULL, page);
    add_terms(experiment, technique, page);
    add_methods(chart, experiment, page);
    add_options(chart, technique, page);
    end(page);
}

void chart_add_scaling_words(const TechniqueScaling *scaling, Text *page)
{
    begin("What the words mean", page);
    add_word(
        "power",
        "Where the amount doubles, time that grows as the power 1 doubles too, as 2 takes four "
        "times as long, as 3 eight times; 0: as long as before. Said is what was measured: the "
        "slope of the straight line nearest to all points, and in brackets the least and the "
        "greatest slope from one point to the next that has half as much again, or more.",
        page);
    add_word("dotted lines", "Slopes to compare with, by their names; nothing was measured there.",
             page);
    for (const TechniqueWord *word = scaling->words; word && word->word; word++)
        add_word(word->word, word->sentence, page);
    end(page);
}
