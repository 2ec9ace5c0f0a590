#!/bin/sh
# How many branches of the pipeline the tests take: coverage.sh BUILD [PERCENT]
#
# BUILD holds programs that were made with COVERAGE=1, and in profiles/ what their runs counted. Prints
# coverage.py's table; branches.txt in BUILD tells the branches that were not taken.
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

"$profdata" merge -sparse -failure-mode=all -o "$build/coverage.profdata" "$build"/profiles/*.profraw
"$cov" export "$build/bin/glasspipe" -object "$build/test/libtested.so" \
    -instr-profile "$build/coverage.profdata" >"$build/coverage.json"
python3 "$here/coverage.py" "$here/coverage_left_out.txt" "$percent" <"$build/coverage.json" \
    2>"$build/branches.txt"
