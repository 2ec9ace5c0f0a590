# Sums the results of test programs: awk -f summary.awk RESULT...
#
# Each RESULT is TAP as run_test.sh left it. A program that promises more tests than it reports (it
# crashed, or left early), that ends with a bad status though no test failed, or that ran no test at
# all counts as one more failure. The details of failures are printed, then one line a program, and
# last: N passed, M failed, K skipped. Exit status 1 unless something passed and nothing failed.

function finish_program()
{
    if (name == "")
        return
    if (planned == 0)
        trouble = "ran no test"
    else if (planned != ok + not_ok + skip)
        trouble = "reported " ok + not_ok + skip " of " planned " tests"
    else if (status == "")
        trouble = "left no exit status"
    else if (status != 0 && not_ok == 0)
        trouble = "ended with status " status
    else
        trouble = ""
    if (trouble != "") {
        not_ok++
        details = details all
    }
    if (details != "")
        printf "--- %s\n%s", name, details
    if (trouble != "")
        printf "%s %s\n", name, trouble
    lines = lines sprintf("%-28s %5d passed", name, ok)
    lines = lines (not_ok ? ", " not_ok " FAILED" : "") (skip ? ", " skip " skipped" : "") "\n"
    passed += ok
    failed += not_ok
    skipped += skip
}

FNR == 1 {
    finish_program()
    name = FILENAME
    sub(/.*\//, "", name)
    sub(/\.tap$/, "", name)
    planned = ok = not_ok = skip = in_failure = 0
    status = details = all = ""
}

{ all = all $0 "\n" }

/^1\.\.0 # SKIP/ { planned++; skip++; next }
/^1\.\.[0-9]+/ { planned += substr($0, 4) + 0; next }
/^(not )?ok .*# SKIP/ { skip++; in_failure = 0; next }
/^ok / { ok++; in_failure = 0; next }
/^not ok / { not_ok++; in_failure = 1; details = details $0 "\n"; next }
/^# exit status / { status = $4; next }
/^# (not )?ok - / { in_failure = 0; next }
in_failure { details = details $0 "\n" }

END {
    finish_program()
    printf "%s%d passed, %d failed, %d skipped\n", lines, passed, failed, skipped
    exit failed > 0 || passed == 0
}
