#!/bin/sh
# How many branches of the pipeline are taken: coverage.sh BUILD [PERCENT]
#
# BUILD holds programs that were made with COVERAGE=1, and what their runs counted: in profiles/ those of the
# tests, in faults/ those in which a call failed, if there were any. Prints coverage.py's table; branches.txt in
# BUILD tells the branches that were not taken.
set -eu

build=$1
percent=${2:-95}
here=$(dirname "$0")

# A tool of clang's, which Debian calls by its version too.
tool() {
    for name in "$1" "$1-14" "$1-15" "$1-16" "$1-17" "$1-18" "$1-19"; do
        command -v "$name" && return
    done
    echo "no $1: it comes with the package llvm" >&2
    exit 2
}
profdata=$(tool llvm-profdata)
cov=$(tool llvm-cov)

# counted FOLDER: what the runs of a folder took. What a killed program left is not whole; the rest counts.
counted() {
    "$profdata" merge -sparse -failure-mode=all -o "$build/$1.profdata" "$build/$1"/*.profraw
    "$cov" export "$build/bin/glasspipe" -object "$build/test/libtested.so" \
        -instr-profile "$build/$1.profdata" >"$build/$1.json"
    echo "$build/$1.json"
}
tests=$(counted profiles)
faults=$([ ! -d "$build/faults" ] || counted faults)
# shellcheck disable=SC2086 # no word where nothing failed
python3 "$here/coverage.py" "$here/coverage_left_out.txt" "$percent" "$tests" $faults 2>"$build/branches.txt"
