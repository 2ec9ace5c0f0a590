#!/bin/sh
# Fuzzes: `make fuzz` runs this from the repository's root: fuzz.sh BUILD SECONDS [TARGET...]
#
# One target after the other, each for so many seconds (default 60), from its seeds, the cases of
# tests/fuzz/found, and what earlier runs kept in BUILD/corpus. Prints a line for each: executions, inputs
# kept, edges of the program that they reach, and what was found, which lies in BUILD/found then: put it
# into tests/fuzz/found/TARGET once it is mended. FUZZ_TIMEOUT: seconds, of a quiet machine. Exit status 1 where anything was found.
build=$1
seconds=${2:-60}
shift
[ $# = 0 ] || shift
make BUILD="$build" CC=clang CXX=clang++ OPT=-O1 ISAS=4:sse2: \
    SANITIZE=fuzzer-no-link,address,undefined "$build/test/fuzz" || exit 2
fuzz=$(pwd)/$build/test/fuzz
here=$(pwd)/$build
mkdir -p "$here/seeds" "$here/corpus" "$here/found" "$here/log"
TMPDIR=$(mktemp -d /dev/shm/glasspipe-fuzz-XXXXXX 2>/dev/null || mktemp -d)
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
trap 'exit 130' INT TERM
FUZZ_SEEDS=$here/seeds "$fuzz" || exit 2
"$fuzz" >"$here/targets"
[ $# -gt 0 ] || {
    # shellcheck disable=SC2046 # names without spaces
    set -- $(cut -d' ' -f1 "$here/targets")
}

# The last number behind a word of a log.
number() {
    sed -n "s/.*$1:* *\([0-9][0-9]*\).*/\1/p" "$2" | tail -n 1
}

printf '%-14s %12s %8s %8s %8s  %s\n' target executions 'a second' inputs edges found
all=0 bad=0
for target; do
    most=$(sed -n "s/^$target //p" "$here/targets")
    log=$here/log/$target
    mkdir -p "$here/corpus/$target"
    found=tests/fuzz/found/$target
    [ -d "$found" ] || found=
    # shellcheck disable=SC2086 # found may be nothing
    FUZZ=$target GP_DATA=/nowhere "$fuzz" -max_len="$most" -max_total_time="$seconds" -timeout="${FUZZ_TIMEOUT:-10}" -rss_limit_mb=3000 \
        -malloc_limit_mb=2500 -print_final_stats=1 -reload=0 -entropic=0 -artifact_prefix="$here/found/$target-" \
        "$here/corpus/$target" "$here/seeds/$target" $found >"$log" 2>&1
    status=$?
    runs=$(number stat::number_of_executed_units "$log")
    runs=${runs:-$(sed -n 's/^#\([0-9]*\).*/\1/p' "$log" | tail -n 1)}
    all=$((all + ${runs:-0}))
    word=none
    [ $status = 0 ] || {
        bad=$((bad + 1))
        word=$(sed -n 's/.*Test unit written to .*found\///p' "$log" | tail -n 1)
        word="${word:-status $status}: $(sed -n 's/.*\(ERROR: .*\|runtime error: .*\|claim: .*\)/\1/p' "$log" | head -n 1)"
    }
    printf '%-14s %12s %8s %8s %8s  %s\n' "$target" "${runs:-0}" \
        "$(number stat::average_exec_per_sec "$log")" \
        "$(find "$here/corpus/$target" -type f | wc -l)" "$(number cov "$log")" "$word"
done
of=$(sed -n 's/^INFO: Loaded .*(\([0-9]*\) .*/\1/p' "$log" | tail -n 1)
echo "$all executions over $# targets, $bad with something found; the program has ${of:-?} edges"
[ $bad = 0 ]
