/* What an input says: by what is in its files, whatever they are called, and however often they are
 * named. */
#include "apps/base/content.h"
#include "apps/base/text.h"
#include "tests/support/folder.h"

static void an_input_counts_by_what_it_says(void **state)
{
    (void)state;
    static const char scene[] = "{ \"mesh\": [\"a.off\", \"nothing\"] }";
    put_text("a.off", "OFF 0");
    const uint64_t first = content_hash(put_text("scene.json", scene), 7);
    assert_true(content_hash(put_text("copy.json", scene), 7) == first);
    assert_true(content_hash(in_folder("copy.json"), 8) != first);
    put_text("a.off", "OFF 1");
    assert_true(content_hash(in_folder("scene.json"), 7) != first);
    assert_true(content_hash("builtin:cube", 7) != content_hash("builtin:knot", 7));
}

/* Which once took as many readings as there are ways from file to file: 1000^8 here. */
static void files_that_name_each_other_are_read_once(void **state)
{
    (void)state;
    Text names = { .data = NULL };
    for (int i = 0; i < 2000; i++)
        text_add(&names, "%s\"%c.json\"", i ? ", " : "[", i % 2 ? 'a' : 'b');
    text_add(&names, "%s", "]");
    put_text("b.json", names.data);
    const uint64_t both = content_hash(put_text("a.json", names.data), 0);
    put_text("b.json", "[]");
    assert_true(content_hash(in_folder("a.json"), 0) != both);
    text_free(&names);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(an_input_counts_by_what_it_says, folder_set_up,
                                        folder_tear_down),
        cmocka_unit_test_setup_teardown(files_that_name_each_other_are_read_once, folder_set_up,
                                        folder_tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
