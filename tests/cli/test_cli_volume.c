/* glasspipe volume as its user meets it. */
#include "pipeline/base/base.h"
#include "tests/support/program.h"

#include <math.h>

#define DIMS(x, y, z) "{ \"dims\": [" x ", " y ", " z "], \"type\": \"uint8\" }"

static void write_samples(const char *name, size_t count)
{
    char path[64], samples[64];
    memset(samples, 'x', sizeof samples);
    snprintf(path, sizeof path, "%s.raw", name);
    samples[count < sizeof samples ? count : sizeof samples - 1] = '\0';
    write_file(path, samples);
}

static void write_volumes(void)
{
    unlink("scene.json");
    write_file("good.json", DIMS("3", "3", "3"));
    write_samples("good", 27);
}

/* --- what is refused -------------------------------------------------------------------------- */

static void wrong_arguments_are_usage_errors(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        { "", "expected a volume" },
        { "a.nrrd b.nrrd", "b.nrrd" },
        { "a.nrrd --method best", "--method: expected raycast" },
        { "a.nrrd --method raycast --mode vt", "--mode: expected --method splat with it" },
        { "a.nrrd --method splat --step 2", "--step: expected --method raycast with it" },
        { "a.nrrd --step 0", "--step" },
        { "a.nrrd --method raycast --spacing 1", "--spacing: expected --method slices with it" },
        { "a.nrrd --method splat --mode xx", "--mode: expected vb, vt, pt, im or qd" },
        { "a.nrrd --method splat --filter box",
          "--filter: expected ewa, reconstruction, lowpass, adaptive or" },
        { "a.nrrd --method splat --accumulate 64f",
          "--accumulate: expected 16f, 32f, 8 or adaptive" },
        { "a.nrrd --method splat --deviation 0", "--deviation" },
        { "a.nrrd --method splat --cut 7", "--cut" },
        { "a.nrrd --method splat --lowpass 0", "--lowpass" },
        { "a.nrrd --method splat --thickness 0", "--thickness" },
        { "a.nrrd --camera a.json --from 1 2", "--camera and --from" },
        { "a.nrrd --from 0 90", "-89 to 89 degrees" },
        { "a.nrrd --up w", "--up: expected y, z, x, -y or -z" },
        { "a.nrrd --zoom 0", "--zoom" },
        { "a.nrrd --size 0x5", "--size" },
        { "a.nrrd --error 1 --step 1", "--error chooses the setting" },
        { "a.nrrd -o a.nrrd", ".png" },
    };
    unlink("scene.json");
    expect_all_refused(2, "volume", wrong, GP_COUNT(wrong));
    expect_files("");
}

/* One line, with the file's name in it where the file is wrong; nothing is written. */
static void wrong_volumes_are_input_errors_of_one_line(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        { "missing.nrrd", "missing.nrrd: no such file" },
        { "good.json", "good.json: expected a name that ends with .nrrd" },
        { "lone.raw", "lone.json" },
        { "short.raw", "short.raw: byte 26: 26 bytes of samples, expected those of 3 x 3 x 3" },
        { "wide.raw", "wide.json: dims: expected three whole numbers" },
        { "builtin:nothing", "no builtin volume 'nothing': expected marschner-lobb" },
        { "builtin:ball:0", "expected ball:N with N of 1 to 1024 samples" },
        { "builtin:ball:2000", "expected ball:N with N of 1 to 1024 samples" },
    };
    write_volumes();
    write_samples("lone", 27);
    write_samples("short", 26);
    write_file("short.json", DIMS("3", "3", "3"));
    write_samples("wide", 27);
    write_file("wide.json", DIMS("3", "3", "0"));
    expect_input_errors("volume", rows, GP_COUNT(rows));
    expect_files("good.json good.raw lone.raw short.json short.raw wide.json wide.raw");
}

static void wrong_transfer_functions_are_input_errors_of_one_line(void **state)
{
    (void)state;
    static const char *const files[][2] = {
        { "", "t.txt: the file is empty" },
        { "# nothing\n", "t.txt: no stops" },
        { "0 0 0 0\n", "t.txt: line 1: the line ends, expected opacity" },
        { "0 0 0 0 0\n255 1 1 nan 1\n", "t.txt: line 2: expected a number for blue, not 'nan'" },
        { "9 0 0 0 0\n9 1 1 1 1\n", "t.txt: line 2: expected values that rise" },
        { "0 0 0 0 0\r\n300 1 1 1 1\r\n", "t.txt: line 2: expected a value of 0 to 255, not 300" },
        { "0 0 0 0 2\n", "t.txt: line 1: expected opacity of 0 to 1, not 2" },
        { "\x89PNG\r\n", "t.txt: line 1: expected a number for a value" },
    };
    write_volumes();
    for (size_t i = 0; i < GP_COUNT(files); i++) {
        const char *const row[][2] = { { "good.raw --transfer t.txt", files[i][1] } };
        write_file("t.txt", files[i][0]);
        expect_input_errors("volume", row, 1);
    }
    static const char *const rows[][2] = {
        { "good.raw --transfer none", "none: no such file" },
        { "good.raw --transfer .", ".: " },
        { "good.raw --camera none.json", "none.json" },
    };
    expect_input_errors("volume", rows, GP_COUNT(rows));
    expect_files("good.json good.raw t.txt");
}

/* --- what is drawn ---------------------------------------------------------------------------- */

static void volumes_are_drawn(void **state)
{
    (void)state;
    write_volumes();
    write_file("t.txt", "# clear, then green\r\n0 0 1 0 0\r\n120 0 1 0 .5");
    assert_int_equal(shell("glasspipe volume good.raw -q --size 64x48 --transfer t.txt"), 0);
    expect_matches(out, "^hash A8R8G8B8 64x48 [0-9a-f]{16}\n$");
    expect_files("good.json good.png good.raw t.txt");
}

/* Of one sample, of a plane of them, from inside, from so far that all is in a pixel, and with
 * nothing to be seen. */
static void odd_volumes_and_places_are_drawn(void **state)
{
    (void)state;
    static const char *const arguments[] = {
        "builtin:ball:1",
        "builtin:checkerboard:1",
        "flat.raw",
        "line.raw --from 90 0",
        "builtin:ball:20 --camera in.json",
        "builtin:ball:20 --camera far.json",
        "builtin:ball:20 --camera parallel.json",
        "builtin:ball:20 --transfer clear.txt",
        "builtin:ball:20 --size 1x1",
        "builtin:ball:20 --size 1x90 --zoom 50",
    };
    write_volumes();
    write_samples("flat", 9);
    write_file("flat.json", DIMS("3", "1", "3"));
    write_samples("line", 9);
    write_file("line.json", DIMS("1", "9", "1"));
    write_file("clear.txt", "0 1 1 1 0\n");
    write_file("in.json", "{ \"eye\": [9, 9, 9], \"at\": [12, 10, 0], \"near\": 0.1 }");
    write_file("far.json", "{ \"eye\": [9, 9, 9000], \"near\": 10, \"far\": 10000 }");
    write_file("parallel.json", "{ \"eye\": [9, 9, 90], \"at\": [9, 9, 9], \"fovy\": 10 }");
    for (size_t i = 0; i < GP_COUNT(arguments); i++) {
        const bool has_size = strstr(arguments[i], "--size");
        if (shell("glasspipe volume %s -q -o a.exr %s --measure", arguments[i],
                  has_size ? "" : "--size 40x30"))
            fail_msg("%s: %s", arguments[i], err);
        expect_matches(out, "^hash A8R8G8B8 [0-9x]+ [0-9a-f]{16}\n[0-9.]+ dB against the data, "
                            "[0-9.]+ dB against the method\n$");
    }
}

static void json_has_what_checks_ask_for(void **state)
{
    (void)state;
    static const char *const members[] = { "hash",     "samples",         "splats",
                                           "transfer", "bytes_per_voxel", "psnr_data",
                                           "setting",  "psnr_method",     "splats_per_second",
                                           "ms" };
    unlink("scene.json");
    assert_int_equal(shell("glasspipe volume builtin:ball:24 --method splat --size 96x96 --measure "
                           "--json -q -o a.exr --output-opacity b.png"),
                     0);
    json_t *object = parse_output();
    for (size_t i = 0; i < GP_COUNT(members); i++)
        if (!json_object_get(object, members[i]))
            fail_msg("%s is missing in:\n%s", members[i], out);
    assert_int_equal(json_integer_value(json_object_get(object, "samples")), 24 * 24 * 24);
    const double data = json_real_value(json_object_get(object, "psnr_data")),
                 method = json_real_value(json_object_get(object, "psnr_method"));
    if (!(method > 40 && data > 25 && data < method))
        fail_msg("%g dB against the data, %g against the method", data, method);
    json_decref(object);
    expect_files("a.exr b.png");
}

static void options_of_one_method_mean_it(void **state)
{
    (void)state;
    static const char *const options[][2] = {
        { "--mode vt", "--method splat --mode vt" },
        { "--filter lowpass", "--method splat --filter lowpass" },
        { "--spacing 2", "--method slices --spacing 2" },
        { "--step 2", "--method raycast --step 2" },
        { "", "--method raycast" },
    };
    unlink("scene.json");
    expect_same_settings("volume builtin:ball:16 --size 32x32", options, GP_COUNT(options));
}

/* The README shows them. */
static void stored_pictures_are_what_their_commands_draw(void **state)
{
    (void)state;
#define BOARD                                                                                      \
    "builtin:checkerboard --transfer checkerboard --up z --from 30 55 --method splat --size 96x96"
    static const char *const pictures[][2] = {
        { "volume_bonsai", "volumes/bonsai.raw.gz --transfer bonsai --from 40 25" },
        { "volume_engine", "volumes/engine.raw.gz --transfer engine --lit --from -140 30" },
        { "volume_head", "volumes/vismale.raw.gz --lit --up -z --from 50 10" },
        { "volume_reconstruction", BOARD " --filter reconstruction" },
        { "volume_lowpass", BOARD " --filter lowpass --zoom 14" },
        { "volume_ewa", BOARD " --filter ewa" },
    };
    for (size_t i = 0; i < GP_COUNT(pictures); i++) {
        const char *arguments = pictures[i][1];
        const int code = shell("glasspipe volume -q %s %s -o a.png", arguments,
                               strstr(arguments, "--size") ? "" : "--size 256x256");
        if (code == 3 && strstr(err, "no such file")) /* the scan is not here */
            continue;
        assert_int_equal(code, 0);
        expect_stored_picture(pictures[i][0]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        PROGRAM_TEST(wrong_arguments_are_usage_errors),
        PROGRAM_TEST(wrong_volumes_are_input_errors_of_one_line),
        PROGRAM_TEST(wrong_transfer_functions_are_input_errors_of_one_line),
        PROGRAM_TEST(volumes_are_drawn),
        PROGRAM_TEST(odd_volumes_and_places_are_drawn),
        PROGRAM_TEST(json_has_what_checks_ask_for),
        PROGRAM_TEST(options_of_one_method_mean_it),
        PROGRAM_TEST(stored_pictures_are_what_their_commands_draw),
    };
    return cmocka_run_group_tests_name("volume", tests, find_program, NULL);
}
